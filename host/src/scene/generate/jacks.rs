//! Enzmann's jacks (SPD 3.6, jacks.c; parameters only).

use serde::Deserialize;

use super::tube::{self, Tube};
use super::{Generate, Shapes, powers, spd};
use crate::scene::file::value::Segments;
use crate::scene::model::{rotation, times};

/// A jack is three crossed cylinders with spheres at their ends; each of the upper levels is surrounded by
/// eight of half its size. The whole is turned by -30 degrees about x and -20 about y.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Jacks {
    /// Levels; default 3: 73 jacks.
    pub size_factor: u32,
    /// Flat sides of a cylinder; default 16.
    pub segments: Segments,
}

impl Default for Jacks {
    fn default() -> Self {
        Self { size_factor: 3, segments: Segments(16) }
    }
}

impl Generate for Jacks {
    fn count(&self) -> u64 {
        let jacks = self.size_factor.checked_sub(1).map_or(0, |last| powers(8, last));
        jacks.saturating_mul(3 * tube::triangles(self.segments.0) + 6)
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        // The third value of the SPD's specular colour is 0.4: a tint that this model does not have.
        shapes.material(spd([0.737, 0.561, 0.561], [0.1, 0.7, 0.7, 20.0]));
        let turn = rotation([-30.0, -20.0, 0.0]);
        self.jack(&mut shapes, [0.0; 3], 1.0, self.size_factor, &turn);
        shapes
    }
}

impl Jacks {
    fn jack(&self, shapes: &mut Shapes, centre: [f64; 3], scale: f64, levels: u32, turn: &[[f64; 3]; 3]) {
        if levels == 0 {
            return;
        }
        for axis in 0..3 {
            let ends = [-0.75, 0.75].map(|end| {
                let mut point = centre;
                point[axis] += end * scale;
                times(turn, point)
            });
            let radii = [0.075 * scale; 2];
            let [from, to] = ends;
            shapes.tube(&Tube { from, to, radii, segments: self.segments.0, material: 0 });
            ends.iter().for_each(|end| shapes.sphere(*end, 0.15 * scale, 0));
        }
        for corner in 0..8 {
            let offset = |i: usize| if corner >> i & 1 == 0 { -0.5 } else { 0.5 };
            let at = std::array::from_fn(|i| centre[i] + offset(i) * scale);
            self.jack(shapes, at, scale / 2.0, levels - 1, turn);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_as_the_spd_has() {
        for (size_factor, cylinders, spheres) in
            [(0, 0, 0), (1, 3, 6), (2, 27, 54), (3, 219, 438), (4, 1755, 3510)]
        {
            let jacks = Jacks { size_factor, segments: Segments(4) };
            let made = jacks.shapes();
            assert_eq!((made.triangles.len(), made.spheres.len()), (cylinders * 8, spheres));
            assert_eq!(jacks.count(), (cylinders * 8 + spheres) as u64);
        }
        assert_eq!(Jacks { size_factor: u32::MAX, ..Jacks::default() }.count(), u64::MAX);
    }
}
