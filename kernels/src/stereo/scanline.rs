//! The tables by walks along rows, from left to right.

use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::spirv;
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::scanline;

/// Walks along `lines` rows from left to right, one after the other. Both tables must be empty.
#[spirv(compute(threads(8)))]
pub fn scanline(
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
        scanline::scanline(p, hits, candidates, gaps, row);
        row += 1;
        remaining -= 1;
    }
}
