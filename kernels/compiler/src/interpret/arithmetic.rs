//! Arithmetic on values, each in the low bits of a `u128`; the bits above its width are zero.

use super::InterpretError;
use crate::ir::{BinaryOp, CastOp, FloatPredicate, IntPredicate, MathOp, Type, mask, sign_extend};

/// The float of these bits.
fn float(bits: u128) -> f32 {
    f32::from_bits(bits as u32)
}

fn bits(value: f32) -> u128 {
    value.to_bits().into()
}

/// A binary operation on values of type `ty`.
pub fn binary(op: BinaryOp, ty: &Type, a: u128, b: u128) -> Result<u128, InterpretError> {
    if let Some(value) = float_binary(op, float(a), float(b)) {
        return Ok(bits(value));
    }
    let width = ty.bits().max(1);
    let (x, y) = (sign_extend(a, width), sign_extend(b, width));
    let amount = (b % u128::from(width)) as u32;
    let divides = matches!(op, BinaryOp::UDiv | BinaryOp::URem | BinaryOp::SDiv | BinaryOp::SRem);
    if divides && b == 0 {
        return Err(InterpretError::DivisionByZero);
    }
    let value = match op {
        BinaryOp::Add => a.wrapping_add(b),
        BinaryOp::Sub => a.wrapping_sub(b),
        BinaryOp::Mul => a.wrapping_mul(b),
        BinaryOp::UDiv => a / b,
        BinaryOp::URem => a % b,
        BinaryOp::SDiv => x.wrapping_div(y) as u128,
        BinaryOp::SRem => x.wrapping_rem(y) as u128,
        BinaryOp::Shl => a << amount,
        BinaryOp::LShr => a >> amount,
        BinaryOp::AShr => (x >> amount) as u128,
        BinaryOp::And => a & b,
        BinaryOp::Or => a | b,
        _ => a ^ b,
    };
    Ok(value & mask(width))
}

fn float_binary(op: BinaryOp, a: f32, b: f32) -> Option<f32> {
    Some(match op {
        BinaryOp::FAdd => a + b,
        BinaryOp::FSub => a - b,
        BinaryOp::FMul => a * b,
        BinaryOp::FDiv => a / b,
        BinaryOp::FRem => a % b,
        _ => return None,
    })
}

/// A comparison of integers of type `ty`.
pub fn compare_integers(predicate: IntPredicate, ty: &Type, a: u128, b: u128) -> bool {
    let width = ty.bits().max(1);
    let (x, y) = (sign_extend(a, width), sign_extend(b, width));
    match predicate {
        IntPredicate::Eq => a == b,
        IntPredicate::Ne => a != b,
        IntPredicate::Ugt => a > b,
        IntPredicate::Uge => a >= b,
        IntPredicate::Ult => a < b,
        IntPredicate::Ule => a <= b,
        IntPredicate::Sgt => x > y,
        IntPredicate::Sge => x >= y,
        IntPredicate::Slt => x < y,
        IntPredicate::Sle => x <= y,
    }
}

/// A comparison of floats.
pub fn compare_floats(predicate: FloatPredicate, a: u128, b: u128) -> bool {
    let (a, b) = (float(a), float(b));
    let unordered = a.is_nan() || b.is_nan();
    match predicate {
        FloatPredicate::False => false,
        FloatPredicate::Oeq => a == b,
        FloatPredicate::Ogt => a > b,
        FloatPredicate::Oge => a >= b,
        FloatPredicate::Olt => a < b,
        FloatPredicate::Ole => a <= b,
        FloatPredicate::One => !unordered && a != b,
        FloatPredicate::Ord => !unordered,
        FloatPredicate::Ueq => unordered || a == b,
        FloatPredicate::Ugt => unordered || a > b,
        FloatPredicate::Uge => unordered || a >= b,
        FloatPredicate::Ult => unordered || a < b,
        FloatPredicate::Ule => unordered || a <= b,
        FloatPredicate::Une => unordered || a != b,
        FloatPredicate::Uno => unordered,
        FloatPredicate::True => true,
    }
}

/// A conversion. Floats out of range become the nearest integer, NaN becomes 0, as by Rust's `as`.
pub fn cast(op: CastOp, from: &Type, to: &Type, value: u128) -> Result<u128, InterpretError> {
    let signed = sign_extend(value, from.bits().max(1));
    let wide = to.bits() > 32;
    Ok(match op {
        CastOp::Bitcast | CastOp::ZExt => value,
        CastOp::Trunc => value & mask(to.bits()),
        CastOp::SExt => signed as u128 & mask(to.bits()),
        CastOp::FpToUi if wide => (float(value) as u64).into(),
        CastOp::FpToUi => (float(value) as u32).into(),
        CastOp::FpToSi if wide => (float(value) as i64 as u64).into(),
        CastOp::FpToSi => (float(value) as i32 as u32).into(),
        CastOp::UiToFp => bits(value as u64 as f32),
        CastOp::SiToFp => bits(signed as i64 as f32),
        other => return Err(InterpretError::Unsupported(format!("{other:?}"))),
    })
}

/// A function that devices have.
pub fn math(function: MathOp, arguments: &[u128]) -> Result<u128, InterpretError> {
    match *arguments {
        [a] if function.is_integer() => bit_function(function, a as u32),
        [a, b] if function.is_integer() => extremum(function, a as u32, b as u32),
        [a] => float_function(function, float(a)),
        [a, b] => match function {
            MathOp::Pow => Some(float(a).powf(float(b))),
            MathOp::Atan2 => Some(float(a).atan2(float(b))),
            _ => None,
        }
        .map(bits),
        // Not fused, as on lavapipe.
        [a, b, c] if function == MathOp::Fma => Some(bits(float(a) * float(b) + float(c))),
        _ => None,
    }
    .ok_or_else(|| InterpretError::Unsupported(format!("{function:?} of {} arguments", arguments.len())))
}

fn bit_function(function: MathOp, a: u32) -> Option<u128> {
    Some(u128::from(match function {
        MathOp::CountOnes => a.count_ones(),
        MathOp::LeadingZeros => a.leading_zeros(),
        MathOp::TrailingZeros => a.trailing_zeros(),
        MathOp::ReverseBits => a.reverse_bits(),
        _ => return None,
    }))
}

fn extremum(function: MathOp, a: u32, b: u32) -> Option<u128> {
    Some(u128::from(match function {
        MathOp::UMin => a.min(b),
        MathOp::UMax => a.max(b),
        MathOp::SMin => (a as i32).min(b as i32) as u32,
        MathOp::SMax => (a as i32).max(b as i32) as u32,
        _ => return None,
    }))
}

fn float_function(function: MathOp, x: f32) -> Option<u128> {
    Some(bits(match function {
        MathOp::Sqrt => x.sqrt(),
        MathOp::Abs => x.abs(),
        MathOp::Floor => x.floor(),
        MathOp::Ceil => x.ceil(),
        MathOp::Trunc => x.trunc(),
        MathOp::RoundEven => x.round_ties_even(),
        MathOp::Sin => x.sin(),
        MathOp::Cos => x.cos(),
        MathOp::Tan => x.tan(),
        MathOp::Exp => x.exp(),
        MathOp::Exp2 => x.exp2(),
        MathOp::Log => x.ln(),
        MathOp::Log2 => x.log2(),
        MathOp::Asin => x.asin(),
        MathOp::Acos => x.acos(),
        MathOp::Atan => x.atan(),
        MathOp::Sinh => x.sinh(),
        MathOp::Cosh => x.cosh(),
        MathOp::Tanh => x.tanh(),
        _ => return None,
    }))
}
