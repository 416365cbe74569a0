//! What points of a lattice see that the other view shows.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Hit, Record, Row, Sample, SceneInfo, Triangle, View};
use parallax_shared::sampling::{lattice, sample as point};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{bounce::bounces, shadow, surface::reconstruct};
use parallax_shared::stereo::source::{VERIFIED, column, is_reused, kind};

/// Shades reused points for this eye, by the light that the source saw; reflections and refractions of them are traced. With `carried`,
/// only the points that have any: the others have the samples of the pass `carry`.
#[spirv(compute(threads(8, 8, 1)))]
pub fn infer(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] source_view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(push_constant)] carried: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] source_seen: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] samples: Out<Sample>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if let Some([x, y]) = lattice::point(view, id.x, id.y) {
        let (first, in_picture) = (y * view.width, view.first_row + y);
        let word = words.at(first + x);
        if is_reused(word) {
            let scene = SceneView { info, rows, triangles, records, texels, effects: Effects(effects) };
            let from = first + column(word);
            let ray = camera::primary_ray(source_view, column(word), in_picture);
            let surface = reconstruct(&scene, &ray, source_hits.at(from), view.interaxial_px);
            if *carried == 0 || bounces(&scene, &surface) {
                let dir = camera::pixel_direction(view, x, in_picture);
                let seen = |word| source_seen.at(from * shadow::words(info.lights) + word);
                let sample = point::inferred(&scene, &surface, dir, kind(word) == VERIFIED, seen);
                samples.put(first + x, sample);
            }
        }
    }
}
