//! Spheres.
//!
//! The quadratic's coefficients lose everything when a small sphere is far away or a large one near. So the
//! ray's origin is first moved to the point that is nearest to the centre, by exact sums and products; what
//! is left to solve has the size of the sphere (Haines et al. 2019, *Precision Improvements for Ray/Sphere
//! Intersection*, has the perpendicular distance too, but from rounded products, whose error grows with the
//! distance; and, as the roots are ±h around the nearest point here, nothing cancels that its second formula
//! would have to save).

use crate::layout::Ray;
use crate::math::{self, Offset, PI, max, min, vector};
use glam::{Vec2, Vec3};

/// The box around a sphere, each plane rounded to nearest. An acceleration structure must use this very box
/// (or a larger one): what rounding takes from it, the padding of boxes gives back.
#[inline(always)]
pub fn bounds(centre: [f32; 3], radius: f32) -> ([f32; 3], [f32; 3]) {
    (centre.map(|c| c - radius), centre.map(|c| c + radius))
}

/// The smallest `t` ≥ `ray.t_min` at which `ray` meets the sphere, or NaN (of which no comparison holds) when
/// there is none.
///
/// `enter` and `leave` bound the ray's way through the sphere's own padded box: `t` is moved into them, and a sphere whose box is
/// missed (`enter > leave`) is missed, so that no larger box can hide a hit (DESIGN §3.1). The answer depends
/// on ray and sphere alone. Origins inside see the far side. A tangent ray hits when the perpendicular
/// distance, within 4 ULP, is not above the radius. `ray.t_max` is left to the caller.
#[inline(always)]
pub fn intersect(centre: [f32; 3], radius: f32, ray: &Ray, enter: f32, leave: f32) -> f32 {
    let (_, chord) = chord_of(centre, radius, ray);
    chord.first_root(ray.t_min, enter, leave)
}

/// Where a ray is inside of a sphere: from `nearest + (middle − half)` to `nearest + (middle + half)`.
#[derive(Clone, Copy)]
pub(super) struct Chord {
    /// Where the ray is about nearest to the centre.
    pub nearest: f32,
    /// From there to where it is, but for rounding: small.
    pub middle: f32,
    /// Half the length; NaN when the sphere is missed.
    pub half: f32,
}

/// The point of the ray at `nearest`, seen from the centre, and the chord.
#[inline(always)]
fn chord_of(centre: [f32; 3], radius: f32, ray: &Ray) -> (Vec3, Chord) {
    let origin = Offset::new(Vec3::from_array(ray.origin), Vec3::from_array(centre));
    let dir = Vec3::from_array(ray.dir);
    let inverse = math::div(1.0, dir.dot(dir));
    let nearest = -(origin.rounded.dot(dir) * inverse);
    let from = origin.along(dir, nearest);
    (from, Chord::new(nearest, from, dir, inverse, radius * radius))
}

impl Chord {
    /// The chord in the sphere around the origin of the line `from + t·dir`, whose `t` is counted from
    /// `nearest`. `inverse` is 1/|dir|².
    ///
    /// `from` is near the point closest to the centre; taking its component along `dir` off makes the rest orthogonal to rounding.
    #[inline(always)]
    pub fn new(nearest: f32, from: Vec3, dir: Vec3, inverse: f32, square: f32) -> Self {
        let middle = -(from.dot(dir) * inverse);
        let across = from + dir * middle;
        let gap = square - across.dot(across);
        Self { nearest, middle, half: if gap >= 0.0 { math::sqrt(gap * inverse) } else { f32::NAN } }
    }

    /// The first end, moved into `enter ..= leave`, that is not before `t_min`; NaN if there is none.
    #[inline(always)]
    pub fn first_root(self, t_min: f32, enter: f32, leave: f32) -> f32 {
        let Self { nearest, middle, half } = self;
        if math::is_nan(half) || enter > leave {
            return f32::NAN;
        }
        let inside = |t: f32| min(max(t, enter), leave);
        let (near, far) = (inside(nearest + (middle - half)), inside(nearest + (middle + half)));
        if near >= t_min {
            near
        } else if far >= t_min {
            far
        } else {
            f32::NAN
        }
    }

    /// The end that is closer to `t`, counted from `nearest`: with more digits than a large `t` has.
    #[inline(always)]
    pub fn end_at(self, t: f32) -> f32 {
        let (near, far) = (self.middle - self.half, self.middle + self.half);
        if math::abs(t - (self.nearest + near)) <= math::abs(t - (self.nearest + far)) { near } else { far }
    }
}

/// The point at which `ray` hits the sphere at parameter `t`, and the unit normal, outwards. The point lies
/// on the sphere within a few ULP of |centre| + radius, whatever the distance (of which `t` itself has only
/// 24 bits).
#[inline(always)]
pub fn point_and_normal(centre: [f32; 3], radius: f32, ray: &Ray, t: f32) -> (Vec3, Vec3) {
    let (from, chord) = chord_of(centre, radius, ray);
    let normal = vector::normalize(from + Vec3::from_array(ray.dir) * chord.end_at(t));
    (Vec3::from_array(centre) + normal * radius, normal)
}

/// Texture coordinates of the unit vector `direction`: u runs once around the y axis, from −z over −x (0.25),
/// +z (0.5) and +x (0.75), to the right as seen from outside; v goes from 0 at −y to 1 at +y.
#[inline(always)]
pub fn uv(direction: Vec3) -> Vec2 {
    let around = math::atan2(direction.x, direction.z) * (0.5 / PI) + 0.5;
    let across = math::sqrt(direction.x * direction.x + direction.z * direction.z);
    let from_top = math::atan2(across, direction.y) * (1.0 / PI);
    Vec2::new(around, 1.0 - from_top)
}
