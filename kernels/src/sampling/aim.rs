//! Nine points a pixel, of which the middle one decides.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{Hit, Reprojection, View};
use parallax_shared::sampling::aim::{middle, pixel_of, word_of_point};

/// What the middle point of each pixel hits. `points` is the lattice.
#[spirv(compute(threads(8, 8, 1)))]
pub fn aim(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] points: &View,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] aimed: Out<Hit>,
) {
    if id.x < p.width && id.y < p.rows {
        aimed.put(id.y * p.width + id.x, hits.at(middle(points.width, id.x, id.y)));
    }
}

/// Plans each point as its pixel was.
#[spirv(compute(threads(8, 8, 1)))]
pub fn spread(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] points: &View,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] planned: Out<u32>,
) {
    if id.x < points.width && id.y < points.rows {
        let [x, y] = pixel_of(p, id.x, id.y);
        planned.put(id.y * points.width + id.x, word_of_point(words.at(y * p.width + x), x, id.x));
    }
}
