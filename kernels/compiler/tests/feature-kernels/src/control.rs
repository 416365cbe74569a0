//! Control flow: switches, state machines, labelled breaks, early returns. (Loops have their own file.)

use kernel_api::At;

word_kernels! {
    /// A switch with ranges, a guard and returns in its arms.
    switches = classified;
    /// A dense switch, which LLVM turns into a table.
    dense_switch = looked_up;
    /// The same again: LLVM keeps one of two equal functions, and both must come out.
    dense_switch_again = looked_up;
    /// A switch inside a loop that some arms leave: a state machine.
    state_machine = automaton;
    /// Blocks left from the middle.
    labelled_blocks = labelled;
    /// Returns from several depths.
    early_returns = early;
    /// Conditions with side effects, evaluated only if they must be.
    short_circuits = lazy;
    /// An enumeration with data.
    enumerations = shapes;
    /// Closures, generic functions and constant parameters.
    generics = generic;
}

fn class(word: u32) -> u32 {
    let scrambled = match word % 11 {
        0 => 17,
        1 | 2 => word ^ 5,
        3..=5 => word >> 3,
        6 => return word.rotate_left(7),
        7 if word & 64 != 0 => 1,
        7 => word.wrapping_mul(3),
        8 => word.count_ones(),
        9 => word.leading_zeros(),
        _ => word.swap_bytes(),
    };
    scrambled ^ 0x100
}

fn classified(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    class(word).wrapping_mul(31) ^ class(word >> 3)
}

fn looked_up(i: u32, words: &[u32]) -> u32 {
    match words.at(i) & 7 {
        0 => 0x11,
        1 => 0x2222,
        2 => 0x31,
        3 => 0x4567,
        4 => 0x9,
        5 => 0xabcd,
        6 => 0x77,
        _ => 0x1357,
    }
}

fn automaton(i: u32, words: &[u32]) -> u32 {
    let (mut state, mut steps, mut x, mut seen) = (0u32, 0u32, words.at(i), 0u32);
    loop {
        steps += 1;
        if steps > 50 {
            break;
        }
        state = match state {
            0 if x & 1 != 0 => 1,
            0 => {
                x >>= 1;
                2
            }
            1 => {
                x = x.wrapping_mul(5).wrapping_add(steps);
                if x & 0x10 != 0 { 3 } else { 0 }
            }
            2 if x == 0 => break,
            2 => {
                x ^= x >> 5;
                0
            }
            3 => {
                x = x.rotate_right(3);
                if x > 0xf000_0000 { 4 } else { 1 }
            }
            _ => {
                seen ^= x;
                break;
            }
        };
    }
    seen ^ x.wrapping_add(state << 8) ^ steps
}

fn labelled(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    let found = 'search: {
        if word & 1 == 0 {
            break 'search 5;
        }
        for k in 0..4 {
            if words.at((word & 63) + k) & 7 == 3 {
                break 'search k;
            }
        }
        word
    };
    'outer: {
        'inner: {
            if found & 2 == 0 {
                break 'inner;
            }
            if found & 4 == 0 {
                break 'outer;
            }
            return found ^ 0x55;
        }
        return found.wrapping_add(9);
    }
    found.wrapping_mul(7)
}

fn early(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    if word & 3 == 0 {
        return 1;
    }
    if word & 4 == 0 {
        if word & 8 == 0 {
            return word >> 4;
        }
        for k in 1..5 {
            let other = words.at((i * k) & 511);
            if other & 0x70 == 0x30 {
                return other ^ k;
            }
        }
    } else if word & 0x100 == 0 {
        return word ^ 0xdead;
    }
    word.wrapping_mul(word)
}

fn next(x: &mut u32) -> bool {
    *x = x.wrapping_mul(0x0001_9660).wrapping_add(0x3c6e_f35f) ^ (*x >> 7);
    *x & 0x20 != 0
}

fn lazy(i: u32, words: &[u32]) -> u32 {
    let mut x = words.at(i);
    let a = next(&mut x) && next(&mut x) || next(&mut x);
    let b = (a || next(&mut x)) && !(next(&mut x) && next(&mut x));
    if b == a && next(&mut x) { x ^ 1 } else { x.wrapping_add(a as u32) }
}

#[derive(Clone, Copy)]
enum Shape {
    Disc { centre: [f32; 2], radius: f32 },
    Square([f32; 2], f32),
    Line(u32),
    Nothing,
}

impl Shape {
    fn read(word: u32) -> Shape {
        let number = |shift: u32| (word >> shift & 15) as f32;
        match word & 3 {
            0 => Shape::Disc { centre: [number(4), number(8)], radius: number(12) },
            1 => Shape::Square([number(8), number(12)], number(4)),
            2 => Shape::Line(word >> 5),
            _ => Shape::Nothing,
        }
    }

    fn size(&self) -> Option<f32> {
        match *self {
            Shape::Disc { centre: [x, y], radius } if x > y => Some(3.0 * radius * radius + x),
            Shape::Disc { radius, .. } => Some(3.0 * radius * radius),
            Shape::Square([x, y], side) => (side > 4.0).then_some(side * side - x * y),
            Shape::Line(length) => Some((length & 0xff) as f32),
            Shape::Nothing => None,
        }
    }
}

fn shapes(i: u32, words: &[u32]) -> u32 {
    let mut best: Option<(f32, Shape)> = None;
    for k in 0..6 {
        let shape = Shape::read(words.at((i + k) & 1023));
        if let Some(size) = shape.size()
            && best.is_none_or(|(largest, _)| size > largest)
        {
            best = Some((size, shape));
        }
    }
    match best {
        Some((size, Shape::Disc { radius, .. })) => (size + radius).to_bits(),
        Some((size, Shape::Square(..))) => size.to_bits() ^ 1,
        Some((_, Shape::Line(length))) => length,
        Some((_, Shape::Nothing)) => 3,
        None => 4,
    }
}

fn horner<const N: usize>(coefficients: [f32; N], x: f32) -> f32 {
    coefficients.iter().rev().fold(0.0, |sum, &c| sum * x + c)
}

fn twice<F: Fn(u32) -> u32>(f: F, x: u32) -> u32 {
    f(f(x))
}

fn generic(i: u32, words: &[u32]) -> u32 {
    let word = words.at(i);
    let x = (word & 0xffff) as f32 / 65536.0;
    let scramble = twice(|k| k.wrapping_mul(word | 1).rotate_left(5), i);
    let few =
        (0..(word & 15)).map(|k| k.wrapping_mul(word) >> 7).filter(|k| k & 1 == 0).fold(1, |sum, k| sum ^ k);
    horner([1.0, 0.5, 0.25], x).to_bits()
        ^ horner([x, 1.0, 2.0, 3.0, 4.0, 5.0], 0.25).to_bits()
        ^ scramble
        ^ few
}
