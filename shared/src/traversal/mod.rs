//! The nearest hit of a ray, and whether it hits anything.
//!
//! A hit is a function of the ray and the primitives alone: not of the tree, the order of its lanes, the way this code is driven or
//! the width of vectors. [`slab`], `geom` and [`rules`] say how. Two drivers share that arithmetic: arrays and masks, which LLVM turns
//! into vector code, for CPUs ([`arrays`]), and lane after lane, without local arrays, for devices ([`lanes`]).
//!
//! The shape of the source decides the speed: what matters is the latency of the chain node → mask → child → next node. Measure
//! before changing it (`parallax bench traversal`).

pub mod arrays;
pub mod lanes;
pub mod occluder;
pub mod ray;
pub mod round;
pub mod rows;
pub mod rules;
pub mod shaft;
pub mod slab;
pub mod walk;

use crate::layout::{Hit, NONE, Ray, Row};
use kernel_api::device::ON_DEVICE;
use rules::Exact;

/// The nearest hit, `t_min <= t < t_max`; of several at the same `t` the one with the smallest primitive number.
///
/// `rows` is what `parallax::build` makes (a structure with links out of range panics on a CPU), `extent` the largest absolute
/// coordinate of its primitives. Components of the direction may be zero, −0 or denormal as long as one is longer than 10⁻¹¹; of
/// shorter directions the limit of 1/d loses hits, below 10⁻¹⁸ all. A `t_min` below zero counts as zero. A ray with a NaN, or an infinity
/// in its origin or direction, hits nothing. `t` may be −0 where `t_min` is 0.
#[inline(always)]
pub fn closest_hit(rows: &[Row], ray: &Ray, extent: f32) -> Hit {
    walk::walk::<Exact, false, ON_DEVICE>(rows, ray, extent)
}

/// Whether [`closest_hit`] would find anything; stops at the first hit. Which one that is depends on the structure.
#[inline(always)]
pub fn occluded(rows: &[Row], ray: &Ray, extent: f32) -> bool {
    walk::walk::<Exact, true, ON_DEVICE>(rows, ray, extent).prim_id != NONE
}
