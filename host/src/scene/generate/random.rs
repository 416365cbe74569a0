//! Random numbers that every platform agrees on.

/// SplitMix64 (Steele, Lea and Flood 2014; constants of Vigna's reference code). The papers name no generator
/// and no seed.
#[derive(Clone, Debug)]
pub struct SplitMix64(u64);

impl SplitMix64 {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number of `[low, high)`, one of 2²⁴ equally spaced ones (`high` itself only by rounding).
    pub fn uniform(&mut self, low: f32, high: f32) -> f32 {
        let fraction = (self.bits() >> 40) as f32 / (1 << 24) as f32;
        low + fraction * (high - low)
    }

    /// A point of the box from `low` to `high`.
    pub fn point(&mut self, low: [f32; 3], high: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|i| self.uniform(low[i], high[i]))
    }

    /// A rotation as rows, uniform over all (Marsaglia 1972: a quaternion of two points in discs).
    pub fn rotation(&mut self) -> [[f64; 3]; 3] {
        let ([a, b], s) = self.in_disc();
        let ([c, d], t) = self.in_disc();
        let scale = ((1.0 - s) / t).sqrt();
        let [w, x, y, z] = [a, b, c * scale, d * scale];
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    }

    /// A point of the unit disc but its middle, and its squared distance from there.
    fn in_disc(&mut self) -> ([f64; 2], f64) {
        loop {
            let [x, y] = [0; 2].map(|_| f64::from(self.uniform(-1.0, 1.0)));
            let square = x * x + y * y;
            if square > 0.0 && square < 1.0 {
                return ([x, y], square);
            }
        }
    }

    /// Puts a list into a random order (Fisher and Yates; the bias of the remainder is below 2⁻⁴⁰ for lists
    /// that fit a scene).
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            let other = (self.bits() % (last as u64 + 1)) as usize;
            list.swap(last, other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_sequence() {
        let mut random = SplitMix64::new(1_234_567);
        assert_eq!(random.bits(), 6_457_827_717_110_365_317);
        assert_eq!(random.bits(), 3_203_168_211_198_807_973);
    }

    #[test]
    fn rotations_are_orthogonal() {
        let mut random = SplitMix64::new(5);
        for _ in 0..100 {
            let rows = random.rotation();
            for (i, a) in rows.iter().enumerate() {
                for (j, b) in rows.iter().enumerate() {
                    let dot: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
                    assert!((dot - f64::from(u8::from(i == j))).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn shuffling_keeps_what_is_there() {
        let mut list: Vec<_> = (0..100).collect();
        SplitMix64::new(9).shuffle(&mut list);
        assert_ne!(list, (0..100).collect::<Vec<_>>());
        list.sort_unstable();
        assert_eq!(list, (0..100).collect::<Vec<_>>());
    }
}
