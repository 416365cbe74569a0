//! A view as it is: the imaginary lower bound of 000 §4.1.

use glam::UVec3;
use kernel_api::{At, Out, spirv};

/// Copies colours.
#[spirv(compute(threads(64)))]
pub fn copy(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] copied: Out<[f32; 4]>,
) {
    if id.x < copied.len() {
        copied.put(id.x, colours.at(id.x));
    }
}
