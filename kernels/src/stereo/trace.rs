//! The rays from the second eye.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{Hit, NONE, Reprojection, Row, SceneInfo, View};
use parallax_shared::sampling::lattice;
use parallax_shared::stereo::settle::{concluded, ray_end};
use parallax_shared::stereo::source::is_reused;
use parallax_shared::traversal::closest_hit;

/// Traces what the source does not show and verifies candidates. Writes the words of bad pixels, which `settle` took for verified,
/// and the hits of traced ones.
#[spirv(compute(threads(8, 8, 1)))]
pub fn trace(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] words: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hits: Out<Hit>,
) {
    if let Some([x, y]) = lattice::point(view, id.x, id.y) {
        let first = y * view.width;
        let word = words.at_ref(first + x).load(Relaxed);
        if let Some(end) = ray_end(p, word, |column| source_hits.at(first + column).t) {
            let mut ray = camera::primary_ray(view, x, view.first_row + y);
            ray.t_max = end;
            let hit = closest_hit(rows, &ray, info.extent);
            let word = concluded(word, hit.prim_id != NONE);
            if !is_reused(word) {
                words.at_ref(first + x).store(word, Relaxed);
                hits.put(first + x, hit);
            }
        }
    }
}
