//! Colours of points that look the same from both eyes.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{RayCounts, Sample, View};
use parallax_shared::sampling::lattice;
use parallax_shared::stereo::source::{VERIFIED, column, is_reused, kind};

/// Gives reused points the colours of the source's.
#[spirv(compute(threads(8, 8, 1)))]
pub fn carry(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] source_samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] samples: Out<Sample>,
) {
    if let Some([x, y]) = lattice::point(view, id.x, id.y) {
        let first = y * view.width;
        let word = words.at(first + x);
        if is_reused(word) {
            let primary = (kind(word) == VERIFIED) as u32;
            let rays = RayCounts { primary, ..RayCounts::NONE };
            samples.put(first + x, Sample { rays, ..source_samples.at(first + column(word)) });
        }
    }
}
