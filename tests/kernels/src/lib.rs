//! Small passes with which the tests exercise the backends: each binds something in another way.
#![cfg_attr(not(test), no_std)]

use core::sync::atomic::{AtomicU32, Ordering};
use glam::UVec3;
use kernel_api::{At, Out, spirv};

/// The folder of this crate, from which tests compile it for a GPU.
pub const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

/// Squares numbers: something read, something written.
#[spirv(compute(threads(64)))]
pub fn square(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] numbers: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] squares: Out<f32>,
) {
    if id.x < squares.len() {
        squares.put(id.x, numbers.at(id.x) * numbers.at(id.x));
    }
}

/// Numbers the invocations of a 3D run and counts them: everything else that can be bound, in two sets.
#[spirv(compute(threads(4, 2, 2)))]
pub fn number(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] local: u32,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(num_workgroups)] groups: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] extent: &[u32; 4],
    #[spirv(push_constant)] offset: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] numbers: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 1, binding = 0)] count: &[AtomicU32],
    #[spirv(spec_constant(id = 1, default = 1))] step: u32,
) {
    count.at_ref(0u32).fetch_add(step, Ordering::Relaxed);
    if id.x < extent[0] && id.y < extent[1] && id.z < extent[2] {
        let group = (group.z * groups.y + group.y) * groups.x + group.x;
        let index = (id.z * extent[1] + id.y) * extent[0] + id.x;
        numbers.put(index, *offset + group * 16 + local);
    }
}

/// Every invocation of a workgroup writes the same element, which no pass may.
#[spirv(compute(threads(8)))]
pub fn collide(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<u32>,
) {
    out.put(id.x / 8, id.x);
}
