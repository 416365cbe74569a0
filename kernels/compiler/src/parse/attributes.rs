//! Attributes and flags: each is either known to change nothing of what a kernel computes, or refused by name.

use super::Result;
use super::cursor::Cursor;
use super::lexer::Token;
use crate::refusal::Reason;

/// Attributes of parameters and results without an argument.
const PLAIN: [&str; 19] = [
    "noundef",
    "nonnull",
    "noalias",
    "readonly",
    "writeonly",
    "readnone",
    "zeroext",
    "signext",
    "nocapture",
    "immarg",
    "returned",
    "inreg",
    "dead_on_unwind",
    "writable",
    "nofree",
    "noext",
    "nocallback",
    "allocptr",
    "allocalign",
];

/// Attributes with an argument in parentheses, or without one.
const WITH_ARGUMENT: [&str; 10] = [
    "dereferenceable",
    "dereferenceable_or_null",
    "captures",
    "range",
    "nofpclass",
    "sret",
    "byval",
    "initializes",
    "memory",
    "dead_on_return",
];

/// What the flags before an instruction's operands say, as far as it matters.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Flags {
    /// `nuw`, `nneg` or `disjoint`: as [`Instruction::exact`](crate::ir::Instruction::exact).
    pub exact: bool,
    /// `atomic`.
    pub atomic: bool,
}

impl Cursor<'_> {
    /// Skips the attributes between a type and a value.
    pub fn skip_attributes(&mut self) {
        loop {
            let word = self.word();
            if PLAIN.contains(&word) {
                self.take();
            } else if WITH_ARGUMENT.contains(&word) {
                self.take();
                self.skip_parentheses();
            } else if word == "align" {
                self.take();
                match self.peek() {
                    Some(Token::Mark('(')) => self.skip_parentheses(),
                    _ => self.skip(),
                }
            } else {
                return;
            }
        }
    }

    /// The flags before an instruction's operands.
    ///
    /// LLVM's promises (`nsw`, `inbounds`, `nnan` …) make a result undefined where they are broken, so a kernel may ignore them.
    /// Flags that allow another result are refused, and so is `volatile`.
    pub fn flags(&mut self) -> Result<Flags> {
        let mut flags = Flags::default();
        loop {
            match self.word() {
                "nuw" | "nneg" | "disjoint" => flags.exact = true,
                "atomic" => flags.atomic = true,
                "nsw" | "exact" | "samesign" | "inbounds" | "nusw" | "nnan" | "ninf" | "nsz" => {}
                word @ ("fast" | "reassoc" | "contract" | "arcp" | "afn" | "volatile" | "inrange") => {
                    return Err(Reason::Unknown(format!("the flag `{word}`")));
                }
                _ => return Ok(flags),
            }
            self.take();
        }
    }
}
