//! Where a point that one view sees lies in the other one.
//!
//! A point has the same `t` in both views, as `pixel_direction` of either has the component d along the axis, and the same row. So a
//! source goes x_r − x_l = `camera::disparity_px` to the side, and as sources stand in whole columns, how far it goes to the nearest
//! pixel depends on `t` alone. In columns counted from the other side the same holds for the right view as the source.

use crate::camera;
use crate::layout::Reprojection;
use crate::math;

/// Key of an entry that nothing has raised.
pub const EMPTY: u32 = 0;

/// Disparities beyond this are one: no picture has so many columns, and a column and a shift have a sum.
const FARTHEST: f32 = 1_048_576.0;

/// 1.5·2²³: numbers up to 2²² in magnitude, added to it, are rounded to whole ones, which its last bits then hold. A conversion to an
/// integer saturates, for which a CPU has no instruction of eight lanes.
const MAGIC: f32 = 12_582_912.0;

/// The key of source column `x`.
#[inline(always)]
pub fn key(x: u32) -> u32 {
    x + 1
}

/// The whole number next to a disparity, the larger one of two (half a pixel goes to the right).
///
/// Within ½ of the disparity as given, and that is within 3·2⁻²⁴ of itself (three roundings) of e (t − 1) / t. ⌊D + ½⌋ would round its
/// sum, and be one too large just below a half; here the only sum that is rounded is that with `MAGIC`, to the nearest whole number,
/// and the difference to that one is exact. Magnitudes are clamped to 2²⁰; NaN (`t` = 0 with e = 0) is the smallest shift, outside of
/// every picture.
#[inline(always)]
pub fn shift_px(disparity_px: f32) -> i32 {
    let disparity_px = math::clamp(disparity_px, -FARTHEST, FARTHEST);
    let nearest = (disparity_px + MAGIC).to_bits().wrapping_sub(MAGIC.to_bits()) as i32;
    // Halves have gone to the even number.
    nearest + (disparity_px - nearest as f32 >= 0.5) as i32
}

/// The column on which source column `x` lands, which sees something at `t`: −1 … width, of which the ends are outside.
///
/// As in 001, a jittered ray counts as one through the middle of its column: it keeps its place beside the middle, within the rounding
/// to columns. (With that place in the sum, neighbours would land apart or together by chance: seven times as many holes.)
#[inline(always)]
pub fn target(p: &Reprojection, t: f32, x: u32) -> i32 {
    let target = x as i32 + shift_px(camera::disparity_px(p.interaxial_px, t));
    target.min(p.width as i32).max(-1)
}

/// Where a column lands that was not sampled.
pub const NOWHERE: i32 = -2;

/// Whether a column with this `t` was sampled, of a picture of which not all were.
#[inline(always)]
pub fn is_sampled(t: f32) -> bool {
    t >= 0.0
}

/// Index of column `x` of `row` among the band's pixels.
#[inline(always)]
pub fn pixel(p: &Reprojection, x: u32, row: u32) -> u32 {
    row * p.width + if p.mirrored == 0 { x } else { p.width - 1 - x }
}

/// The `t` at which a point has a disparity one pixel smaller than at `t`: what is nearer hides a candidate at `t` by more than the
/// rounding to pixels explains.
///
/// 1 / t grows by 1 / e. +∞ for the sky, which anything hides; 0 without a distance between the eyes, where nothing is hidden.
#[inline(always)]
pub fn nearer_by_a_pixel(interaxial_px: f32, t: f32) -> f32 {
    if interaxial_px == 0.0 {
        0.0
    } else if t == f32::INFINITY {
        f32::INFINITY
    } else {
        math::div(t * interaxial_px, interaxial_px + t)
    }
}
