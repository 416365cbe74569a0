//! Ellipsoids: spheres in a space of their own.

use super::sphere::Chord;
use crate::layout::{Ellipsoid, Ray};
use crate::math::{self, Offset, vector};
use glam::Vec3;

/// Rows of the matrix that takes the ellipsoid to the unit sphere.
#[derive(Clone, Copy)]
pub struct ToUnit(pub [Vec3; 3]);

impl ToUnit {
    /// The matrix of `ellipsoid`.
    #[inline(always)]
    pub fn new(ellipsoid: &Ellipsoid) -> Self {
        let row = |i: usize| {
            Vec3::new(
                ellipsoid.world_to_unit[i][0],
                ellipsoid.world_to_unit[i][1],
                ellipsoid.world_to_unit[i][2],
            )
        };
        Self([row(0), row(1), row(2)])
    }

    /// The vector `v`, seen in unit space.
    #[inline(always)]
    fn of(&self, v: Vec3) -> Vec3 {
        let [x, y, z] = self.0;
        Vec3::new(x.dot(v), y.dot(v), z.dot(v))
    }

    /// The transposed matrix times `v`: takes normals of the unit sphere to the world (not of unit length).
    #[inline(always)]
    fn transposed(&self, v: Vec3) -> Vec3 {
        let [x, y, z] = self.0;
        (x * v.x + y * v.y) + z * v.z
    }
}

/// The box around an ellipsoid; see [`sphere::bounds`](super::sphere::bounds).
#[inline(always)]
pub fn bounds(ellipsoid: &Ellipsoid) -> ([f32; 3], [f32; 3]) {
    let half = [ellipsoid.world_to_unit[0][3], ellipsoid.world_to_unit[1][3], ellipsoid.world_to_unit[2][3]];
    let side = |sign: f32| core::array::from_fn(|i| ellipsoid.centre[i] + sign * half[i]);
    (side(-1.0), side(1.0))
}

/// The smallest `t` ≥ `ray.t_min` at which `ray` meets the ellipsoid, or NaN when there is none; as
/// [`sphere::intersect`](super::sphere::intersect) in every respect.
///
/// The ray's origin is moved to its nearest point (as seen in unit space) in *world* space, by exact sums and
/// products, and only then transformed. So the point at `t` is off the ellipsoid by a few ULP of its largest
/// half axis, even if another one is 10⁴ times smaller.
#[inline(always)]
pub fn intersect(centre: [f32; 3], to_unit: &ToUnit, ray: &Ray, enter: f32, leave: f32) -> f32 {
    let (_, chord) = chord_of(centre, to_unit, ray);
    chord.first_root(ray.t_min, enter, leave)
}

/// The point of the ray at `nearest`, seen from the centre, and the chord.
#[inline(always)]
fn chord_of(centre: [f32; 3], to_unit: &ToUnit, ray: &Ray) -> (Vec3, Chord) {
    let origin = Offset::new(Vec3::from_array(ray.origin), Vec3::from_array(centre));
    let dir = Vec3::from_array(ray.dir);
    let unit_dir = to_unit.of(dir);
    let inverse = math::div(1.0, unit_dir.dot(unit_dir));
    let nearest = -(to_unit.of(origin.rounded).dot(unit_dir) * inverse);
    let from = origin.along(dir, nearest);
    (from, Chord::new(nearest, to_unit.of(from), unit_dir, inverse, 1.0))
}

/// A point of an ellipsoid.
#[derive(Clone, Copy)]
pub struct Point {
    /// World space.
    pub position: Vec3,
    /// Unit normal, outwards, world space.
    pub normal: Vec3,
    /// The point of the unit sphere that it corresponds to.
    pub on_unit_sphere: Vec3,
}

/// The point at which `ray` hits the ellipsoid at parameter `t`.
#[inline(always)]
pub fn point(ellipsoid: &Ellipsoid, ray: &Ray, t: f32) -> Point {
    let (centre, to_unit) = (Vec3::from_array(ellipsoid.centre), ToUnit::new(ellipsoid));
    let (from, chord) = chord_of(ellipsoid.centre, &to_unit, ray);
    let from_centre = from + Vec3::from_array(ray.dir) * chord.end_at(t);
    let unit = to_unit.of(from_centre);
    let to_surface = math::div(1.0, vector::length(unit));
    let on_unit_sphere = unit * to_surface;
    Point {
        position: centre + from_centre * to_surface,
        normal: vector::normalize(to_unit.transposed(on_unit_sphere)),
        on_unit_sphere,
    }
}
