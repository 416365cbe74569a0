//! Where a pixel needs more points: adaptive supersampling (Whitted 1980) on 001's structure.
//!
//! A cell of a level is a square between four of its points. It is divided if their colours differ too much, and only if it is itself
//! a part of a divided cell. The middle of a cell belongs to no other cell, so whether it was sampled tells whether the cell is divided.

use crate::layout::View;
use crate::math::clamp;
use crate::stereo::source::{UNSAMPLED, kind};
use glam::Vec3;

/// A cell of the level that `view` has: its upper left point and the distance to the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Column of the upper left point.
    pub column: u32,
    /// Its row of the band.
    pub row: u32,
    /// Points from corner to corner.
    pub side: u32,
}

impl Cell {
    /// Cell (`x`, `y`) of a level; none outside.
    #[inline(always)]
    pub fn new(view: &View, x: u32, y: u32) -> Option<Self> {
        let side = 1 << view.spacing_log2;
        let [column, row] = [x << view.spacing_log2, y << view.spacing_log2];
        (column + side < view.width && row + side < view.rows).then_some(Self { column, row, side })
    }

    /// Index of a point of the cell, so far to the right and down in a lattice of `width` columns.
    #[inline(always)]
    pub fn point(&self, width: u32, right: u32, down: u32) -> u32 {
        (self.row + down) * width + self.column + right
    }

    /// Its middle; only cells with more than one point a side have one.
    #[inline(always)]
    pub fn middle(&self, width: u32) -> u32 {
        self.point(width, self.side >> 1, self.side >> 1)
    }

    /// The middle of the cell of twice the side of which this is a quarter.
    #[inline(always)]
    pub fn middle_of_parent(&self, width: u32) -> u32 {
        let of_parent = |at: u32| (at & !(2 * self.side - 1)) + self.side;
        of_parent(self.row) * width + of_parent(self.column)
    }

    /// Its corners, row by row.
    #[inline(always)]
    pub fn corners(&self, width: u32) -> [u32; 4] {
        let side = self.side;
        [(0, 0), (side, 0), (0, side), (side, side)].map(|(right, down)| self.point(width, right, down))
    }

    /// Calls `visit` with column and row of each point that a division adds: of each edge the middle, and that of the cell.
    #[inline(always)]
    pub fn between(&self, mut visit: impl FnMut(u32, u32)) {
        let (half, mut down) = (self.side >> 1, 0);
        while down < 3 {
            let mut right = 0;
            while right < 3 {
                if (right | down) & 1 == 1 {
                    visit(self.column + right * half, self.row + down * half);
                }
                right += 1;
            }
            down += 1;
        }
    }
}

/// Whether a point with this word was sampled, or is to be.
#[inline(always)]
pub fn is_sampled(word: u32) -> bool {
    kind(word) != UNSAMPLED
}

/// Whether a component of two of the colours differs by more than `tolerance`, of what a screen can show: linear, in [0, 1].
#[inline(always)]
pub fn differ(colours: [Vec3; 4], tolerance: f32) -> bool {
    let shown = colours.map(|c| Vec3::new(clamp(c.x, 0.0, 1.0), clamp(c.y, 0.0, 1.0), clamp(c.z, 0.0, 1.0)));
    let [a, b, c, d] = shown;
    let apart = |a: Vec3, b: Vec3| {
        let d = a - b;
        (d.x > tolerance)
            | (d.y > tolerance)
            | (d.z > tolerance)
            | (-d.x > tolerance)
            | (-d.y > tolerance)
            | (-d.z > tolerance)
    };
    apart(a, b) | apart(a, c) | apart(a, d) | apart(b, c) | apart(b, d) | apart(c, d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;

    const WIDTH: u32 = 9;

    fn cell(spacing_log2: u32, x: u32, y: u32) -> Option<Cell> {
        Cell::new(&View { width: WIDTH, rows: 9, spacing_log2, ..Zeroable::zeroed() }, x, y)
    }

    #[test]
    fn cells_lie_between_points() {
        assert_eq!(cell(3, 0, 0), Some(Cell { column: 0, row: 0, side: 8 }));
        assert_eq!((cell(3, 1, 0), cell(0, 8, 0), cell(0, 0, 8)), (None, None, None));
        assert!(cell(0, 7, 7).is_some());
    }

    #[test]
    fn quarters_have_the_middle_of_their_parent_as_a_corner() {
        let parent = cell(2, 1, 0).unwrap();
        for (x, y) in [(2, 0), (3, 0), (2, 1), (3, 1)] {
            let quarter = cell(1, x, y).unwrap();
            assert_eq!(quarter.middle_of_parent(WIDTH), parent.middle(WIDTH));
            assert!(quarter.corners(WIDTH).contains(&parent.middle(WIDTH)));
        }
        let mut points = parent.corners(WIDTH).to_vec();
        parent.between(|column, row| points.push(row * WIDTH + column));
        points.sort_unstable();
        assert_eq!(points, [4, 6, 8, 22, 24, 26, 40, 42, 44]);
    }

    #[test]
    fn one_component_is_enough_and_what_no_screen_shows_does_not_count() {
        let grey = [Vec3::splat(0.5); 4];
        assert!(!differ(grey, 0.0));
        for corner in 0..4 {
            for axis in 0..3 {
                for by in [-0.11, 0.11] {
                    let mut colours = grey;
                    colours[corner][axis] += by;
                    assert!(differ(colours, 0.1) && !differ(colours, 0.12), "{corner} {axis} {by}");
                }
            }
        }
        assert!(!differ([Vec3::ONE, Vec3::splat(9.0), Vec3::ONE, Vec3::splat(2.0)], 0.0));
    }
}
