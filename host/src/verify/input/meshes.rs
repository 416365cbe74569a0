//! Meshes that are generated: closed ones, whose every ray from inside must hit, and how rays are aimed at their edges.

use bytemuck::Zeroable;
use parallax_shared::layout::{Ray, Triangle};
use std::collections::HashMap;

/// A point or vector.
pub type Vector = [f32; 3];

/// A mesh with its name.
pub struct Mesh {
    /// For reports.
    pub name: String,
    /// Its triangles.
    pub triangles: Vec<Triangle>,
}

impl Mesh {
    fn new(name: &str, vertices: &[Vector], faces: &[[usize; 3]]) -> Self {
        let triangle =
            |face: &[usize; 3]| Triangle { vertices: face.map(|i| vertices[i]), ..Zeroable::zeroed() };
        Self { name: name.into(), triangles: faces.iter().map(triangle).collect() }
    }

    /// The corners of its box.
    pub fn bounds(&self) -> (Vector, Vector) {
        let mut bounds = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for vertex in self.triangles.iter().flat_map(|triangle| triangle.vertices) {
            for (axis, coordinate) in vertex.into_iter().enumerate() {
                bounds.0[axis] = bounds.0[axis].min(coordinate);
                bounds.1[axis] = bounds.1[axis].max(coordinate);
            }
        }
        bounds
    }

    /// Scaled by the power of two that brings the largest coordinate between 1 and 2, as the host scales a scene.
    pub fn scaled(mut self) -> Self {
        let (low, high) = self.bounds();
        let extent = low.iter().chain(&high).fold(0f32, |most, x| most.max(x.abs()));
        let scale = f32::from_bits((254 - (extent.to_bits() >> 23)) << 23);
        self.triangles.iter_mut().for_each(|t| t.vertices = t.vertices.map(|v| v.map(|x| x * scale)));
        self
    }

    /// Each triangle `times` times, in random order: hits at equal `t` in different packs.
    pub fn repeated(mut self, times: usize) -> Self {
        self.triangles = self.triangles.repeat(times);
        let mut random = Random(3);
        for i in (1..self.triangles.len()).rev() {
            self.triangles.swap(i, random.below(i + 1));
        }
        self.name += &format!(", each triangle {times} times");
        self
    }
}

/// An icosahedron, each face cut into four `level` times, its vertices on the sphere.
pub fn icosphere(level: u32, radius: f64, centre: Vector) -> Mesh {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(1.0, golden), (1.0, -golden), (-1.0, golden), (-1.0, -golden)] {
        vertices.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let mut faces = icosahedron_faces(&vertices);
    for _ in 0..level {
        faces = subdivided(&mut vertices, &faces);
    }
    let place = |v: &[f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        [0, 1, 2].map(|k| (v[k] / length * radius + centre[k] as f64) as f32)
    };
    let vertices: Vec<Vector> = vertices.iter().map(place).collect();
    Mesh::new(&format!("sphere, radius {radius:e} at {centre:?}"), &vertices, &faces)
}

/// All triples of vertices with the distance of an edge.
fn icosahedron_faces(vertices: &[[f64; 3]]) -> Vec<[usize; 3]> {
    let edge = |a: usize, b: usize| {
        let square = (0..3).map(|k| (vertices[a][k] - vertices[b][k]).powi(2)).sum::<f64>();
        (square - 4.0).abs() < 0.1
    };
    let triples = (0..12).flat_map(|i| (i + 1..12).flat_map(move |j| (j + 1..12).map(move |k| [i, j, k])));
    triples.filter(|&[i, j, k]| edge(i, j) && edge(j, k) && edge(i, k)).collect()
}

/// Each face cut into four at the middles of its edges, which are shared and pushed out to the sphere.
fn subdivided(vertices: &mut Vec<[f64; 3]>, faces: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut middles = HashMap::new();
    let mut middle = |a: usize, b: usize| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            let sum = [0, 1, 2].map(|k| vertices[a][k] + vertices[b][k]);
            let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0;
            vertices.push(sum.map(|x| x / length));
            vertices.len() - 1
        })
    };
    let cut = |&[a, b, c]: &[usize; 3]| {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    };
    faces.iter().flat_map(cut).collect()
}

/// An axis-parallel cube.
pub fn cube(half: f32, centre: Vector) -> Mesh {
    let corner = |i: usize| [0, 1, 2].map(|k| centre[k] + if i >> k & 1 == 1 { half } else { -half });
    let vertices: Vec<Vector> = (0..8).map(corner).collect();
    let faces = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    Mesh::new(&format!("cube, half {half} at {centre:?}"), &vertices, &faces)
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// At least 0, less than `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// At least 0, less than 1.
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / 16_777_216.0
    }
}

fn mix(a: Vector, b: Vector, t: f32) -> Vector {
    [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t)
}

/// A ray from `origin` through `target`.
pub fn towards(origin: Vector, target: Vector) -> Ray {
    Ray { origin, t_min: 0.0, dir: [0, 1, 2].map(|k| target[k] - origin[k]), t_max: f32::INFINITY }
}

/// `count` rays from near the centre of a closed mesh at its vertices, points of edges, middles of edges and points of faces; a fifth
/// of them parallel to an axis.
pub fn rays_from_inside(mesh: &Mesh, count: usize, seed: u64) -> Vec<Ray> {
    let (low, high) = mesh.bounds();
    let centre = mix(low, high, 0.5);
    let size = (0..3).fold(0f32, |most, k| most.max(high[k] - low[k]));
    let mut random = Random(seed);
    let mut ray = |number: usize| {
        let triangle = mesh.triangles[random.below(mesh.triangles.len())].vertices;
        let (from, to) = (triangle[number / 5 % 3], triangle[(number / 5 + 1) % 3]);
        let target = match number % 5 {
            0 | 4 => from,
            1 => mix(from, to, random.unit()),
            2 => mix(from, to, 0.5),
            _ => mix(mix(triangle[0], triangle[1], random.unit()), triangle[2], random.unit()),
        };
        let near = |c: f32, random: &mut Random| c + size * 0.2 * (random.unit() - 0.5);
        let mut origin = if number.is_multiple_of(3) { centre } else { centre.map(|c| near(c, &mut random)) };
        if number % 5 == 4 {
            along_an_axis(&mut origin, target, centre, size);
        }
        towards(origin, target)
    };
    (0..count).map(&mut ray).collect()
}

/// Moves `origin` so that `target` is straight along an axis, as far as it stays inside.
fn along_an_axis(origin: &mut Vector, target: Vector, centre: Vector, size: f32) {
    let offset = |k: usize| (target[k] - origin[k]).abs();
    let axis = (0..3).fold(0, |best, k| if offset(k) > offset(best) { k } else { best });
    for k in (0..3).filter(|&k| k != axis) {
        if (target[k] - centre[k]).abs() < size * 0.2 {
            origin[k] = target[k];
        }
    }
}

/// Rays from outside: at random, at vertices and edges, in the plane of a triangle, along an axis; half of them with a range.
pub fn rays_from_outside(mesh: &Mesh, count: usize, seed: u64) -> Vec<Ray> {
    let (low, high) = mesh.bounds();
    let centre = mix(low, high, 0.5);
    let size = (0..3).fold(0f32, |most, k| most.max(high[k] - low[k]));
    let mut random = Random(seed);
    let mut ray = |number: usize| {
        let reach = if number.is_multiple_of(2) { 1.5 } else { 0.5 };
        let mut origin = centre.map(|c| c + size * reach * (2.0 * random.unit() - 1.0));
        let [a, b, c] = mesh.triangles[random.below(mesh.triangles.len())].vertices;
        let (u, v) = (random.unit(), random.unit());
        let target = match number % 6 {
            0 => centre.map(|c| c + size * (random.unit() - 0.5)),
            1 => a,
            2 => mix(a, b, u),
            3 => mix(b, c, 0.5),
            4 => {
                origin = mix(a, mix(b, c, v * 3.0 - 1.0), u * 40.0 - 20.0);
                mix(a, b, v)
            }
            _ => {
                let axis = number / 6 % 3;
                origin = [0, 1, 2].map(|k| if k == axis { origin[k] } else { a[k] });
                a
            }
        };
        let (t_min, t_max) = match number / 6 % 4 {
            0 => (0.0, 1.0),
            1 => (0.9 * u, 1.0 + u),
            _ => (0.0, f32::INFINITY),
        };
        Ray { t_min, t_max, ..towards(origin, target) }
    };
    (0..count).map(&mut ray).collect()
}
