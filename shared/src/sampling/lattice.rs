//! The points at which a picture is sampled: a finer grid over it, which each pass sees as a picture of its own.
//!
//! Either a pixel has n × n points, each in the middle of its part, or jittered in it (001's n by n method); or it has (2ᵏ + 1)², of
//! which those on its edges are its neighbours', too (001's nine rays, and the structure of its fig. 11). The second kind is sampled level
//! by level: first the corners of pixels, then, where `refine` asks for them, the points between. Level l has each 2ᵏ⁻ˡ-th point; those
//! of level l − 1 among them have been sampled before.
//!
//! Where a point comes from says its word (`stereo::source`), in the first view too.

use crate::layout::{Hit, NONE, View};
use crate::stereo::source::{UNSAMPLED, is_reused, traced};
use kernel_api::At;

/// The point that an invocation samples: column, and row of the band; none outside, or where the level before has been.
#[inline(always)]
pub fn point(view: &View, x: u32, y: u32) -> Option<[u32; 2]> {
    let [column, row] = [x << view.spacing_log2, y << view.spacing_log2];
    let is_new = view.refines == 0 || (x | y) & 1 == 1;
    (is_new && column < view.width && row < view.rows).then_some([column, row])
}

/// The word of a point before anything is sampled: `planned` on the first level.
#[inline(always)]
pub fn first_word(view: &View, column: u32, row: u32, planned: u32) -> u32 {
    let between = (1 << view.spacing_log2) - 1;
    if (column | row) & between == 0 { planned } else { traced(UNSAMPLED) }
}

/// The plan for a point: what was `planned` for it or, if nothing of the source lands on it, for the nearest point of its row (the left
/// one of two) that something lands on, within `reach` columns.
///
/// 001 asks for a ray to land on the very point. On a coarse level, where the points of both views are few, that would be a matter of luck:
/// with points each 4 columns, a surface at one depth has all of them or none. Half the distance to the next point of the level is as near
/// as one ray per pixel comes; where that makes a difference, colours differ, and the next level is twice as strict.
#[inline(always)]
pub fn plan(planned: &[u32], columns: u32, column: u32, row: u32, reach: u32) -> u32 {
    let first = row * columns;
    let word = planned.at(first + column);
    let mut apart = 1;
    while apart <= reach && !is_reused(word) {
        if column >= apart && is_reused(planned.at(first + column - apart)) {
            return planned.at(first + column - apart);
        }
        if column + apart < columns && is_reused(planned.at(first + column + apart)) {
            return planned.at(first + column + apart);
        }
        apart += 1;
    }
    word
}

/// The hit of a point that was not sampled: reprojection leaves it out (`stereo::reprojection::is_sampled`).
pub const UNSAMPLED_HIT: Hit = Hit { t: -1.0, prim_id: NONE };

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use std::collections::HashSet;

    #[test]
    fn levels_visit_every_point_once() {
        let (width, rows) = (17, 9);
        let mut visited = HashSet::new();
        for (spacing_log2, refines) in [(2, 0), (1, 1), (0, 1)] {
            let view = View { width, rows, spacing_log2, refines, ..Zeroable::zeroed() };
            for (x, y) in (0..rows + 7).flat_map(|y| (0..width + 7).map(move |x| (x, y))) {
                if let Some(point) = point(&view, x, y) {
                    assert!(visited.insert(point), "{point:?} twice");
                }
            }
        }
        assert_eq!(visited.len() as u32, width * rows);
        assert!(visited.iter().all(|[x, y]| *x < width && *y < rows));
    }

    #[test]
    fn plans_come_from_the_nearest_point_within_reach() {
        let hole = traced(crate::stereo::source::HOLE);
        let planned = [7, hole, hole, hole, hole, 8, hole, 9];
        let from = |column, reach| plan(&planned, 8, column, 0, reach);
        assert_eq!([from(5, 2), from(2, 2), from(3, 2), from(6, 1)], [8, 7, 8, 8]);
        assert_eq!([from(2, 1), from(6, 0)], [hole, hole], "too far");
        assert_eq!(plan(&planned, 4, 3, 0, 3), 7, "the next row is another one");
        assert_eq!(plan(&planned, 4, 0, 1, 1), 8);
    }

    #[test]
    fn only_corners_are_wanted_at_first() {
        let view = View { width: 9, rows: 9, spacing_log2: 2, ..Zeroable::zeroed() };
        let wanted = (0..81).filter(|i| first_word(&view, i % 9, i / 9, 5) == 5);
        assert_eq!(wanted.collect::<Vec<_>>(), [0, 4, 8, 36, 40, 44, 72, 76, 80]);
    }
}
