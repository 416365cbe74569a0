//! Colours of the reused pixels of the second view where they depend on the viewer.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Record, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{bounce::marked, shadow};
use parallax_shared::stereo::source::{column, is_reused};

/// Shades the points that the source shows once more, for this eye: nothing specular is copied. Which lights they see is reused.
///
/// Departure from 001, which keeps the diffuse part: it is computed again, which costs no ray and no further buffer.
#[spirv(compute(threads(8, 8, 1)))]
pub fn gloss(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] source_surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] source_seen: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] colours: Out<[f32; 4]>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let word = source.at(id.y * view.width + id.x);
        if is_reused(word) {
            let scene =
                SceneView { info, rows: &[], triangles: &[], records, texels, effects: Effects(effects) };
            let from = id.y * view.width + column(word);
            let first = from * shadow::words(info.lights);
            let dir = camera::pixel_direction(view, id.x, view.first_row + id.y);
            let seen = |word| source_seen.at(first + word);
            let surface = source_surfaces.at(from);
            let colour = shadow::shade(&scene, &surface, dir, seen);
            colours.put(id.y * view.width + id.x, marked(&scene, &surface, colour));
        }
    }
}
