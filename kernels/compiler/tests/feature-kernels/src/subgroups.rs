//! Subgroup operations. What is written does not depend on how large a subgroup is.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::{At, spirv, subgroup};

/// Each operation, combined over a workgroup: eight words a workgroup, which begin as 0 but the second, which begins as the largest.
#[spirv(compute(threads(64)))]
pub fn subgroup_operations(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cells: &[AtomicU32],
) {
    let word = words.at(id.x);
    let (lane, size) = (subgroup::lane(), subgroup::size());
    let sum = subgroup!(add(word));
    let (least, most) = (subgroup!(min(word)), subgroup!(max(word)));
    let odd = subgroup!(count(word & 1 == 1));
    let (any, all) = (subgroup!(any(word & 63 == 5)), subgroup!(all(word & 0xff00_0000 != 0)));
    let mut mixed = 0;
    for from in 0..size {
        mixed ^= subgroup!(read(word, from));
    }
    let cell = |k: u32| cells.at_ref(group.x * 8 + k);
    if lane == 0 {
        cell(0).fetch_add(sum, Relaxed);
        cell(1).fetch_min(least, Relaxed);
        cell(2).fetch_max(most, Relaxed);
        cell(3).fetch_add(odd, Relaxed);
        cell(4).fetch_or(any as u32 | (!all as u32) << 1, Relaxed);
        cell(5).fetch_xor(mixed, Relaxed);
    }
    cell(6).fetch_add((lane < size) as u32, Relaxed);
    cell(7).fetch_add((lane + 1 == size) as u32 * size, Relaxed);
}

/// A sum between two uses of one condition: rustc would like to copy it into both sides.
#[spirv(compute(threads(64)))]
pub fn subgroup_convergence(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cells: &[AtomicU32],
) {
    let word = words.at(id.x);
    let kind = if word & 1 == 0 { 1u32 } else { 2 };
    let sum = subgroup!(add(kind));
    if subgroup::lane() == 0 {
        cells.at_ref(0u32).fetch_add(sum, Relaxed);
    }
    if kind == 1 {
        cells.at_ref(1u32).fetch_add(word, Relaxed);
    }
}
