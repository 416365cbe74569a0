//! The exact power of two by which a scene is scaled before anything is computed (DESIGN §3.1.7).
//!
//! It changes no bit of any mantissa, so that what is computed is the same picture; but squares, and the
//! error terms of products, stay far away from denormals and from overflow, whatever the units of the scene
//! are.

use crate::scene::{Ellipsoid, Light, Material, Scene, Sphere, Triangle};

/// The largest coordinate of a scaled scene is in [2⁹, 2¹⁰). With 24 bits of it left for details, fourth
/// powers of the smallest are above 2⁻⁶⁰, their error terms above 2⁻¹⁰⁸, and eighth powers of the largest
/// below 2⁸⁰.
const EXPONENT: i32 = 9;

/// The factor for a scene whose largest absolute coordinate is `extent`.
pub fn factor(extent: f32) -> f32 {
    if extent == 0.0 {
        return 1.0;
    }
    let exponent = (extent.abs().to_bits() >> 23) as i32 - 127;
    f32::from_bits(((EXPONENT - exponent).clamp(-126, 126) + 127) as u32 * (1 << 23))
}

/// The largest absolute coordinate of all primitives and of the point between the eyes.
pub fn extent(scene: &Scene) -> f32 {
    let triangles = scene.triangles.iter().map(|triangle| largest(triangle.vertices.as_flattened()));
    let spheres = scene.spheres.iter().map(|sphere| largest(&sphere.centre) + sphere.radius);
    let ellipsoids = scene.ellipsoids.iter().map(|ellipsoid| {
        let half = ellipsoid.world_to_unit.map(|row| row[3]);
        largest(&ellipsoid.centre) + largest(&half)
    });
    triangles.chain(spheres).chain(ellipsoids).fold(largest(&scene.rig.eye), f32::max)
}

/// The largest absolute value.
pub fn largest(values: &[f32]) -> f32 {
    values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

/// Something with coordinates.
pub trait Scaled {
    /// The same thing in units that are `1 / factor` as large; `factor` is a power of two.
    fn scaled(&self, factor: f32) -> Self;
}

impl Scaled for [f32; 3] {
    fn scaled(&self, factor: f32) -> Self {
        self.map(|coordinate| coordinate * factor)
    }
}

impl Scaled for Triangle {
    fn scaled(&self, factor: f32) -> Self {
        Self { vertices: self.vertices.map(|vertex| vertex.scaled(factor)), ..*self }
    }
}

impl Scaled for Sphere {
    fn scaled(&self, factor: f32) -> Self {
        Self { centre: self.centre.scaled(factor), radius: self.radius * factor, ..*self }
    }
}

impl Scaled for Ellipsoid {
    fn scaled(&self, factor: f32) -> Self {
        let row = |[x, y, z, half]: [f32; 4]| [x / factor, y / factor, z / factor, half * factor];
        Self { centre: self.centre.scaled(factor), world_to_unit: self.world_to_unit.map(row), ..*self }
    }
}

impl Scaled for Light {
    fn scaled(&self, factor: f32) -> Self {
        Self { position: self.position.scaled(factor), ..*self }
    }
}

impl Scaled for Material {
    fn scaled(&self, factor: f32) -> Self {
        Self { checker_scale: self.checker_scale / factor, ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_powers_of_two_that_bring_the_extent_to_one_size() {
        for extent in [1e-30_f32, 1e-15, 0.1, 1.0, 3.0, 512.0, 148_376.0, 1e15, 1e38] {
            let factor = factor(extent);
            assert_eq!(factor.to_bits() & 0x7f_ffff, 0, "{extent}");
            assert!((512.0..1024.0).contains(&(extent * factor)), "{extent}");
        }
    }

    #[test]
    fn nothing_and_almost_nothing_have_a_factor_too() {
        assert_eq!(factor(0.0), 1.0);
        assert_eq!(factor(f32::from_bits(1)), 2.0_f32.powi(126));
    }

    #[test]
    fn an_ellipsoid_keeps_its_shape() {
        let world_to_unit = [[0.5, 0.0, 0.0, 2.0], [0.0, 0.25, 0.0, 4.0], [0.0, 0.0, 1.0, 1.0]];
        let ellipsoid = Ellipsoid { centre: [1.0, 2.0, 3.0], material: 7, world_to_unit };
        let scaled = ellipsoid.scaled(8.0);
        assert_eq!(scaled.centre, [8.0, 16.0, 24.0]);
        assert_eq!(scaled.world_to_unit[0], [0.0625, 0.0, 0.0, 16.0]);
        assert_eq!(scaled.scaled(0.125), ellipsoid);
    }
}
