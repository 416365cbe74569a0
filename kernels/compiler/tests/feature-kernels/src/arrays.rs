//! Arrays of an invocation's own, large records, constant tables.

use kernel_api::At;

word_kernels! {
    /// Several local arrays of different types, written and read at computed places.
    local_arrays = local;
    /// Tables of words, pairs and records.
    tables = tabled;
    /// A record of 100 bytes, returned, copied and chosen between.
    large_records = large;
    /// An array of arrays, by value.
    nested_arrays = nested;
    /// A static table.
    static_table = looked_up;
    /// Swaps, fills, reversals and comparisons.
    whole_arrays = whole;
    /// A queue in a ring.
    ring = queued;
    /// Small arrays that LLVM keeps in registers, indexed by a constant after all.
    registers = registered;
}

fn local(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    let x = (word & 0xffff) as f32 / 65536.0;
    let (mut numbers, mut sums) = ([0u32; 24], [1.0f32; 12]);
    let (mut pairs, mut flags) = ([(0u32, 0.0f32); 8], [false; 10]);
    let (mut top, mut sum) = (0u32, 0u32);
    for k in 0..30u32 {
        let hash = word.wrapping_mul(k | 1).rotate_left(k) >> 5;
        if hash & 3 != 0 && top < 24 {
            numbers.put(top, hash);
            top += 1;
        } else if top > 0 {
            top -= 1;
            sum ^= numbers.at(top);
        }
        let (sum_so_far, flag) = (sums.at(hash % 12), flags.at(hash % 10));
        sums.put(hash % 12, sum_so_far + x);
        pairs.put(hash & 7, (k, x * k as f32));
        flags.put(hash % 10, !flag);
    }
    for k in 0..8u32 {
        sum = sum.wrapping_mul(31) ^ pairs.at(k).0 ^ pairs.at(k).1.to_bits();
    }
    sum ^ sums.at(word % 12).to_bits() ^ flags.at(word % 10) as u32
}

fn tabled(i: u32, words: &[u32]) -> u32 {
    const WEIGHTS: [f32; 5] = [0.0625, 0.25, 0.375, 0.25, 0.0625];
    const OFFSETS: [(i32, i32); 4] = [(-1, 0), (1, 0), (0, -1), (0, 1)];
    const RECORDS: [(f32, u8, [i16; 2]); 3] = [(1.5, 2, [3, -4]), (5.5, 6, [7, 8]), (9.5, 250, [-11, 12])];
    let word = words.at(i);
    let (dx, dy) = OFFSETS.at(word >> 9 & 3);
    let record = RECORDS.at(word % 3);
    let weight = WEIGHTS.at(word >> 16 & 3) * WEIGHTS.at((word >> 18) % 5);
    weight.to_bits() ^ (dx * 3 + dy) as u32 ^ (record.0 * record.1 as f32) as u32 ^ record.2[1] as i32 as u32
}

#[derive(Clone, Copy)]
struct Large {
    vectors: [[f32; 3]; 8],
    count: u32,
}

fn fill(i: u32, words: &[u32]) -> Large {
    let mut large = Large { vectors: [[0.0; 3]; 8], count: 0 };
    for k in 0..8 {
        if words.at((i + k) & 1023) & 1 == 1 {
            large.vectors.put(large.count, [k as f32, 1.0, 0.5 * k as f32]);
            large.count += 1;
        }
    }
    large
}

fn large(i: u32, words: &[u32]) -> u32 {
    let one = fill(i, words);
    let mut other = fill(i + 1, words);
    if one.count > other.count {
        other = one;
    }
    let mut sum = 0.0;
    for k in 0..other.count {
        sum += other.vectors.at(k)[0] * one.vectors.at(k & 7)[1];
    }
    sum.to_bits()
}

fn nested(i: u32, words: &[u32]) -> u32 {
    let word = |k: u32| words.at((i + k) & 1023);
    let matrix = [[word(0), 1, 2], [3, word(1), 5], [6, 7, word(2)]];
    let mut sum = 0u32;
    for row in matrix {
        for (k, item) in row.iter().enumerate() {
            sum = sum.wrapping_mul(31).wrapping_add(item ^ k as u32);
        }
    }
    sum ^ matrix.at(word(3) % 3).at(word(4) % 3)
}

static DIGITS: [u32; 16] = [3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3];

fn looked_up(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    DIGITS.at(word & 15) * 10 + DIGITS.at(word >> 4 & 15)
}

fn whole(i: u32, words: &[u32]) -> u32 {
    let mut items = [words.at(i), 5, words.at((i + 1) & 1023), 7, 11, i];
    items.swap(0, 4);
    items.reverse();
    let copy = items;
    items.fill(words.at((i + 2) & 1023) & 0xff);
    items.put(copy.at(0u32) % 6, 77);
    let mut other = copy;
    other.put(i % 6, copy.at(i % 3));
    let start = if other == copy { 7 } else { 8 };
    copy.iter().zip(&items).fold(start, |sum: u32, (a, b)| sum.rotate_left(7) ^ a.wrapping_mul(*b))
}

fn queued(i: u32, words: &[u32]) -> u32 {
    let mut ring = [0u32; 8];
    let (mut head, mut tail, mut sum) = (0u32, 0u32, 0u32);
    for k in 0..25 {
        let word = words.at((i * 5 + k) & 1023);
        if word & 3 != 0 && head.wrapping_sub(tail) < 8 {
            ring.put(head & 7, word);
            head += 1;
        } else if head != tail {
            sum = sum.wrapping_mul(13) ^ ring.at(tail & 7);
            tail += 1;
        }
    }
    sum ^ (head << 8 | tail)
}

fn registered(i: u32, words: &[u32]) -> u32 {
    let mut state = [words.at(i), words.at((i + 1) & 1023), 3, 4];
    for round in 0..4usize {
        state[round] = state[round].wrapping_add(state[(round + 1) & 3]).rotate_left(7);
        state[(round + 2) & 3] ^= state[round];
    }
    state[0] ^ state[1] ^ state[2] ^ state[3]
}
