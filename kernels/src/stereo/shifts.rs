//! The tables by way of a scatter table.

use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::run::Run;
use parallax_shared::stereo::shifts as scatter;

/// Where each column of the source lands, plus 1: run `id.x` of row `id.y`.
#[spirv(compute(threads(64)))]
pub fn shifts(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] targets: Out<u32>,
) {
    scatter::shifts(&Run::new(p, id.x, id.y), hits, targets);
}

/// Lets each column land where `targets` says. Both tables must be empty.
#[spirv(compute(threads(64)))]
pub fn splat_shifts(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] targets: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] candidates: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] gaps: &[AtomicU32],
) {
    scatter::splat(&Run::new(p, id.x, id.y), targets, candidates, gaps);
}
