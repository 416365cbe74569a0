//! How much memory buffers take.

/// Counts the bytes of the elements of all buffers that a backend holds, as they are asked for: what an allocator or a driver adds to
/// that, and for how long a driver keeps what was given back, only these know.
#[derive(Debug, Default)]
pub(super) struct Usage {
    now: u64,
    peak: u64,
}

impl Usage {
    /// A buffer of so many bytes is there.
    pub fn add(&mut self, bytes: u64) {
        self.now += bytes;
        self.peak = self.peak.max(self.now);
    }

    /// One of so many bytes, which was added before, is given back.
    pub fn remove(&mut self, bytes: u64) {
        self.now -= bytes;
    }

    /// The most bytes at once since the last time that this was asked; at the first time, of all. Never less than there are now.
    pub fn take_peak(&mut self) -> u64 {
        std::mem::replace(&mut self.peak, self.now)
    }
}

#[cfg(test)]
mod tests {
    use super::Usage;

    #[test]
    fn a_peak_is_of_what_is_there_at_once() {
        let mut usage = Usage::default();
        assert_eq!(usage.take_peak(), 0);
        usage.add(5);
        usage.add(7);
        usage.remove(5);
        usage.add(4);
        assert_eq!(usage.take_peak(), 12, "not 16, and not the 11 of now");
        assert_eq!(usage.take_peak(), 11, "what is still there counts");
        usage.remove(11);
        assert_eq!((usage.take_peak(), usage.take_peak()), (11, 0));
    }
}
