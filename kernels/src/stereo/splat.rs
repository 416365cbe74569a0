//! The tables by atomic maxima.

use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::spirv;
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::{run::Run, splat};

/// Lets each column of the source land: run `id.x` of row `id.y`. Both tables must be empty.
#[spirv(compute(threads(64)))]
pub fn splat(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] candidates: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] gaps: &[AtomicU32],
) {
    splat::splat(&Run::new(p, id.x, id.y), hits, candidates, gaps);
}
