//! Correctly rounded division out of any approximate one, by the exact remainder in wrapping 32-bit
//! arithmetic: no f64, no u64, no fma, and nothing that depends on how a driver rounds or treats denormals.

use super::unpack;

const NAN: u32 = 0x7fc0_0000;
const INFINITY: u32 = 0x7f80_0000;
const SIGN: u32 = 0x8000_0000;

/// By how much the first quotient is set too low, in units of the last place: it is then below the true one
/// as long as the driver's division errs by less, and the remainder stays non-negative and below 2³⁰.
const MARGIN: u32 = 32;

/// `a / b`, correctly rounded, from this machine's own division. What [`div`](super::div) is on a strict device.
#[inline(always)]
pub fn div_corrected(a: f32, b: f32) -> f32 {
    div_from(a, b, |n, d| n / d)
}

/// `a / b`, correctly rounded, from an approximation of 1/`d` and of the quotient.
///
/// `approximate(1, d)` is asked for 2²³ ≤ `d` < 2²⁴ and may be wrong by 12 ULP (Vulkan allows 2.5). NaN, infinities, zeros and
/// denormals as in IEEE 754; a NaN result has the bits 0x7fc00000.
#[inline(always)]
pub fn div_from(a: f32, b: f32, approximate: impl Fn(f32, f32) -> f32) -> f32 {
    let (bits_a, bits_b) = (a.to_bits(), b.to_bits());
    let sign = (bits_a ^ bits_b) & SIGN;
    let (a, b) = (bits_a & !SIGN, bits_b & !SIGN);
    if a > INFINITY || b > INFINITY || (a == b && (a == 0 || a == INFINITY)) {
        return f32::from_bits(NAN);
    }
    if a == 0 || b == INFINITY {
        return f32::from_bits(sign);
    }
    if b == 0 || a == INFINITY {
        return f32::from_bits(sign | INFINITY);
    }
    let ((n, exponent_a), (d, exponent_b)) = (unpack(a), unpack(b));
    let low = (n < d) as u32;
    let exponent = exponent_a - exponent_b - 23 - low as i32;
    let (quotient, remainder) = divide_mantissas(n << low, d, approximate);
    f32::from_bits(sign | round(quotient, exponent, remainder << 1, d))
}

/// ⌊`n` · 2²³ / `d`⌋ and the remainder, for `d` ≤ `n` < 2`d` and 2²³ ≤ `d` < 2²⁴.
#[inline(always)]
fn divide_mantissas(n: u32, d: u32, approximate: impl Fn(f32, f32) -> f32) -> (u32, u32) {
    let inverse = approximate(1.0, d as f32);
    // `n` has 24 significant bits (if it has 25, the lowest is zero), so both conversions are exact.
    let mut quotient = (n as f32 * inverse * 8_388_608.0) as u32 - MARGIN;
    // The true remainder is in 0 .. 2³⁰, so its low 32 bits are all of it.
    let mut remainder = (n << 23).wrapping_sub(quotient.wrapping_mul(d));
    let more = (remainder as f32 * inverse) as u32;
    quotient += more;
    remainder = remainder.wrapping_sub(more * d);
    // `more` has at most 7 bits, so its rounding puts it off by no more than one.
    if remainder as i32 >= d as i32 {
        (quotient + 1, remainder - d)
    } else if (remainder as i32) < 0 {
        (quotient - 1, remainder.wrapping_add(d))
    } else {
        (quotient, remainder)
    }
}

/// The bits of (`quotient` + `twice_rest` / 2`unit`) · 2^`exponent`, rounded to nearest even; `quotient` in
/// 2²³ .. 2²⁴.
#[inline(always)]
fn round(quotient: u32, exponent: i32, twice_rest: u32, unit: u32) -> u32 {
    let biased = exponent + 150;
    if biased >= 1 {
        let up = twice_rest > unit || (twice_rest == unit && quotient & 1 == 1);
        // A mantissa of 2²⁴ carries into the exponent, as it should.
        let bits = ((biased as u32 - 1) << 23).wrapping_add(quotient + up as u32);
        return if biased > 254 || bits >= INFINITY { INFINITY } else { bits };
    }
    let shift = 1 - biased;
    if shift > 25 {
        return 0;
    }
    let kept = quotient >> shift;
    let lost = quotient & ((1 << shift) - 1);
    let half = 1 << (shift - 1);
    let up = lost > half || (lost == half && (twice_rest > 0 || kept & 1 == 1));
    kept + up as u32
}
