//! A place in the tokens of one line.

use super::Result;
use super::lexer::Token;
use crate::ir::{BlockId, Id, Type};
use crate::refusal::Reason;
use std::collections::HashMap;
use std::sync::Arc;

/// What names stand for.
#[derive(Default)]
pub struct Names {
    /// Named types of the module.
    pub types: HashMap<String, Type>,
}

/// What names of a function stand for.
#[derive(Default)]
pub struct Locals {
    /// Instructions by the name of their result.
    pub values: HashMap<String, Id>,
    /// Blocks by label.
    pub blocks: HashMap<String, BlockId>,
}

/// Reads one line from left to right.
pub struct Cursor<'a> {
    tokens: &'a [Token],
    at: usize,
    text: &'a str,
    pub(super) names: &'a Names,
    pub(super) locals: &'a Locals,
}

impl<'a> Cursor<'a> {
    /// At the begin of `tokens`, which are those of `text`.
    pub fn new(text: &'a str, tokens: &'a [Token], names: &'a Names, locals: &'a Locals) -> Self {
        Self { tokens, at: 0, text, names, locals }
    }

    /// The next token.
    pub fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    /// Takes the next token.
    pub fn take(&mut self) -> Option<&'a Token> {
        let token = self.tokens.get(self.at);
        self.at += 1;
        token
    }

    /// Leaves the next token out.
    pub fn skip(&mut self) {
        self.at += 1;
    }

    /// The next token, if it is a word; else nothing.
    pub fn word(&self) -> &'a str {
        match self.peek() {
            Some(Token::Word(word)) => word,
            _ => "",
        }
    }

    /// Takes `word` if it comes next.
    pub fn eat(&mut self, word: &str) -> bool {
        let next = self.word() == word;
        self.at += usize::from(next);
        next
    }

    /// Takes `mark` if it comes next.
    pub fn eat_mark(&mut self, mark: char) -> bool {
        let next = self.peek() == Some(&Token::Mark(mark));
        self.at += usize::from(next);
        next
    }

    /// Takes a comma, unless metadata follow it: they say nothing of what is computed.
    pub fn eat_comma_before_operand(&mut self) -> bool {
        self.tokens.get(self.at + 1) != Some(&Token::Metadata) && self.eat_mark(',')
    }

    /// Takes `word`, which must come next.
    pub fn expect(&mut self, word: &str) -> Result<()> {
        if self.eat(word) { Ok(()) } else { Err(self.unknown(&format!("something else than `{word}`"))) }
    }

    /// Takes `mark`, which must come next.
    pub fn expect_mark(&mut self, mark: char) -> Result<()> {
        if self.eat_mark(mark) { Ok(()) } else { Err(self.unknown(&format!("something else than `{mark}`"))) }
    }

    /// Takes a whole number.
    pub fn number<T: std::str::FromStr>(&mut self) -> Result<T> {
        match self.peek() {
            Some(Token::Number(number)) => {
                let value = number.parse().map_err(|_| self.unknown(&format!("the number `{number}`")))?;
                self.at += 1;
                Ok(value)
            }
            _ => Err(self.unknown("something else than a number")),
        }
    }

    /// Takes the name of a global.
    pub fn global(&mut self) -> Option<Arc<str>> {
        match self.peek() {
            Some(Token::Global(name)) => {
                self.at += 1;
                Some(name.as_str().into())
            }
            _ => None,
        }
    }

    /// Takes `label %block`.
    pub fn label(&mut self) -> Result<BlockId> {
        self.expect("label")?;
        self.block()
    }

    /// Takes `%block`.
    pub fn block(&mut self) -> Result<BlockId> {
        match self.take() {
            Some(Token::Local(name)) => self
                .locals
                .blocks
                .get(name)
                .copied()
                .ok_or_else(|| self.unknown(&format!("the block %{name}"))),
            _ => Err(self.unknown("something else than a block")),
        }
    }

    /// Skips `( … )` if it comes next.
    pub fn skip_parentheses(&mut self) {
        let mut depth = 0;
        while let Some(token) = self.peek() {
            match token {
                Token::Mark('(') => depth += 1,
                Token::Mark(')') if depth > 0 => depth -= 1,
                _ if depth == 0 => return,
                _ => {}
            }
            self.at += 1;
            if depth == 0 {
                return;
            }
        }
    }

    /// A refusal that names what is not known, and where.
    pub fn unknown(&self, what: &str) -> Reason {
        let text: String = self.text.trim().chars().take(120).collect();
        Reason::Unknown(format!("{what} (in the IR `{text}`)"))
    }
}
