//! Reflections and refractions of the source.

use glam::{UVec3, Vec4};
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{NONE, Surface, View};
use parallax_shared::stereo::recall::is_near;
use parallax_shared::stereo::source::{column, is_reused};

/// Adds to the colours of reused pixels (`local`) what the source's pixel reflects and refracts, where the rays of both eyes are no
/// farther apart than `cos_limit` says. `remaining` has the surfaces of the other pixels; the pass `bounce` adds nothing to a miss.
#[spirv(compute(threads(8, 8, 1)))]
pub fn recall(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] source_view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(push_constant)] cos_limit: &f32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] source: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] source_local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source_colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] remaining: Out<Surface>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] recalled: Out<[f32; 4]>,
) {
    if id.x < view.width && id.y < view.rows {
        let (first, y) = (id.y * view.width, view.first_row + id.y);
        let word = source.at(first + id.x);
        let (mut surface, mut colour) = (surfaces.at(first + id.x), Vec4::from_array(local.at(first + id.x)));
        let there = camera::pixel_direction(source_view, column(word), y);
        if is_reused(word) && is_near(there, camera::pixel_direction(view, id.x, y), *cos_limit) {
            let from = first + column(word);
            colour += Vec4::from_array(source_colours.at(from)) - Vec4::from_array(source_local.at(from));
            surface.prim_id = NONE;
        }
        remaining.put(first + id.x, surface);
        recalled.put(first + id.x, colour.to_array());
    }
}
