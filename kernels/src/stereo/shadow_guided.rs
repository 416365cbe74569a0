//! Which lights the surfaces of the second view see, by what is known of the first one's.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{NONE, RayCounts, Record, Reprojection, Row, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::{proof, shadow};
use parallax_shared::stereo::reprojection::{EMPTY, pixel};

/// What the pass `shadow` does, bit for bit. A pixel looks at the tile of its candidate's source first, and at what hides the light
/// there.
#[spirv(compute(threads(8, 8, 1)))]
pub fn shadow_guided(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] proofs: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] candidates: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] hiding: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] seen: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 10)] counts: Out<RayCounts>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < p.width && id.y < p.rows {
        let at = pixel(p, id.x, id.y);
        let scene = SceneView { info, rows, triangles: &[], records, texels: &[], effects: Effects(effects) };
        let candidate = candidates.at(at);
        let source = if candidate == EMPTY { NONE } else { pixel(p, candidate - 1, id.y) };
        let tile = if source == NONE {
            NONE
        } else {
            proof::tile_of(view, source - id.y * p.width, id.y) * proof::words(info.lights)
        };
        let expected = |light| if source == NONE { NONE } else { hiding.at(source * info.lights + light) };
        let first = at * shadow::words(info.lights);
        let put = |word, bits| seen.put(first + word, bits);
        counts.put(at, proof::trace(&scene, &surfaces.at(at), proofs, tile, expected, |_, _| {}, put));
    }
}
