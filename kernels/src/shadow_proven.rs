//! Which lights each surface sees, by what is known of its tile.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{NONE, RayCounts, Record, Row, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{proof, shadow};

/// What the pass `shadow` does, bit for bit. If `keep` is not zero, `hiding` gets the pack that hides each light from each pixel.
#[spirv(compute(threads(8, 8, 1)))]
pub fn shadow_proven(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(push_constant)] keep: &u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] proofs: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] seen: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] counts: Out<RayCounts>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] hiding: Out<u32>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        let scene = SceneView { info, rows, triangles: &[], records, texels: &[], effects: Effects(effects) };
        let tile = proof::tile_of(view, id.x, id.y) * proof::words(info.lights);
        let first = pixel * shadow::words(info.lights);
        let kept = |light, pack| {
            if *keep != 0 {
                hiding.put(pixel * info.lights + light, pack);
            }
        };
        let put = |word, bits| seen.put(first + word, bits);
        counts.put(pixel, proof::trace(&scene, &surfaces.at(pixel), proofs, tile, |_| NONE, kept, put));
    }
}
