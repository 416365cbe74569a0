//! Angles, from `+ − ×` and one division.

use super::{PI, abs, copysign, div, is_nan, max, min};

/// atan(a) / a as a polynomial in a², for 0 ≤ a ≤ 1, to 1.6·10⁻⁸.
const ATAN: [f32; 9] = [
    1.0,
    -0.333_330_73,
    0.199_926_19,
    -0.142_036_41,
    0.106_409_25,
    -0.075_042_82,
    0.042_691_43,
    -0.016_068_603,
    0.002_849_889_5,
];

/// The angle of the point (`x`, `y`) from the x axis, in −π ..= π, with an absolute error of at most 4·10⁻⁷
/// (and within 4 ULP for |y| ≤ x).
///
/// 0 at the origin (with the sign of `y`, whatever that of `x`). Angles below 2⁻¹⁰⁰ become zero, so that none
/// is denormal. NaN when either is NaN or both are infinite.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    if is_nan(x + y) {
        return f32::NAN;
    }
    let (width, height) = (abs(x), abs(y));
    let large = max(width, height);
    if large == 0.0 {
        return copysign(0.0, y);
    }
    let tangent = div(min(width, height), large);
    let a = if tangent < 7.888_609e-31 { 0.0 } else { tangent };
    let z = a * a;
    let mut sum = ATAN[8];
    let mut i = 8;
    while i > 0 {
        i -= 1;
        sum = sum * z + ATAN[i];
    }
    let octant = a * sum;
    let quadrant = if height > width { 0.5 * PI - octant } else { octant };
    let half = if x < 0.0 { PI - quadrant } else { quadrant };
    copysign(half, y)
}
