//! Colours of the traced pixels of the second view.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Hit, RayCounts, Record, Row, SceneInfo, Triangle, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{bounce::marked, shadow::direct, surface::reconstruct};
use parallax_shared::stereo::source::is_reused;

/// What the passes `surface`, `shadow` and `shade` do, for the pixels that were traced; others keep what they have. `counts` has the
/// rays to lights.
#[spirv(compute(threads(8, 8, 1)))]
pub fn light(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] source: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] colours: Out<[f32; 4]>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] counts: Out<RayCounts>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        if !is_reused(source.at(pixel)) {
            let scene = SceneView { info, rows, triangles, records, texels, effects: Effects(effects) };
            let ray = camera::primary_ray(view, id.x, view.first_row + id.y);
            let surface = reconstruct(&scene, &ray, hits.at(pixel), view.interaxial_px);
            let (colour, rays) = direct(&scene, &surface, ray.dir.into(), |_, _| {});
            colours.put(pixel, marked(&scene, &surface, colour));
            counts.put(pixel, rays);
        }
    }
}
