//! Types.

use super::Result;
use super::cursor::Cursor;
use super::lexer::Token;
use crate::ir::Type;

/// Words for types that no kernel can use; a value of one is refused where it is used.
const OTHERS: [&str; 9] =
    ["metadata", "label", "token", "half", "bfloat", "fp128", "x86_fp80", "ppc_fp128", "x86_amx"];

impl Cursor<'_> {
    /// A type. A function type, which only stands before a variadic callee, is [`Type::Other`].
    pub fn ty(&mut self) -> Result<Type> {
        let ty = self.plain_type()?;
        if self.peek() == Some(&Token::Mark('('))
            && matches!(ty, Type::Void | Type::Int(_) | Type::F32 | Type::Pointer)
        {
            self.skip_parentheses();
            return Ok(Type::Other("function".into()));
        }
        Ok(ty)
    }

    fn plain_type(&mut self) -> Result<Type> {
        match self.peek() {
            Some(Token::Word(word)) => self.type_word(word),
            Some(Token::Local(name)) => {
                self.take();
                self.names.types.get(name).cloned().ok_or_else(|| self.unknown(&format!("the type %{name}")))
            }
            Some(Token::Mark('{')) => Ok(Type::Struct(self.fields()?)),
            Some(Token::Mark('[')) => {
                self.take();
                let (n, element) = self.counted()?;
                self.expect_mark(']')?;
                Ok(Type::Array(n, Box::new(element)))
            }
            Some(Token::Mark('<')) => self.packed_or_vector(),
            _ => Err(self.unknown("something else than a type")),
        }
    }

    fn type_word(&mut self, word: &str) -> Result<Type> {
        let ty = match word {
            "void" => Type::Void,
            "float" => Type::F32,
            "double" => Type::F64,
            "ptr" => Type::Pointer,
            "opaque" => Type::Other(word.into()),
            _ if OTHERS.contains(&word) => Type::Other(word.into()),
            _ => match word.strip_prefix('i').and_then(|bits| bits.parse().ok()) {
                Some(bits @ 1..=128) => Type::Int(bits),
                _ => return Err(self.unknown(&format!("the type `{word}`"))),
            },
        };
        self.take();
        if ty == Type::Pointer && self.word() == "addrspace" {
            return Err(self.unknown("a pointer into another address space"));
        }
        Ok(ty)
    }

    fn packed_or_vector(&mut self) -> Result<Type> {
        self.expect_mark('<')?;
        let ty = if self.peek() == Some(&Token::Mark('{')) {
            Type::Packed(self.fields()?)
        } else {
            let (n, element) = self.counted()?;
            let n = u32::try_from(n).map_err(|_| self.unknown("a vector of so many elements"))?;
            Type::Vector(n, Box::new(element))
        };
        self.expect_mark('>')?;
        Ok(ty)
    }

    fn fields(&mut self) -> Result<Vec<Type>> {
        self.expect_mark('{')?;
        let mut fields = Vec::new();
        while !self.eat_mark('}') {
            fields.push(self.ty()?);
            self.eat_mark(',');
        }
        Ok(fields)
    }

    /// `n x type`.
    fn counted(&mut self) -> Result<(u64, Type)> {
        let n = self.number()?;
        self.expect("x")?;
        Ok((n, self.ty()?))
    }
}

#[cfg(test)]
mod tests {
    use super::super::cursor::{Locals, Names};
    use super::super::lexer::tokens;
    use super::*;

    fn ty(text: &str) -> Result<Type> {
        let tokens = tokens(text)?;
        Cursor::new(text, &tokens, &Names::default(), &Locals::default()).ty()
    }

    #[test]
    fn types_of_each_kind() {
        assert_eq!(ty("<4 x i32>"), Ok(Type::vec4()));
        assert_eq!(ty("<{ ptr, [2 x i8] }>").map(|t| t.size()), Ok(10));
        assert_eq!(ty("{ i32, i1 }"), Ok(Type::Struct(vec![Type::I32, Type::BOOL])));
        assert_eq!(ty("void (ptr, ...)"), Ok(Type::Other("function".into())));
        assert_eq!(ty("half"), Ok(Type::Other("half".into())));
    }

    #[test]
    fn unknown_types_are_named() {
        for (text, name) in
            [("x86_mmx", "x86_mmx"), ("ptr addrspace(3)", "address space"), ("%T", "%T"), ("i999", "i999")]
        {
            let error = ty(text).expect_err("not a type").to_string();
            assert!(error.contains(name), "{error}");
        }
    }
}
