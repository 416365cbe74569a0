//! Calls.

use super::Result;
use super::cursor::Cursor;
use super::instructions::{Line, plain};
use super::lexer::Token;
use crate::ir::{SourceOp, Type, Value};
use crate::refusal::Reason;

/// Words between `call` and the type of its result.
const CONVENTIONS: [&str; 4] = ["fastcc", "coldcc", "ccc", "cold"];

/// Whether the compiler may know the function: the others need no arguments, they are refused by name.
pub fn is_known(callee: &str) -> bool {
    callee.starts_with("llvm.") || callee.starts_with("__k_") || callee == "bcmp"
}

impl Cursor<'_> {
    pub(super) fn call(&mut self) -> Result<Line> {
        self.flags()?;
        while CONVENTIONS.contains(&self.word()) {
            self.take();
        }
        self.skip_attributes();
        let ty = self.ty()?;
        if self.word() == "asm" {
            return Err(self.unknown("inline assembly"));
        }
        let callee = self.global().ok_or(Reason::IndirectCall)?;
        let arguments = if is_known(&callee) { self.arguments()? } else { vec![] };
        Ok(plain(SourceOp::Call(callee, arguments), ty))
    }

    /// `( type value, … )`, without metadata.
    fn arguments(&mut self) -> Result<Vec<Value>> {
        self.expect_mark('(')?;
        let mut arguments = Vec::new();
        while !self.eat_mark(')') {
            let ty = self.ty()?;
            self.skip_attributes();
            if ty == Type::Other("metadata".into()) {
                self.skip_metadata();
            } else {
                arguments.push(self.value(&ty)?);
            }
            self.eat_mark(',');
        }
        Ok(arguments)
    }

    fn skip_metadata(&mut self) {
        while !matches!(self.peek(), Some(Token::Mark(',' | ')')) | None) {
            self.take();
        }
    }
}
