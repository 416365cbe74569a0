//! Primary rays.

use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::layout::{Hit, NONE, View};

/// Nothing is hit (to be replaced by the traversal).
#[spirv(compute(threads(8, 8, 1)))]
pub fn trace(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: Out<Hit>,
) {
    if id.x < view.width && id.y < view.rows {
        hits.put(id.y * view.width + id.x, Hit { t: id.x as f32 * view.distance, prim_id: NONE });
    }
}
