//! Records in buffers: 16-byte aligned ones, which are read 128 bits at a time, and others.

use bytemuck::{Pod, Zeroable};
use glam::{Mat3, UVec3, Vec3, Vec4};
use kernel_api::{At, Out, spirv};

/// A box with two words: 32 bytes, two 128-bit loads.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Node {
    /// Lower corner.
    pub low: Vec3,
    /// A word.
    pub first: u32,
    /// Upper corner.
    pub high: Vec3,
    /// Another word.
    pub count: u32,
}

/// Whole records read and written.
#[spirv(compute(threads(64)))]
pub fn aligned_records(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] from: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] to: Out<Node>,
) {
    if id.x >= to.len() {
        return;
    }
    let (a, b) = (from.at(id.x), from.at((id.x * 7 + 1) & 127));
    let low = Vec3::select(a.low.cmplt(b.low), a.low, b.low);
    to.put(
        id.x,
        Node {
            low,
            first: a.first ^ b.first,
            high: a.high + b.high * 0.5,
            count: a.count.wrapping_add(b.count),
        },
    );
}

/// Single fields of aligned records, some after a branch.
#[spirv(compute(threads(64)))]
pub fn record_fields(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<f32>,
) {
    if id.x >= out.len() {
        return;
    }
    let mut at = id.x & 127;
    let mut sum = 0.0;
    for _ in 0..5 {
        let node = nodes.at_ref(at);
        if node.count & 1 == 0 {
            sum += node.high.z;
        } else {
            sum -= node.low.x;
        }
        at = node.first & 127;
    }
    out.put(id.x, sum);
}

/// A record of 28 bytes with arrays in it.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Packed {
    /// Bytes, which can be read but not written.
    pub bytes: [u8; 4],
    /// Half words.
    pub halves: [u16; 2],
    /// Numbers.
    pub numbers: [f32; 5],
}

/// Records that are not aligned, with parts smaller than a word.
#[spirv(compute(threads(64)))]
pub fn packed_records(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] from: &[Packed],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<[u32; 3]>,
) {
    if id.x < out.len() {
        let record = from.at_ref(id.x);
        let byte = record.bytes.at(record.halves[1] as u32 & 3);
        let number = record.numbers.at(byte as u32 % 5);
        out.put(id.x, [byte as u32, record.halves[0] as u32 ^ record.bytes[2] as u32, number.to_bits()]);
    }
}

/// A matrix for each vector.
#[spirv(compute(threads(64)))]
pub fn matrices(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] matrices: &[Mat3],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] vectors: &[Vec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<Vec4>,
) {
    if id.x < out.len() {
        let (matrix, vector) = (matrices.at(id.x & 3), vectors.at(id.x));
        let moved = matrix * vector.truncate();
        out.put(
            id.x,
            (moved.cross(vector.truncate()) + matrix.transpose() * moved).extend(vector.w - moved.dot(moved)),
        );
    }
}
