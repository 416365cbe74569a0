//! Where a kernel's data comes from.

use glam::{UVec3, Vec3};
use kernel_api::{At, Out, spirv};

/// A few numbers that all invocations share.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Shared {
    /// How many elements.
    pub count: u32,
    /// A step through them.
    pub step: u32,
    /// A factor.
    pub scale: f32,
    /// So that `direction` begins at a multiple of 16 bytes.
    pub unused: u32,
    /// A vector.
    pub direction: Vec3,
    /// So that the record is a multiple of 16 bytes.
    pub unused_too: u32,
}

fn mix(shared: &Shared, i: u32, words: &[u32]) -> u32 {
    let other = words.at((i * shared.step) % shared.count);
    words.at(i) ^ other.rotate_left(5) ^ (i as f32 * shared.scale + shared.direction.y).to_bits()
}

/// A uniform buffer.
#[spirv(compute(threads(64)))]
pub fn uniform_buffer(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] shared: &Shared,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<u32>,
) {
    // A division by a number from outside must be guarded.
    if id.x < out.len() && shared.count > 0 {
        out.put(id.x, mix(shared, id.x, words));
    }
}

/// A push constant.
#[spirv(compute(threads(64)))]
pub fn push_constant(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(push_constant)] shared: &Shared,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<u32>,
) {
    if id.x < out.len() && shared.count > 0 {
        out.put(id.x, mix(shared, id.x, words));
    }
}

/// Several outputs, bindings out of order. (Gaps between them are lost on wgpu's way to a driver.)
#[spirv(compute(threads(32)))]
pub fn outputs(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] sums: Out<u32>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] products: Out<f32>,
) {
    if id.x < sums.len() {
        sums.put(id.x, words.at(id.x).wrapping_add(id.x));
    }
    if id.x < products.len() {
        products.put(id.x, id.x as f32 * 0.75);
    }
}

/// What a slice knows of its own length.
#[spirv(compute(threads(1)))]
pub fn lengths(
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] records: &[[f32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<u32>,
) {
    out.put(0u32, words.len() as u32);
    out.put(1u32, records.len() as u32);
    out.put(2u32, out.len());
    out.put(3u32, words.iter().fold(0, |sum, word| sum ^ word));
}
