//! The boxes of primitives, and which primitive has which number.

use super::BuildError;
use glam::Vec3A;
use obvhs::aabb::Aabb;
use parallax_shared::geom::{ellipsoid, sphere};
use parallax_shared::layout::{Ellipsoid, Sphere, Triangle};
use parallax_shared::traversal::rows::Kind;

/// The primitives of a scene, numbered through: triangles, spheres, ellipsoids.
#[derive(Clone, Copy)]
pub struct Primitives<'a> {
    /// The first numbers.
    pub triangles: &'a [Triangle],
    /// The next.
    pub spheres: &'a [Sphere],
    /// The last.
    pub ellipsoids: &'a [Ellipsoid],
}

impl Primitives<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.triangles.len() + self.spheres.len() + self.ellipsoids.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// What primitive `number` is.
    pub fn kind(&self, number: u32) -> Kind {
        let number = number as usize;
        if number < self.triangles.len() {
            Kind::Triangles
        } else if number < self.triangles.len() + self.spheres.len() {
            Kind::Spheres
        } else {
            Kind::Ellipsoids
        }
    }

    /// The box of each, exactly as the traversal bounds it.
    pub fn all_boxes(&self) -> impl Iterator<Item = Aabb> {
        (self.triangles.iter().map(triangle_box))
            .chain(self.spheres.iter().map(sphere_box))
            .chain(self.ellipsoids.iter().map(ellipsoid_box))
    }

    /// [`all_boxes`](Self::all_boxes), checked.
    ///
    /// # Errors
    /// If one is not finite, or if there are too many.
    pub fn boxes(&self) -> Result<Vec<Aabb>, BuildError> {
        if self.len() > (1 << 27) {
            return Err(BuildError::TooMany(self.len()));
        }
        let boxes: Vec<Aabb> = self.all_boxes().collect();
        match boxes.iter().position(|b| !(b.min.is_finite() && b.max.is_finite())) {
            Some(number) => Err(BuildError::NotFinite(number as u32)),
            None => Ok(boxes),
        }
    }
}

/// NaN if a coordinate is: `min` and `max` alone would drop it.
fn triangle_box(triangle: &Triangle) -> Aabb {
    let [a, b, c] = triangle.vertices.map(Vec3A::from);
    let nan = (a + b + c) * 0.0;
    Aabb { min: a.min(b).min(c) + nan, max: a.max(b).max(c) + nan }
}

fn sphere_box(sphere: &Sphere) -> Aabb {
    let (low, high) = sphere::bounds(sphere.centre, sphere.radius);
    Aabb { min: low.into(), max: high.into() }
}

fn ellipsoid_box(ellipsoid: &Ellipsoid) -> Aabb {
    let (low, high) = ellipsoid::bounds(ellipsoid);
    Aabb { min: low.into(), max: high.into() }
}

/// Largest absolute coordinate of all boxes.
pub fn extent(boxes: &[Aabb]) -> f32 {
    boxes.iter().fold(0.0, |extent, b| b.min.abs().max(b.max.abs()).max_element().max(extent))
}
