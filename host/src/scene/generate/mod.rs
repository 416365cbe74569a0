//! Generated objects: the random scenes of the papers, Haines' Standard Procedural Databases, and simple
//! solids.
//!
//! Every generator is a record that a scene file's table is read into (its keys are the record's fields) and
//! that says how much it would make before it makes it: more than [`MAX_PRIMITIVES`] is refused. The same
//! record always makes the same objects: random numbers are SplitMix64's, and nothing depends on the platform
//! but the rounding of sines and cosines.

mod ellipsoid;
mod jacks;
mod lattice;
mod random;
mod random_ellipsoids;
mod random_spheres;
mod solids;
mod sphereflake;
mod tree;
mod tube;

pub use ellipsoid::ellipsoid;
pub use jacks::Jacks;
pub use lattice::Lattice;
pub use random::SplitMix64;
pub use random_ellipsoids::RandomEllipsoids;
pub use random_spheres::RandomSpheres;
pub use solids::{Cube, Icosphere, Quad};
pub use sphereflake::Sphereflake;
pub use tree::Tree;

use parallax_shared::layout::{Ellipsoid, Material, Sphere, Triangle};

use super::material;

/// The most primitives that one generated object may have.
pub const MAX_PRIMITIVES: u64 = 1 << 22;

/// Generated primitives; their materials count in `materials`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    /// Materials.
    pub materials: Vec<Material>,
    /// Triangles.
    pub triangles: Vec<Triangle>,
    /// Spheres.
    pub spheres: Vec<Sphere>,
    /// Ellipsoids.
    pub ellipsoids: Vec<Ellipsoid>,
}

/// What makes objects.
pub trait Generate {
    /// How many primitives it makes; [`u64::MAX`] when they cannot be counted.
    fn count(&self) -> u64;

    /// Makes them. To be called only when [`Generate::count`] is at most [`MAX_PRIMITIVES`].
    fn shapes(&self) -> Shapes;
}

impl Shapes {
    /// Adds a material and returns its number.
    fn material(&mut self, material: Material) -> u32 {
        self.materials.push(material);
        self.materials.len() as u32 - 1
    }

    fn sphere(&mut self, centre: [f64; 3], radius: f64, material: u32) {
        let centre = centre.map(|x| x as f32);
        self.spheres.push(Sphere { centre, radius: radius as f32, material, padding: [0; 3] });
    }

    /// A parallelogram from `corner` along `u` and `v`, seen counter-clockwise from `u × v`.
    fn parallelogram(&mut self, corner: [f32; 3], u: [f32; 3], v: [f32; 3], material: u32) {
        let at = |a: f32, b: f32| std::array::from_fn(|i| corner[i] + a * u[i] + b * v[i]);
        self.quadrangle([at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)], material);
    }

    /// A plane quadrangle: two flat triangles.
    fn quadrangle(&mut self, [a, b, c, d]: [[f32; 3]; 4], material: u32) {
        for (vertices, uvs) in [
            ([a, b, c], [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]),
            ([a, c, d], [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]),
        ] {
            let normals = [[0.0; 3]; 3];
            self.triangles.push(Triangle { vertices, material, normals, smooth: 0, uvs, padding: [0; 2] });
        }
    }
}

/// A material of the SPD: (ambient, diffuse, specular, shininess); it reflects as much as it shines.
fn spd(colour: [f32; 3], [ambient, diffuse, specular, shininess]: [f32; 4]) -> Material {
    Material { colour, ambient, diffuse, specular, shininess, reflection: specular, ..material::DEFAULT }
}

/// The sum of `base^n` for n from 0 to `last`, or [`u64::MAX`].
fn powers(base: u64, last: u32) -> u64 {
    let mut sum = 0_u64;
    for _ in 0..=last.min(64) {
        sum = sum.saturating_mul(base).saturating_add(1);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_powers() {
        assert_eq!([0, 1, 2, 6].map(|n| powers(9, n)), [1, 10, 91, 597_871]);
        assert_eq!(powers(2, 11), 4095);
        assert_eq!(powers(9, u32::MAX), u64::MAX);
    }
}
