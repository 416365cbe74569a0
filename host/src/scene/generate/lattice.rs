//! Costa's lattice (SPD 3.6, lattice.c; parameters only).

use serde::Deserialize;

use super::tube::{self, Tube};
use super::{Generate, Shapes, spd};
use crate::scene::file::value::Segments;

/// The grid points of the unit cube as spheres, and cylinders between neighbours, one colour for each
/// direction.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Lattice {
    /// Cells along an edge; default 5 (the SPD's own is 12): 216 spheres and 540 cylinders.
    pub size_factor: u32,
    /// Flat sides of a cylinder; default 12.
    pub segments: Segments,
}

impl Default for Lattice {
    fn default() -> Self {
        Self { size_factor: 5, segments: Segments(12) }
    }
}

/// The cylinders end this far, in radii of the spheres, from their middles.
const INSIDE: f64 = 0.495;

impl Generate for Lattice {
    fn count(&self) -> u64 {
        let points = u64::from(self.size_factor).saturating_add(1);
        let square = points.saturating_mul(points);
        let cylinders = square.saturating_mul(3 * u64::from(self.size_factor));
        square
            .saturating_mul(points)
            .saturating_add(cylinders.saturating_mul(tube::triangles(self.segments.0)))
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let ball = shapes.material(spd([0.9; 3], [0.0, 0.5, 0.5, 37.0]));
        let rods = [0, 1, 2].map(|axis| {
            let colour = std::array::from_fn(|i| if i == axis { 0.9 } else { 0.1 });
            shapes.material(spd(colour, [0.1, 0.99, 0.0, 0.0]))
        });
        let cells = self.size_factor;
        // A lattice of no cells is one point of the size that a lattice of one cell has.
        let spacing = 1.0 / f64::from(cells.max(1));
        let radius = spacing / 4.0;
        for (x, y, z) in points(cells) {
            let cell = [x, y, z];
            let centre = cell.map(|i| f64::from(i) * spacing);
            shapes.sphere(centre, radius, ball);
            for axis in (0..3).filter(|axis| cell[*axis] < cells) {
                let at = |along: f64| {
                    let mut point = centre;
                    point[axis] += along;
                    point
                };
                let (from, to) = (at(INSIDE * radius), at(spacing - INSIDE * radius));
                let (segments, material) = (self.segments.0, rods[axis]);
                shapes.tube(&Tube { from, to, radii: [spacing / 16.0; 2], segments, material });
            }
        }
        shapes
    }
}

fn points(cells: u32) -> impl Iterator<Item = (u32, u32, u32)> {
    (0..=cells).flat_map(move |z| (0..=cells).flat_map(move |y| (0..=cells).map(move |x| (x, y, z))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_as_the_spd_has() {
        for (size_factor, spheres, cylinders) in
            [(0, 1, 0), (1, 8, 12), (2, 27, 54), (3, 64, 144), (5, 216, 540)]
        {
            let lattice = Lattice { size_factor, segments: Segments(3) };
            let made = lattice.shapes();
            assert_eq!((made.spheres.len(), made.triangles.len()), (spheres, cylinders * 6));
            assert_eq!(lattice.count(), (spheres + cylinders * 6) as u64);
        }
        let count = |size_factor| Lattice { size_factor, segments: Segments(3) }.count();
        assert_eq!(count(12), 2197 + 6084 * 6);
        assert_eq!(count(u32::MAX), u64::MAX);
    }
}
