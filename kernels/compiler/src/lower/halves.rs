//! The high words of 64-bit integers, and what needs both halves.
//!
//! Rust hands pairs of words around as one `i64`, and some kernels count in `u64`. Devices without 64-bit integers do with two words:
//! each `i64` has a low word (see [`narrow`](super::narrow)) and a high one. Divisions, shifts by variable amounts and conversions to
//! float have no such form; a value of theirs stays wide.

use super::Lowering;
use crate::ir::{BinaryOp, BlockId, CastOp, Id, IntPredicate, Op, Type, Value};

impl Lowering<'_> {
    /// The high word of an `i64`.
    pub(super) fn high_word(&mut self, value: &Value) -> Value {
        if let Some(constant) = value.as_int() {
            return Value::u32((constant >> 32) as u32);
        }
        match value.as_inst().and_then(|id| self.high.get(&id).cloned()) {
            Some(high) => high,
            None if value.is_undef() => Value::u32(0),
            None => self.upper_half(value),
        }
    }

    /// The high word taken out of the whole value.
    fn upper_half(&mut self, value: &Value) -> Value {
        let whole = self.build.resolve(value);
        let high = self.build.binary_const(BinaryOp::LShr, &whole, 32);
        self.build.cast(CastOp::Trunc, &high, Type::I32)
    }

    /// Makes the high word of `id`, an `i64` whose low word has just been made.
    pub(super) fn make_high(&mut self, id: Id) {
        let value = Value::Inst(id);
        let high = match &self.source[id].op {
            Op::Phi(_) => self.build.emit(Op::Phi(vec![]), Type::I32),
            _ if self.bounds.fits_word(&value) => Value::u32(0),
            op => self.high_of(id, op).unwrap_or_else(|| self.upper_half(&value)),
        };
        self.high.insert(id, high);
    }

    /// The high word computed from words, where that is possible.
    fn high_of(&mut self, id: Id, op: &Op) -> Option<Value> {
        match op {
            Op::Binary(op, a, b) => self.high_of_binary(id, *op, a, b),
            Op::Cast(CastOp::SExt, a) if self.source.type_of(a).bits() <= 32 => {
                let a = self.build.resolve(a);
                let word = self.build.cast(CastOp::SExt, &a, Type::I32);
                Some(self.build.binary_const(BinaryOp::AShr, &word, 31))
            }
            Op::Select(condition, a, b) => {
                let (condition, a, b) = (self.build.resolve(condition), self.high_word(a), self.high_word(b));
                Some(self.build.select(&condition, &a, &b))
            }
            Op::Copy(a) => Some(self.high_word(a)),
            _ => None,
        }
    }

    fn high_of_binary(&mut self, id: Id, op: BinaryOp, a: &Value, b: &Value) -> Option<Value> {
        use BinaryOp::*;
        if let Shl | LShr | AShr = op {
            return self.high_of_shift(op, a, b.as_u32().filter(|amount| *amount < 64)?);
        }
        let ((low_a, high_a), (low_b, high_b)) = (self.halves(a), self.halves(b));
        let high = match op {
            And | Or | Xor => self.build.binary(op, &high_a, &high_b),
            Add => {
                let low = self.low_word(&Value::Inst(id));
                let carry = self.build.compare(IntPredicate::Ult, &low, &low_a);
                let carry = self.build.cast(CastOp::ZExt, &carry, Type::I32);
                let sum = self.build.binary(Add, &high_a, &high_b);
                self.build.binary(Add, &sum, &carry)
            }
            Sub => {
                let borrow = self.build.compare(IntPredicate::Ult, &low_a, &low_b);
                let borrow = self.build.cast(CastOp::ZExt, &borrow, Type::I32);
                let difference = self.build.binary(Sub, &high_a, &high_b);
                self.build.binary(Sub, &difference, &borrow)
            }
            Mul => {
                let high = self.build.emit(Op::MulHigh(low_a.clone(), low_b.clone()), Type::I32);
                let (x, y) =
                    (self.build.binary(Mul, &low_a, &high_b), self.build.binary(Mul, &high_a, &low_b));
                let high = self.build.binary(Add, &high, &x);
                self.build.binary(Add, &high, &y)
            }
            _ => return None,
        };
        Some(high)
    }

    fn high_of_shift(&mut self, op: BinaryOp, a: &Value, amount: u32) -> Option<Value> {
        let (low, high) = self.halves(a);
        Some(match (op, amount) {
            (_, 0) => high,
            (BinaryOp::Shl, 32..) => self.build.binary_const(BinaryOp::Shl, &low, (amount - 32).into()),
            (BinaryOp::Shl, _) => self.across(&low, &high, 32 - amount),
            (BinaryOp::LShr, 32..) => Value::u32(0),
            (_, 32..) => self.build.binary_const(BinaryOp::AShr, &high, 31),
            _ => self.build.binary_const(op, &high, amount.into()),
        })
    }

    /// The low word of a right shift by a constant.
    pub(super) fn low_of_right_shift(&mut self, op: BinaryOp, a: &Value, amount: u32) -> Value {
        let (low, high) = self.halves(a);
        match amount {
            0 => low,
            1..32 => self.across(&low, &high, amount),
            _ => self.build.binary_const(op, &high, (amount - 32).into()),
        }
    }

    /// The word that begins at bit `from` (1 to 31) of two words.
    fn across(&mut self, low: &Value, high: &Value, from: u32) -> Value {
        let x = self.build.binary_const(BinaryOp::LShr, low, from.into());
        let y = self.build.binary_const(BinaryOp::Shl, high, (32 - from).into());
        self.build.binary(BinaryOp::Or, &x, &y)
    }

    fn halves(&mut self, value: &Value) -> (Value, Value) {
        (self.low_word(value), self.high_word(value))
    }

    /// The operands of a high word's phi.
    pub(super) fn close_high_phi(&mut self, id: Id, edges: &[(Value, BlockId)]) {
        let Some(Value::Inst(phi)) = self.high.get(&id).cloned() else { return };
        let edges = edges.iter().map(|(value, from)| (self.high_word(value), *from)).collect();
        self.build.function[phi].op = Op::Phi(edges);
    }

    /// A comparison of both halves: the high ones decide unless they are equal.
    pub(super) fn compare_halves(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Value {
        use IntPredicate::*;
        let ((low_a, high_a), (low_b, high_b)) = (self.halves(a), self.halves(b));
        let (strict, low) = match predicate {
            Eq | Ne => {
                let (x, y) = (
                    self.build.compare(predicate, &low_a, &low_b),
                    self.build.compare(predicate, &high_a, &high_b),
                );
                let op = if predicate == Eq { BinaryOp::And } else { BinaryOp::Or };
                return self.build.binary(op, &x, &y);
            }
            Ugt => (Ugt, Ugt),
            Uge => (Ugt, Uge),
            Ult => (Ult, Ult),
            Ule => (Ult, Ule),
            Sgt => (Sgt, Ugt),
            Sge => (Sgt, Uge),
            Slt => (Slt, Ult),
            Sle => (Slt, Ule),
        };
        let decided = self.build.compare(strict, &high_a, &high_b);
        let equal = self.build.compare(Eq, &high_a, &high_b);
        let low = self.build.compare(low, &low_a, &low_b);
        let low = self.build.binary(BinaryOp::And, &equal, &low);
        self.build.binary(BinaryOp::Or, &decided, &low)
    }
}
