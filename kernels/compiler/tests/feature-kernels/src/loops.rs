//! Loops: with several exits, nested, with results, counting down, over iterators.

use kernel_api::{At, Stack};

word_kernels! {
    /// Two nested loops with `continue` and `break` to both, and a return from inside.
    nested_loops = nested;
    /// A loop with three exits of its own.
    loop_exits = exits;
    /// A loop whose exits carry different values.
    loop_values = valued;
    /// A traversal with a stack.
    stack_loop = walked;
    /// Ranges backwards, with steps, and of length zero.
    ranges = ranged;
    /// Loops that end after different numbers of rounds in each invocation, one in another.
    uneven_rounds = uneven;
    /// A value that changes in a loop and is needed after it, on each exit another one.
    carried_values = carried;
    /// Newton's iteration until nothing changes.
    fixed_point = root;
}

fn search(words: &[u32], at: u32, limit: u32) -> Option<(u32, u32)> {
    let mut sum = 0u32;
    'outer: for y in 0..limit {
        for x in 0..limit {
            let word = words.at((at + y * limit + x) & 1023);
            if word & 0xff == 0x42 {
                return Some((y, x));
            }
            if word & 0x1f == 3 {
                continue 'outer;
            }
            if word & 0x3f == 9 {
                break;
            }
            if word & 0x7f == 77 {
                break 'outer;
            }
            sum = sum.wrapping_mul(31).wrapping_add(word);
            if sum & 0xffff == 0 {
                continue;
            }
            sum ^= x;
        }
        sum = sum.rotate_left(1);
    }
    if sum & 1 == 0 { None } else { Some((sum, u32::MAX)) }
}

fn nested(i: u32, words: &[u32]) -> u32 {
    let mut sum = 0u32;
    for k in 1..9 {
        match search(words, i * 3 + k * 17, k) {
            None => sum = sum.wrapping_add(1),
            Some((y, u32::MAX)) => {
                sum ^= y;
                if sum & 7 == 5 {
                    continue;
                }
                sum = sum.rotate_left(3);
            }
            Some((y, x)) => {
                if y > 5 {
                    return 0xdead;
                }
                sum = sum.wrapping_mul(33) ^ (y << 8 | x);
            }
        }
        while sum & 0x80 != 0 {
            sum = sum.wrapping_mul(3) >> 1;
            if sum & 0xf000 == 0x3000 {
                break;
            }
        }
    }
    sum
}

fn exits(i: u32, words: &[u32]) -> u32 {
    let (mut x, mut k) = (words.at(i), 0u32);
    loop {
        if x & 0x1f == 7 {
            x ^= 0x100;
            break;
        }
        k += 1;
        x = x.wrapping_mul(0x9e37_79b1).rotate_left(k);
        if k == 12 {
            return x ^ 0x77;
        }
        let other = words.at(x & 1023);
        if other > 0xe000_0000 {
            x = other;
            break;
        }
        if other & 1 == 0 {
            continue;
        }
        x ^= other;
    }
    x.wrapping_add(k)
}

fn valued(i: u32, words: &[u32]) -> u32 {
    let mut k = i & 31;
    let (kind, value) = loop {
        let word = words.at(k);
        if word & 15 == 3 {
            break (1, word);
        }
        if k > 60 {
            break (2, k);
        }
        k += 1 + (word & 1);
        if word & 0x700 == 0x500 {
            break (3, word ^ k);
        }
    };
    value.wrapping_mul(5) ^ kind
}

fn walked(i: u32, words: &[u32]) -> u32 {
    let mut stack = Stack::<u32, 16>::new();
    stack.push(i);
    let mut sum = 0u32;
    let mut rounds = 0u32;
    while let Some(node) = stack.pop() {
        rounds += 1;
        if rounds > 100 {
            break;
        }
        sum = sum.wrapping_mul(3) ^ node;
        let word = words.at(node & 1023);
        if word & 1 == 1 && node > 3 {
            let both = stack.push(node / 2) && stack.push(node / 3 + 1);
            if !both {
                return sum ^ 0xf011;
            }
        }
    }
    sum ^ rounds << 24
}

fn ranged(i: u32, words: &[u32]) -> u32 {
    let mut sum = words.at(i);
    for k in (0..20u32).rev().step_by(3) {
        sum = sum.rotate_left(k) ^ k;
    }
    for k in 5..(sum & 7) {
        sum = sum.wrapping_add(words.at(k));
    }
    for k in -3i32..=3 {
        sum = sum.wrapping_mul(9).wrapping_add((k * k) as u32);
    }
    for (k, word) in words.iter().take(9).zip(words.iter().skip((i & 3) as usize)) {
        sum ^= k.wrapping_mul(*word);
    }
    sum
}

fn uneven(i: u32, words: &[u32]) -> u32 {
    let mut sum = i;
    let mut x = words.at(i) | 1;
    while x != 0 {
        let mut inner = x & 0xf;
        while inner > 0 {
            sum = sum.wrapping_mul(17).wrapping_add(inner);
            inner = inner.saturating_sub(1 + (sum & 3));
        }
        x >>= 1 + (sum & 7);
    }
    sum
}

fn carried(i: u32, words: &[u32]) -> u32 {
    let (mut last, mut before, mut total) = (words.at(i), 0u32, 0u32);
    let mut k = 0u32;
    while k < 40 {
        let word = words.at((last ^ k) & 1023);
        if word & 0xf0 == 0x30 {
            before = last;
            if word & 1 == 0 {
                break;
            }
        }
        total = total.wrapping_add(before ^ word);
        last = last.rotate_left(3) ^ word;
        k += 1;
    }
    last ^ before.wrapping_mul(3) ^ total.wrapping_mul(5) ^ k
}

fn root(i: u32, words: &[u32]) -> u32 {
    let square = words.at(i) >> 8;
    if square == 0 {
        return 0;
    }
    let mut x = square;
    loop {
        // `x` is never 0: `square` is not.
        let better = (x + square / x.max(1)) / 2;
        if better >= x {
            return x;
        }
        x = better;
    }
}
