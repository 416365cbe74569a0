//! Integers of odd widths live in words.
//!
//! `i2` to `i31` are kept in 32 bits and `i33` to `i63` in 64, the bits above being anything. They are cleared, or filled with the sign,
//! only where they would change a result: before divisions, right shifts, comparisons, extensions and conversions to float.

use super::builder::Builder;
use crate::ir::{BinaryOp, CastOp, Function, Id, IntPredicate, Op, Type, Value, mask, sign_extend};

/// Rewrites all integers of odd widths.
pub fn odd_widths(function: &mut Function) {
    let types = function.instructions.iter().map(|instruction| instruction.ty.clone()).collect();
    let build = Builder { function: std::mem::take(function), ..Builder::default() };
    let mut promotion = Promotion { types, build };
    for block in 0..promotion.build.function.blocks.len() {
        let ids = std::mem::take(&mut promotion.build.function.blocks[block].instructions);
        ids.into_iter().for_each(|id| promotion.instruction(id));
        promotion.build.function.blocks[block].instructions = std::mem::take(&mut promotion.build.out);
    }
    *function = promotion.build.function;
}

/// The type that holds an integer of an odd width; `None` for other types.
fn container(ty: &Type) -> Option<Type> {
    match ty {
        Type::Int(2..=31) => Some(Type::I32),
        Type::Int(33..=63) => Some(Type::I64),
        _ => None,
    }
}

struct Promotion {
    /// The types before.
    types: Vec<Type>,
    build: Builder,
}

impl Promotion {
    fn instruction(&mut self, id: Id) {
        use BinaryOp::*;
        let ty = self.types[id.index()].clone();
        self.build.location = self.build.function[id].location;
        let op = match self.build.function[id].op.clone() {
            Op::Binary(op @ (LShr | UDiv | URem), a, b) => Op::Binary(op, self.zeros(&a), self.zeros(&b)),
            Op::Binary(AShr, a, b) => Op::Binary(AShr, self.signs(&a), self.zeros(&b)),
            Op::Binary(op @ (SDiv | SRem), a, b) => Op::Binary(op, self.signs(&a), self.signs(&b)),
            Op::Binary(Shl, a, b) => Op::Binary(Shl, self.any(&a), self.zeros(&b)),
            Op::IntCompare(predicate, a, b) if predicate.is_signed() => {
                Op::IntCompare(predicate, self.signs(&a), self.signs(&b))
            }
            Op::IntCompare(predicate, a, b) => Op::IntCompare(predicate, self.zeros(&a), self.zeros(&b)),
            Op::Cast(op, value) => self.cast(op, value, &ty),
            mut op => {
                op.for_each_operand_mut(|operand| *operand = self.any(operand));
                op
            }
        };
        let instruction = &mut self.build.function[id];
        instruction.op = op;
        instruction.ty = container(&ty).unwrap_or(ty);
        self.build.out.push(id);
    }

    fn cast(&mut self, op: CastOp, value: Value, ty: &Type) -> Op {
        let from = self.type_of(&value);
        let to = container(ty).unwrap_or_else(|| ty.clone());
        match op {
            CastOp::ZExt | CastOp::SExt | CastOp::UiToFp | CastOp::SiToFp => {
                let signed = matches!(op, CastOp::SExt | CastOp::SiToFp);
                let value = if signed { self.signs(&value) } else { self.zeros(&value) };
                let held = container(&from).unwrap_or(from);
                if held == to { Op::Copy(value) } else { Op::Cast(op, value) }
            }
            CastOp::Trunc => {
                let held = container(&from).unwrap_or(from);
                let value = self.any(&value);
                if *ty == Type::BOOL {
                    let bit = self.build.binary_const(BinaryOp::And, &value, 1);
                    return Op::IntCompare(IntPredicate::Ne, bit, Value::int(held.bits(), 0));
                }
                if held == to { Op::Copy(value) } else { Op::Cast(op, value) }
            }
            // The device's conversion of what fits is that of the wider type.
            _ => Op::Cast(op, self.any(&value)),
        }
    }

    fn type_of(&self, value: &Value) -> Type {
        match value {
            Value::Inst(id) if id.index() < self.types.len() => self.types[id.index()].clone(),
            value => self.build.type_of(value),
        }
    }

    /// The value in its container, the bits above being anything.
    fn any(&self, value: &Value) -> Value {
        match (container(&self.type_of(value)), value) {
            (Some(held), Value::Undef(_) | Value::Zero(_)) => Value::int(held.bits(), 0),
            (Some(held), Value::Int(_, number)) => Value::int(held.bits(), *number),
            _ => value.clone(),
        }
    }

    /// The value in its container, the bits above being zero.
    fn zeros(&mut self, value: &Value) -> Value {
        let ty = self.type_of(value);
        let value = self.any(value);
        match (container(&ty), value.as_int()) {
            (Some(held), None) => {
                let ones = Value::int(held.bits(), mask(ty.bits()));
                self.build.emit(Op::Binary(BinaryOp::And, value, ones), held)
            }
            _ => value,
        }
    }

    /// The value in its container, the bits above being those of the sign.
    fn signs(&mut self, value: &Value) -> Value {
        let ty = self.type_of(value);
        let value = self.any(value);
        let Some(held) = container(&ty) else { return value };
        if let Some(number) = value.as_int() {
            return Value::int(held.bits(), sign_extend(number, ty.bits()) as u128);
        }
        let shift = Value::int(held.bits(), (held.bits() - ty.bits()).into());
        let high = self.build.emit(Op::Binary(BinaryOp::Shl, value, shift.clone()), held.clone());
        self.build.emit(Op::Binary(BinaryOp::AShr, high, shift), held)
    }
}
