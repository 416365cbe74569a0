//! What each pixel of the second view shows.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{Hit, NONE, Reprojection, Row, SceneInfo, View};
use parallax_shared::stereo::{reprojection::pixel, settle::Plan};
use parallax_shared::traversal::closest_hit;

/// Verifies candidates and traces what the source does not show. Writes the word of each pixel, the hits of traced ones (of all with
/// `p.keep_hits`) and, with `p.copies`, the colours of reused ones.
#[spirv(compute(threads(8, 8, 1)))]
pub fn settle(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] candidates: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] gaps: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] source_colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] source: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] hits: Out<Hit>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] colours: Out<[f32; 4]>,
) {
    if id.x < p.width && id.y < p.rows {
        let (x, row) = (id.x, id.y);
        let at = pixel(p, x, row);
        let plan = Plan::new(p, candidates, gaps, x, row);
        if let Some(end) = plan.ray_end(p, source_hits, row) {
            let mut ray = camera::primary_ray(view, pixel(p, x, 0), view.first_row + row);
            ray.t_max = end;
            let hit = closest_hit(rows, &ray, info.extent);
            let word = plan.conclude(p, hit.prim_id != NONE);
            if !parallax_shared::stereo::source::is_reused(word) {
                source.put(at, word);
                hits.put(at, hit);
                return;
            }
        }
        let from = pixel(p, plan.column, row);
        source.put(at, plan.conclude(p, false));
        if p.keep_hits != 0 {
            hits.put(at, source_hits.at(from));
        }
        if p.copies != 0 {
            colours.put(at, source_colours.at(from));
        }
    }
}
