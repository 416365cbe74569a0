//! A lattice of which nothing is known.

use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::layout::{Hit, View};
use parallax_shared::sampling::lattice::{UNSAMPLED_HIT, first_word, plan};
use parallax_shared::stereo::source::{HOLE, traced};

/// Lets the points of the level that `view` has be sampled, as `planned` if `plans` is 1, else traced; the others wait for `refine`.
#[spirv(compute(threads(8, 8, 1)))]
pub fn begin(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(push_constant)] plans: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] planned: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] hits: Out<Hit>,
) {
    if id.x < view.width && id.y < view.rows {
        let at = id.y * view.width + id.x;
        let reach = (1 << view.spacing_log2) >> 1;
        let planned = if *plans == 1 { plan(planned, view.width, id.x, id.y, reach) } else { traced(HOLE) };
        words.put(at, first_word(view, id.x, id.y, planned));
        hits.put(at, UNSAMPLED_HIT);
    }
}
