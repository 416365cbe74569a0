//! Where a model stands in the world.

use super::Polygons;
use super::polygon::Facet;

/// How a model is brought into the world: rotated, then fitted, then scaled, then moved.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Placement {
    /// Degrees about x, then y, then z, each counter-clockwise seen from the axis' tip.
    pub(crate) rotate: [f32; 3],
    /// Length that the longest side of its box is given; the box then stands centred on the origin of the
    /// plane y = 0.
    pub(crate) fit: Option<f32>,
    /// Factor, 1 when not said.
    pub(crate) scale: Option<f32>,
    /// Movement, world units.
    pub(crate) translate: [f32; 3],
}

impl Placement {
    /// Moves all vertices and turns all normals; the box of `fit` is that of the facets.
    pub(super) fn apply(&self, polygons: &mut Polygons, facets: &[Facet]) {
        if *self == Self::default() {
            return;
        }
        let rotation = rotation(self.rotate);
        if self.rotate != [0.0; 3] {
            for v in polygons.positions.iter_mut().chain(&mut polygons.normals) {
                *v = times(&rotation, v.map(f64::from)).map(|x| x as f32);
            }
        }
        let (foot, fitted) = match (self.fit, bounds(polygons, facets)) {
            (Some(length), Some(bounds)) => standing(bounds, f64::from(length)),
            _ => ([0.0; 3], 1.0),
        };
        let scale = fitted * f64::from(self.scale.unwrap_or(1.0));
        for p in &mut polygons.positions {
            for axis in 0..3 {
                let moved = (f64::from(p[axis]) - foot[axis]) * scale + f64::from(self.translate[axis]);
                p[axis] = moved as f32;
            }
        }
    }
}

/// The middle of the box's floor, and the factor that makes its longest side `length` long.
fn standing([low, high]: [[f32; 3]; 2], length: f64) -> ([f64; 3], f64) {
    let [low, high] = [low.map(f64::from), high.map(f64::from)];
    let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let middle = |i: usize| (low[i] + high[i]) / 2.0;
    ([middle(0), low[1], middle(2)], if longest > 0.0 { length / longest } else { 1.0 })
}

/// The box of all facets.
fn bounds(polygons: &Polygons, facets: &[Facet]) -> Option<[[f32; 3]; 2]> {
    let corners = facets.iter().flat_map(|f| f.corners).map(|c| polygons.positions[c.position as usize]);
    corners.map(|p| [p, p]).reduce(|[low, high], [p, _]| {
        [std::array::from_fn(|i| low[i].min(p[i])), std::array::from_fn(|i| high[i].max(p[i]))]
    })
}

/// The rotation by `degrees` about x, then y, then z, as rows.
pub(crate) fn rotation(degrees: [f32; 3]) -> [[f64; 3]; 3] {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.map(sin_cos);
    [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
}

/// Sine and cosine, exact at quarter turns.
fn sin_cos(degrees: f32) -> (f64, f64) {
    match f64::from(degrees).rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        turned => turned.to_radians().sin_cos(),
    }
}

/// Matrix times vector.
pub(crate) fn times(rows: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    rows.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::model::{Corner, Face};
    use crate::scene::warning::Tally;
    use parallax_shared::layout::NONE;

    #[test]
    fn rotations_turn_counter_clockwise() {
        assert_eq!(times(&rotation([90.0, 0.0, 0.0]), [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
        assert_eq!(times(&rotation([0.0, 90.0, 0.0]), [0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]);
        assert_eq!(times(&rotation([0.0, 0.0, 90.0]), [1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        // About x first: z goes to -y, which the turn about z takes to x.
        assert_eq!(times(&rotation([90.0, 0.0, 90.0]), [0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_fitted_model_stands_on_the_floor() {
        let corner = |position| Corner { position, uv: NONE, normal: NONE };
        let mut polygons = Polygons {
            positions: vec![[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 0.0, 4.0], [1e9; 3]],
            corners: (0..3).map(corner).collect(),
            faces: vec![Face { first: 0, corners: 3, material: NONE, line: 0 }],
            ..Polygons::default()
        };
        let facets = polygons.facets(&mut Tally::default());
        let placement = Placement {
            rotate: [-90.0, 0.0, 0.0],
            fit: Some(1.0),
            scale: Some(2.0),
            translate: [0.0, 0.0, 5.0],
        };
        placement.apply(&mut polygons, &facets);
        assert_eq!(polygons.positions[..3], [[-1.0, 0.0, 5.0], [1.0, 0.0, 5.0], [-1.0, 1.0, 5.0]]);
    }
}
