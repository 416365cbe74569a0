//! Where a pixel of the second view comes from, as one word: the column of the source (bits 0 to 15) and what was done (above).

/// The column of a pixel that no column of the source shows.
const NO_COLUMN: u32 = 0xffff;

/// The source shows the same point.
pub const REUSED: u32 = 0;
/// As [`REUSED`], and a ray has verified that nothing is nearer.
pub const VERIFIED: u32 = 1;
/// Traced: no column of the source lands there (missed pixel).
pub const HOLE: u32 = 2;
/// Traced: between neighbouring columns that land apart, so that something may show through (001's bad pixel).
pub const GAP: u32 = 3;
/// The ray that should verify a candidate met something nearer, which is what the pixel shows (000's bad pixel).
pub const BAD: u32 = 4;
/// Traced, expected to end where the source's hit is (the exact method).
pub const GUIDED: u32 = 5;
/// Traced without any expectation (the exact method).
pub const UNGUIDED: u32 = 6;

/// Not sampled: no pixel needs this point of a lattice.
pub const UNSAMPLED: u32 = 7;

/// The word of a pixel for which the source's `column` was used.
#[inline(always)]
pub fn from_column(kind: u32, column: u32) -> u32 {
    (kind << 16) | column
}

/// The word of a traced pixel.
#[inline(always)]
pub fn traced(kind: u32) -> u32 {
    from_column(kind, NO_COLUMN)
}

/// What was done.
#[inline(always)]
pub fn kind(source: u32) -> u32 {
    source >> 16
}

/// The source's column, in the picture (not mirrored), of a pixel that [`is_reused`].
#[inline(always)]
pub fn column(source: u32) -> u32 {
    source & 0xffff
}

/// Whether the source shows the pixel's point.
#[inline(always)]
pub fn is_reused(source: u32) -> bool {
    kind(source) <= VERIFIED
}

/// Whether a ray found what the pixel shows.
#[inline(always)]
pub fn is_traced(source: u32) -> bool {
    !is_reused(source) && kind(source) != UNSAMPLED
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_parts_come_back() {
        let source = from_column(VERIFIED, 32_767);
        assert_eq!((kind(source), column(source), is_reused(source)), (VERIFIED, 32_767, true));
        assert!(!is_traced(source) && !is_traced(traced(UNSAMPLED)));
        for kind in [HOLE, GAP, BAD, GUIDED, UNGUIDED] {
            assert_eq!((super::kind(traced(kind)), is_reused(traced(kind))), (kind, false));
            assert!(is_traced(traced(kind)));
        }
    }
}
