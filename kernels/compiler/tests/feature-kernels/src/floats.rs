//! Floating-point arithmetic: only what every driver gives the same bits for.

// With numbers that may be NaN or rounded, none of these expressions is what clippy takes it for.
#![allow(clippy::eq_op, clippy::double_comparisons, clippy::neg_cmp_op_on_partial_ord)]

use kernel_api::At;
use parallax_shared::math;

word_kernels! {
    /// The six comparisons, their negations, and what is unordered.
    comparisons = compared;
    /// The sign of zero, and signs in general.
    signs = signed;
    /// Smallest and largest by comparison and selection.
    selection = selected;
    /// Rounding to whole numbers.
    whole_numbers = whole;
    /// To integers, which saturate, and back.
    conversions = converted;
    /// Sums and products, in the order in which they stand.
    sums = summed;
    /// The machine's own quotient, which both drivers round correctly.
    quotients = divided;
    /// Division and square root with one result everywhere.
    strict = exact;
    /// What kind of number it is, by its bits.
    classes = classified;
}

/// A number with a magnitude of 1/64 to 8, or every eighth time a special one.
fn number(word: u32) -> f32 {
    const SPECIAL: [f32; 16] = [
        0.0,
        -0.0,
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.5,
        -0.5,
        1.5,
        2.5,
        -2.5,
        2147483648.0,
        -2147483648.0,
        4294967296.0,
        3e9,
        8388607.5,
        1e20,
    ];
    if word & 7 == 0 {
        return SPECIAL.at(word >> 3 & 15);
    }
    let magnitude = ((word >> 9) + 16384) as f32 / 1048576.0;
    if word & 0x100 == 0 { magnitude } else { -magnitude }
}

/// The bits, with one NaN: which one an operation yields is left open.
fn bits(x: f32) -> u32 {
    if x.to_bits() & 0x7fff_ffff > 0x7f80_0000 { 0x7fc0_0000 } else { x.to_bits() }
}

fn pair(i: u32, words: &[u32]) -> (f32, f32) {
    (number(words.at(i)), number(words.at((i * 7 + 3) & 1023)))
}

fn compared(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    let plain = [x < y, x <= y, x > y, x >= y, x == y, x != y];
    let negated = [!(x < y), !(x <= y), !(x > y), !(x >= y)];
    let both = [x < y || x > y, x == y || x != x, x.is_nan(), !(x < y || x > y)];
    let all = plain.iter().chain(&negated).chain(&both).fold(0, |sum, &holds| sum << 1 | holds as u32);
    all << 2 | x.partial_cmp(&y).map_or(3, |order| (order as i32 + 1) as u32)
}

fn signed(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    // No constant zeros: lavapipe takes x · 0 for 0, x + 0 for x and 0 − x for −x, whatever the signs are.
    let zero = y - y;
    let zeros = [x * zero, -x, zero - x, x + zero, x.abs(), x.copysign(y)];
    let zeros = zeros.iter().fold(0u32, |sum, &z| sum.rotate_left(3) ^ bits(z));
    zeros ^ (x.is_sign_negative() && !x.is_nan()) as u32
}

fn least(x: f32, y: f32) -> f32 {
    if x < y { x } else { y }
}

fn most(x: f32, y: f32) -> f32 {
    if x > y { x } else { y }
}

fn selected(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    bits(least(x, y)) ^ bits(most(x, y)).rotate_left(7) ^ bits(most(least(x, 2.0), -1.0)).rotate_left(14)
}

fn whole(i: u32, words: &[u32]) -> u32 {
    let (x, _) = pair(i, words);
    let rounded = [x.floor(), x.ceil(), x.trunc(), x - x.floor(), x.round_ties_even()];
    rounded.iter().fold(0u32, |sum, &x| sum.rotate_left(5) ^ bits(x))
}

fn converted(i: u32, words: &[u32]) -> u32 {
    let (x, _) = pair(i, words);
    let word = words.at(i);
    let integers = [
        x as i32 as u32,
        x as u32,
        x as u8 as u32,
        (x * 3.0) as i16 as u32,
        (x as i8 as u32).rotate_left(16),
    ];
    // SwiftShader rounds words from 2³¹ on otherwise.
    let numbers = [(word >> 1) as f32, word as i32 as f32, (word as u16) as f32, (word as i8) as f32];
    let integers = integers.iter().fold(0u32, |sum, &x| sum.rotate_left(5) ^ x);
    numbers.iter().fold(integers, |sum, &x| sum.rotate_left(3) ^ bits(x))
}

fn summed(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    // Contracted or reordered, each of these would have other bits.
    let product = x * y + 0.1;
    let difference = x * y - y * x + (x + y) - x - y;
    let polynomial = ((x * 0.3 + 0.7) * x - 1.1) * x + 0.01 * y;
    let sum = (0..8).fold(0.0, |sum, k| sum + number(words.at((i + k) & 1023)) * 0.1);
    [product, difference, polynomial, sum].iter().fold(0u32, |sum, &x| sum.rotate_left(5) ^ bits(x))
}

fn divided(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    bits(x / y) ^ bits(1.0 / x).rotate_left(5) ^ bits(y / 3.0).rotate_left(10)
}

fn exact(i: u32, words: &[u32]) -> u32 {
    let (x, y) = pair(i, words);
    let any = f32::from_bits(words.at(i) & 0x3fff_ffff | 0x2000_0000);
    bits(math::div(x, y))
        ^ bits(math::sqrt(x)).rotate_left(7)
        ^ bits(math::div(any, 3.0 + x)).rotate_left(14)
        ^ bits(math::sqrt(any)).rotate_left(21)
}

fn classified(i: u32, words: &[u32]) -> u32 {
    let (x, _) = pair(i, words);
    let holds = [x.is_nan(), x.is_infinite(), x.is_finite(), x.is_normal(), x == 0.0];
    holds.iter().fold(0, |sum, &holds| sum << 1 | holds as u32)
        ^ bits(f32::from_bits(x.to_bits() ^ 0x8000_0000))
}
