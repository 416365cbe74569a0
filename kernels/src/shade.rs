//! Colours without reflection and refraction.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Record, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{bounce::marked, shadow};

/// The linear colour of each pixel by ambient light and the lights that it sees, or the sky's. The fourth word is 1 where
/// that is all, and 0 where the pass `bounce` adds to it.
#[spirv(compute(threads(8, 8, 1)))]
pub fn shade(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] seen: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] colours: Out<[f32; 4]>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        let scene = SceneView { info, rows: &[], triangles: &[], records, texels, effects: Effects(effects) };
        let first = pixel * shadow::words(info.lights);
        let dir = camera::pixel_direction(view, id.x, view.first_row + id.y);
        let surface = surfaces.at(pixel);
        let colour = shadow::shade(&scene, &surface, dir, |word| seen.at(first + word));
        colours.put(pixel, marked(&scene, &surface, colour));
    }
}
