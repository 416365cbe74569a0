//! Atomic operations. The results do not depend on the order in which the invocations come by.

use core::sync::atomic::{AtomicI32, AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::{At, spirv};

/// Each operation on `u32`, on a cell of its own.
#[spirv(compute(threads(64)))]
pub fn atomics_u32(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cells: &[AtomicU32],
) {
    let word = words.at(id.x);
    cells.at_ref(0u32).fetch_add(word, Relaxed);
    cells.at_ref(1u32).fetch_sub(word >> 3, Relaxed);
    cells.at_ref(2u32).fetch_min(word, Relaxed);
    cells.at_ref(3u32).fetch_max(word, Relaxed);
    cells.at_ref(4u32).fetch_and(word | 0xffff, Relaxed);
    cells.at_ref(5u32).fetch_or(word & 0xf0f0, Relaxed);
    cells.at_ref(6u32).fetch_xor(word, Relaxed);
    // A saturating sum by compare and exchange.
    let mut sum = cells.at_ref(7u32).load(Relaxed);
    while let Err(newer) =
        cells.at_ref(7u32).compare_exchange(sum, sum.saturating_add(word), Relaxed, Relaxed)
    {
        sum = newer;
    }
    // A ticket each: no two invocations get one cell, and all cells are taken.
    let ticket = cells.at_ref(8u32).fetch_add(1, Relaxed);
    cells.at_ref(16 + ticket).store(1, Relaxed);
    // What is exchanged into a cell of one's own comes back.
    let own = cells.at_ref(16 + words.len() as u32 + id.x);
    own.swap(word, Relaxed);
    own.fetch_add(own.swap(id.x, Relaxed), Relaxed);
}

/// Each operation on `i32`.
#[spirv(compute(threads(64)))]
pub fn atomics_i32(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] numbers: &[i32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cells: &[AtomicI32],
) {
    let number = numbers.at(id.x);
    cells.at_ref(0u32).fetch_add(number, Relaxed);
    cells.at_ref(1u32).fetch_sub(number >> 3, Relaxed);
    cells.at_ref(2u32).fetch_min(number, Relaxed);
    cells.at_ref(3u32).fetch_max(number, Relaxed);
    cells.at_ref(4u32).fetch_and(number | 0xffff, Relaxed);
    cells.at_ref(5u32).fetch_or(number & 0xf0f0, Relaxed);
    cells.at_ref(6u32).fetch_xor(number, Relaxed);
    let mut smallest = cells.at_ref(7u32).load(Relaxed);
    while number < smallest {
        match cells.at_ref(7u32).compare_exchange(smallest, number, Relaxed, Relaxed) {
            Ok(_) => break,
            Err(newer) => smallest = newer,
        }
    }
    cells.at_ref(8 + id.x).swap(-number, Relaxed);
}
