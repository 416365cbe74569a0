//! Powers and logarithms to base 2, from `+ − ×` and one division. The coefficients are minimax fits (Remez
//! in 60 digits); the errors stated are the largest that the tests find.

use super::{div, floor, is_nan, scale, unpack};

/// (2^f − 1) / f for −½ ≤ f ≤ ½, to 7·10⁻⁹.
const EXP2: [f32; 6] =
    [core::f32::consts::LN_2, 0.240_226_5, 0.055_503_57, 0.009_618_031, 0.001_339_086_7, 0.000_154_697_35];

/// log₂((1 + s) / (1 − s)) / s as a polynomial in s², for m = (1 + s) / (1 − s) in √½ … √2, to 10⁻⁹ of it.
const LOG2: [f32; 4] = [2.885_39, 0.961_798_85, 0.576_714_05, 0.431_744_7];

/// Below this a power ends at zero: no square or product of what is left is denormal.
const VANISHES: f32 = 1.084_202_2e-19; // 2⁻⁶³

/// 2^`x` within 1.5 ULP. +∞ from 128 on, 0 below −126 (never a denormal), NaN for NaN; exact for whole `x`.
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    if is_nan(x) {
        return x;
    }
    if x >= 128.0 {
        return f32::INFINITY;
    }
    if x < -126.0 {
        return 0.0;
    }
    let whole = floor(x + 0.5);
    let f = x - whole;
    let [c0, c1, c2, c3, c4, c5] = EXP2;
    let rest = f * (c0 + f * (c1 + f * (c2 + f * (c3 + f * (c4 + f * c5)))));
    scale(1.0 + rest, whole as i32)
}

/// log₂ `x` within 3 ULP, denormals included; exact for powers of two. −∞ at ±0, +∞ at +∞, NaN below zero and
/// for NaN.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    let bits = x.to_bits();
    let (mantissa, unit) = unpack(bits & 0x7fff_ffff);
    // By the mantissa: LLVM makes a comparison of floats of one of all bits but the sign, and for that a driver may flush denormals.
    if mantissa == 0 {
        return f32::NEG_INFINITY;
    }
    if bits >= 0x7f80_0000 {
        return if bits == 0x7f80_0000 { x } else { f32::NAN };
    }
    // 1.0110101…₂ = √2: the mantissa goes to √½ … √2 around 1, where the logarithm is smallest.
    let above = (mantissa > 0x00b5_04f3) as i32;
    let m = scale(f32::from_bits((mantissa & 0x007f_ffff) | 0x3f80_0000), -above);
    let s = div(m - 1.0, m + 1.0);
    let z = s * s;
    let [c0, c1, c2, c3] = LOG2;
    (unit + 23 + above) as f32 + s * (c0 + z * (c1 + z * (c2 + z * c3)))
}

/// `x`^`n` by squaring, with a relative error of at most `n`·2⁻²³. 1 for `n` = 0, whatever `x` is.
///
/// Powers and intermediate squares below 2⁻⁶³ in magnitude become zero, so that none is ever denormal.
#[inline(always)]
pub fn powi(x: f32, n: u32) -> f32 {
    let (mut power, mut square, mut left) = (1.0, x, n);
    while left != 0 {
        if left & 1 == 1 {
            power = vanish(power * vanish(square));
        }
        left >>= 1;
        square = vanish(square);
        square *= square;
    }
    power
}

/// `x`^`y` for `x` ≥ 0, with a relative error of at most (2 + 2·|`y` log₂ `x`| + `y`)·2⁻²³, in which `y` counts for whole `y` only.
///
/// Whole `y` from 0 to 65536 go to [`powi`]; the others are `exp2(y · log2(x))`: 0^`y` is 0 for `y` > 0 and
/// +∞ for `y` < 0, NaN for negative `x`, 0 where the power is below 2⁻¹²⁶, NaN where either is NaN.
#[inline(always)]
pub fn pow(x: f32, y: f32) -> f32 {
    if (0.0..=65536.0).contains(&y) && floor(y) == y {
        return powi(x, y as u32);
    }
    exp2(y * log2(x))
}

#[inline(always)]
fn vanish(x: f32) -> f32 {
    if super::abs(x) < VANISHES { 0.0 } else { x }
}
