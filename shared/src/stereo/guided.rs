//! The exact method: every ray of the second view is traced, with what the first view shows as a hint.
//!
//! None of the papers has it. A hit is a function of ray and primitives alone, so a ray that ends a little behind where it is expected
//! to has the hit of the whole ray if it has any, bit for bit; if it has none the whole ray follows.

use crate::layout::{Hit, NONE, Ray, Row};
use crate::traversal::closest_hit;

/// How far behind the expected end of a ray it is looked for, of its length: surfaces that are seen askew end there.
const MARGIN: f32 = 1.0 / 32.0;

/// [`closest_hit`] of `ray`, whose `t_max` is +∞, faster if the hit is at about `expected`, which need not be true.
#[inline(always)]
pub fn closest_hit_expected(rows: &[Row], ray: &Ray, extent: f32, expected: f32) -> Hit {
    let mut ray = *ray;
    ray.t_max = expected + expected * MARGIN;
    // A loop, so that a device has the walk once in its code.
    loop {
        let hit = closest_hit(rows, &ray, extent);
        let whole = ray.t_max == f32::INFINITY;
        if whole || hit.prim_id != NONE {
            return hit;
        }
        ray.t_max = f32::INFINITY;
    }
}
