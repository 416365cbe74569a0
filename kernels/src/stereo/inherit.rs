//! Surfaces of the second view.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Hit, Record, SceneInfo, Surface, Triangle, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::bounce::is_whole;
use parallax_shared::shading::surface::reconstruct;
use parallax_shared::stereo::source::{column, is_reused};

/// What shading needs of each pixel: of a reused one the source's surface, of a traced one what the pass `surface` makes of its hit.
/// With them, reflection and refraction have their first level reprojected and further ones traced, as 001 does. Without `all`, only for
/// the pixels whose `colours` are not whole: the pass `bounce` asks for no other ones.
#[spirv(compute(threads(8, 8, 1)))]
pub fn inherit(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(push_constant)] all: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] source_surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] surfaces: Out<Surface>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        if *all == 0 && is_whole(&colours.at(pixel)) {
            return;
        }
        let word = source.at(pixel);
        if is_reused(word) {
            surfaces.put(pixel, source_surfaces.at(id.y * view.width + column(word)));
        } else {
            let scene =
                SceneView { info, rows: &[], triangles, records, texels: &[], effects: Effects(effects) };
            let ray = camera::primary_ray(view, id.x, view.first_row + id.y);
            surfaces.put(pixel, reconstruct(&scene, &ray, hits.at(pixel), view.interaxial_px));
        }
    }
}
