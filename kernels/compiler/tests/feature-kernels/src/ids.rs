//! Which invocation this is, in one, two and three dimensions.

use glam::UVec3;
use kernel_api::{Out, spirv};

/// A digest in which each component counts.
fn digest(parts: [UVec3; 4]) -> u32 {
    parts.iter().fold(17, |sum: u32, part| {
        [part.x, part.y, part.z].iter().fold(sum, |sum, &word| sum.wrapping_mul(31).wrapping_add(word))
    })
}

/// All ids of a one-dimensional run.
#[spirv(compute(threads(64)))]
pub fn ids_1d(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_id)] local: UVec3,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(num_workgroups)] groups: UVec3,
    #[spirv(local_invocation_index)] index: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<[u32; 2]>,
) {
    out.put(id.x, [digest([id, local, group, groups]), index]);
}

/// All ids of a two-dimensional run.
#[spirv(compute(threads(8, 4)))]
pub fn ids_2d(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_id)] local: UVec3,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(num_workgroups)] groups: UVec3,
    #[spirv(local_invocation_index)] index: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<[u32; 2]>,
) {
    out.put(id.y * groups.x * 8 + id.x, [digest([id, local, group, groups]), index]);
}

/// All ids of a three-dimensional run.
#[spirv(compute(threads(4, 2, 3)))]
pub fn ids_3d(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_id)] local: UVec3,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(num_workgroups)] groups: UVec3,
    #[spirv(local_invocation_index)] index: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<[u32; 2]>,
) {
    let at = (id.z * groups.y * 2 + id.y) * groups.x * 4 + id.x;
    out.put(at, [digest([id, local, group, groups]), index]);
}
