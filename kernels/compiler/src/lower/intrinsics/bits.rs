//! Counting and moving bits.

use crate::cleanup::builder::Builder;
use crate::ir::{BinaryOp, CastOp, IntPredicate, MathOp, Type, Value};

pub fn expand(build: &mut Builder, base: &str, arguments: &[Value], bits: u32) -> Option<Value> {
    match (base, arguments) {
        ("fshl", [a, b, amount]) => Some(funnel(build, true, [a, b, amount], bits)),
        ("fshr", [a, b, amount]) => Some(funnel(build, false, [a, b, amount], bits)),
        ("bswap", [a]) => Some(swap_bytes(build, a, bits)),
        ("ctpop" | "ctlz" | "cttz" | "bitreverse", [a, ..]) => match bits {
            32 => Some(build.math(word_op(base), vec![a.clone()])),
            0..32 => Some(narrow(build, base, a, bits)),
            64 => Some(wide(build, base, a)),
            _ => None,
        },
        _ => None,
    }
}

fn word_op(base: &str) -> MathOp {
    match base {
        "ctpop" => MathOp::CountOnes,
        "ctlz" => MathOp::LeadingZeros,
        "cttz" => MathOp::TrailingZeros,
        _ => MathOp::ReverseBits,
    }
}

/// Through a word.
fn narrow(build: &mut Builder, base: &str, a: &Value, bits: u32) -> Value {
    let unused = u128::from(32 - bits);
    let mut word = build.cast(CastOp::ZExt, a, Type::I32);
    if base == "cttz" {
        word = build.binary_const(BinaryOp::Or, &word, 1 << bits); // so that zero has `bits` of them
    }
    let result = build.math(word_op(base), vec![word]);
    let result = match base {
        "ctlz" => build.binary_const(BinaryOp::Sub, &result, unused),
        "bitreverse" => build.binary_const(BinaryOp::LShr, &result, unused),
        _ => result,
    };
    build.cast(CastOp::Trunc, &result, Type::Int(bits))
}

/// Through two words.
fn wide(build: &mut Builder, base: &str, a: &Value) -> Value {
    let low = build.cast(CastOp::Trunc, a, Type::I32);
    let high = build.binary_const(BinaryOp::LShr, a, 32);
    let high = build.cast(CastOp::Trunc, &high, Type::I32);
    let word = |build: &mut Builder, value: &Value| build.math(word_op(base), vec![value.clone()]);
    let result = match base {
        "ctpop" => {
            let (x, y) = (word(build, &low), word(build, &high));
            build.binary(BinaryOp::Add, &x, &y)
        }
        "ctlz" => zeros_of_two(build, MathOp::LeadingZeros, &high, &low),
        "cttz" => zeros_of_two(build, MathOp::TrailingZeros, &low, &high),
        _ => {
            let (x, y) = (word(build, &high), word(build, &low));
            let (x, y) = (build.cast(CastOp::ZExt, &x, Type::I64), build.cast(CastOp::ZExt, &y, Type::I64));
            let y = build.binary_const(BinaryOp::Shl, &y, 32);
            return build.binary(BinaryOp::Or, &x, &y);
        }
    };
    build.cast(CastOp::ZExt, &result, Type::I64)
}

/// The zeros of `first`, and if it has nothing else, of `second` behind it.
fn zeros_of_two(build: &mut Builder, op: MathOp, first: &Value, second: &Value) -> Value {
    let empty = build.compare_const(IntPredicate::Eq, first, 0);
    let (x, y) = (build.math(op, vec![first.clone()]), build.math(op, vec![second.clone()]));
    let y = build.binary_const(BinaryOp::Add, &y, 32);
    build.select(&empty, &y, &x)
}

fn swap_bytes(build: &mut Builder, a: &Value, bits: u32) -> Value {
    let mut swapped = Value::int(bits, 0);
    for at in (0..bits).step_by(8) {
        let byte = build.binary_const(BinaryOp::LShr, a, at.into());
        let byte = build.binary_const(BinaryOp::And, &byte, 0xff);
        let byte = build.binary_const(BinaryOp::Shl, &byte, (bits - 8 - at).into());
        swapped = build.binary(BinaryOp::Or, &swapped, &byte);
    }
    swapped
}

/// The high part (to the left) or the low part (to the right) of the two values, one behind the other, shifted. The amount is taken
/// modulo the width, a power of two.
fn funnel(build: &mut Builder, left: bool, [a, b, amount]: [&Value; 3], bits: u32) -> Value {
    if let Some(amount) = amount.as_int() {
        return constant_funnel(build, left, a, b, (amount % u128::from(bits)) as u32, bits);
    }
    let last = Value::int(bits, u128::from(bits - 1));
    let amount = build.binary(BinaryOp::And, amount, &last);
    let rest = build.binary(BinaryOp::Sub, &last, &amount);
    // In two steps, since a shift by the width is not defined.
    let (x, y) = if left {
        let half = build.binary_const(BinaryOp::LShr, b, 1);
        (build.binary(BinaryOp::Shl, a, &amount), build.binary(BinaryOp::LShr, &half, &rest))
    } else {
        let double = build.binary_const(BinaryOp::Shl, a, 1);
        (build.binary(BinaryOp::Shl, &double, &rest), build.binary(BinaryOp::LShr, b, &amount))
    };
    build.binary(BinaryOp::Or, &x, &y)
}

fn constant_funnel(build: &mut Builder, left: bool, a: &Value, b: &Value, amount: u32, bits: u32) -> Value {
    match (amount, left) {
        (0, true) => a.clone(),
        (0, false) => b.clone(),
        _ => {
            let to_left = if left { amount } else { bits - amount };
            let x = build.binary_const(BinaryOp::Shl, a, to_left.into());
            let y = build.binary_const(BinaryOp::LShr, b, (bits - to_left).into());
            build.binary(BinaryOp::Or, &x, &y)
        }
    }
}
