//! Operations that make a value, as expressions.

use super::{EmitError, Writer, type_name};
use crate::ir::{BinaryOp, CastOp, FloatPredicate, IntPredicate, Op, Type, Value};

impl Writer<'_> {
    pub fn expression(&mut self, op: &Op, ty: &Type) -> Result<String, EmitError> {
        match op {
            Op::Binary(op, a, b) => self.binary(*op, ty, a, b),
            Op::IntCompare(predicate, a, b) => self.compare_integers(*predicate, a, b),
            Op::FloatCompare(predicate, a, b) => self.compare_floats(*predicate, a, b),
            Op::Select(condition, a, b) => {
                let (condition, a, b) = (self.value(condition)?, self.value(a)?, self.value(b)?);
                Ok(format!("select({b}, {a}, {condition})"))
            }
            Op::Cast(cast, value) => self.cast(*cast, value, ty),
            Op::FloatNegate(value) => Ok(format!("-({})", self.value(value)?)),
            Op::Copy(value) => self.value(value),
            Op::LoadWord(root, index) => self.load_word(*root, index),
            Op::LoadVec4(root, element) => self.load_vec4(*root, element),
            Op::Component(vector, component) => {
                Ok(format!("{}[{}]", self.value(vector)?, self.value(component)?))
            }
            Op::AtomicWord(op, root, index, operand) => self.atomic(*op, *root, index, operand),
            Op::CompareExchangeWord(root, index, expected, new) => {
                self.compare_exchange(*root, index, expected, new)
            }
            Op::AtomicLoadWord(root, index) => self.atomic_load(*root, index),
            Op::WordCount(root) => Ok(self.word_count(*root)),
            Op::Math(function, arguments) => self.math(*function, arguments),
            Op::MulHigh(a, b) => {
                self.mul_high = true;
                Ok(format!("mul_high({}, {})", self.value(a)?, self.value(b)?))
            }
            Op::Builtin(builtin, component) => Ok(self.builtin(*builtin, *component)),
            Op::SpecConstant { id, default } => Ok(self.spec_constant(*id, *default)),
            Op::Subgroup(op, arguments) => self.subgroup(*op, arguments),
            other => Err(EmitError::unsupported(other, "WGSL")),
        }
    }

    fn binary(&mut self, op: BinaryOp, ty: &Type, a: &Value, b: &Value) -> Result<String, EmitError> {
        let (x, y) = (self.value(a)?, self.value(b)?);
        if *ty == Type::BOOL {
            return truth_operator(op).map(|operator| format!("({x} {operator} {y})"));
        }
        Ok(match op {
            BinaryOp::SDiv => format!("bitcast<u32>(bitcast<i32>({x}) / bitcast<i32>({y}))"),
            BinaryOp::SRem => format!("bitcast<u32>(bitcast<i32>({x}) % bitcast<i32>({y}))"),
            BinaryOp::AShr => format!("bitcast<u32>(bitcast<i32>({x}) >> ({y} & 31u))"),
            // A constant amount of 32 or more, whose result LLVM does not use, would be an error.
            BinaryOp::Shl | BinaryOp::LShr => format!("({x} {} ({y} & 31u))", operator(op)),
            op => format!("({x} {} {y})", operator(op)),
        })
    }

    fn compare_integers(
        &mut self,
        predicate: IntPredicate,
        a: &Value,
        b: &Value,
    ) -> Result<String, EmitError> {
        let (mut a, mut b) = (self.value(a)?, self.value(b)?);
        if predicate.is_signed() {
            (a, b) = (format!("bitcast<i32>({a})"), format!("bitcast<i32>({b})"));
        }
        let operator = match predicate {
            IntPredicate::Eq => "==",
            IntPredicate::Ne => "!=",
            IntPredicate::Ugt | IntPredicate::Sgt => ">",
            IntPredicate::Uge | IntPredicate::Sge => ">=",
            IntPredicate::Ult | IntPredicate::Slt => "<",
            IntPredicate::Ule | IntPredicate::Sle => "<=",
        };
        Ok(format!("({a} {operator} {b})"))
    }

    /// WGSL's comparisons are false for NaNs; the unordered ones are the opposite of the opposite.
    fn compare_floats(
        &mut self,
        predicate: FloatPredicate,
        a: &Value,
        b: &Value,
    ) -> Result<String, EmitError> {
        let (x, y) = (self.value(a)?, self.value(b)?);
        Ok(match predicate {
            FloatPredicate::Oeq => format!("({x} == {y})"),
            FloatPredicate::Ogt => format!("({x} > {y})"),
            FloatPredicate::Oge => format!("({x} >= {y})"),
            FloatPredicate::Olt => format!("({x} < {y})"),
            FloatPredicate::Ole => format!("({x} <= {y})"),
            FloatPredicate::One => format!("(({x} < {y}) || ({x} > {y}))"),
            FloatPredicate::Ueq => format!("!(({x} < {y}) || ({x} > {y}))"),
            FloatPredicate::Ugt => format!("!({x} <= {y})"),
            FloatPredicate::Uge => format!("!({x} < {y})"),
            FloatPredicate::Ult => format!("!({x} >= {y})"),
            FloatPredicate::Ule => format!("!({x} > {y})"),
            FloatPredicate::Une => format!("!({x} == {y})"),
            FloatPredicate::Uno => format!("({} || {})", is_nan(&x), is_nan(&y)),
            FloatPredicate::Ord => format!("!({} || {})", is_nan(&x), is_nan(&y)),
            FloatPredicate::False => "false".into(),
            FloatPredicate::True => "true".into(),
        })
    }

    fn cast(&mut self, cast: CastOp, value: &Value, to: &Type) -> Result<String, EmitError> {
        let from = self.kernel.function.type_of(value);
        let value = self.value(value)?;
        Ok(match cast {
            CastOp::Bitcast if from == *to => value,
            CastOp::ZExt if from == Type::BOOL => format!("select(0u, 1u, {value})"),
            CastOp::SExt if from == Type::BOOL => format!("select(0u, 4294967295u, {value})"),
            CastOp::UiToFp if from == Type::BOOL => format!("select(0f, 1f, {value})"),
            CastOp::SiToFp if from == Type::BOOL => format!("select(0f, -1f, {value})"),
            CastOp::Bitcast => format!("bitcast<{}>({value})", type_name(to)?),
            CastOp::FpToUi => format!("u32({value})"),
            CastOp::FpToSi => format!("bitcast<u32>(i32({value}))"),
            CastOp::UiToFp => format!("f32({value})"),
            CastOp::SiToFp => format!("f32(bitcast<i32>({value}))"),
            other => return Err(EmitError::unsupported(other, "WGSL")),
        })
    }
}

/// On the bits, since a compiler may assume that there are no NaNs.
fn is_nan(float: &str) -> String {
    format!("((bitcast<u32>({float}) & 2147483647u) > 2139095040u)")
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add | BinaryOp::FAdd => "+",
        BinaryOp::Sub | BinaryOp::FSub => "-",
        BinaryOp::Mul | BinaryOp::FMul => "*",
        BinaryOp::UDiv | BinaryOp::SDiv | BinaryOp::FDiv => "/",
        BinaryOp::URem | BinaryOp::SRem | BinaryOp::FRem => "%",
        BinaryOp::Shl => "<<",
        BinaryOp::LShr | BinaryOp::AShr => ">>",
        BinaryOp::And => "&",
        BinaryOp::Or => "|",
        BinaryOp::Xor => "^",
    }
}

/// Arithmetic modulo 2.
fn truth_operator(op: BinaryOp) -> Result<&'static str, EmitError> {
    match op {
        BinaryOp::And | BinaryOp::Mul => Ok("&"),
        BinaryOp::Or => Ok("|"),
        BinaryOp::Xor | BinaryOp::Add | BinaryOp::Sub => Ok("!="),
        other => Err(EmitError::unsupported((other, "of truth values"), "WGSL")),
    }
}
