//! The tables by way of a 3D buffer.

use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::{reprojection::pixel, run::Run, slots as buffer};

/// Puts each column of the source into a slot of the pixel where it lands: run `id.x` of row `id.y`. Slots and gaps must be empty.
#[spirv(compute(threads(64)))]
pub fn slots(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] slots: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] gaps: &[AtomicU32],
) {
    buffer::put(&Run::new(p, id.x, id.y), hits, slots, gaps);
}

/// Chooses the nearest source of each pixel.
#[spirv(compute(threads(8, 8, 1)))]
pub fn nearest_slot(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] slots: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] candidates: Out<u32>,
) {
    if id.x < p.width && id.y < p.rows {
        let pixel = pixel(p, id.x, id.y);
        candidates.put(pixel, buffer::nearest(slots, pixel, p.depth));
    }
}

/// The smallest and the largest shift in each row, of the sources that land in the picture.
#[spirv(compute(threads(8)))]
pub fn shift_range(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] ranges: Out<[i32; 2]>,
) {
    if id.x < p.rows {
        ranges.put(id.x, buffer::shift_range(p, hits, id.x));
    }
}
