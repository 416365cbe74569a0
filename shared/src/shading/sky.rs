//! What a ray sees that leaves the scene.

use super::texture::{self, Edge};
use crate::effects::Effects;
use crate::geom::sphere;
use crate::layout::NONE;
use crate::math::{abs, vector};
use crate::scene::SceneView;
use glam::Vec3;

/// Linear colour of the sky in direction `dir` (any length but zero); y is up.
///
/// An equirectangular map (seen from inside: its middle is at −z, its right half at +x, its top row straight
/// up), or the gradient from the horizon to the zenith, linear in the height |y| of the unit vector and
/// mirrored below.
#[inline(always)]
pub fn colour(scene: &SceneView<'_>, dir: Vec3) -> Vec3 {
    let dir = vector::normalize(dir);
    if scene.effects.has(Effects::SKY_MAP) && scene.info.sky_texture != NONE {
        let map = scene.texture(scene.info.sky_texture);
        // From inside, the sphere's texture would be a mirror image.
        let outside = Vec3::new(dir.x, dir.y, -dir.z);
        return texture::sample(scene.texels, &map, sphere::uv(outside), Edge::Clamp);
    }
    let (horizon, zenith) =
        (Vec3::from_array(scene.info.sky_horizon), Vec3::from_array(scene.info.sky_zenith));
    vector::lerp(horizon, zenith, abs(dir.y))
}
