//! Pixels from their points.

use glam::{UVec3, Vec3};
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{Lattice, RayCounts, Sample};
use parallax_shared::sampling::average::{colour, rays};
use parallax_shared::sampling::refine::is_sampled;

/// The colour of each pixel, and the rays of the points that count as its own.
#[spirv(compute(threads(8, 8, 1)))]
pub fn average(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] lattice: &Lattice,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] samples: &[Sample],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] colours: Out<[f32; 4]>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] counts: Out<RayCounts>,
) {
    if id.x < lattice.width && id.y < lattice.rows {
        let pixel = id.y * lattice.width + id.x;
        let of_point = |at: u32| Vec3::from_array(samples.at_ref(at).colour);
        let is_sampled = |at: u32| is_sampled(words.at(at));
        colours.put(pixel, colour(lattice, id.x, id.y, of_point, is_sampled).extend(1.0).to_array());
        counts.put(pixel, rays(lattice, id.x, id.y, |at| samples.at_ref(at).rays, is_sampled));
    }
}
