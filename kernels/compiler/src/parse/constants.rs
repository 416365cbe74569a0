//! Operands: names and constants.

use super::Result;
use super::cursor::Cursor;
use super::lexer::Token;
use crate::ir::{Type, Value, mask, sign_extend};

impl Cursor<'_> {
    /// A type and a value of it.
    pub fn typed_value(&mut self) -> Result<(Type, Value)> {
        let ty = self.ty()?;
        self.skip_attributes();
        let value = self.value(&ty)?;
        Ok((ty, value))
    }

    /// A value of type `ty`.
    pub fn value(&mut self, ty: &Type) -> Result<Value> {
        match self.take() {
            Some(Token::Local(name)) => {
                let id = self.locals.values.get(name).copied();
                id.map(Value::Inst).ok_or_else(|| self.unknown(&format!("the value %{name}")))
            }
            Some(Token::Global(name)) => Ok(Value::Global(name.as_str().into(), 0)),
            Some(Token::Number(number)) => self.number_of_type(number, ty),
            Some(Token::Text(bytes)) => Ok(Value::Bytes(bytes.as_slice().into())),
            Some(Token::Word(word)) => self.constant_word(word, ty),
            Some(Token::Mark('[')) => self.elements(ty, ']'),
            Some(Token::Mark('{')) => self.elements(ty, '}'),
            Some(Token::Mark('<')) if self.eat_mark('{') => {
                let value = self.elements(ty, '}')?;
                self.expect_mark('>')?;
                Ok(value)
            }
            Some(Token::Mark('<')) => self.elements(ty, '>'),
            _ => Err(self.unknown("something else than a value")),
        }
    }

    fn number_of_type(&self, number: &str, ty: &Type) -> Result<Value> {
        let bad = || self.unknown(&format!("the number `{number}`"));
        match ty {
            Type::Int(bits) => {
                let value: i128 = number.parse().map_err(|_| bad())?;
                Ok(Value::int(*bits, value as u128))
            }
            Type::F32 => Ok(Value::F32(narrow(double(number).ok_or_else(bad)?))),
            Type::F64 => Ok(Value::F64(double(number).ok_or_else(bad)?.to_bits())),
            _ => Err(bad()),
        }
    }

    fn constant_word(&mut self, word: &str, ty: &Type) -> Result<Value> {
        match word {
            "true" => Ok(Value::bool(true)),
            "false" => Ok(Value::bool(false)),
            "null" | "zeroinitializer" => Ok(Value::Zero(ty.clone())),
            "undef" | "poison" => Ok(Value::Undef(ty.clone())),
            "splat" => self.splat(ty),
            "getelementptr" => self.constant_address(),
            "inttoptr" => self.dangling(),
            _ => Err(self.unknown(&format!("the constant `{word}`"))),
        }
    }

    /// The elements of a constant aggregate, up to `close`.
    fn elements(&mut self, ty: &Type, close: char) -> Result<Value> {
        let mut elements = Vec::new();
        while !self.eat_mark(close) {
            elements.push(self.typed_value()?.1);
            self.eat_mark(',');
        }
        Ok(Value::Aggregate(ty.clone(), elements.into()))
    }

    fn splat(&mut self, ty: &Type) -> Result<Value> {
        let Type::Vector(n, _) = ty else {
            return Err(self.unknown("a splat that is no vector"));
        };
        self.expect_mark('(')?;
        let value = self.typed_value()?.1;
        self.expect_mark(')')?;
        Ok(Value::Aggregate(ty.clone(), vec![value; *n as usize].into()))
    }

    /// `getelementptr (type, ptr @global, i64 …)`.
    fn constant_address(&mut self) -> Result<Value> {
        self.flags()?;
        self.expect_mark('(')?;
        let ty = self.ty()?;
        self.expect_mark(',')?;
        let base = self.typed_value()?.1;
        let mut indices = Vec::new();
        while self.eat_mark(',') {
            self.eat("inrange");
            indices.push(self.typed_value()?.1);
        }
        self.expect_mark(')')?;
        match (base, constant_offset(&ty, &indices)) {
            (Value::Global(name, start), Some(offset)) => Ok(Value::Global(name, start + offset)),
            _ => Err(self.unknown("a constant address")),
        }
    }

    /// `inttoptr (i64 4 to ptr)`: the pointer of an empty slice, which nobody follows.
    fn dangling(&mut self) -> Result<Value> {
        self.expect_mark('(')?;
        let (_, value) = self.typed_value()?;
        self.expect("to")?;
        let ty = self.ty()?;
        self.expect_mark(')')?;
        match value.as_int() {
            Some(1..=16) if ty == Type::Pointer => Ok(Value::Undef(ty)),
            _ => Err(self.unknown("a pointer made from an integer")),
        }
    }
}

/// The offset in bytes that constant indices into a `ty` mean.
pub fn constant_offset(ty: &Type, indices: &[Value]) -> Option<i64> {
    let index = |value: &Value| match value {
        Value::Int(bits @ (32 | 64), x) => i64::try_from(sign_extend(*x, *bits)).ok(),
        _ => None,
    };
    let (first, rest) = indices.split_first()?;
    let mut offset = index(first)? * ty.stride() as i64;
    let mut ty = ty.clone();
    for value in rest {
        let k = index(value)?;
        ty = match ty {
            Type::Struct(_) | Type::Packed(_) => {
                let k = usize::try_from(k).ok()?;
                offset += ty.field_offset(k) as i64;
                ty.fields()?.get(k)?.clone()
            }
            Type::Array(_, element) | Type::Vector(_, element) => {
                offset += k * element.stride() as i64;
                *element
            }
            _ => return None,
        };
    }
    Some(offset)
}

/// LLVM writes a float as a decimal that is exact, or as the bits of the `double` of the same value.
fn double(number: &str) -> Option<f64> {
    match number.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).ok().map(f64::from_bits),
        None => number.parse().ok(),
    }
}

/// The bits of the `f32` of the same value; a NaN keeps the payload that fits.
fn narrow(value: f64) -> u32 {
    if !value.is_nan() {
        return (value as f32).to_bits();
    }
    let bits = value.to_bits();
    let payload = (bits >> 29) as u32 & mask(23) as u32;
    (bits >> 32) as u32 & 0x8000_0000 | 0x7f80_0000 | payload
}

#[cfg(test)]
mod tests {
    use super::super::cursor::{Locals, Names};
    use super::super::lexer::tokens;
    use super::*;

    fn value(text: &str) -> Result<Value> {
        let tokens = tokens(text)?;
        Cursor::new(text, &tokens, &Names::default(), &Locals::default()).typed_value().map(|v| v.1)
    }

    #[test]
    fn numbers() {
        assert_eq!(value("i8 -1"), Ok(Value::Int(8, 255)));
        assert_eq!(value("float 0x3FB99999A0000000"), Ok(Value::f32(0.1)));
        assert_eq!(value("float -1.500000e+00"), Ok(Value::f32(-1.5)));
        assert_eq!(value("float 0x7FF8000000000000"), Ok(Value::F32(0x7fc0_0000)));
        assert_eq!(value("float 0xFFF0000000000000"), Ok(Value::f32(f32::NEG_INFINITY)));
        assert_eq!(value("float 0x36A0000000000000"), Ok(Value::F32(1)), "the least denormal");
    }

    #[test]
    fn aggregates_and_addresses() {
        let pair = value("<2 x i32> <i32 1, i32 2>");
        let ty = Type::Vector(2, Box::new(Type::I32));
        assert_eq!(pair, Ok(Value::Aggregate(ty.clone(), [1, 2].map(Value::u32).into())));
        assert_eq!(value("<2 x i32> splat (i32 7)"), Ok(Value::Aggregate(ty, [7, 7].map(Value::u32).into())));
        let address =
            value("ptr getelementptr inbounds nuw ({ i8, [3 x i32] }, ptr @t, i64 1, i32 1, i64 2)");
        assert_eq!(address, Ok(Value::Global("t".into(), 28)));
        assert_eq!(value("ptr inttoptr (i64 4 to ptr)"), Ok(Value::Undef(Type::Pointer)));
    }

    #[test]
    fn unknown_constants_are_named() {
        for (text, name) in
            [("ptr blockaddress(@f, %b)", "blockaddress"), ("ptr inttoptr (i64 4096 to ptr)", "integer")]
        {
            let error = value(text).expect_err("not a constant").to_string();
            assert!(error.contains(name), "{error}");
        }
    }
}
