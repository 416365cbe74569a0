//! The low words of integers of more than 32 bits.

use super::{Lowering, Translation};
use crate::ir::{BinaryOp, BlockId, CastOp, Id, MathOp, Op, SourceOp, Type, Value};

impl Lowering<'_> {
    /// The low 32 bits of an integer of any width. Those of a wide one are known since it was made.
    pub(super) fn low_word(&mut self, value: &Value) -> Value {
        if let Some(constant) = value.as_u32() {
            return Value::u32(constant);
        }
        let low = value.as_inst().and_then(|id| self.low.get(&id).cloned());
        match (low, self.build.resolve(value)) {
            (Some(low), _) => low,
            (None, Value::Undef(_)) => Value::u32(0),
            (None, value) => match self.build.type_of(&value) {
                Type::Int(33..) => self.build.cast(CastOp::Trunc, &value, Type::I32),
                _ => self.build.cast(CastOp::ZExt, &value, Type::I32),
            },
        }
    }

    /// Makes the low word of `id`, an integer of more than 32 bits that has just been translated.
    pub(super) fn make_low(&mut self, id: Id) {
        let low = match &self.source[id].op {
            Op::Phi(_) => self.build.emit(Op::Phi(vec![]), Type::I32),
            op => self.narrow(id, op).unwrap_or_else(|| {
                let whole = self.build.resolve(&Value::Inst(id));
                self.build.cast(CastOp::Trunc, &whole, Type::I32)
            }),
        };
        self.low.insert(id, low);
    }

    /// The low word computed from the low words of the operands, where that is possible.
    fn narrow(&mut self, id: Id, op: &Op) -> Option<Value> {
        Some(match op {
            Op::Binary(op, a, b) => return self.narrow_binary(id, *op, a, b),
            Op::Cast(op @ (CastOp::ZExt | CastOp::SExt), a) => {
                let a = self.build.resolve(a);
                match self.build.type_of(&a) {
                    Type::Int(33..) => self.low_word(&a),
                    _ => self.build.cast(*op, &a, Type::I32),
                }
            }
            Op::Cast(CastOp::Trunc, a) | Op::Copy(a) => self.low_word(a),
            Op::Select(condition, a, b) => {
                let (condition, a, b) = (self.build.resolve(condition), self.low_word(a), self.low_word(b));
                self.build.select(&condition, &a, &b)
            }
            Op::Source(SourceOp::Call(name, arguments)) => return self.narrow_call(name, arguments),
            _ => return None,
        })
    }

    fn narrow_binary(&mut self, id: Id, op: BinaryOp, a: &Value, b: &Value) -> Option<Value> {
        use BinaryOp::*;
        let narrow = match op {
            Add | Sub | Mul | And | Or | Xor => true,
            Shl => match b.as_int() {
                Some(0..32) => true,
                Some(_) => return Some(Value::u32(0)),
                None => false,
            },
            UDiv | URem => self.bounds.is_usize(a) && self.bounds.is_usize(b),
            LShr if self.bounds.is_index(id) && b.as_int().is_some_and(|k| k < 32) => self.bounds.is_usize(a),
            LShr => self.bounds.fits_word(a) && b.as_int().is_some_and(|k| k < 32),
            _ => false,
        };
        if !narrow {
            let amount = b.as_u32().filter(|amount| *amount < 64 && self.source[id].ty == Type::I64)?;
            return matches!(op, LShr | AShr).then(|| self.low_of_right_shift(op, a, amount));
        }
        let (x, y) = (self.low_word(a), self.low_word(b));
        let low = self.build.binary(op, &x, &y);
        let made = Op::Binary(op, x, y);
        if let Some(low) = low.as_inst().filter(|low| self.build.function[*low].op == made) {
            self.build.function[low].exact = self.loses_nothing(id, op);
        }
        Some(low)
    }

    /// Whether the low word of a product or a sum by `or` is the whole of it wherever it is used in an address: if it does not
    /// overflow 64 bits, and what it is used for is in range, then it does not overflow 32 bits either.
    fn loses_nothing(&self, id: Id, op: BinaryOp) -> bool {
        let fits = || self.bounds.upper(&Value::Inst(id)) < u128::from(u64::MAX);
        match op {
            BinaryOp::Or => self.source[id].exact,
            BinaryOp::Mul | BinaryOp::Shl => self.source[id].exact || fits(),
            _ => false,
        }
    }

    fn narrow_call(&mut self, name: &str, arguments: &[Value]) -> Option<Value> {
        let [a, b, ..] = arguments else { return None };
        if !self.bounds.is_usize(a) || !self.bounds.is_usize(b) {
            return None;
        }
        let (a, b) = (self.low_word(a), self.low_word(b));
        Some(match name {
            "llvm.umin.i64" => self.build.math(MathOp::UMin, vec![a, b]),
            "llvm.umax.i64" => self.build.math(MathOp::UMax, vec![a, b]),
            "llvm.usub.sat.i64" => {
                let smaller = self.build.math(MathOp::UMin, vec![a.clone(), b]);
                self.build.binary(BinaryOp::Sub, &a, &smaller)
            }
            _ => return None,
        })
    }

    /// The operands of a low word's phi.
    pub(super) fn close_low_phi(&mut self, id: Id, edges: &[(Value, BlockId)]) {
        let Some(Value::Inst(phi)) = self.low.get(&id).cloned() else { return };
        let edges = edges.iter().map(|(value, from)| (self.low_word(value), *from)).collect();
        self.build.function[phi].op = Op::Phi(edges);
    }

    /// A conversion of a 64-bit integer that needs the low word only.
    pub(super) fn narrow_cast(&mut self, op: CastOp, value: &Value, ty: &Type) -> Translation {
        match op {
            CastOp::Trunc => {
                let low = self.low_word(value);
                Translation::Value(self.build.cast(CastOp::Trunc, &low, ty.clone()))
            }
            CastOp::UiToFp | CastOp::SiToFp if self.bounds.fits_word(value) => {
                let low = self.low_word(value);
                Translation::Value(self.build.cast(CastOp::UiToFp, &low, ty.clone()))
            }
            _ => self.fold(&Op::Cast(op, value.clone()), ty),
        }
    }
}
