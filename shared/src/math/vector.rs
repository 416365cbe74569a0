//! Vectors, on glam's `Vec3` (whose `+ − ×` and, with `scalar-math`, `dot = (x·x + y·y) + z·z` and `cross`
//! have one order of rounding). glam's own division, `length`, `normalize`, `min` and `max` are not used:
//! they bypass [`math`](super).

use super::{div, max, sqrt};
use glam::Vec3;

/// |`v`|. Infinite or zero when the sum of the squares over- or underflows (|v| above 2⁶³ or below 2⁻⁶³).
#[inline(always)]
pub fn length(v: Vec3) -> f32 {
    sqrt(v.dot(v))
}

/// `v` / |`v`|, by one division and three products: within 2 ULP of unit length. Zero stays zero (so does what underflows);
/// NaN or infinite components give NaN.
#[inline(always)]
pub fn normalize(v: Vec3) -> Vec3 {
    let square = v.dot(v);
    if square == 0.0 { Vec3::ZERO } else { v * div(1.0, sqrt(square)) }
}

/// Largest magnitude of the components; NaN components are ignored unless all are NaN.
#[inline(always)]
pub fn max_abs(v: Vec3) -> f32 {
    max(super::abs(v.x), max(super::abs(v.y), super::abs(v.z)))
}

/// `incident` mirrored at a surface with unit normal `normal` (which side it points to does not matter).
#[inline(always)]
pub fn reflect(incident: Vec3, normal: Vec3) -> Vec3 {
    incident - normal * (2.0 * incident.dot(normal))
}

/// The point at `parameter` of the ray.
#[inline(always)]
pub fn point_at(origin: Vec3, dir: Vec3, parameter: f32) -> Vec3 {
    origin + dir * parameter
}

/// `a` + (`b` − `a`)·`t`, componentwise; exactly `a` at 0, `b` up to a rounding at 1.
#[inline(always)]
pub fn lerp(a: Vec3, b: Vec3, t: f32) -> Vec3 {
    a + (b - a) * t
}
