//! Tokens of a line.

use super::Result;
use crate::refusal::Reason;

/// A token.
#[derive(Clone, PartialEq, Debug)]
pub enum Token {
    /// A keyword, or a label without its colon.
    Word(String),
    /// `%name`, without the sign.
    Local(String),
    /// `@name`, without the sign.
    Global(String),
    /// `!name`, `#number` or `$name`.
    Metadata,
    /// A number as it is written.
    Number(String),
    /// A string or `c"…"`, its escapes resolved.
    Text(Vec<u8>),
    /// Any other character.
    Mark(char),
}

/// The tokens of `line`, without comments.
pub fn tokens(line: &str) -> Result<Vec<Token>> {
    let mut lexer = Lexer { bytes: line.as_bytes(), at: 0 };
    let mut tokens = Vec::new();
    while let Some(token) = lexer.next()? {
        tokens.push(token);
    }
    Ok(tokens)
}

struct Lexer<'a> {
    bytes: &'a [u8],
    at: usize,
}

fn in_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'$' | b'-')
}

impl Lexer<'_> {
    fn peek(&self, ahead: usize) -> Option<u8> {
        self.bytes.get(self.at + ahead).copied()
    }

    fn next(&mut self) -> Result<Option<Token>> {
        while self.peek(0).is_some_and(|b| b.is_ascii_whitespace()) {
            self.at += 1;
        }
        let Some(byte) = self.peek(0).filter(|b| *b != b';') else {
            return Ok(None);
        };
        Ok(Some(match byte {
            b'"' => Token::Text(self.quoted()?),
            b'c' if self.peek(1) == Some(b'"') => {
                self.at += 1;
                Token::Text(self.quoted()?)
            }
            b'%' => Token::Local(self.sigil_name()?),
            b'@' => Token::Global(self.sigil_name()?),
            b'!' | b'#' | b'$' => {
                self.sigil_name()?;
                Token::Metadata
            }
            b'-' | b'+' | b'0'..=b'9' => Token::Number(self.number()),
            _ if in_name(byte) => Token::Word(self.name()),
            _ => {
                self.at += 1;
                Token::Mark(char::from(byte))
            }
        }))
    }

    fn take(&mut self, wanted: impl Fn(u8) -> bool) -> String {
        let start = self.at;
        while self.peek(0).is_some_and(&wanted) {
            self.at += 1;
        }
        String::from_utf8_lossy(&self.bytes[start..self.at]).into_owned()
    }

    fn name(&mut self) -> String {
        self.take(in_name)
    }

    /// The name behind a sign, quoted or not.
    fn sigil_name(&mut self) -> Result<String> {
        self.at += 1;
        if self.peek(0) == Some(b'"') {
            return Ok(String::from_utf8_lossy(&self.quoted()?).into_owned());
        }
        Ok(self.name())
    }

    /// Decimal (with a fraction and an exponent) or hexadecimal. A label may begin like one.
    fn number(&mut self) -> String {
        let start = self.at;
        self.at += 1;
        while let Some(byte) = self.peek(0) {
            let exponent_sign = matches!(byte, b'+' | b'-') && self.bytes[self.at - 1] == b'e';
            if !(byte.is_ascii_alphanumeric() || byte == b'.' || byte == b'_' || exponent_sign) {
                break;
            }
            self.at += 1;
        }
        String::from_utf8_lossy(&self.bytes[start..self.at]).into_owned()
    }

    fn quoted(&mut self) -> Result<Vec<u8>> {
        self.at += 1;
        let mut out = Vec::new();
        loop {
            let byte = self.peek(0).ok_or_else(|| Reason::Unknown("a string without an end".into()))?;
            self.at += 1;
            match byte {
                b'"' => return Ok(out),
                b'\\' => out.push(self.escape().unwrap_or(byte)),
                _ => out.push(byte),
            }
        }
    }

    /// The byte of two hexadecimal digits.
    fn escape(&mut self) -> Option<u8> {
        let digit = |byte: u8| char::from(byte).to_digit(16);
        let value = digit(self.peek(0)?)? * 16 + digit(self.peek(1)?)?;
        self.at += 2;
        Some(value as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_each_kind() {
        let line = r#"%"a b".i = fadd float %x-y, 0x3FF0000000000000, -1.5e+01, @f ; gone"#;
        let word = |w: &str| Token::Word(w.into());
        let expected = [
            Token::Local("a b".into()),
            word(".i"),
            Token::Mark('='),
            word("fadd"),
            word("float"),
            Token::Local("x-y".into()),
            Token::Mark(','),
            Token::Number("0x3FF0000000000000".into()),
            Token::Mark(','),
            Token::Number("-1.5e+01".into()),
            Token::Mark(','),
            Token::Global("f".into()),
        ];
        assert_eq!(tokens(line), Ok(expected.to_vec()));
        assert_eq!(tokens(r#"c"a\00\FF\\""#), Ok(vec![Token::Text(b"a\0\xff\\\\".to_vec())]));
        assert!(tokens("c\"no end").is_err());
    }
}
