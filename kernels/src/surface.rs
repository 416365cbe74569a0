//! From hits to surfaces.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{self, Hit, Record, SceneInfo, Triangle, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::surface::reconstruct;

/// What shading needs of each primary hit: position, normals, texture coordinates, material, disparity.
#[spirv(compute(threads(8, 8, 1)))]
pub fn surface(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] surfaces: Out<layout::Surface>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        let ray = camera::primary_ray(view, id.x, view.first_row + id.y);
        let scene = SceneView { info, rows: &[], triangles, records, texels: &[], effects: Effects(effects) };
        surfaces.put(pixel, reconstruct(&scene, &ray, hits.at(pixel), view.interaxial_px));
    }
}
