//! Which lights each surface sees.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{RayCounts, Record, Row, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::shadow;

/// Traces a ray to each light that a surface faces. Of the pixel's `⌈lights / 32⌉` words (at least one),
/// which follow each other, bit i % 32 of word i / 32 is set when light i is seen.
#[spirv(compute(threads(8, 8, 1)))]
pub fn shadow(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] seen: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] counts: Out<RayCounts>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        let scene = SceneView { info, rows, triangles: &[], records, texels: &[], effects: Effects(effects) };
        let first = pixel * shadow::words(info.lights);
        counts.put(
            pixel,
            shadow::trace(&scene, &surfaces.at(pixel), |word, bits| seen.put(first + word, bits)),
        );
    }
}
