//! Local reflection: Lambert's diffuse and Phong's (1975) specular term.

use crate::math::{self, max, vector};
use glam::Vec3;

/// Lambert: the cosine between the unit normal and the unit vector to the light, none from behind.
#[inline(always)]
pub fn diffuse(normal: Vec3, to_light: Vec3) -> f32 {
    max(normal.dot(to_light), 0.0)
}

/// Phong: the cosine between the unit vector to the viewer and the mirror direction of the light, to the
/// power of `shininess`. All vectors point away from the surface. 0 to 1 but for rounding; with an exponent
/// of 0 it is 1 everywhere.
#[inline(always)]
pub fn specular(normal: Vec3, to_light: Vec3, to_viewer: Vec3, shininess: f32) -> f32 {
    let mirrored = -vector::reflect(to_light, normal);
    math::pow(max(mirrored.dot(to_viewer), 0.0), shininess)
}
