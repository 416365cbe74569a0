//! What the rays from the second eye hit, sooner.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{Hit, NONE, Reprojection, Row, SceneInfo, View};
use parallax_shared::stereo::reprojection::{EMPTY, pixel};
use parallax_shared::stereo::source::{GUIDED, UNGUIDED, traced};
use parallax_shared::traversal::{closest_hit_from, rows::ROOT};

/// Traces the primary ray of each pixel, and first the pack (`leaves`, by primitive) with what the candidate's source shows. The hits
/// are those of the pass `primary`, bit for bit.
#[spirv(compute(threads(8, 8, 1)))]
pub fn guided(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] leaves: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] candidates: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] words: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] hits: Out<Hit>,
) {
    if id.x < p.width && id.y < p.rows {
        let at = pixel(p, id.x, id.y);
        let candidate = candidates.at(at);
        let shown = match candidate {
            EMPTY => NONE,
            key => source_hits.at(pixel(p, key - 1, id.y)).prim_id,
        };
        let start = if shown == NONE { ROOT } else { leaves.at(shown) };
        let ray = camera::primary_ray(view, pixel(p, id.x, 0), view.first_row + id.y);
        hits.put(at, closest_hit_from(rows, &ray, info.extent, start));
        words.put(at, traced(if shown == NONE { UNGUIDED } else { GUIDED }));
    }
}
