//! Numbers that are the same in every run.

/// Marsaglia's xorshift generator with 32 bits of state ("Xorshift RNGs", 2003, section 3).
#[derive(Clone, Debug)]
pub struct Numbers(u32);

impl Numbers {
    /// A sequence for each seed.
    pub fn new(seed: u32) -> Self {
        let mut numbers = Self(seed.wrapping_mul(0x9e37_79b9) | 1);
        // Seeds that are near each other part.
        for _ in 0..8 {
            numbers.word();
        }
        numbers
    }

    /// The next word, never 0.
    pub fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A number below `end`.
    pub fn below(&mut self, end: u32) -> u32 {
        ((self.word() as u64 * end as u64) >> 32) as u32
    }

    /// A multiple of 2⁻¹² in [−4, 4): sums and products of a few are exact, none is denormal.
    pub fn small(&mut self) -> f32 {
        (self.below(1 << 15) as f32 - 16384.0) / 4096.0
    }

    /// So many words.
    pub fn words(&mut self, count: usize) -> Vec<u32> {
        (0..count).map(|_| self.word()).collect()
    }
}
