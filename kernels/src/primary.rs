//! What the rays from the eye hit.

use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{Hit, RayCounts, Row, SceneInfo, View};
use parallax_shared::traversal::closest_hit;

/// Traces the primary ray of each pixel of the band.
#[spirv(compute(threads(8, 8, 1)))]
pub fn primary(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: Out<Hit>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: Out<RayCounts>,
) {
    if id.x < view.width && id.y < view.rows {
        let ray = camera::primary_ray(view, id.x, view.first_row + id.y);
        let pixel = id.y * view.width + id.x;
        hits.put(pixel, closest_hit(rows, &ray, info.extent));
        counts.put(pixel, RayCounts { primary: 1, ..RayCounts::NONE });
    }
}
