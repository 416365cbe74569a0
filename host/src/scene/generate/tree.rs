//! Haines' tree (SPD 3.6, tree.c; parameters only).

use serde::Deserialize;

use super::tube::{self, Tube};
use super::{Generate, Shapes, powers, spd};
use crate::scene::file::value::Segments;
use crate::scene::model::{rotation, times};

/// A branch is a cone with a sphere at its tip and bears two smaller branches; the field is a square at z =
/// 0. Grows along +z.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Tree {
    /// Levels above the trunk; default 8 (the SPD's own is 11): 511 cones and spheres.
    pub size_factor: u32,
    /// Flat sides of a cone; default 16.
    pub segments: Segments,
    /// Whether there is a field; default true.
    pub floor: bool,
}

impl Default for Tree {
    fn default() -> Self {
        Self { size_factor: 8, segments: Segments(16), floor: true }
    }
}

impl Generate for Tree {
    fn count(&self) -> u64 {
        powers(2, self.size_factor).saturating_mul(tube::triangles(self.segments.0) + 1).saturating_add(2)
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let bark = shapes.material(spd([0.55, 0.4, 0.2], [0.0, 1.0, 0.0, 0.0]));
        if self.floor {
            let grass = shapes.material(spd([0.2, 0.7, 0.2], [0.0, 1.0, 0.0, 0.0]));
            shapes.parallelogram([-50.0, -50.0, 0.0], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0], grass);
        }
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let trunk = Branch { matrix: unit, foot: [0.0; 3], thickness: 1.0 };
        let mut grower = Grower { shapes, segments: self.segments.0, bark };
        grower.grow(&trunk, self.size_factor);
        grower.shapes
    }
}

/// Takes a branch's own frame, in which it goes from the origin to (0, 0, 1), to the world.
struct Branch {
    matrix: [[f64; 3]; 3],
    foot: [f64; 3],
    /// Factor of the radii, which are in world units and do not pass through the matrix.
    thickness: f64,
}

impl Branch {
    fn tip(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.foot[i] + self.matrix[i][2])
    }

    /// The branch at this one's tip that is turned about x, then about z, and scaled.
    fn child(&self, [about_x, about_z]: [f32; 2], scale: f64) -> Self {
        let turned = rotation([about_x, 0.0, about_z]);
        let column = |i: usize| times(&self.matrix, turned.map(|row| scale * row[i]));
        let columns = [0, 1, 2].map(column);
        let matrix = std::array::from_fn(|row| [0, 1, 2].map(|i| columns[i][row]));
        Self { matrix, foot: self.tip(), thickness: 0.67 * self.thickness }
    }
}

struct Grower {
    shapes: Shapes,
    segments: u32,
    bark: u32,
}

impl Grower {
    fn grow(&mut self, branch: &Branch, levels: u32) {
        let base = 0.15 * branch.thickness;
        let (from, to, radii) = (branch.foot, branch.tip(), [base, 0.67 * base]);
        self.shapes.tube(&Tube { from, to, radii, segments: self.segments, material: self.bark });
        self.shapes.sphere(to, radii[1], self.bark);
        if levels > 0 {
            self.grow(&branch.child([40.0, 90.0], 0.65), levels - 1);
            self.grow(&branch.child([25.0, 230.0], 0.7), levels - 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_branches_as_the_spd_has() {
        for (size_factor, branches) in [(1, 3), (2, 7), (3, 15), (8, 511)] {
            let tree = Tree { size_factor, segments: Segments(5), floor: true };
            let made = tree.shapes();
            assert_eq!(made.spheres.len(), branches);
            assert_eq!(made.triangles.len(), branches * 10 + 2);
            assert_eq!(tree.count(), (branches * 11 + 2) as u64);
        }
        assert_eq!(powers(2, 15), 65_535);
    }

    #[test]
    fn the_first_branches_lean_as_told() {
        let spheres = Tree { size_factor: 1, ..Tree::default() }.shapes().spheres;
        assert_eq!((spheres[0].centre, spheres[0].radius), ([0.0, 0.0, 1.0], 0.1005));
        // 40 degrees about x takes +z towards -y; 90 about z takes that to +x.
        let (s, c) = 40_f32.to_radians().sin_cos();
        let expected = [0.65 * s, 0.0, 1.0 + 0.65 * c];
        assert!(spheres[1].centre.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6));
    }
}
