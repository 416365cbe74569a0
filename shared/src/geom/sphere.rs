//! Spheres.
//!
//! The quadratic's coefficients lose everything when a small sphere is far away or a large one near. So the ray's origin is first moved to the
//! point that is nearest to the centre, by an exact product; what is left to solve has the size of the sphere (Haines et al. 2019, *Precision
//! Improvements for Ray/Sphere Intersection*, has the perpendicular distance too, but from rounded products, whose error grows with the
//! distance; and, as the roots are ±h around the nearest point here, nothing cancels that its second formula would have to save).

use crate::layout::Ray;
use crate::math::{self, PI, max, min, vector};
use glam::{Vec2, Vec3};

/// The box around a sphere, each plane rounded to nearest. An acceleration structure must use this very box (or a larger one): what
/// rounding takes from it, the padding of boxes gives back.
#[inline]
pub fn bounds(centre: [f32; 3], radius: f32) -> ([f32; 3], [f32; 3]) {
    (centre.map(|c| c - radius), centre.map(|c| c + radius))
}

/// The smallest `t` ≥ `ray.t_min` at which `ray` meets the sphere, or NaN (of which no comparison holds) when there is none.
///
/// `enter` and `leave` bound the ray's way through the sphere's own padded box: `t` is moved into them, and a sphere whose box is
/// missed (`enter > leave`) is missed, so that no larger box can hide a hit (DESIGN §3.1). The answer depends on ray and sphere
/// alone. Origins inside see the far side. A tangent ray hits when the perpendicular distance, within 4 ULP, is not above the
/// radius. `ray.t_max` is left to the caller.
#[inline(always)]
pub fn intersect(centre: [f32; 3], radius: f32, ray: &Ray, enter: f32, leave: f32) -> f32 {
    let (origin, dir) = (Vec3::from_array(ray.origin) - Vec3::from_array(centre), Vec3::from_array(ray.dir));
    let inverse = math::div(1.0, dir.dot(dir));
    let nearest = -(origin.dot(dir) * inverse);
    let (middle, half) = chord(math::along(origin, dir, nearest), dir, inverse, radius * radius);
    first_root(nearest, middle, half, ray.t_min, enter, leave)
}

/// Where the line `from + t·dir` crosses the sphere around the origin: at `middle ± half`; `half` is NaN if nowhere. `inverse` is 1/|dir|².
///
/// `from` is near the point closest to the centre; taking its component along `dir` off once more makes the rest orthogonal to rounding.
#[inline(always)]
pub(super) fn chord(from: Vec3, dir: Vec3, inverse: f32, square: f32) -> (f32, f32) {
    let middle = -(from.dot(dir) * inverse);
    let across = from + dir * middle;
    let gap = square - across.dot(across);
    (middle, if gap >= 0.0 { math::sqrt(gap * inverse) } else { f32::NAN })
}

/// The first of `nearest + (middle ± half)`, moved into `enter ..= leave`, that is not before `t_min`; NaN if there is none.
#[inline(always)]
pub(super) fn first_root(nearest: f32, middle: f32, half: f32, t_min: f32, enter: f32, leave: f32) -> f32 {
    let inside = |t: f32| if enter <= leave { min(max(t, enter), leave) } else { f32::NAN };
    if math::is_nan(half) {
        return half;
    }
    let (near, far) = (inside(nearest + (middle - half)), inside(nearest + (middle + half)));
    if near >= t_min {
        near
    } else if far >= t_min {
        far
    } else {
        f32::NAN
    }
}

/// The point of the sphere at parameter `t` of a ray that hits it there, and the unit normal, outwards. The point lies on the
/// sphere within a few ULP of |centre| + radius, whatever the distance.
#[inline]
pub fn point_and_normal(centre: [f32; 3], radius: f32, ray: &Ray, t: f32) -> (Vec3, Vec3) {
    let centre = Vec3::from_array(centre);
    let normal =
        vector::normalize(math::along(Vec3::from_array(ray.origin) - centre, Vec3::from_array(ray.dir), t));
    (centre + normal * radius, normal)
}

/// Texture coordinates of the unit vector `direction`: u runs once around the y axis, from −z over −x (0.25), +z (0.5) and +x (0.75), to the right as seen from outside; v goes
/// from 0 at −y to 1 at +y.
#[inline]
pub fn uv(direction: Vec3) -> Vec2 {
    let around = math::atan2(direction.x, direction.z) * (0.5 / PI) + 0.5;
    let across = math::sqrt(direction.x * direction.x + direction.z * direction.z);
    let from_top = math::atan2(across, direction.y) * (1.0 / PI);
    Vec2::new(around, 1.0 - from_top)
}
