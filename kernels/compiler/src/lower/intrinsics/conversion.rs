//! Floats to integers, and questions about a float's bits.

use crate::cleanup::builder::Builder;
use crate::ir::{BinaryOp, CastOp, FloatPredicate, IntPredicate, Type, Value, mask};

const MAGNITUDE: u128 = 0x7fff_ffff;
const INFINITY: u128 = 0x7f80_0000;
const LEAST_NORMAL: u128 = 0x0080_0000;

pub fn expand(build: &mut Builder, base: &str, arguments: &[Value], ty: &Type) -> Option<Value> {
    match (base, arguments, ty) {
        ("fptoui.sat", [a], Type::Int(bits @ 1..=32)) => Some(to_unsigned(build, a, *bits)),
        ("fptosi.sat", [a], Type::Int(bits @ 2..=32)) => Some(to_signed(build, a, *bits)),
        ("is.fpclass", [a, classes], _) => class(build, a, classes.as_u32()?),
        _ => None,
    }
}

/// Whether a float is a NaN, by its bits, so that no driver may assume it is none.
pub fn is_nan(build: &mut Builder, a: &Value) -> Value {
    let word = build.cast(CastOp::Bitcast, a, Type::I32);
    let magnitude = build.binary_const(BinaryOp::And, &word, MAGNITUDE);
    build.compare_const(IntPredicate::Ugt, &magnitude, INFINITY)
}

/// Rust's `as`: towards zero, to the nearest end of the range, a NaN to zero. The device's conversion is used in range only.
fn to_unsigned(build: &mut Builder, a: &Value, bits: u32) -> Value {
    let inside = build.cast(CastOp::FpToUi, a, Type::I32);
    let positive = build.compare_float(FloatPredicate::Ogt, a, &Value::f32(0.0)); // false for a NaN
    let result = build.select(&positive, &inside, &Value::u32(0));
    let limit = Value::f32((bits as f32).exp2());
    let above = build.compare_float(FloatPredicate::Oge, a, &limit);
    let result = build.select(&above, &Value::int(32, mask(bits)), &result);
    build.cast(CastOp::Trunc, &result, Type::Int(bits))
}

fn to_signed(build: &mut Builder, a: &Value, bits: u32) -> Value {
    let end = (bits as f32 - 1.0).exp2();
    let (least, greatest) = (Value::int(32, (-1i128 << (bits - 1)) as u128), Value::int(32, mask(bits - 1)));
    let inside = build.cast(CastOp::FpToSi, a, Type::I32);
    let above_least = build.compare_float(FloatPredicate::Ogt, a, &Value::f32(-end));
    let result = build.select(&above_least, &inside, &least);
    let above = build.compare_float(FloatPredicate::Oge, a, &Value::f32(end));
    let result = build.select(&above, &greatest, &result);
    let nan = is_nan(build, a);
    let result = build.select(&nan, &Value::u32(0), &result);
    build.cast(CastOp::Trunc, &result, Type::Int(bits))
}

/// Whether a float is of one of the classes: LLVM's bits, from the NaNs over −∞ to +∞.
fn class(build: &mut Builder, a: &Value, classes: u32) -> Option<Value> {
    let mut found = match classes & 3 {
        0 => Value::bool(false),
        3 => is_nan(build, a),
        _ => return None, // one kind of NaN only
    };
    let word = build.cast(CastOp::Bitcast, a, Type::I32);
    let negative = build.compare_const(IntPredicate::Slt, &word, 0);
    let positive = build.compare_const(IntPredicate::Sge, &word, 0);
    let magnitude = build.binary_const(BinaryOp::And, &word, MAGNITUDE);
    let kinds = magnitude_kinds(build, &magnitude);
    let order = [(&negative, 3), (&negative, 2), (&negative, 1), (&negative, 0)].into_iter().chain([
        (&positive, 0),
        (&positive, 1),
        (&positive, 2),
        (&positive, 3),
    ]);
    for (bit, (sign, kind)) in order.enumerate() {
        if classes >> (bit + 2) & 1 == 1 {
            let is = build.binary(BinaryOp::And, sign, &kinds[kind]);
            found = build.binary(BinaryOp::Or, &found, &is);
        }
    }
    Some(found)
}

/// Whether it is zero, denormal, normal, infinite.
fn magnitude_kinds(build: &mut Builder, magnitude: &Value) -> [Value; 4] {
    let less_one = build.binary_const(BinaryOp::Sub, magnitude, 1);
    let above_least = build.binary_const(BinaryOp::Sub, magnitude, LEAST_NORMAL);
    [
        build.compare_const(IntPredicate::Eq, magnitude, 0),
        build.compare_const(IntPredicate::Ult, &less_one, LEAST_NORMAL - 1),
        build.compare_const(IntPredicate::Ult, &above_least, INFINITY - LEAST_NORMAL),
        build.compare_const(IntPredicate::Eq, magnitude, INFINITY),
    ]
}
