//! Integer arithmetic.

use kernel_api::At;
use kernel_api::device::mul_high;

word_kernels! {
    /// Shifts by amounts known and unknown, with and without sign.
    shifts = shifted;
    /// Rotations.
    rotations = rotated;
    /// Counting, reversing and moving bits and bytes.
    bits = counted;
    /// Arithmetic that stays at the ends of its range.
    saturating = saturated;
    /// Arithmetic that says when it has left its range.
    checked = guarded;
    /// The whole product of two words, and carries by hand.
    wide = widened;
    /// Quotients and remainders by constants.
    constant_divisors = divided;
    /// Quotients and remainders by numbers that are known not to be zero.
    variable_divisors = divided_by;
    /// Smallest, largest, distances and signs.
    order = ordered;
    /// Numbers of 8 and 16 bits.
    narrow = narrowed;
    /// Powers, roots and logarithms of integers.
    powers = raised;
    /// Sorting by exchange.
    sorting = sorted;
}

fn pair(i: u32, words: &[u32]) -> (u32, u32) {
    (words.at(i), words.at((i + 1) & 1023))
}

fn shifted(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let by = b & 31;
    (a << by)
        ^ (a >> by)
        ^ ((a as i32 >> by) as u32)
        ^ (a << 7)
        ^ ((a as i32 >> 9) as u32)
        ^ a.wrapping_shl(b)
        ^ a.checked_shl(b & 63).unwrap_or(5)
}

fn rotated(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    a.rotate_left(b & 31) ^ a.rotate_right(b >> 3) ^ a.rotate_left(13)
}

fn counted(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let narrow = a >> (b & 31);
    let counts = [narrow.leading_zeros(), narrow.trailing_zeros(), narrow.count_ones(), 0u32.leading_zeros()];
    let ends = [
        (narrow & 0xff).leading_ones(),
        (!narrow).trailing_ones(),
        (a as u16).leading_zeros(),
        (a as u8).count_zeros(),
    ];
    let counts = counts.iter().chain(&ends).fold(0u32, |sum, count| sum.rotate_left(5) ^ count);
    counts ^ a.reverse_bits() ^ b.swap_bytes() ^ (a as u16).swap_bytes() as u32
}

fn saturated(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let (p, q) = (a as i32, b as i32);
    a.saturating_add(b)
        ^ a.saturating_sub(b).rotate_left(3)
        ^ (p.saturating_add(q) as u32).rotate_left(6)
        ^ (p.saturating_sub(q) as u32).rotate_left(9)
        ^ ((a as u8).saturating_add(b as u8) as u32)
        ^ ((a as i16).saturating_sub(b as i16) as u32)
        ^ (p.saturating_neg() as u32)
}

fn guarded(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let first = a.checked_add(b).map_or(u32::MAX, |sum| sum ^ 1);
    let second = (a & 0x1ffff).checked_mul(b & 0xffff).and_then(|x| x.checked_sub(i)).unwrap_or(7);
    let (difference, borrow) = a.overflowing_sub(b);
    let (sum, carry) = (a as i32).overflowing_add(b as i32);
    let quotient = a.checked_div(b & 3).unwrap_or(11);
    let negated = (a as i32).checked_neg().map_or(3, |x| x as u32);
    first
        ^ second
        ^ difference.rotate_left(2)
        ^ borrow as u32
        ^ sum as u32
        ^ (carry as u32) << 4
        ^ quotient
        ^ negated
}

fn widened(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    // 64-bit sum of squares by words.
    let (high_a, low_a) = (mul_high(a, a), a.wrapping_mul(a));
    let (low, carry) = low_a.overflowing_add(b.wrapping_mul(b));
    let high = high_a.wrapping_add(mul_high(b, b)).wrapping_add(carry as u32);
    high ^ low.rotate_left(11) ^ mul_high(a, 0xcccc_cccd)
}

fn divided(i: u32, words: &[u32]) -> u32 {
    let (a, _) = pair(i, words);
    let s = a as i32;
    let unsigned = [a / 3, a / 7, a / 10, a % 641, a / 641, a % 1000, a / 16, a % 16, a / 0x8000_0001];
    let signed = [s / 3, s % 3, s / -7, s % -7, s / 8, s % 8, s / 1000, s.rem_euclid(10), s.div_euclid(-12)];
    let unsigned = unsigned.iter().fold(0u32, |sum, x| sum.rotate_left(5) ^ x);
    signed.iter().fold(unsigned, |sum, &x| sum.rotate_left(3).wrapping_add(x as u32))
}

fn divided_by(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let divisor = (b >> (i & 31)) | 1;
    let positive = ((b >> 20) | 1) as i32;
    let s = (a as i32) >> 1;
    (a / divisor) ^ (a % divisor).rotate_left(9) ^ (s / positive) as u32 ^ (s % positive) as u32
}

fn ordered(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let (p, q) = (a as i32, b as i32);
    let unsigned =
        a.min(b) ^ a.max(b).rotate_left(1) ^ a.abs_diff(b).rotate_left(2) ^ a.clamp(1 << 20, 1 << 30);
    let signed = p.min(q) ^ p.max(q).rotate_left(3) ^ p.signum() ^ p.wrapping_abs() ^ p.clamp(-1000, 1000);
    unsigned
        ^ signed as u32
        ^ p.unsigned_abs()
        ^ (a.cmp(&b) as i32 as u32)
        ^ ((p < q) as u32) << 9
        ^ ((a < b) as u32) << 8
}

fn narrowed(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let (x, y, z, w) = (a as i8, b as u8, a as u16, b as i16);
    let product = (x as i32).wrapping_mul(y as i32) + w as i32;
    let sum = y.wrapping_mul(z as u8).wrapping_add(a as u8).rotate_left(3);
    let more = z.wrapping_mul(257) ^ (w >> 3) as u16;
    product as u32
        ^ (sum as u32) << 16
        ^ more as u32
        ^ (x.wrapping_neg() as u8 as u32) << 24
        ^ ((x < y as i8) as u32)
}

fn raised(i: u32, words: &[u32]) -> u32 {
    let (a, b) = pair(i, words);
    let power = (a & 0xff).wrapping_pow(b & 7);
    let logarithm = (a | 1).ilog2();
    power
        ^ (a >> 4).isqrt()
        ^ logarithm << 27
        ^ (b & 0xffff).next_power_of_two()
        ^ (a.is_power_of_two() as u32)
}

fn sorted(i: u32, words: &[u32]) -> u32 {
    let mut items = [0u32; 8];
    for k in 0..8u32 {
        items.put(k, words.at((i + k) & 1023));
    }
    for pass in 0..8u32 {
        for k in 0..7 - pass {
            if items.at(k) > items.at(k + 1) {
                let (less, more) = (items.at(k + 1), items.at(k));
                items.put(k, less);
                items.put(k + 1, more);
            }
        }
    }
    items.at(3u32) ^ items.at(i & 7)
}
