//! Light that arrives by reflection and refraction: the tree of rays behind a hit (Whitted 1980), without recursion.

use super::{fresnel, light, sky, surface};
use crate::effects::Effects;
use crate::layout::{BACK, Hit, Material, NONE, Ray, RayCounts, Surface};
use crate::math::{max, min, vector};
use crate::scene::SceneView;
use crate::traversal::closest_hit;
use glam::Vec3;
use kernel_api::Stack;

/// Levels of the tree behind the primary hit, at most; a larger
/// [`max_depth`](crate::layout::SceneInfo::max_depth) counts as this one.
pub const MAX_DEPTH: u32 = 15;

/// Room for the rays that wait. Two rays leave a hit and the tree is walked depth first, so no more than one
/// per level waits, and one more.
const PENDING: usize = MAX_DEPTH as usize + 1;

/// A ray that would change no component of the pixel by more than this times what it sees is not traced.
const LEAST_WEIGHT: f32 = 1.0 / 1024.0;

/// Whether `surface` reflects or refracts, so that [`light_from`] may add something to what it sends by itself.
#[inline(always)]
pub fn bounces(scene: &SceneView<'_>, surface: &Surface) -> bool {
    scene.effects.has(Effects::REFLECTION)
        && scene.info.max_depth > 0
        && surface.prim_id != NONE
        && reflects(&light::material_of(scene, surface))
}

/// `colour`, which `surface` sends by itself, with a fourth word that says whether that is all: 0 where it [`bounces`], else 1. Nothing
/// but this word has to be read of all other pixels.
#[inline(always)]
pub fn marked(scene: &SceneView<'_>, surface: &Surface, colour: Vec3) -> [f32; 4] {
    colour.extend(if bounces(scene, surface) { 0.0 } else { 1.0 }).to_array()
}

/// Whether a colour that is [`marked`] is all that is seen.
#[inline(always)]
pub fn is_whole(colour: &[f32; 4]) -> bool {
    colour[3] != 0.0
}

#[inline(always)]
fn reflects(material: &Material) -> bool {
    material.reflection > 0.0 || material.transmission > 0.0
}

/// A ray of the tree that has not been traced yet.
#[derive(Clone, Copy)]
struct Pending {
    origin: Vec3,
    /// Unit length.
    dir: Vec3,
    /// What it sees counts this much.
    weight: Vec3,
    /// Its level; rays that leave a primary hit have 1.
    depth: u32,
}

/// What reaches the viewer from `seen`, which a primary ray in direction `dir` (any length) saw, by
/// reflection and refraction, and the rays that it took. Nothing for a miss.
///
/// A material with reflection r and transmission t sends (r + t·F) of what it sees in mirror direction and
/// t·(1 − F) of what it sees through the surface, F being Fresnel's reflectance: both together r + t, so that
/// no light is made. Where everything is reflected F is 1. A ray on the last level sees only the surface's
/// own light. What is behind a ray of too little weight (1/1024) counts as black.
#[inline(always)]
pub fn light_from(scene: &SceneView<'_>, seen: &Surface, dir: Vec3) -> (Vec3, RayCounts) {
    let mut counts = RayCounts::NONE;
    if !scene.effects.has(Effects::REFLECTION) || seen.prim_id == NONE {
        return (Vec3::ZERO, counts);
    }
    let mut pending = Stack::<Pending, PENDING>::new();
    let mut sum = Vec3::ZERO;
    let first = light::material_of(scene, seen);
    spawn(scene, seen, &first, vector::normalize(dir), Vec3::ONE, 0, &mut pending, &mut counts);
    while let Some(Pending { origin, dir, weight, depth }) = pending.pop() {
        let ray = Ray { origin: origin.to_array(), t_min: 0.0, dir: dir.to_array(), t_max: f32::INFINITY };
        let hit = closest_hit(scene.rows, &ray, scene.info.extent);
        if hit.prim_id == NONE {
            sum += weight * sky::colour(scene, dir);
        } else {
            sum += weight * at_hit(scene, &ray, hit, weight, depth, &mut pending, &mut counts);
        }
    }
    (sum, counts)
}

/// What a surface of the tree sends by itself. The rays that leave it begin to wait.
#[inline(always)]
fn at_hit(
    scene: &SceneView<'_>,
    ray: &Ray,
    hit: Hit,
    weight: Vec3,
    depth: u32,
    pending: &mut Stack<Pending, PENDING>,
    counts: &mut RayCounts,
) -> Vec3 {
    let dir = Vec3::from_array(ray.dir);
    let seen = surface::reconstruct(scene, ray, hit, 0.0);
    let material = light::material_of(scene, &seen);
    spawn(scene, &seen, &material, dir, weight, depth, pending, counts);
    let local =
        light::local(scene, &seen, &material, dir, |_, light| light::is_seen(scene, &seen, light, counts));
    local.diffuse + local.specular
}

/// Lets the rays wait that leave `seen`, which a ray on level `depth` hit in direction `dir`.
#[allow(clippy::too_many_arguments)] // One call's worth of state; a struct for it would only be taken apart again.
#[inline(always)]
fn spawn(
    scene: &SceneView<'_>,
    seen: &Surface,
    material: &Material,
    dir: Vec3,
    weight: Vec3,
    depth: u32,
    pending: &mut Stack<Pending, PENDING>,
    counts: &mut RayCounts,
) {
    if depth >= min_depth(scene.info.max_depth) || !reflects(material) {
        return;
    }
    let normal = facing_normal(seen, dir);
    let cos_i = min(-dir.dot(normal), 1.0);
    let mut mirrored = material.reflection;
    if scene.effects.has(Effects::REFRACTION) && material.transmission > 0.0 {
        let inside = seen.material & BACK != 0;
        let eta = if inside { crate::math::div(1.0, material.eta) } else { material.eta };
        let share = fresnel::reflectance(cos_i, eta);
        mirrored += material.transmission * share;
        if let Some(cos_t) = fresnel::refracted_cosine(cos_i, eta) {
            let through = vector::normalize(fresnel::refracted(dir, normal, cos_i, cos_t, eta));
            let weight = weight * (material.transmission * (1.0 - share));
            counts.refracted += push(seen, through, weight, depth + 1, pending);
        }
    }
    counts.reflected += push(seen, vector::reflect(dir, normal), weight * mirrored, depth + 1, pending);
}

#[inline(always)]
fn min_depth(max_depth: u32) -> u32 {
    if max_depth < MAX_DEPTH { max_depth } else { MAX_DEPTH }
}

/// The shading normal if a ray in direction `dir` sees its front and is mirrored to outside of the surface,
/// else the geometric one.
#[inline(always)]
fn facing_normal(seen: &Surface, dir: Vec3) -> Vec3 {
    let (shading, geometric) = (Vec3::from_array(seen.shading_normal), Vec3::from_array(seen.normal));
    let faces = dir.dot(shading) < 0.0;
    let outside = vector::reflect(dir, shading).dot(geometric) > 0.0;
    if faces & outside { shading } else { geometric }
}

/// Lets a ray wait, unless its weight is too small; returns how many rays that makes.
#[inline(always)]
fn push(seen: &Surface, dir: Vec3, weight: Vec3, depth: u32, pending: &mut Stack<Pending, PENDING>) -> u32 {
    if max(weight.x, max(weight.y, weight.z)) < LEAST_WEIGHT {
        return 0;
    }
    pending.push(Pending { origin: surface::leave(seen, dir), dir, weight, depth }) as u32
}
