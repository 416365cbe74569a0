//! The tables by walks along rows, from right to left.

use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::spirv;
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::scanline_rtl;

/// Walks along `lines` rows from right to left, one after the other. Both tables must be empty.
#[spirv(compute(threads(8)))]
pub fn scanline_rtl(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(push_constant)] lines: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] candidates: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] gaps: &[AtomicU32],
) {
    let mut row = id.x * *lines;
    let mut remaining = *lines;
    while remaining > 0 && row < p.rows {
        scanline_rtl::scanline_rtl(p, hits, candidates, gaps, row);
        row += 1;
        remaining -= 1;
    }
}
