//! Float arithmetic with a constant zero, written so that a driver cannot simplify it wrongly.
//!
//! lavapipe takes `x · 0` for 0, `x + 0` for x and `0 − x` for −x whenever the zero is a constant, decorations or not: a NaN or an infinity
//! is lost, and the sign of a zero is wrong. LLVM keeps these operations because they are not the identity; what they are is a
//! selection on the bits of `x`.

use super::builder::Builder;
use crate::ir::{BinaryOp, CastOp, FloatPredicate, Function, Id, IntPredicate, Op, Type, Value};

const SIGN: u32 = 0x8000_0000;
const INFINITY: u32 = 0x7f80_0000;
const NAN: u32 = 0x7fc0_0000;

/// Rewrites all additions, subtractions and products that have a constant zero as an operand.
pub fn spell_out(function: &mut Function) {
    let mut build = Builder { function: std::mem::take(function), ..Builder::default() };
    for block in 0..build.function.blocks.len() {
        for id in std::mem::take(&mut build.function.blocks[block].instructions) {
            instruction(&mut build, id);
        }
        build.function.blocks[block].instructions = std::mem::take(&mut build.out);
    }
    *function = build.function;
}

fn instruction(build: &mut Builder, id: Id) {
    build.location = build.function[id].location;
    if let Op::Binary(op, a, b) = build.function[id].op.clone()
        && let Some(value) = rewritten(build, op, &a, &b)
    {
        build.function[id].op = Op::Copy(value);
    }
    build.out.push(id);
}

fn rewritten(build: &mut Builder, op: BinaryOp, a: &Value, b: &Value) -> Option<Value> {
    match (op, zero_sign(a), zero_sign(b)) {
        (BinaryOp::FAdd, None, Some(sign)) => Some(plus_zero(build, a, sign)),
        (BinaryOp::FAdd, Some(sign), None) => Some(plus_zero(build, b, sign)),
        (BinaryOp::FSub, None, Some(sign)) => Some(plus_zero(build, a, sign ^ SIGN)),
        (BinaryOp::FSub, Some(sign), None) => {
            let negated = build.emit(Op::FloatNegate(b.clone()), Type::F32);
            Some(plus_zero(build, &negated, sign))
        }
        (BinaryOp::FMul, None, Some(sign)) => Some(times_zero(build, a, sign)),
        (BinaryOp::FMul, Some(sign), None) => Some(times_zero(build, b, sign)),
        _ => None,
    }
}

/// The sign bit of a value that is a constant zero.
fn zero_sign(value: &Value) -> Option<u32> {
    match value {
        Value::F32(bits) if bits & !SIGN == 0 => Some(*bits),
        Value::Zero(Type::F32) => Some(0),
        _ => None,
    }
}

/// `x + 0`: `x`, but +0 where `x` is a zero of either sign. `x + −0` is `x`.
fn plus_zero(build: &mut Builder, x: &Value, sign: u32) -> Value {
    if sign == SIGN {
        return x.clone();
    }
    let is_zero = build.compare_float(FloatPredicate::Oeq, x, &Value::F32(0));
    build.select(&is_zero, &Value::F32(0), x)
}

/// `x · ±0`: a zero with the product of the signs, or NaN where `x` is infinite or NaN.
fn times_zero(build: &mut Builder, x: &Value, sign: u32) -> Value {
    let bits = build.cast(CastOp::Bitcast, x, Type::I32);
    let magnitude = build.binary_const(BinaryOp::And, &bits, (!SIGN).into());
    let finite = build.compare_const(IntPredicate::Ult, &magnitude, INFINITY.into());
    let signs = build.binary_const(BinaryOp::And, &bits, SIGN.into());
    let signs = build.binary_const(BinaryOp::Xor, &signs, sign.into());
    let result = build.select(&finite, &signs, &Value::int(32, NAN.into()));
    build.cast(CastOp::Bitcast, &result, Type::F32)
}
