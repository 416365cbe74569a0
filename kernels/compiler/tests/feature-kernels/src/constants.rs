//! Specialisation constants of each type.

use glam::UVec3;
use kernel_api::{At, Out, spirv};

/// A number of rounds, a factor and a switch.
#[spirv(compute(threads(64)))]
pub fn specialised(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(spec_constant(id = 0, default = 3))] rounds: u32,
    #[spirv(spec_constant(id = 1, default = -0.5))] factor: f32,
    #[spirv(spec_constant(id = 7, default = true))] add_id: bool,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] numbers: &[f32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<f32>,
) {
    if id.x >= out.len() {
        return;
    }
    let mut sum = numbers.at(id.x);
    for round in 0..rounds {
        sum = sum * factor + round as f32;
    }
    out.put(id.x, if add_id { sum + id.x as f32 } else { sum });
}
