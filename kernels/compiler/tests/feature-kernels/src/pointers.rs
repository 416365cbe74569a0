//! Slices, references and iterators: pointers whose place is only known when the kernel runs.

use glam::UVec3;
use kernel_api::{At, Out, spirv};

word_kernels! {
    /// A slice split in the middle.
    split = halves;
    /// Pieces of four.
    chunks = fours;
    /// Overlapping pieces of three.
    windows = threes;
    /// A reference that may be none.
    optional_references = optional;
    /// Patterns over slices.
    slice_patterns = patterned;
    /// The position of a largest element.
    iterators = largest;
    /// A reference into a local array or a buffer.
    chosen_references = chosen;
    /// A tail handed on.
    tails = tailed;
    /// `get`, `first` and searches.
    searches = searched;
}

fn halves(i: u32, words: &[u32]) -> u32 {
    let (left, right) = words.split_at(words.len() / 2);
    left.at(i & 15) ^ right.at(i & 31).rotate_left(5)
}

fn fours(i: u32, words: &[u32]) -> u32 {
    let mut sum = i;
    for four in words.chunks_exact(4).skip((i & 7) as usize).take(8) {
        sum = sum.wrapping_add(four[0] ^ four[3]);
    }
    sum
}

fn threes(i: u32, words: &[u32]) -> u32 {
    let mut sum = i;
    for three in words.tail(i & 7).windows(3).take(5) {
        sum = sum.wrapping_mul(7) ^ three[0] ^ three[2];
    }
    sum
}

fn optional(i: u32, words: &[u32]) -> u32 {
    let reference = if i & 1 == 0 { words.get((i * 3) as usize) } else { None };
    reference.copied().unwrap_or(9)
}

fn patterned(i: u32, words: &[u32]) -> u32 {
    match words {
        [x, y, .., z] if i > 3 => x ^ y ^ z ^ i,
        [x, ..] => *x,
        [] => 0,
    }
}

fn largest(i: u32, words: &[u32]) -> u32 {
    let some = words.iter().enumerate().skip((i & 31) as usize).take(20);
    some.max_by_key(|item| *item.1).map_or(0, |item| item.0 as u32)
}

fn chosen(i: u32, words: &[u32]) -> u32 {
    let own = [i, i ^ 3, 5, 7];
    let mut sum = 0u32;
    for k in 0..6 {
        let word = words.at((i + k) & 1023);
        let from = if word & 1 == 0 { own.at_ref(word >> 1 & 3) } else { words.at_ref(word >> 1 & 511) };
        sum = sum.wrapping_mul(5) ^ *from;
    }
    sum
}

fn sum_of(words: &[u32], count: u32) -> u32 {
    (0..count).fold(0, |sum, k| sum.wrapping_add(words.at(k)))
}

fn tailed(i: u32, words: &[u32]) -> u32 {
    sum_of(words.tail(i & 255), 7) ^ sum_of(words.tail((i & 255) + 3).tail(2u32), i & 3)
}

fn searched(i: u32, words: &[u32]) -> u32 {
    let wanted = i & 15;
    let position = (0..40).find(|&at| words.at(at) & 15 == wanted).unwrap_or(99);
    let first = words.first().copied().unwrap_or(0);
    let any = words.tail(i & 63).iter().any(|word| *word & 0xff == wanted) as u32;
    position ^ first ^ any << 8 ^ words.get((i * 2) as usize).map_or(1, |word| word >> 1)
}

/// One of two buffers, chosen when the kernel runs.
#[spirv(compute(threads(64)))]
pub fn chosen_buffer(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] left: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] right: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<u32>,
) {
    if id.x < out.len() {
        let from = if left.at(id.x) & 1 == 0 { left } else { right };
        out.put(id.x, from.at(id.x) ^ from.at(id.x >> 1));
    }
}
