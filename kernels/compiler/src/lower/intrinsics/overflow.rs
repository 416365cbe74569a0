//! Arithmetic that saturates or tells of an overflow.

use crate::cleanup::builder::Builder;
use crate::ir::{BinaryOp, CastOp, IntPredicate, Op, Type, Value, mask};

pub fn expand(build: &mut Builder, base: &str, arguments: &[Value], bits: u32) -> Option<Value> {
    let [a, b] = arguments else { return None };
    if let Some(kind) = base.strip_suffix(".with.overflow") {
        let (result, overflow) = checked(build, kind, a, b, bits)?;
        return Some(build.pair(result, overflow));
    }
    let kind = base.strip_suffix(".sat")?;
    let (result, overflow) = match kind {
        "uadd" | "usub" | "sadd" | "ssub" => checked(build, kind, a, b, bits)?,
        _ => return None,
    };
    let limit = match kind {
        "uadd" => Value::int(bits, u128::MAX),
        "usub" => Value::int(bits, 0),
        // Beyond the end on the side of the first operand's sign.
        _ => {
            let negative = build.compare_const(IntPredicate::Slt, a, 0);
            build.select(&negative, &Value::int(bits, 1 << (bits - 1)), &Value::int(bits, mask(bits - 1)))
        }
    };
    Some(build.select(&overflow, &limit, &result))
}

/// The result modulo 2^bits, and whether it is not the true one.
fn checked(build: &mut Builder, kind: &str, a: &Value, b: &Value, bits: u32) -> Option<(Value, Value)> {
    match kind {
        "uadd" => {
            let sum = build.binary(BinaryOp::Add, a, b);
            let overflow = build.compare(IntPredicate::Ult, &sum, a);
            Some((sum, overflow))
        }
        "usub" => {
            let overflow = build.compare(IntPredicate::Ult, a, b);
            Some((build.binary(BinaryOp::Sub, a, b), overflow))
        }
        "sadd" => Some(signed_sum(build, BinaryOp::Add, IntPredicate::Sgt, IntPredicate::Slt, a, b)),
        "ssub" => Some(signed_sum(build, BinaryOp::Sub, IntPredicate::Slt, IntPredicate::Sgt, a, b)),
        "umul" | "smul" if bits < 32 && 2 * bits <= 32 => {
            Some(narrow_product(build, kind == "smul", a, b, bits))
        }
        "umul" if bits == 32 => {
            let high = high_word(build, a, b);
            let overflow = build.compare_const(IntPredicate::Ne, &high, 0);
            Some((build.binary(BinaryOp::Mul, a, b), overflow))
        }
        "smul" if bits == 32 => Some(signed_product(build, a, b)),
        _ => None,
    }
}

/// A sum or difference wraps if it lies on the wrong side of `a`, seen from the sign of `b`.
fn signed_sum(
    build: &mut Builder,
    op: BinaryOp,
    wrong_if_negative: IntPredicate,
    wrong_else: IntPredicate,
    a: &Value,
    b: &Value,
) -> (Value, Value) {
    let result = build.binary(op, a, b);
    let negative = build.compare_const(IntPredicate::Slt, b, 0);
    let (x, y) = (build.compare(wrong_if_negative, &result, a), build.compare(wrong_else, &result, a));
    (result, build.select(&negative, &x, &y))
}

/// In words, which hold the whole product.
fn narrow_product(build: &mut Builder, signed: bool, a: &Value, b: &Value, bits: u32) -> (Value, Value) {
    let extend = if signed { CastOp::SExt } else { CastOp::ZExt };
    let (x, y) = (build.cast(extend, a, Type::I32), build.cast(extend, b, Type::I32));
    let product = build.binary(BinaryOp::Mul, &x, &y);
    let result = build.cast(CastOp::Trunc, &product, Type::Int(bits));
    let back = build.cast(extend, &result, Type::I32);
    let overflow = build.compare(IntPredicate::Ne, &back, &product);
    (result, overflow)
}

fn high_word(build: &mut Builder, a: &Value, b: &Value) -> Value {
    build.emit(Op::MulHigh(a.clone(), b.clone()), Type::I32)
}

/// The high word of the signed product is that of the unsigned one, less each factor that the other one's sign counts 2³² times.
fn signed_product(build: &mut Builder, a: &Value, b: &Value) -> (Value, Value) {
    let product = build.binary(BinaryOp::Mul, a, b);
    let mut high = high_word(build, a, b);
    for (sign, other) in [(a, b), (b, a)] {
        let ones = build.binary_const(BinaryOp::AShr, sign, 31);
        let excess = build.binary(BinaryOp::And, &ones, other);
        high = build.binary(BinaryOp::Sub, &high, &excess);
    }
    let expected = build.binary_const(BinaryOp::AShr, &product, 31);
    let overflow = build.compare(IntPredicate::Ne, &high, &expected);
    (product, overflow)
}
