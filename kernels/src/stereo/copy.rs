//! A view as it is: the imaginary lower bound of 000 §4.1.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::shading::bounce::is_whole;

/// Copies what is seen: `local` where it is whole, `colours` (of the pass `bounce`) elsewhere.
#[spirv(compute(threads(64)))]
pub fn copy(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] colours: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] copied: Out<[f32; 4]>,
) {
    if id.x < copied.len() {
        let own = local.at(id.x);
        copied.put(id.x, if is_whole(&own) { own } else { colours.at(id.x) });
    }
}
