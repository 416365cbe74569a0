//! Kernels of somebody else: the Mandelbrot set, and a histogram of its escape times.
#![no_std]

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::{UVec3, Vec2};
use kernel_api::{At, Out, spirv};

/// Where the picture lies.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Frame {
    /// The point of the first pixel.
    pub corner: Vec2,
    /// The distance between pixels.
    pub step: f32,
    /// Pixels of a row.
    pub width: u32,
}

/// After how many rounds of z ← z² + c the point `c` escapes; at most `limit`.
pub fn escape(c: Vec2, limit: u32) -> u32 {
    let (mut z, mut rounds) = (Vec2::ZERO, 0);
    while rounds < limit && z.length_squared() <= 4.0 {
        z = Vec2::new(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        rounds += 1;
    }
    rounds
}

/// The escape time of each pixel.
#[spirv(compute(threads(8, 8)))]
pub fn mandelbrot(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(push_constant)] frame: &Frame,
    #[spirv(spec_constant(id = 0, default = 100))] limit: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] rounds: Out<u32>,
) {
    let at = id.y * frame.width + id.x;
    if id.x < frame.width && at < rounds.len() {
        let c = frame.corner + Vec2::new(id.x as f32, id.y as f32) * frame.step;
        rounds.put(at, escape(c, limit));
    }
}

/// How often each escape time occurs.
#[spirv(compute(threads(64)))]
pub fn histogram(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] rounds: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] counts: &[AtomicU32],
) {
    if (id.x as usize) < rounds.len() {
        let round = rounds.at(id.x);
        if (round as usize) < counts.len() {
            counts.at_ref(round).fetch_add(1, Relaxed);
        }
    }
}
