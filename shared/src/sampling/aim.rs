//! 001's aiming ray: the middle one of nine decides where a pixel lands.
//!
//! Departure: 001 moves the mean colour of the nine. Here their points are moved, each with the pixel whose upper left quarter it bounds,
//! so that what depends on the viewer can be had anew; what 001 does about ghosts (`Reprojection::inclusive`) is done.

use crate::layout::Reprojection;
use crate::stereo::source::{self, REUSED};

/// Index of the middle point of pixel (`x`, `y`) of the band, in a lattice of `columns` columns.
#[inline(always)]
pub fn middle(columns: u32, x: u32, y: u32) -> u32 {
    (2 * y + 1) * columns + 2 * x + 1
}

/// The pixel that decides about the point in this column and row of the lattice.
#[inline(always)]
pub fn pixel_of(p: &Reprojection, column: u32, row: u32) -> [u32; 2] {
    let last = |place: u32, places: u32| if place < places { place } else { places - 1 };
    [last(column >> 1, p.width), last(row >> 1, p.rows)]
}

/// The word of a point in `column` whose pixel, in column `x`, has this word. What was verified is so for the middle only: the other
/// points are reused with it.
#[inline(always)]
pub fn word_of_point(word: u32, x: u32, column: u32) -> u32 {
    if source::is_reused(word) {
        source::from_column(REUSED, 2 * source::column(word) + (column - 2 * x))
    } else {
        word
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use source::{HOLE, VERIFIED, traced};

    #[test]
    fn edges_belong_to_the_pixel_behind_them_and_the_last_to_the_last() {
        let p = Reprojection { width: 3, rows: 2, ..Zeroable::zeroed() };
        let pixels: Vec<_> = (0..7).map(|column| pixel_of(&p, column, 4)).collect();
        assert_eq!(pixels, [[0, 1], [0, 1], [1, 1], [1, 1], [2, 1], [2, 1], [2, 1]]);
        assert_eq!(middle(7, 2, 1), 3 * 7 + 5);
    }

    #[test]
    fn points_come_from_the_same_place_in_the_sources_pixel() {
        let word = source::from_column(VERIFIED, 5);
        for (column, from) in [(14, 10), (15, 11), (16, 12)] {
            assert_eq!(word_of_point(word, 7, column), source::from_column(REUSED, from));
        }
        assert_eq!(word_of_point(traced(HOLE), 7, 14), traced(HOLE));
    }
}
