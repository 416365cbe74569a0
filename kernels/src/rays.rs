//! Rays in, hits out: the traversal by itself, for tests and for whoever has rays of their own.

use glam::UVec3;
use kernel_api::{At, Out, spirv};
use parallax_shared::layout::{Hit, Ray, Row};
use parallax_shared::traversal;

/// The nearest hit of each ray.
#[spirv(compute(threads(64)))]
pub fn trace_rays(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] rows: &[Row],
    #[spirv(push_constant)] extent: &f32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] hits: Out<Hit>,
) {
    if id.x < hits.len() {
        hits.put(id.x, traversal::closest_hit(rows, rays.at_ref(id.x), *extent));
    }
}

/// For each ray 1 if it hits anything, else 0.
#[spirv(compute(threads(64)))]
pub fn occluded_rays(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] rays: &[Ray],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] rows: &[Row],
    #[spirv(push_constant)] extent: &f32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] occluded: Out<u32>,
) {
    if id.x < occluded.len() {
        occluded.put(id.x, traversal::occluded(rows, rays.at_ref(id.x), *extent) as u32);
    }
}
