//! The only door to arithmetic beyond `+ − ×` and comparisons, so that both backends give the same bits (DESIGN §3).
//!
//! | function | CPU | device, strict | device, fast |
//! |---|---|---|---|
//! | [`div`], [`sqrt`] | IEEE 754, correctly rounded | corrected by the exact remainder: the same bits | the driver's |
//! | everything else | built from `+ − ×`, comparisons, conversions and the two above | the same | the same source |
//!
//! Two things are not promised: the bits of a NaN (its sign and payload), and results below 2⁻¹²⁶ on a device
//! that flushes denormals. No function here makes a denormal out of ordinary numbers; those that could end at
//! zero early instead, and say so.
//!
//! `cfg` stands in this module alone; algorithms are free of it.

mod angle;
mod division;
mod exact;
mod power;
mod root;
pub mod vector;

pub use angle::atan2;
pub use division::{div_corrected, div_from};
pub use exact::{Offset, product_error};
pub use power::{exp2, log2, pow, powi};
pub use root::{sqrt_corrected, sqrt_from};

/// π rounded to f32.
pub const PI: f32 = core::f32::consts::PI;

/// `a / b`, correctly rounded (round to nearest, ties to even).
///
/// As IEEE 754: 0/0 and ∞/∞ are NaN, `x/0` is an infinity with the product of the signs, `x/∞` a zero.
/// Denormal operands and results are exact too; on a strict device they are computed with integers, so that
/// they survive a driver that flushes them. In the fast profile of a device this is the driver's division
/// (within 2.5 ULP by Vulkan's rules).
#[inline(always)]
pub fn div(a: f32, b: f32) -> f32 {
    #[cfg(all(feature = "device", not(feature = "fast")))]
    return div_corrected(a, b);
    #[cfg(not(all(feature = "device", not(feature = "fast"))))]
    return a / b;
}

/// √`a`, correctly rounded: NaN below zero, −0 at −0, +∞ at +∞.
///
/// As with [`div`]: corrected on a strict device, the driver's own in its fast profile.
#[inline(always)]
pub fn sqrt(a: f32) -> f32 {
    #[cfg(all(feature = "device", not(feature = "fast")))]
    return sqrt_corrected(a);
    #[cfg(not(all(feature = "device", not(feature = "fast"))))]
    return kernel_api::device::native_sqrt(a);
}

/// The smaller one by comparison and selection: `b` when they are equal (so `min(+0, −0)` is −0) or when
/// either is NaN.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger one by comparison and selection: `b` when they are equal (so `max(−0, +0)` is +0) or when
/// either is NaN.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// `x` moved into `low ..= high` (with `low <= high`); `low` when `x` is NaN.
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}

/// `x` without its sign bit; exact for every input, NaN stays NaN.
#[inline(always)]
pub fn abs(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7fff_ffff)
}

/// `magnitude` with the sign bit of `sign`, whatever either is.
#[inline(always)]
pub fn copysign(magnitude: f32, sign: f32) -> f32 {
    f32::from_bits((magnitude.to_bits() & 0x7fff_ffff) | (sign.to_bits() & 0x8000_0000))
}

/// Whether `x` is NaN, by its bits: a driver may assume that there is none and fold `x != x` away.
#[inline(always)]
pub fn is_nan(x: f32) -> bool {
    x.to_bits() & 0x7fff_ffff > 0x7f80_0000
}

/// Whether `x` is neither NaN nor infinite, by its bits.
#[inline(always)]
pub fn is_finite(x: f32) -> bool {
    x.to_bits() & 0x7fff_ffff < 0x7f80_0000
}

/// The largest whole number that is not above `x`. Exact. A zero result is +0; magnitudes from 2²³ on,
/// infinities and NaN are whole already and stay as they are.
#[inline(always)]
pub fn floor(x: f32) -> f32 {
    let below = floor_to_int(x) as f32;
    if abs(x) < 8_388_608.0 { below } else { x }
}

/// [`floor`] as an integer, saturated at the ends of `i32`; 0 for NaN.
#[inline(always)]
pub fn floor_to_int(x: f32) -> i32 {
    let whole = x as i32;
    whole.wrapping_sub((whole as f32 > x) as i32)
}

/// `condition ? yes : no` of two values that are both known.
#[inline(always)]
pub fn select(condition: bool, yes: f32, no: f32) -> f32 {
    if condition { yes } else { no }
}

/// `value · 2^exponent` for a normal `value` and a normal result; wrong bits otherwise.
#[inline(always)]
fn scale(value: f32, exponent: i32) -> f32 {
    f32::from_bits(value.to_bits().wrapping_add((exponent as u32) << 23))
}

/// Mantissa in 2²³ … 2²⁴ − 1 and the exponent of its unit, of a finite non-zero magnitude given by its bits; of zero the mantissa is 0.
#[inline(always)]
fn unpack(magnitude: u32) -> (u32, i32) {
    if magnitude >= 0x0080_0000 {
        ((magnitude & 0x007f_ffff) | 0x0080_0000, (magnitude >> 23) as i32 - 150)
    } else {
        let shift = magnitude.leading_zeros() - 8;
        (magnitude << shift, -149 - shift as i32)
    }
}
