//! The kernels of the example `embed`: how much of the sky each cell of a level's ground sees.
#![cfg_attr(not(test), no_std)]

use bytemuck::{Pod, Zeroable};
use core::sync::atomic::{AtomicU32, Ordering};
use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{Ray, Row};
use parallax_shared::math::div;
use parallax_shared::traversal::occluded;

/// The folder of this crate, from which the example compiles it for a GPU.
pub const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

/// A square of cells on the plane y = 0.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Ground {
    /// Centre of cell (0, 0).
    pub first: [f32; 3],
    /// Cells along x and along z.
    pub cells: u32,
    /// From a cell to the next one.
    pub step: f32,
    /// The structure's extent.
    pub extent: f32,
    /// Zero.
    pub padding: [u32; 2],
}

/// For each cell the share of `directions` in which nothing stands before the sky.
#[spirv(compute(threads(8, 8, 1)))]
pub fn sky_exposure(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] ground: &Ground,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] directions: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] exposure: Out<f32>,
) {
    if id.x >= ground.cells || id.y >= ground.cells {
        return;
    }
    let [x, y, z] = ground.first;
    let origin = [x + id.x as f32 * ground.step, y, z + id.y as f32 * ground.step];
    let count = directions.len() as u32;
    let mut open = 0;
    for i in 0..count {
        let [dx, dy, dz, _] = directions.at(i);
        let ray = Ray { origin, t_min: 0.0, dir: [dx, dy, dz], t_max: f32::INFINITY };
        open += !occluded(rows, &ray, ground.extent) as u32;
    }
    exposure.put(id.y * ground.cells + id.x, div(open as f32, count as f32));
}

/// Counts the cells by their exposure, in as many steps as `histogram` has.
#[spirv(compute(threads(64)))]
pub fn count_by_exposure(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] exposure: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] histogram: &[AtomicU32],
) {
    if id.x < exposure.len() as u32 {
        let last = histogram.len() as u32 - 1;
        let step = (exposure.at(id.x) * last as f32 + 0.5) as u32;
        histogram.at_ref(step).fetch_add(1, Ordering::Relaxed);
    }
}
