//! Tables that begin empty.

use glam::UVec3;
use kernel_api::{Out, spirv};
use parallax_shared::stereo::{reprojection::EMPTY, run::RUN};

/// Empties a table, eight entries an invocation. A pass of its own: 000 Alg. 2 resets entries while others fill them.
#[spirv(compute(threads(64)))]
pub fn clear(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] table: Out<u32>,
) {
    for entry in 0..RUN {
        let entry = id.x * RUN + entry;
        if entry < table.len() {
            table.put(entry, EMPTY);
        }
    }
}
