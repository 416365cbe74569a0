//! What the rays from the second eye hit, sooner.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::layout::{Hit, Reprojection, Row, SceneInfo, View};
use parallax_shared::stereo::guided::closest_hit_expected;
use parallax_shared::stereo::reprojection::{EMPTY, pixel};
use parallax_shared::stereo::source::{GUIDED, UNGUIDED, traced};

/// Traces the primary ray of each pixel, which is expected to end where its candidate's source does. The hits are those of the pass
/// `primary`, bit for bit.
#[spirv(compute(threads(8, 8, 1)))]
pub fn guided(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &Reprojection,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 2)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] candidates: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] source_hits: &[Hit],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] words: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] hits: Out<Hit>,
) {
    if id.x < p.width && id.y < p.rows {
        let at = pixel(p, id.x, id.y);
        let candidate = candidates.at(at);
        let (word, expected) = match candidate {
            EMPTY => (traced(UNGUIDED), f32::INFINITY),
            key => (traced(GUIDED), source_hits.at(pixel(p, key - 1, id.y)).t),
        };
        let ray = camera::primary_ray(view, pixel(p, id.x, 0), view.first_row + id.y);
        hits.put(at, closest_hit_expected(rows, &ray, info.extent, expected));
        words.put(at, word);
    }
}
