//! What each pixel of the second view shows, as far as the source tells.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::{reprojection::pixel, run::Run, settle::Plan, source};

/// Decides run `id.x` of row `id.y`. Writes the word of each pixel, the colours of those that have a source (with `p.copies`) and
/// their hits (with `p.keep_hits`).
#[spirv(compute(threads(64)))]
pub fn settle(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] candidates: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] gaps: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] source_colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] words: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] hits: Out<Hit>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] colours: Out<[f32; 4]>,
) {
    let run = Run::new(p, id.x, id.y);
    let mut x = run.first;
    while x < run.end {
        let (at, plan) = (run.pixel(x), Plan::new(p, candidates, gaps, x, id.y));
        let (word, from) = (plan.word(p), pixel(p, plan.column, id.y));
        words.put(at, word);
        if source::is_reused(word) && p.copies != 0 {
            colours.put(at, source_colours.at(from));
        }
        if source::is_reused(word) && p.keep_hits != 0 {
            hits.put(at, source_hits.at(from));
        }
        x += 1;
    }
}
