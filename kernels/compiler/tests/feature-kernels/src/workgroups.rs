//! Workgroup memory and barriers.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::{At, Out, Workgroup, barrier, spirv};

/// The sum of each workgroup's words, and how many of them leave which remainder modulo 4: five words a workgroup.
#[spirv(compute(threads(64)))]
pub fn reduction(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(workgroup)] sums: &Workgroup<u32, 64>,
    #[spirv(workgroup)] counts: &[AtomicU32; 4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<u32>,
) {
    let word = words.at(id.x);
    sums.set(lane, word);
    if lane < 4 {
        counts.at_ref(lane).store(0, Relaxed);
    }
    barrier!();
    counts.at_ref(word & 3).fetch_add(1, Relaxed);
    let mut step = 32u32;
    while step > 0 {
        if lane < step {
            sums.set(lane, sums.get(lane).wrapping_add(sums.get(lane + step)));
        }
        barrier!();
        step >>= 1;
    }
    if lane == 0 {
        out.put(group.x * 5, sums.get(0u32));
    }
    if lane < 4 {
        out.put(group.x * 5 + 1 + lane, counts.at_ref(lane).load(Relaxed));
    }
}

/// A square matrix transposed by way of 8 × 8 tiles.
#[spirv(compute(threads(8, 8)))]
pub fn transpose(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_id)] local: UVec3,
    #[spirv(workgroup_id)] group: UVec3,
    #[spirv(num_workgroups)] groups: UVec3,
    #[spirv(workgroup)] tile: &Workgroup<[f32; 2], 72>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] from: &[[f32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] to: Out<[f32; 2]>,
) {
    let size = groups.x * 8;
    // Rows of nine: the columns lie in different banks.
    tile.set(local.y * 9 + local.x, from.at(id.y * size + id.x));
    barrier!();
    let (x, y) = (group.y * 8 + local.x, group.x * 8 + local.y);
    to.put(y * size + x, tile.get(local.x * 9 + local.y));
}

/// The running sum inside each workgroup, by Hillis and Steele's doubling.
#[spirv(compute(threads(128)))]
pub fn running_sum(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] sums: &Workgroup<u32, 128>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<u32>,
) {
    let mut sum = words.at(id.x);
    sums.set(lane, sum);
    barrier!();
    for power in 0..7 {
        let distance = 1u32 << power;
        let before = if lane >= distance { sums.get(lane - distance) } else { 0 };
        barrier!();
        sum = sum.wrapping_add(before);
        sums.set(lane, sum);
        barrier!();
    }
    out.put(id.x, sum);
}

/// A barrier between two uses of one condition: rustc would like to copy it into both sides.
#[spirv(compute(threads(64)))]
pub fn exchange_halves(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] half: &Workgroup<u32, 64>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<u32>,
) {
    let word = words.at(id.x);
    let upper = if lane >= 32 { 1u32 } else { 2 };
    half.set(lane, word.wrapping_mul(upper));
    barrier!();
    let other = if upper == 1 { half.get(lane - 32) } else { half.get(lane + 32) };
    out.put(id.x, other ^ lane);
}
