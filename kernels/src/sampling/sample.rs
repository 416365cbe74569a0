//! What points of a lattice see that were traced.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{self, Hit, Record, Row, SceneInfo, Triangle, View};
use parallax_shared::sampling::{lattice, sample as point};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{shadow, surface::reconstruct};
use parallax_shared::stereo::source::is_traced;

/// Light, reflection and refraction at the hits of traced points; which lights they see is noted in `seen`.
#[spirv(compute(threads(8, 8, 1)))]
pub fn sample(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] seen: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] samples: Out<layout::Sample>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if let Some([x, y]) = lattice::point(view, id.x, id.y) {
        let at = y * view.width + x;
        if is_traced(words.at(at)) {
            let scene = SceneView { info, rows, triangles, records, texels, effects: Effects(effects) };
            let ray = camera::primary_ray(view, x, view.first_row + y);
            let surface = reconstruct(&scene, &ray, hits.at(at), view.interaxial_px);
            let first = at * shadow::words(info.lights);
            let note = |word, bits| seen.put(first + word, bits);
            samples.put(at, point::traced(&scene, &surface, ray.dir.into(), note));
        }
    }
}
