//! Simple closed meshes and the parallelogram, for scenes and tests.

use std::collections::HashMap;

use serde::Deserialize;

use super::{Generate, Shapes};
use crate::scene::file::value::{Length, Lengths, Point};

/// A parallelogram of two flat triangles; texture coordinates go from (0, 0) at `corner` to (1, 1).
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quad {
    /// A corner.
    pub corner: Point,
    /// From there to a neighbouring corner, along which texture coordinate u grows.
    pub u: Point,
    /// From there to the other one, along which v grows.
    pub v: Point,
}

impl Generate for Quad {
    fn count(&self) -> u64 {
        2
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        shapes.parallelogram(self.corner.0, self.u.0, self.v.0, 0);
        shapes
    }
}

/// A cuboid along the axes, twelve flat triangles that face out.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cube {
    /// Its middle.
    pub centre: Point,
    /// Lengths of its sides.
    pub size: Lengths,
}

impl Generate for Cube {
    fn count(&self) -> u64 {
        12
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let (low, high): ([f32; 3], [f32; 3]) = {
            let half = |i: usize| self.size.0[i] / 2.0;
            let end = |sign: f32| std::array::from_fn(|i| self.centre.0[i] + sign * half(i));
            (end(-1.0), end(1.0))
        };
        let corner = |bits: [bool; 3]| std::array::from_fn(|i| if bits[i] { high[i] } else { low[i] });
        for axis in 0..3 {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            for side in [false, true] {
                // Corners are picked, not summed, so that neighbouring faces share them to the bit.
                let at = |along_u: bool, along_v: bool| {
                    let mut bits = [false; 3];
                    bits[axis] = side;
                    // The far face is wound the other way.
                    (bits[u], bits[v]) = if side { (along_u, along_v) } else { (along_v, along_u) };
                    corner(bits)
                };
                shapes.quadrangle([at(false, false), at(true, false), at(true, true), at(false, true)], 0);
            }
        }
        shapes
    }
}

/// A sphere as a mesh: an icosahedron whose triangles are split into four, again and again.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Icosphere {
    /// Its middle.
    pub centre: Point,
    /// Distance of its vertices from there.
    pub radius: Length,
    /// How often each triangle is split: `20 · 4^subdivisions` triangles.
    pub subdivisions: u32,
    /// Whether it is shaded as a sphere; default true.
    #[serde(default = "yes")]
    pub smooth: bool,
}

fn yes() -> bool {
    true
}

impl Generate for Icosphere {
    fn count(&self) -> u64 {
        4_u64.checked_pow(self.subdivisions).and_then(|n| n.checked_mul(20)).unwrap_or(u64::MAX)
    }

    fn shapes(&self) -> Shapes {
        let (mut points, mut faces) = icosahedron();
        for _ in 0..self.subdivisions {
            faces = split(&mut points, &faces);
        }
        let mut shapes = Shapes::default();
        let place = |n: [f64; 3]| {
            std::array::from_fn(|i| (f64::from(self.centre.0[i]) + f64::from(self.radius.0) * n[i]) as f32)
        };
        for face in faces {
            let normals = face.map(|i| points[i as usize]);
            let uvs = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
            shapes.smooth(normals.map(place), normals.map(|n| n.map(|x| x as f32)), uvs, 0);
            if let (false, Some(last)) = (self.smooth, shapes.triangles.last_mut()) {
                (last.smooth, last.normals) = (0, [[0.0; 3]; 3]);
            }
        }
        shapes
    }
}

/// Unit vectors and faces that look out counter-clockwise.
fn icosahedron() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5_f64.sqrt()) / 2.0;
    let length = (1.0 + golden * golden).sqrt();
    let (a, b) = (1.0 / length, golden / length);
    let points = vec![
        [-a, b, 0.0],
        [a, b, 0.0],
        [-a, -b, 0.0],
        [a, -b, 0.0],
        [0.0, -a, b],
        [0.0, a, b],
        [0.0, -a, -b],
        [0.0, a, -b],
        [b, 0.0, -a],
        [b, 0.0, a],
        [-b, 0.0, -a],
        [-b, 0.0, a],
    ];
    #[rustfmt::skip]
    let faces = vec![
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
        [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
        [8, 6, 7], [9, 8, 1],
    ];
    (points, faces)
}

/// Each face as four, new points at the middles of edges and on the unit sphere; an edge's point is made
/// once.
fn split(points: &mut Vec<[f64; 3]>, faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            let [p, q] = [a, b].map(|i| points[i as usize]);
            let sum: [f64; 3] = std::array::from_fn(|i| p[i] + q[i]);
            let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
            points.push(sum.map(|x| x / length));
            points.len() as u32 - 1
        })
    };
    let quarters = faces.iter().flat_map(|&[a, b, c]| {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    });
    quarters.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use parallax_shared::layout::Triangle;

    /// Six times the volume, and whether every edge is shared by exactly two faces that run along it in
    /// opposite directions.
    fn volume(triangles: &[Triangle]) -> (f64, bool) {
        let mut edges: HashMap<_, i32> = HashMap::new();
        let mut six = 0.0;
        for t in triangles {
            let [a, b, c] = t.vertices.map(|v| v.map(f64::from));
            six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]);
            six += a[2] * (b[0] * c[1] - b[1] * c[0]);
            for i in 0..3 {
                let [p, q] = [t.vertices[i], t.vertices[(i + 1) % 3]].map(|v| v.map(f32::to_bits));
                *edges.entry(if p < q { (p, q) } else { (q, p) }).or_default() += if p < q { 1 } else { 100 };
            }
        }
        (six, edges.values().all(|n| *n == 101))
    }

    #[test]
    fn solids_are_closed_and_face_out() {
        let cube = Cube { centre: Point([0.1, 0.2, 0.3]), size: Lengths([1.0, 2.0, 3.0]) }.shapes();
        let (six, closed) = volume(&cube.triangles);
        assert!(closed && (six - 36.0).abs() < 1e-5, "{six}");
        let (centre, radius) = (Point([5.0, 6.0, 7.0]), Length(2.0));
        let sphere = Icosphere { centre, radius, subdivisions: 4, smooth: false };
        let (six, closed) = volume(&sphere.shapes().triangles);
        assert!(closed && (six / 6.0 / 33.51 - 1.0).abs() < 0.01, "{six}");
        assert_eq!((sphere.count(), sphere.shapes().triangles.len()), (5120, 5120));
        assert_eq!(Icosphere { subdivisions: 99, ..sphere }.count(), u64::MAX);
    }

    #[test]
    fn a_quad_faces_its_u_times_v() {
        let quad =
            Quad { corner: Point([1.0; 3]), u: Point([2.0, 0.0, 0.0]), v: Point([0.0, 3.0, 0.0]) }.shapes();
        assert_eq!(quad.triangles[0].vertices, [[1.0; 3], [3.0, 1.0, 1.0], [3.0, 4.0, 1.0]]);
        assert_eq!(quad.triangles[1].vertices, [[1.0; 3], [3.0, 4.0, 1.0], [1.0, 4.0, 1.0]]);
        assert_eq!(quad.triangles[1].uvs, [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    }
}
