//! Reflections and refractions of the source.

use glam::{UVec3, Vec4};
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::View;
use parallax_shared::shading::bounce::is_whole;
use parallax_shared::stereo::recall::is_near;
use parallax_shared::stereo::source::{column, is_reused};

/// Adds to the colours of reused pixels (`local`) that are not whole what the source's pixel reflects and refracts, where the rays of both
/// eyes are no farther apart than `cos_limit` says. They are whole then, so that the pass `bounce` leaves them as they are.
#[spirv(compute(threads(8, 8, 1)))]
pub fn recall(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] source_view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(push_constant)] cos_limit: &f32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] source: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] source_local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source_colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] recalled: Out<[f32; 4]>,
) {
    if id.x < view.width && id.y < view.rows {
        let (first, y) = (id.y * view.width, view.first_row + id.y);
        let (word, own) = (source.at(first + id.x), local.at(first + id.x));
        let mut colour = Vec4::from_array(own);
        if is_reused(word) && !is_whole(&own) {
            let there = camera::pixel_direction(source_view, column(word), y);
            if is_near(there, camera::pixel_direction(view, id.x, y), *cos_limit) {
                let from = first + column(word);
                // Of the fourth words, too: 0 + (1 − 0).
                colour += Vec4::from_array(source_colours.at(from)) - Vec4::from_array(source_local.at(from));
            }
        }
        recalled.put(first + id.x, colour.to_array());
    }
}
