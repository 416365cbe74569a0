//! Which lights nothing can hide from a tile.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Record, Row, SceneInfo, Surface, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::proof;

/// Invocations are tiles. `margin` is by how much a tile's box is larger than that of its points, of its size on each side.
#[spirv(compute(threads(8, 8, 1)))]
pub fn prove(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(push_constant)] margin: &f32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] proofs: Out<u32>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    let tile = proof::Tile::new(view, id.x, id.y);
    if tile.count != 0 {
        let scene = SceneView { info, rows, triangles: &[], records, texels: &[], effects: Effects(effects) };
        let first = tile.number * proof::words(info.lights);
        let surface = |i| surfaces.at(tile.pixel(view, i));
        proof::prove(&scene, *margin, tile.count, surface, |i, word| proofs.put(first + i, word));
    }
}
