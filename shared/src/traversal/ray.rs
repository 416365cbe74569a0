//! What a traversal works out once for each ray.

use super::rows::LANES;
use super::rules::Rules;
use crate::layout::Ray;
use crate::math::{div, max, min};

/// 1/d is clamped to this, so that zero and denormal components of a direction need no case of their own.
pub(super) const LARGEST_INVERSE: f32 = 1e18;

/// At which word of a triangle's vertex x, y and z start.
pub(crate) const XYZ_AT: [usize; 3] = [0, LANES, 2 * LANES];

/// A ray with the constants of its slab tests and projections.
#[derive(Clone, Copy)]
pub struct Prepared {
    /// The ray itself, its `t_min` +0 or more.
    pub ray: Ray,
    /// By how much every box is padded.
    pub padding: f32,
    /// Origins that are shifted by the padding, for near and for far planes: every box grows by the same amount, at no cost.
    pub near_origin: [f32; 3],
    /// See `near_origin`.
    pub far_origin: [f32; 3],
    /// Smallest accepted `t`, +0 or more.
    pub t_min: f32,
    /// 1/direction, clamped.
    pub inv_dir: [f32; 3],
    /// At which word of a node the near planes of each axis start: picked by address, never by selecting values. In words, as an
    /// address takes them; row numbers would be shifted for every node.
    pub(crate) near_at: [usize; 3],
    /// Likewise for the far planes.
    pub(crate) far_at: [usize; 3],
    /// At which word of a triangle's vertex the coordinates start, in an order of the axes that has the largest component of the
    /// direction last.
    pub(crate) axes_at: [usize; 3],
    /// The origin in that order.
    pub(crate) origin: [f32; 3],
    /// The direction in that order, the last component inverted.
    pub(crate) shear: [f32; 3],
}

impl Prepared {
    /// Works out the constants; `extent` is the largest absolute coordinate of all primitives (of the scene, not of a tree, so that
    /// every structure pads alike).
    #[inline(always)]
    pub fn new<R: Rules>(ray: &Ray, extent: f32) -> Self {
        let dir = ray.dir;
        // Four lanes, the last one idle: of three LLVM makes a scalar and a pair.
        let four = [dir[0], dir[1], dir[2], ray.t_max];
        let mut inverse = [0.0; 4];
        for lane in 0..4 {
            inverse[lane] = clamped_inverse(four[lane]);
        }
        let inv_dir = [inverse[0], inverse[1], inverse[2]];
        let padding = (largest(ray.origin) + extent) * R::PADDING;
        let (mut near_origin, mut far_origin) = (ray.origin, ray.origin);
        let (mut near_at, mut far_at) = ([0; 3], [0; 3]);
        for axis in 0..3 {
            let sign = dir[axis].to_bits() & 0x8000_0000;
            let three_rows = 3 * LANES * (sign >> 31) as usize;
            near_at[axis] = LANES * axis + three_rows;
            far_at[axis] = LANES * axis + (3 * LANES - three_rows);
            let shift = f32::from_bits(padding.to_bits() | sign);
            near_origin[axis] = ray.origin[axis] + shift;
            far_origin[axis] = ray.origin[axis] - shift;
        }
        let last = largest_axis(dir);
        let (dir, inverse) = (ending_with(last, dir), ending_with(last, inv_dir));
        // Not −0, whose bits do not have their place in the order; a NaN stays, and is behind the end of every box.
        let t_min = if ray.t_min <= 0.0 { 0.0 } else { ray.t_min };
        Self {
            ray: Ray { t_min, ..*ray },
            padding,
            near_origin,
            far_origin,
            t_min,
            inv_dir,
            near_at,
            far_at,
            axes_at: ending_with(last, XYZ_AT),
            origin: ending_with(last, ray.origin),
            shear: [dir[0], dir[1], inverse[2]],
        }
    }

    /// Whether a walk with the ray is defined: origin and direction are finite, and the largest component of the direction is not too
    /// small for 1/d. A NaN would miss every triangle in any case, but meet the boxes of all of them on its way.
    #[inline(always)]
    pub fn is_proper(&self) -> bool {
        let last = self.shear[2].abs();
        self.is_finite() & (self.padding < f32::INFINITY) & (last < LARGEST_INVERSE)
    }

    /// Whether all components of origin and direction are finite.
    #[inline(always)]
    fn is_finite(&self) -> bool {
        let Ray { origin: o, dir: d, .. } = self.ray;
        // Zero, or NaN if any of them is infinite or NaN.
        (o[0] * 0.0 + o[1] * 0.0 + o[2] * 0.0) + (d[0] * 0.0 + d[1] * 0.0 + d[2] * 0.0) == 0.0
    }
}

/// 1/x within ±10¹⁸ (10¹⁸ for NaN).
#[inline(always)]
pub(super) fn clamped_inverse(x: f32) -> f32 {
    max(min(div(1.0, x), LARGEST_INVERSE), -LARGEST_INVERSE)
}

#[inline(always)]
fn largest(v: [f32; 3]) -> f32 {
    max(v[0].abs(), max(v[1].abs(), v[2].abs()))
}

/// The axis of the largest component.
#[inline(always)]
fn largest_axis(v: [f32; 3]) -> usize {
    let (x, y, z) = (v[0].abs(), v[1].abs(), v[2].abs());
    if x > y {
        if x > z { 0 } else { 2 }
    } else if y > z {
        1
    } else {
        2
    }
}

/// Turns `v` so that component `last` comes last. Branches: an index into a local array was slower.
#[inline(always)]
fn ending_with<T: Copy>(last: usize, v: [T; 3]) -> [T; 3] {
    if last == 0 {
        [v[1], v[2], v[0]]
    } else if last == 1 {
        [v[2], v[0], v[1]]
    } else {
        v
    }
}
