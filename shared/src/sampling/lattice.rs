//! The points at which a picture is sampled: a finer grid over it, which each pass sees as a picture of its own.
//!
//! Either a pixel has n × n points, each in the middle of its part, or jittered in it (001's n by n method); or it has (2ᵏ + 1)², of
//! which those on its edges are its neighbours', too (001's nine rays, and the structure of its fig. 11). The second kind is sampled level
//! by level: first the corners of pixels, then, where `refine` asks for them, the points between. Level l has each 2ᵏ⁻ˡ-th point; those
//! of level l − 1 among them have been sampled before.
//!
//! Where a point comes from says its word (`stereo::source`), in the first view too.

use crate::layout::{Hit, NONE, View};
use crate::stereo::source::{UNSAMPLED, traced};

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
    fn only_corners_are_wanted_at_first() {
        let view = View { width: 9, rows: 9, spacing_log2: 2, ..Zeroable::zeroed() };
        let wanted = (0..81).filter(|i| first_word(&view, i % 9, i / 9, 5) == 5);
        assert_eq!(wanted.collect::<Vec<_>>(), [0, 4, 8, 36, 40, 44, 72, 76, 80]);
    }
}
