//! Ambient light and point lights.
//!
//! As in Whitted's and Phong's models a point light does not fade with distance, and a transparent object
//! casts a full shadow: the light that it would refract cannot be found by a ray towards the light.

use super::{phong, surface, texture};
use crate::effects::Effects;
use crate::layout::{BACK, Light, Material, Ray, RayCounts, Surface};
use crate::math::vector;
use crate::scene::SceneView;
use crate::traversal::occluded;
use glam::Vec3;

/// Light that a surface sends to the viewer by itself, in parts: what is the same for every viewer, and what is not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local {
    /// Ambient and diffuse: two views may share it.
    pub diffuse: Vec3,
    /// Specular: each view has its own.
    pub specular: Vec3,
}

/// The material of `surface`.
#[inline(always)]
pub fn material_of(scene: &SceneView<'_>, surface: &Surface) -> Material {
    scene.material(surface.material & !BACK)
}

/// Whether light from points can change how `material` looks.
#[inline(always)]
pub fn is_lit(material: &Material) -> bool {
    material.diffuse > 0.0 || material.specular > 0.0
}

/// The ray from `surface` to the light, with the light at `t` = 1, which is not accepted; `None` when the
/// surface turns away from it (by its geometric or its shading normal), so that no ray is needed.
#[inline(always)]
pub fn shadow_ray(surface: &Surface, light: &Light) -> Option<Ray> {
    let position = Vec3::from_array(light.position);
    let towards = position - Vec3::from_array(surface.position);
    let faces = Vec3::from_array(surface.normal).dot(towards) > 0.0;
    let shows = Vec3::from_array(surface.shading_normal).dot(towards) > 0.0;
    let origin = surface::leave(surface, towards);
    let ray = Ray { origin: origin.to_array(), t_min: 0.0, dir: (position - origin).to_array(), t_max: 1.0 };
    (faces & shows).then_some(ray)
}

/// Whether `surface` faces the light and nothing is between them; a ray that this takes is counted.
#[inline(always)]
pub fn is_seen(scene: &SceneView<'_>, surface: &Surface, light: &Light, counts: &mut RayCounts) -> bool {
    match shadow_ray(surface, light) {
        Some(ray) => {
            counts.shadow += 1;
            !occluded(scene.rows, &ray, scene.info.extent)
        }
        None => false,
    }
}

/// What `surface` of `material` sends against `dir`, the unit direction of the ray that sees it. `sees` says
/// of light `i` whether the surface faces it and nothing is between them; it is asked once for each light, in
/// order.
#[inline(always)]
pub fn local(
    scene: &SceneView<'_>,
    surface: &Surface,
    material: &Material,
    dir: Vec3,
    mut sees: impl FnMut(u32, &Light) -> bool,
) -> Local {
    let colour = texture::colour(scene, material, surface);
    let mut diffuse = Vec3::from_array(scene.info.ambient) * material.ambient;
    let mut specular = Vec3::ZERO;
    if scene.effects.has(Effects::LIGHTS) && is_lit(material) {
        let normal = Vec3::from_array(surface.shading_normal);
        let mut i = 0;
        while i < scene.info.lights {
            let light = scene.light(i);
            if sees(i, &light) {
                let to_light =
                    vector::normalize(Vec3::from_array(light.position) - Vec3::from_array(surface.position));
                let strength = Vec3::from_array(light.colour);
                diffuse += strength * (material.diffuse * phong::diffuse(normal, to_light));
                if scene.effects.has(Effects::SPECULAR) {
                    let shine = phong::specular(normal, to_light, -dir, material.shininess);
                    specular += strength * (material.specular * shine);
                }
            }
            i += 1;
        }
    }
    Local { diffuse: colour * diffuse, specular }
}
