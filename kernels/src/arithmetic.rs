//! One operation on many numbers: what `parallax verify` asks a driver, and compares with the CPU.

use bytemuck::Zeroable;
use glam::UVec3;
use kernel_api::device::{native_fma, native_sqrt};
use kernel_api::{At, Out, spirv};
use parallax_shared::camera::disparity_px;
use parallax_shared::layout::Reprojection;
use parallax_shared::math;
use parallax_shared::shading::fresnel::reflectance;
use parallax_shared::stereo::reprojection::{pixel, shift_px};

/// Columns and rows of the largest picture whose pixels are numbered here.
pub const SIDE: u32 = 16_384;

/// The operations; a and b are its operands.
pub mod operation {
    /// a / b of `shared::math`.
    pub const DIVIDE: u32 = 0;
    /// √a of `shared::math`.
    pub const ROOT: u32 = 1;
    /// a / b, corrected by its remainder wherever this runs.
    pub const CORRECTED_DIVIDE: u32 = 2;
    /// √a, corrected by its remainder wherever this runs.
    pub const CORRECTED_ROOT: u32 = 3;
    /// 2^a.
    pub const EXP2: u32 = 4;
    /// log₂ a.
    pub const LOG2: u32 = 5;
    /// a^b.
    pub const POW: u32 = 6;
    /// The angle of the point (b, a).
    pub const ATAN2: u32 = 7;
    /// ⌊a⌋.
    pub const FLOOR: u32 = 8;
    /// The smaller one.
    pub const MIN: u32 = 9;
    /// The larger one.
    pub const MAX: u32 = 10;
    /// a + b.
    pub const ADD: u32 = 11;
    /// a · b.
    pub const MULTIPLY: u32 = 12;
    /// What rounding takes from a · b.
    pub const PRODUCT_ERROR: u32 = 13;
    /// Fresnel's share at cosine a with index b.
    pub const REFLECTANCE: u32 = 14;
    /// By how many columns, an integer, a point at t = b goes to the side with eyes a pixels apart.
    pub const SHIFT: u32 = 15;
    /// Index of column a of row b (integers) in a picture of [`SIDE`](super::SIDE) columns, counted from the right.
    pub const PIXEL: u32 = 16;
    /// a / b as the machine divides.
    pub const NATIVE_DIVIDE: u32 = 17;
    /// √a as the machine has it.
    pub const NATIVE_ROOT: u32 = 18;
    /// a · a − b, which a driver may round once or twice.
    pub const SQUARE_LESS: u32 = 19;
    /// The same by fused multiply-add, if the driver fuses.
    pub const FUSED_SQUARE_LESS: u32 = 20;
    /// b after a rounds (integers) of a loop of which no compiler knows the end: Numerical Recipes' generator.
    pub const ROUNDS: u32 = 21;
}

/// `results[i]` = the operation of `a[i]` and `b[i]`; words, so that no driver changes a bit on the way.
#[spirv(compute(threads(64)))]
pub fn arithmetic(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] a: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] b: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] results: Out<u32>,
    #[spirv(spec_constant(id = 0, default = 0))] operation: u32,
) {
    if id.x < results.len() {
        results.put(id.x, apply(operation, a.at(id.x), b.at(id.x)));
    }
}

/// `start` after `count` rounds of [`operation::ROUNDS`].
#[inline(always)]
pub fn rounds(count: u32, start: u32) -> u32 {
    (0..count).fold(start, |state, _| state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223))
}

#[inline(always)]
fn apply(operation: u32, word_a: u32, word_b: u32) -> u32 {
    let (a, b) = (f32::from_bits(word_a), f32::from_bits(word_b));
    let result = match operation {
        operation::DIVIDE => math::div(a, b),
        operation::ROOT => math::sqrt(a),
        operation::CORRECTED_DIVIDE => math::div_corrected(a, b),
        operation::CORRECTED_ROOT => math::sqrt_corrected(a),
        operation::EXP2 => math::exp2(a),
        operation::LOG2 => math::log2(a),
        operation::POW => math::pow(a, b),
        operation::ATAN2 => math::atan2(a, b),
        operation::FLOOR => math::floor(a),
        operation::MIN => math::min(a, b),
        operation::MAX => math::max(a, b),
        operation::ADD => a + b,
        operation::MULTIPLY => a * b,
        operation::PRODUCT_ERROR => math::product_error(a, b, a * b),
        operation::REFLECTANCE => reflectance(a, b),
        operation::SHIFT => return shift_px(disparity_px(a, b)) as u32,
        operation::PIXEL => {
            let picture = Reprojection { width: SIDE, rows: SIDE, mirrored: 1, ..Zeroable::zeroed() };
            return pixel(&picture, word_a, word_b);
        }
        // The machine's own: what is measured here is how far off it is.
        operation::NATIVE_DIVIDE => a / b,
        operation::NATIVE_ROOT => native_sqrt(a),
        operation::SQUARE_LESS => a * a - b,
        operation::ROUNDS => return rounds(word_a, word_b),
        _ => native_fma(a, a, -b),
    };
    result.to_bits()
}
