//! What a point of a lattice sees: everything that the passes of a dense picture do one after the other, for points that are few.

use crate::layout::{RayCounts, Sample, Surface};
use crate::scene::SceneView;
use crate::shading::{bounce, shadow};
use glam::Vec3;

/// The sample of a point whose ray, in direction `dir`, was traced and met `surface`. `note` gets the words of
/// [`shadow::trace`] as they would be for a surface that light changes; none for others.
#[inline(always)]
pub fn traced(scene: &SceneView<'_>, surface: &Surface, dir: Vec3, note: impl FnMut(u32, u32)) -> Sample {
    let (local, to_lights) = shadow::direct(scene, surface, dir, note);
    with_bounces(scene, surface, dir, local, RayCounts { primary: 1, ..to_lights })
}

/// The sample of a point for which the other view has `surface` and `seen`, the words about its lights. `verified` when a ray made sure
/// that nothing hides it.
#[inline(always)]
pub fn inferred(
    scene: &SceneView<'_>,
    surface: &Surface,
    dir: Vec3,
    verified: bool,
    seen: impl Fn(u32) -> u32,
) -> Sample {
    let local = shadow::shade(scene, surface, dir, seen);
    let counts = RayCounts { primary: verified as u32, ..RayCounts::NONE };
    with_bounces(scene, surface, dir, local, counts)
}

#[inline(always)]
fn with_bounces(
    scene: &SceneView<'_>,
    surface: &Surface,
    dir: Vec3,
    local: Vec3,
    counts: RayCounts,
) -> Sample {
    let (bounced, more) = bounce::light_from(scene, surface, dir);
    let rays = RayCounts {
        primary: counts.primary + more.primary,
        shadow: counts.shadow + more.shadow,
        reflected: more.reflected,
        refracted: more.refracted,
    };
    Sample { colour: (local + bounced).to_array(), padding: 0, rays }
}
