//! Division and square root against the processor's, elementary functions against f64, sums and products of both backends.

use crate::verify::Outcome;
use crate::verify::input::meshes::Random;
use crate::verify::input::numbers::{is_same, ordinary, quotients, special, special_pairs, ulps};
use crate::verify::suite::{CHUNK, Suite, values};
use parallax_kernels::arithmetic::operation::*;

/// Pairs that are divided where the whole range is tried.
const ALL_QUOTIENTS: u64 = 1_000_000_000;

/// An operation that is made of another one's approximation and its exact remainder, and what it is compared with.
struct Corrected {
    name: &'static str,
    operation: u32,
    corrected: u32,
}

const DIVISION: Corrected = Corrected { name: "/", operation: DIVIDE, corrected: CORRECTED_DIVIDE };
const SQUARE_ROOT: Corrected = Corrected { name: "√", operation: ROOT, corrected: CORRECTED_ROOT };

impl Corrected {
    /// Compares the processor's corrected results and the device's with what the processor has in hardware, which is correctly rounded.
    fn assert_rounded(&self, suite: &mut Suite, a: &[u32], b: &[u32]) -> Outcome {
        let (native, others) = suite.values(self.operation, a, b)?;
        let corrected = values(suite.cpu, self.corrected, a, b)?;
        for (place, results) in [("CPU, corrected", Some(corrected)), ("GPU", others)] {
            for (i, (result, expected)) in results.iter().flatten().zip(&native).enumerate() {
                suite.check(is_same(*result, *expected), || {
                    let (a, name, b) = (a[i], self.name, b[i]);
                    format!("{place}: {a:08x} {name} {b:08x} is {expected:08x}, not {result:08x}")
                });
            }
        }
        suite.tried(a.len());
        Ok(())
    }
}

/// All pairs of special values, and hostile ones: denormal results, ties, overflow; 10⁹ of them where all is tried.
///
/// Guard: the first quotient is set too low by a margin that exceeds any driver's error (`math::division`).
pub fn divisions_are_correctly_rounded(suite: &mut Suite) -> Outcome {
    let (a, b) = special_pairs();
    DIVISION.assert_rounded(suite, &a, &b)?;
    let mut random = Random(1);
    let chunks = if suite.full { ALL_QUOTIENTS.div_ceil(CHUNK as u64) } else { 1 };
    for chunk in 0..chunks {
        let (a, b) = quotients(&mut random, CHUNK);
        DIVISION.assert_rounded(suite, &a, &b)?;
        suite.done(chunk + 1, chunks);
    }
    Ok(())
}

/// Every 4097th number; all 2³² where all is tried.
///
/// Guard: the first root is set too low by a margin that exceeds any driver's error (`math::root`).
pub fn square_roots_are_correctly_rounded(suite: &mut Suite) -> Outcome {
    let special = special();
    SQUARE_ROOT.assert_rounded(suite, &special, &special)?;
    let chunks = if suite.full { (1 << 32) / CHUNK as u64 } else { 1 };
    let step = ((1 << 32) / CHUNK as u64 / chunks) as u32;
    for chunk in 0..chunks {
        let first = chunk as u32 * CHUNK as u32;
        // An odd step visits every mantissa's last bits.
        let numbers: Vec<_> =
            (0..CHUNK as u32).map(|i| (first.wrapping_add(i)).wrapping_mul(step | 1)).collect();
        SQUARE_ROOT.assert_rounded(suite, &numbers, &numbers)?;
        suite.done(chunk + 1, chunks);
    }
    Ok(())
}

/// A function that is compared with f64.
struct Function {
    name: &'static str,
    operation: u32,
    exact: fn(f64, f64) -> f64,
    /// Whether its documentation allows a result.
    allows: fn(&Beside64) -> bool,
}

/// A result beside f64's.
struct Beside64 {
    a: f64,
    b: f64,
    truth: f64,
    /// The error in units of the last place of the truth.
    ulps: f64,
    /// The error as a share of the truth.
    share: f64,
}

const POWER_OF_TWO: Function =
    Function { name: "2^", operation: EXP2, exact: |x, _| x.exp2(), allows: |found| found.ulps <= 1.5 };
const LOGARITHM: Function =
    Function { name: "log₂", operation: LOG2, exact: |x, _| x.log2(), allows: |found| found.ulps <= 3.0 };
const POWER: Function = Function { name: "^", operation: POW, exact: f64::powf, allows: allows_power };
const ANGLE: Function = Function { name: "atan2", operation: ATAN2, exact: f64::atan2, allows: allows_angle };

/// Where the power is an ordinary number, and no square on the way vanishes.
fn allows_power(found: &Beside64) -> bool {
    let Beside64 { a: x, b: y, share, .. } = *found;
    let exponent = y * x.log2();
    let whole = if y.fract() == 0.0 { y } else { 0.0 };
    let bound = (2.0 + 2.0 * exponent.abs() + whole) * f64::from(f32::EPSILON);
    !(-62.0..126.0).contains(&exponent) || share <= bound
}

fn allows_angle(found: &Beside64) -> bool {
    let Beside64 { a: y, b: x, truth, ulps, share } = *found;
    share * truth.abs() <= 4e-7 && (y.abs() > x || ulps <= 4.0)
}

impl Function {
    fn assert_bounded(&self, suite: &mut Suite, a: &[u32], b: &[u32]) -> Outcome {
        let results = suite.same_values(self.name, self.operation, a, b)?;
        for ((a, b), result) in a.iter().zip(b).zip(results) {
            let [a, b] = [*a, *b].map(|word| f64::from(f32::from_bits(word)));
            let (truth, value) = ((self.exact)(a, b), f32::from_bits(result));
            let share = (f64::from(value) / truth - 1.0).abs();
            let found = Beside64 { a, b, truth, ulps: ulps(result, truth), share };
            suite.check((self.allows)(&found), || format!("{a} {} {b} is {truth}, not {value}", self.name));
        }
        Ok(())
    }
}

/// Elementary functions within the bounds that their documentation states, against f64; the same bits on both backends.
pub fn elementary_functions_keep_their_bounds(suite: &mut Suite) -> Outcome {
    const COUNT: usize = 200_000;
    let mut random = Random(5);
    let mut between = |low: f32, high: f32| -> Vec<u32> {
        (0..COUNT).map(|_| (low + (high - low) * random.unit()).to_bits()).collect()
    };
    let exponents = between(-126.0, 128.0);
    POWER_OF_TWO.assert_bounded(suite, &exponents, &exponents)?;
    let mut positive = between(0.5, 2.0);
    positive.extend((0..COUNT as u32).map(|i| i * 10_650 + 1));
    positive.retain(|x| f32::from_bits(*x) != 1.0);
    LOGARITHM.assert_bounded(suite, &positive, &positive)?;
    let (bases, mut powers) = (between(0.0, 1.3), between(0.0, 300.0));
    powers.iter_mut().step_by(2).for_each(|y| *y = f32::from_bits(*y).floor().to_bits());
    POWER.assert_bounded(suite, &bases, &powers)?;
    let (ys, xs) = (between(-1.0, 1.0), between(-1.0, 1.0));
    ANGLE.assert_bounded(suite, &ys, &xs)
}

/// Sums, products, their errors, the smaller and the larger one, and whole numbers: of ordinary operands with ordinary results, and of
/// zeros, infinities and NaN.
///
/// Guards: no contraction in the strict profile, minimum and maximum by comparison and selection (`math`).
pub fn sums_products_and_choices_have_the_same_bits(suite: &mut Suite) -> Outcome {
    let mut random = Random(6);
    let [a, mut b] = [(); 2].map(|()| ordinary(&mut random, 1 << 18, -30, 30));
    // Sums that cancel but for a few digits.
    for i in (0..a.len()).step_by(4) {
        b[i] = (a[i] ^ 0x8000_0000).wrapping_add(random.below(64) as u32);
    }
    let (special_a, special_b) = special_pairs();
    for (name, operation) in [
        ("+", ADD),
        ("·", MULTIPLY),
        ("error of ·", PRODUCT_ERROR),
        ("min", MIN),
        ("max", MAX),
        ("floor", FLOOR),
    ] {
        suite.same_values(name, operation, &a, &b)?;
        // Denormals are for division and square root to keep: a driver may flush them here.
        let kept = |(a, b): &(u32, u32)| is_ordinary(operation, f32::from_bits(*a), f32::from_bits(*b));
        let pairs = special_a.iter().copied().zip(special_b.iter().copied()).filter(kept);
        let (a, b): (Vec<_>, Vec<_>) = pairs.unzip();
        suite.same_values(name, operation, &a, &b)?;
    }
    Ok(())
}

/// Whether neither operand is denormal, nor the result before it is rounded.
fn is_ordinary(operation: u32, a: f32, b: f32) -> bool {
    let (wide_a, wide_b) = (f64::from(a), f64::from(b));
    let is_normal =
        |result: f64| result == 0.0 || result.abs() >= f32::MIN_POSITIVE.into() || result.is_nan();
    let result_is = match operation {
        ADD => is_normal(wide_a + wide_b),
        MULTIPLY => is_normal(wide_a * wide_b),
        // Defined for products from 2⁻⁷⁸ to 2¹⁰⁰ of numbers that can be split.
        PRODUCT_ERROR => [wide_a, wide_b, wide_a * wide_b].iter().all(|x| (1e-23..1e30).contains(&x.abs())),
        _ => true,
    };
    !a.is_subnormal() && !b.is_subnormal() && result_is
}
