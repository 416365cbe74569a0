//! Points for the next level of a lattice.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::{UVec3, Vec3};
use kernel_api::{At, spirv};
use parallax_shared::layout::{Refinement, Sample, View};
use parallax_shared::sampling::lattice::plan;
use parallax_shared::sampling::refine::{Cell, differ, is_sampled};
use parallax_shared::stereo::source::{HOLE, traced};

/// Divides the cells of a level whose corners differ too much: the points between wait to be sampled. Cells that share a point write
/// the same word to it.
#[spirv(compute(threads(8, 8, 1)))]
pub fn refine(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(push_constant)] refinement: &Refinement,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] planned: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] words: &[AtomicU32],
) {
    let Some(cell) = Cell::new(view, id.x, id.y) else { return };
    let word = |at: u32| words.at_ref(at).load(Relaxed);
    if view.refines == 0 || is_sampled(word(cell.middle_of_parent(view.width))) {
        let colours = cell.corners(view.width).map(|at| Vec3::from_array(samples.at_ref(at).colour));
        if differ(colours, refinement.tolerance) {
            cell.between(|column, row| {
                let at = row * view.width + column;
                let reach = cell.side >> 2;
                let word_of_point = match refinement.plans {
                    1 => plan(planned, view.width, column, row, reach),
                    _ => traced(HOLE),
                };
                if !is_sampled(word(at)) {
                    words.at_ref(at).store(word_of_point, Relaxed);
                }
            });
        }
    }
}
