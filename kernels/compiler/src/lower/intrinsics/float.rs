//! Functions of floats.

use super::conversion::is_nan;
use crate::cleanup::builder::Builder;
use crate::ir::{BinaryOp, CastOp, FloatPredicate, MathOp, Type, Value};

pub fn expand(build: &mut Builder, base: &str, arguments: &[Value]) -> Option<Value> {
    match (base, arguments) {
        ("minnum" | "minimumnum", [a, b]) => Some(extreme(build, FloatPredicate::Olt, a, b)),
        ("maxnum" | "maximumnum", [a, b]) => Some(extreme(build, FloatPredicate::Ogt, a, b)),
        ("copysign", [a, b]) => Some(copy_sign(build, a, b)),
        ("round", [a]) => Some(round(build, a)),
        ("powi", [a, exponent]) => Some(power(build, a, exponent.as_u32()? as i32)),
        ("log10", [a]) => {
            let log = build.math(MathOp::Log2, vec![a.clone()]);
            Some(build.binary(BinaryOp::FMul, &log, &Value::f32(std::f32::consts::LOG10_2)))
        }
        _ => Some(build.math(math_op(base)?, arguments.to_vec())),
    }
}

fn math_op(base: &str) -> Option<MathOp> {
    use MathOp::*;
    Some(match base {
        "sqrt" => Sqrt,
        "fabs" => Abs,
        "floor" => Floor,
        "ceil" => Ceil,
        "trunc" => Trunc,
        "rint" | "roundeven" | "nearbyint" => RoundEven,
        "fma" => Fma,
        "sin" => Sin,
        "cos" => Cos,
        "tan" => Tan,
        "exp" => Exp,
        "exp2" => Exp2,
        "log" => Log,
        "log2" => Log2,
        "pow" => Pow,
        "asin" => Asin,
        "acos" => Acos,
        "atan" => Atan,
        "atan2" => Atan2,
        "sinh" => Sinh,
        "cosh" => Cosh,
        "tanh" => Tanh,
        _ => return None,
    })
}

/// The number that comes first by `predicate`; of a number and a NaN the number. Drivers differ in which zero is the smaller one; here
/// it is `a`, as on x86.
fn extreme(build: &mut Builder, predicate: FloatPredicate, a: &Value, b: &Value) -> Value {
    let nan = is_nan(build, a);
    let first = build.compare_float(predicate, b, a);
    let take_b = build.binary(BinaryOp::Or, &nan, &first);
    build.select(&take_b, b, a)
}

fn copy_sign(build: &mut Builder, a: &Value, b: &Value) -> Value {
    let (x, y) = (build.cast(CastOp::Bitcast, a, Type::I32), build.cast(CastOp::Bitcast, b, Type::I32));
    let magnitude = build.binary_const(BinaryOp::And, &x, 0x7fff_ffff);
    let sign = build.binary_const(BinaryOp::And, &y, 0x8000_0000);
    let word = build.binary(BinaryOp::Or, &magnitude, &sign);
    build.cast(CastOp::Bitcast, &word, Type::F32)
}

/// To the nearest integer, halves away from zero. The difference to the truncation is exact.
fn round(build: &mut Builder, a: &Value) -> Value {
    let truncated = build.math(MathOp::Trunc, vec![a.clone()]);
    let rest = build.binary(BinaryOp::FSub, a, &truncated);
    let rest = build.math(MathOp::Abs, vec![rest]);
    let up = build.compare_float(FloatPredicate::Oge, &rest, &Value::f32(0.5));
    let step = build.select(&up, &Value::f32(1.0), &Value::f32(0.0));
    let step = copy_sign(build, &step, a);
    build.binary(BinaryOp::FAdd, &truncated, &step)
}

/// By squaring, in the order of compiler-rt's `__powisf2`.
fn power(build: &mut Builder, a: &Value, exponent: i32) -> Value {
    let mut left = exponent.unsigned_abs();
    let (mut square, mut product) = (a.clone(), None);
    while left > 0 {
        if left & 1 == 1 {
            product = Some(match product {
                Some(product) => build.binary(BinaryOp::FMul, &product, &square),
                None => square.clone(),
            });
        }
        left >>= 1;
        if left > 0 {
            square = build.binary(BinaryOp::FMul, &square, &square.clone());
        }
    }
    let product = product.unwrap_or(Value::f32(1.0));
    if exponent < 0 { build.binary(BinaryOp::FDiv, &Value::f32(1.0), &product) } else { product }
}
