//! Appends instructions to a block under construction, folding as it goes.

use super::fold::fold;
use crate::ir::{
    BinaryOp, CastOp, FloatPredicate, Function, Id, IntPredicate, MathOp, Op, SourceOp, Type, Value,
};

/// A function and the block that is being written.
#[derive(Debug, Default)]
pub struct Builder {
    /// The function.
    pub function: Function,
    /// The instructions of the block so far.
    pub out: Vec<Id>,
    /// Where new instructions come from.
    pub location: Option<u32>,
}

impl Builder {
    /// Appends `op`, unless its value is known already.
    pub fn emit(&mut self, op: impl Into<Op>, ty: Type) -> Value {
        let op = op.into();
        if let Some(value) = fold(&self.function, &op, &ty) {
            return value;
        }
        Value::Inst(self.append(op, ty))
    }

    /// Appends an instruction that makes no value.
    pub fn effect(&mut self, op: Op) {
        self.append(op, Type::Void);
    }

    fn append(&mut self, op: Op, ty: Type) -> Id {
        let id = self.function.push(op, ty);
        self.function[id].location = self.location;
        self.out.push(id);
        id
    }

    /// What `value` is a copy of.
    pub fn resolve(&self, value: &Value) -> Value {
        let mut value = value;
        while let Some(Op::Copy(original)) = self.function.op_of(value) {
            value = original;
        }
        value.clone()
    }

    /// The type of a value.
    pub fn type_of(&self, value: &Value) -> Type {
        self.function.type_of(value)
    }

    /// Arithmetic in the type of `a`.
    pub fn binary(&mut self, op: BinaryOp, a: &Value, b: &Value) -> Value {
        let ty = self.type_of(a);
        self.emit(Op::Binary(op, a.clone(), b.clone()), ty)
    }

    /// Arithmetic with a constant, in the type of `a`.
    pub fn binary_const(&mut self, op: BinaryOp, a: &Value, b: u128) -> Value {
        let b = Value::int(self.type_of(a).bits(), b);
        self.binary(op, a, &b)
    }

    /// A comparison of integers.
    pub fn compare(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Value {
        self.emit(Op::IntCompare(predicate, a.clone(), b.clone()), Type::BOOL)
    }

    /// A comparison of integers with a constant.
    pub fn compare_const(&mut self, predicate: IntPredicate, a: &Value, b: u128) -> Value {
        let b = Value::int(self.type_of(a).bits(), b);
        self.compare(predicate, a, &b)
    }

    /// A comparison of floats.
    pub fn compare_float(&mut self, predicate: FloatPredicate, a: &Value, b: &Value) -> Value {
        self.emit(Op::FloatCompare(predicate, a.clone(), b.clone()), Type::BOOL)
    }

    /// `a` if the condition holds, else `b`.
    pub fn select(&mut self, condition: &Value, a: &Value, b: &Value) -> Value {
        let ty = self.type_of(a);
        self.emit(Op::Select(condition.clone(), a.clone(), b.clone()), ty)
    }

    /// The value converted to `ty`, if it is of another type.
    pub fn cast(&mut self, op: CastOp, value: &Value, ty: Type) -> Value {
        if self.type_of(value) == ty {
            return value.clone();
        }
        self.emit(Op::Cast(op, value.clone()), ty)
    }

    /// A function of words or floats, in the type of its first argument.
    pub fn math(&mut self, op: MathOp, arguments: Vec<Value>) -> Value {
        let ty = arguments.first().map_or(Type::Void, |a| self.type_of(a));
        self.emit(Op::Math(op, arguments), ty)
    }

    /// A struct of two values.
    pub fn pair(&mut self, first: Value, second: Value) -> Value {
        let ty = Type::Struct(vec![self.type_of(&first), self.type_of(&second)]);
        let half = self.emit(SourceOp::InsertValue(Value::Undef(ty.clone()), first, vec![0]), ty.clone());
        self.emit(SourceOp::InsertValue(half, second, vec![1]), ty)
    }
}
