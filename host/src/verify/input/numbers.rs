//! Hostile operands, as words: what rounding, denormals, infinities and signs of zero go wrong on.

use super::meshes::Random;

/// Zeros, denormals, ends of the ranges, neighbours of 1 and of powers of two, infinities, NaN; of either sign.
pub fn special() -> Vec<u32> {
    let values = [
        0.0,
        f32::from_bits(1),
        f32::from_bits(2),
        f32::from_bits(0x0040_0000),
        f32::from_bits(0x007f_ffff),
        f32::MIN_POSITIVE,
        f32::from_bits(0x0080_0001),
        1e-30,
        f32::EPSILON,
        1.0 / 3.0,
        0.5,
        f32::from_bits(0x3f7f_ffff),
        1.0,
        f32::from_bits(0x3f80_0001),
        f32::from_bits(0x3fff_ffff),
        2.0,
        3.0,
        8_388_607.5,
        8_388_608.0,
        16_777_215.0,
        1e19,
        f32::from_bits(0x7f00_0000),
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    values.into_iter().flat_map(|value: f32| [value.to_bits(), (-value).to_bits()]).collect()
}

/// Every pair of special values.
pub fn special_pairs() -> (Vec<u32>, Vec<u32>) {
    let values = special();
    values.iter().flat_map(|a| values.iter().map(move |b| (*a, *b))).unzip()
}

/// `count` pairs to divide: a quarter each of any bits, of quotients that are denormal or nearly so and often ties, of quotients near
/// the largest number, and of dividends one ULP or less beside a rounded product.
pub fn quotients(random: &mut Random, count: usize) -> (Vec<u32>, Vec<u32>) {
    (0..count).map(|i| quotient(random.bits(), i)).unzip()
}

fn quotient(bits: u64, kind: usize) -> (u32, u32) {
    let (a, b) = (bits as u32, (bits >> 32) as u32);
    let mantissa = |word: u32| word & 0x007f_ffff;
    let exponent = |word: u32, exponent: u32| (word & 0x8000_0000) | (exponent << 23) | mantissa(word);
    match kind % 4 {
        0 => (a, b),
        1 => {
            // 2^-126 and less, by divisors of few digits: what is shifted out is often exactly a half.
            let few = exponent(b & 0xff00_0000, 127 + (b >> 16 & 63)) | (b >> 3 & 0x0070_0000);
            (exponent(a, 1 + (b >> 8 & 63)), few)
        }
        2 => (exponent(a, 190 + (b >> 25 & 63)), exponent(b, 64 - (a >> 26 & 31))),
        _ => {
            let (divisor, rounded) = (exponent(b, 127), f32::from_bits(exponent(a, 127)));
            let product = (f32::from_bits(divisor) * rounded).to_bits();
            (product.wrapping_add((bits >> 31 & 3) as u32).wrapping_sub(1), divisor)
        }
    }
}

/// `count` normal numbers with magnitudes from 2^`low` to 2^`high`, of either sign.
pub fn ordinary(random: &mut Random, count: usize, low: i32, high: i32) -> Vec<u32> {
    let span = (high - low) as usize;
    let number = |random: &mut Random| {
        let exponent = (127 + low) as u32 + random.below(span) as u32;
        (random.bits() as u32 & 0x807f_ffff) | (exponent << 23)
    };
    (0..count).map(|_| number(random)).collect()
}

/// Whether two words are the same number; all NaN are one.
pub fn is_same(a: u32, b: u32) -> bool {
    a == b || (f32::from_bits(a).is_nan() && f32::from_bits(b).is_nan())
}

/// How far `word` is from the number `truth`, in units of the last place of `truth`.
pub fn ulps(word: u32, truth: f64) -> f64 {
    let rounded = truth as f32;
    let ulp = f64::from(f32::from_bits((rounded.abs().to_bits() + 1).min(0x7f7f_ffff)))
        - f64::from(f32::from_bits((rounded.abs().to_bits()).min(0x7f7f_fffe)));
    (f64::from(f32::from_bits(word)) - truth).abs() / ulp
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_are_of_all_kinds() {
        let (a, b) = quotients(&mut Random(1), 100_000);
        let divided = a.iter().zip(&b).map(|(a, b)| (f32::from_bits(*a), f32::from_bits(*b)));
        let (mut denormal, mut infinite, mut ties, mut exact) = (0, 0, 0, 0);
        for (a, b) in divided {
            let q = a / b;
            let finite = a.is_finite() && b.is_finite();
            denormal += (q.is_subnormal()) as u32;
            infinite += (finite && q.is_infinite() && b != 0.0) as u32;
            // A tie is half a unit of the smallest denormal away.
            let unit = f64::from(f32::from_bits(1));
            let rest = (f64::from(a) / f64::from(b) / unit).abs().fract();
            ties += (q.is_subnormal() && rest == 0.5) as u32;
            exact += (q.is_normal() && f64::from(q) * f64::from(b) == f64::from(a)) as u32;
        }
        assert!(
            denormal > 5000 && infinite > 1000 && ties > 50 && exact > 1000,
            "{denormal} {infinite} {ties} {exact}"
        );
    }

    #[test]
    fn ulps_are_counted_from_the_truth() {
        assert_eq!(ulps(1f32.to_bits(), 1.0), 0.0);
        assert_eq!(ulps(0x3f80_0003, 1.0), 3.0);
        assert_eq!(ulps(1f32.to_bits(), 1.0 + f64::from(f32::EPSILON) / 2.0), 0.5);
    }

    #[test]
    fn zeros_differ_and_nans_do_not() {
        assert!(
            !is_same(0, 0x8000_0000)
                && is_same(0x7fc0_0000, 0xffff_ffff)
                && !is_same(0x7f80_0000, 0x7fc0_0000)
        );
    }
}
