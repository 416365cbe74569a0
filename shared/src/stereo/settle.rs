//! What each pixel of the second view shows: a point that the source shows too, or what a ray meets.
//!
//! The two tables of the producers hold, for each pixel, the key of the nearest source that lands there (`candidates`), and that of the
//! last gap over it (`gaps`). 001's questionable pixels are those whose gap is not below their candidate; 000's missed pixels those
//! without a candidate.
//!
//! Departures from 000 Alg. 3 and 5: the test on its line 3 is the other way round (the bounded ray belongs to pixels that have a
//! candidate), and depth and colour are those of the candidate's source, not of the target's place in the source. A bounded ray
//! that meets something has found the pixel's nearest hit, so no second ray follows. The bound is one pixel of disparity in front of
//! the candidate instead of the candidate itself, which every slanted surface would fail.

use super::reprojection::{EMPTY, nearer_by_a_pixel, pixel};
use super::source;
use crate::layout::Reprojection;
use kernel_api::At;

/// Nothing is verified: pixels in gaps are traced.
pub const VERIFY_NONE: u32 = 0;
/// Candidates in gaps and beside steps of depth are verified.
pub const VERIFY_EDGES: u32 = 1;
/// All candidates are verified.
pub const VERIFY_ALL: u32 = 2;

/// What is to be done for a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// What the word of [`source`] says if no ray meets anything in front of the candidate.
    pub kind: u32,
    /// Source column, of mirrored ones, if there is a candidate.
    pub column: u32,
}

impl Plan {
    /// The plan for column `x` (mirrored) of `row`.
    #[inline(always)]
    pub fn new(p: &Reprojection, candidates: &[u32], gaps: &[u32], x: u32, row: u32) -> Self {
        let at = pixel(p, x, row);
        let candidate = candidates.at(at);
        if candidate == EMPTY {
            return Self { kind: source::HOLE, column: 0 };
        }
        let column = candidate - 1;
        let in_gap = gaps.at(at) >= candidate;
        if in_gap && p.verify == VERIFY_NONE {
            return Self { kind: source::GAP, column };
        }
        let edge = |there: bool, neighbour: u32| there && steps(p, candidates, column, x, neighbour, row);
        let verified = p.verify == VERIFY_ALL
            || x >= p.checked_from
            || (p.verify == VERIFY_EDGES
                && (in_gap || edge(x > 0, x.wrapping_sub(1)) || edge(x + 1 < p.width, x + 1)));
        Self { kind: if verified { source::VERIFIED } else { source::REUSED }, column }
    }

    /// The pixel's word, as long as no ray says otherwise.
    #[inline(always)]
    pub fn word(&self, p: &Reprojection) -> u32 {
        match self.kind {
            source::REUSED | source::VERIFIED => source::from_column(self.kind, pixel(p, self.column, 0)),
            kind => source::traced(kind),
        }
    }
}

/// Up to which `t` the ray of a pixel has to be traced, by its word; none if it is reused as it is. `t` is that of the source's column.
#[inline(always)]
pub fn ray_end(p: &Reprojection, word: u32, t: impl Fn(u32) -> f32) -> Option<f32> {
    match source::kind(word) {
        source::REUSED | source::UNSAMPLED => None,
        source::VERIFIED => Some(nearer_by_a_pixel(p.interaxial_px, t(source::column(word)))),
        _ => Some(f32::INFINITY),
    }
}

/// The pixel's word behind its ray: a verified candidate is bad if something was `met` in front of it.
#[inline(always)]
pub fn concluded(word: u32, met: bool) -> u32 {
    if source::kind(word) == source::VERIFIED && met { source::traced(source::BAD) } else { word }
}

/// Whether depth steps between a pixel, whose candidate is source column `column`, and its neighbour: their shifts differ by two or
/// more, or the neighbour is a hole. Where not every column was sampled, a neighbour without a source tells nothing.
#[inline(always)]
fn steps(p: &Reprojection, candidates: &[u32], column: u32, x: u32, neighbour: u32, row: u32) -> bool {
    let other = candidates.at(pixel(p, neighbour, row));
    let shift = x as i32 - column as i32;
    let other_shift = neighbour as i32 - other.wrapping_sub(1) as i32;
    if other == EMPTY { p.sparse == 0 } else { (shift - other_shift + 1) as u32 > 2 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;

    fn plans(verify: u32, candidates: &[u32], gaps: &[u32]) -> Vec<u32> {
        let width = candidates.len() as u32;
        let p = Reprojection { width, rows: 1, verify, checked_from: width, ..Zeroable::zeroed() };
        (0..width).map(|x| Plan::new(&p, candidates, gaps, x, 0).kind).collect()
    }

    #[test]
    fn holes_gaps_and_edges_are_told_apart() {
        use source::{GAP, HOLE, REUSED, VERIFIED};
        // Shifts 0, 0, 0, −, 2, 2, 1, 1; a gap over the fourth and the fifth, and one under the sixth.
        let candidates = [1, 2, 3, EMPTY, 3, 4, 6, 7];
        let gaps = [EMPTY, EMPTY, EMPTY, 9, 3, 2, EMPTY, EMPTY];
        assert_eq!(
            plans(VERIFY_NONE, &candidates, &gaps),
            [REUSED, REUSED, REUSED, HOLE, GAP, REUSED, REUSED, REUSED]
        );
        let edges = [REUSED, REUSED, VERIFIED, HOLE, VERIFIED, REUSED, REUSED, REUSED];
        assert_eq!(plans(VERIFY_EDGES, &candidates, &gaps), edges);
        let all = [VERIFIED, VERIFIED, VERIFIED, HOLE, VERIFIED, VERIFIED, VERIFIED, VERIFIED];
        assert_eq!(plans(VERIFY_ALL, &candidates, &gaps), all);
    }

    #[test]
    fn a_step_of_two_is_an_edge_and_one_of_one_is_not() {
        let edges = |candidates: &[u32]| plans(VERIFY_EDGES, candidates, &[EMPTY; 4]);
        assert_eq!(edges(&[1, 2, 2, 3]), [source::REUSED; 4]);
        let verified = source::VERIFIED;
        assert_eq!(edges(&[1, 2, 1, 2]), [source::REUSED, verified, verified, source::REUSED]);
    }

    #[test]
    fn the_strip_that_only_one_eye_sees_is_verified_whatever_is_asked_for() {
        let p = Reprojection { width: 2, rows: 1, checked_from: 1, ..Zeroable::zeroed() };
        let kinds: Vec<_> = (0..2).map(|x| Plan::new(&p, &[1, 2], &[EMPTY; 2], x, 0).kind).collect();
        assert_eq!(kinds, [source::REUSED, source::VERIFIED]);
    }

    #[test]
    fn rays_end_a_pixel_of_disparity_in_front_of_the_candidate() {
        let p = Reprojection { width: 1, rows: 1, interaxial_px: 10.0, ..Zeroable::zeroed() };
        let end = |kind, t| ray_end(&p, source::from_column(kind, 0), |_| t);
        assert_eq!(end(source::REUSED, 2.0), None);
        assert_eq!(end(source::HOLE, 2.0), Some(f32::INFINITY));
        assert_eq!(end(source::VERIFIED, f32::INFINITY), Some(f32::INFINITY));
        // 10 − 10 / t is one less at t = 5/3.
        assert!((end(source::VERIFIED, 2.0).unwrap() - 5.0 / 3.0).abs() < 1e-6);
    }

    #[test]
    fn only_a_verified_candidate_can_be_bad() {
        let word = source::from_column(source::VERIFIED, 7);
        assert_eq!((concluded(word, false), concluded(word, true)), (word, source::traced(source::BAD)));
        let hole = source::traced(source::HOLE);
        assert_eq!((concluded(hole, false), concluded(hole, true)), (hole, hole));
    }
}
