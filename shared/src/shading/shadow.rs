//! Direct light of primary hits in two steps, so that the visibility of lights can be had, kept and reused
//! apart from colours.

use super::{light, sky};
use crate::effects::Effects;
use crate::layout::{NONE, RayCounts, Surface};
use crate::math::vector;
use crate::scene::SceneView;
use crate::traversal::occluded;
use glam::Vec3;

/// How many words hold a bit for each of `lights` lights; at least one.
#[inline(always)]
pub fn words(lights: u32) -> u32 {
    if lights <= 32 { 1 } else { (lights + 31) >> 5 }
}

/// Traces a ray from `surface` to each light that it faces. `put` gets every word once, in order, with bit i
/// % 32 of word i / 32 set when light i is seen. Misses, and materials on which light does not show, see
/// none. Returns the number of rays.
#[inline(always)]
pub fn trace(scene: &SceneView<'_>, surface: &Surface, mut put: impl FnMut(u32, u32)) -> RayCounts {
    let mut counts = RayCounts::NONE;
    let lit = scene.effects.has(Effects::LIGHTS)
        && surface.prim_id != NONE
        && light::is_lit(&light::material_of(scene, surface));
    let mut word = 0;
    while word < words(scene.info.lights) {
        let (mut bits, mut bit) = (0, 0);
        while lit && bit < 32 && word * 32 + bit < scene.info.lights {
            if let Some(ray) = light::shadow_ray(surface, &scene.light(word * 32 + bit)) {
                counts.shadow += 1;
                bits |= (!occluded(scene.rows, &ray, scene.info.extent) as u32) << bit;
            }
            bit += 1;
        }
        put(word, bits);
        word += 1;
    }
    counts
}

/// The colour that a primary ray in direction `dir` sees at `surface`, without reflection and refraction, and the rays to lights that
/// it took: what [`trace`] and [`shade`] do, bit for bit, without anything kept in between. `note` gets the words that `trace` would put,
/// as far as `shade` would ask for them.
#[inline(always)]
pub fn direct(
    scene: &SceneView<'_>,
    surface: &Surface,
    dir: Vec3,
    mut note: impl FnMut(u32, u32),
) -> (Vec3, RayCounts) {
    let mut counts = RayCounts::NONE;
    if surface.prim_id == NONE {
        return (sky::colour(scene, dir), counts);
    }
    let material = light::material_of(scene, surface);
    let mut bits = 0;
    let local = light::local(scene, surface, &material, vector::normalize(dir), |i, light| {
        let seen = light::is_seen(scene, surface, light, &mut counts);
        bits |= (seen as u32) << (i & 31);
        if i & 31 == 31 || i + 1 == scene.info.lights {
            note(i >> 5, bits);
            bits = 0;
        }
        seen
    });
    (local.diffuse + local.specular, counts)
}

/// The colour that a primary ray in direction `dir` (any length) sees at `surface`, without reflection and
/// refraction; the sky's colour at a miss. `seen` gives the words that [`trace`] has put.
#[inline(always)]
pub fn shade(scene: &SceneView<'_>, surface: &Surface, dir: Vec3, seen: impl Fn(u32) -> u32) -> Vec3 {
    if surface.prim_id == NONE {
        return sky::colour(scene, dir);
    }
    let material = light::material_of(scene, surface);
    let mut word = 0;
    let local = light::local(scene, surface, &material, vector::normalize(dir), |i, _| {
        // One read for 32 lights.
        if i & 31 == 0 {
            word = seen(i >> 5);
        }
        (word >> (i & 31)) & 1 == 1
    });
    local.diffuse + local.specular
}
