//! Addresses as linear forms.

use crate::ir::{BinaryOp, Function, Op, Value};

/// `constant + Σ value · scale`, in bytes from the begin of a root, over 32-bit values. It is taken modulo 2³².
///
/// Terms are split where that cannot change the address, so that constants meet and common factors are seen: then a word index needs no
/// multiplication and shift, and a record's fields share one element index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Linear {
    /// The constant part.
    pub constant: i64,
    /// The variable parts, each value once.
    pub terms: Vec<(Value, i64)>,
}

impl Linear {
    /// A constant offset.
    pub fn constant(constant: i64) -> Self {
        Self { constant, terms: vec![] }
    }

    /// `value · scale`.
    pub fn term(value: Value, scale: i64) -> Self {
        Self { constant: 0, terms: vec![(value, scale)] }
    }

    /// So many bytes further.
    pub fn plus(&self, bytes: i64) -> Self {
        Self { constant: self.constant + bytes, terms: self.terms.clone() }
    }

    /// Adds `value · scale`. Sums with constants are split always, products and shifts only where no bit is lost (`exact`).
    pub fn add(&mut self, function: &Function, value: &Value, scale: i64) {
        if let Some(constant) = value.as_u32() {
            self.constant += i64::from(constant as i32) * scale;
            return;
        }
        let exact = value.as_inst().is_some_and(|id| function[id].exact);
        match function.op_of(value) {
            Some(Op::Copy(original)) => self.add(function, original, scale),
            Some(Op::Binary(op, a, b)) => match (op, b.as_u32()) {
                (BinaryOp::Add, Some(_)) => {
                    self.add(function, b, scale);
                    self.add(function, a, scale);
                }
                (BinaryOp::Or, Some(_)) if exact => {
                    self.add(function, b, scale);
                    self.add(function, a, scale);
                }
                (BinaryOp::Shl, Some(k @ 0..16)) if exact => self.add(function, a, scale << k),
                (BinaryOp::Mul, Some(k @ 0..0x10_0000)) if exact => {
                    self.add(function, a, scale * i64::from(k))
                }
                _ => self.add_whole(value, scale),
            },
            _ => self.add_whole(value, scale),
        }
    }

    fn add_whole(&mut self, value: &Value, scale: i64) {
        match self.terms.iter_mut().find(|term| term.0 == *value) {
            Some(term) => term.1 += scale,
            None => self.terms.push((value.clone(), scale)),
        }
    }

    /// The greatest common divisor of all parts; 0 for the constant 0.
    pub fn divisor(&self) -> i64 {
        self.terms.iter().fold(self.constant.abs(), |divisor, term| gcd(divisor, term.1))
    }

    /// Whether it is a multiple of `bytes`, whatever the values are.
    pub fn is_multiple_of(&self, bytes: i64) -> bool {
        self.divisor() % bytes == 0
    }

    /// Whether all variable parts are multiples of `bytes`.
    pub fn steps_are_multiples_of(&self, bytes: i64) -> bool {
        self.terms.iter().all(|term| term.1 % bytes == 0)
    }
}

/// The greatest common divisor; that of a number and 0 is the number's magnitude.
pub fn gcd(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Type;

    fn product(exact: bool) -> (Function, Value, Value) {
        let mut f = Function::default();
        let x = Value::Inst(f.push(Op::SpecConstant { id: 0, default: 0 }, Type::I32));
        let product = f.push(Op::Binary(BinaryOp::Mul, x.clone(), Value::u32(12)), Type::I32);
        f[product].exact = exact;
        let sum = f.push(Op::Binary(BinaryOp::Add, Value::Inst(product), Value::u32(u32::MAX)), Type::I32);
        (f, x, Value::Inst(sum))
    }

    #[test]
    fn constants_and_factors_come_out() {
        let (f, x, sum) = product(true);
        let mut linear = Linear::constant(8);
        linear.add(&f, &sum, 4);
        assert_eq!(linear, Linear { constant: 4, terms: vec![(x, 48)] });
        assert_eq!(linear.divisor(), 4);
        assert!(linear.steps_are_multiples_of(16) && !linear.is_multiple_of(16));
    }

    #[test]
    fn a_product_that_may_wrap_stays_whole() {
        let (f, x, sum) = product(false);
        let mut linear = Linear::default();
        linear.add(&f, &sum, 1);
        assert_eq!(linear.constant, -1);
        assert!(linear.terms.iter().all(|term| term.0 != x));
        assert!(!linear.is_multiple_of(4));
    }
}
