//! Correctly rounded square root out of any approximate one, by the exact remainder in wrapping 32-bit arithmetic.

use super::unpack;

/// By how much the first root is set too low, in units of the last place (as in `division`).
const MARGIN: u32 = 24;

/// √`a`, correctly rounded, from this machine's own square root. What [`sqrt`](super::sqrt) is on a strict device.
#[inline(always)]
pub fn sqrt_corrected(a: f32) -> f32 {
    sqrt_from(a, kernel_api::device::native_sqrt)
}

/// √`a`, correctly rounded, from an approximation of √`n`.
///
/// `approximate(n)` is asked for 2²³ ≤ `n` < 2²⁵ and may be wrong by 12 ULP (Vulkan: that of 1/inversesqrt, about 5). NaN below
/// zero (bits 0x7fc00000), −0 at −0, +∞ at +∞; denormals are exact.
#[inline(always)]
pub fn sqrt_from(a: f32, approximate: impl Fn(f32) -> f32) -> f32 {
    let bits = a.to_bits();
    let magnitude = bits & 0x7fff_ffff;
    if magnitude == 0 || bits == 0x7f80_0000 {
        return a;
    }
    if bits > 0x7f80_0000 {
        return f32::from_bits(0x7fc0_0000);
    }
    let (mantissa, exponent) = unpack(magnitude);
    let odd = exponent & 1;
    let n = mantissa << odd;
    // `n` · 2^shift has a root of 24 bits, and its exponent is even.
    let (shift, biased) =
        if n < 0x0100_0000 { (24, (exponent - odd) / 2 + 138) } else { (22, (exponent - odd) / 2 + 139) };
    let (root, rest) = root_of_mantissa(n, shift, approximate);
    // (root + 1/2)² = root² + root + 1/4, and the rest is whole: it rounds up exactly if rest > root.
    let rounded = root + (rest > root) as u32;
    f32::from_bits(((biased as u32 - 1) << 23) + rounded)
}

/// ⌊√(`n` · 2^`shift`)⌋, of 24 bits, and what is left of the radicand.
#[inline(always)]
fn root_of_mantissa(n: u32, shift: u32, approximate: impl Fn(f32) -> f32) -> (u32, u32) {
    // `n` has 24 significant bits; its root has its unit at 2⁻¹² (shift 24) or 2⁻¹¹ (shift 22).
    let unit = if shift == 24 { 4096.0 } else { 2048.0 };
    let root = (approximate(n as f32) * unit) as u32 - MARGIN;
    // The true rest is in 0 .. 2³¹, so its low 32 bits are all of it.
    let rest = (n << shift).wrapping_sub(root.wrapping_mul(root));
    // (root + more)² = root² + more · (2 root + more), and more² is small against 2 root.
    let more = (rest as f32 * (0.5 / root as f32)) as u32;
    let rest = rest.wrapping_sub(more * (2 * root + more));
    let root = root + more;
    if (rest as i32) < 0 {
        (root - 1, rest.wrapping_add(2 * root - 1))
    } else if rest > 2 * root {
        (root + 1, rest - (2 * root + 1))
    } else {
        (root, rest)
    }
}
