//! Triangles with the normals that shading needs: the file's own, or those of a surface that is round up to a
//! crease angle.

use std::collections::HashMap;

use parallax_shared::layout::NONE;

use super::polygon::Facet;
use super::{Corner, Polygons};
use crate::scene::warning::Tally;
use crate::scene::{Problem, Triangle};

/// Around a vertex of more faces than this, creases are not looked for: it would take time quadratic in their
/// number.
const MAX_FACES: usize = 64;

/// The facets as triangles with materials `materials[facet.material]`, or the last one.
///
/// A corner without a normal gets the sum of the normals, each as long as its face is large, of the faces
/// around its vertex whose angle to its own face is at most `crease_deg`; vertices at one place are one
/// vertex. Faces that turn out flat, and all with a crease angle of zero, are marked so. Zero areas are
/// counted.
pub(super) fn finish(
    polygons: &Polygons,
    facets: &[Facet],
    crease_deg: f32,
    materials: &[u32],
    tally: &mut Tally,
) -> Vec<Triangle> {
    let crosses: Vec<[f64; 3]> = facets.iter().map(|f| cross(polygons, f)).collect();
    let complete = facets.iter().all(|f| f.corners.iter().all(|c| c.normal != NONE));
    let surface = (!complete && crease_deg > 0.0)
        .then(|| Surface::new(polygons, facets, &crosses, f64::from(crease_deg).to_radians().cos()));
    let fallback = materials.last().copied().unwrap_or(0);
    facets
        .iter()
        .enumerate()
        .map(|(i, facet)| {
            if crosses[i] == [0.0; 3] {
                tally.add(Problem::ZeroArea, None);
            }
            let normals = normals(polygons, facet, i, surface.as_ref());
            Triangle {
                vertices: facet.corners.map(|c| polygons.positions[c.position as usize]),
                material: materials.get(facet.material as usize).copied().unwrap_or(fallback),
                normals: normals.unwrap_or_default(),
                smooth: normals.is_some().into(),
                uvs: facet.corners.map(|c| polygons.uvs.get(c.uv as usize).copied().unwrap_or_default()),
                padding: [0; 2],
            }
        })
        .collect()
}

/// The normals at a facet's corners; `None` when it is flat.
fn normals(polygons: &Polygons, facet: &Facet, i: usize, surface: Option<&Surface>) -> Option<[[f32; 3]; 3]> {
    let given = |c: &Corner| polygons.normals.get(c.normal as usize).map(|n| n.map(f64::from));
    let sums: [Option<[f64; 3]>; 3] = std::array::from_fn(|corner| {
        given(&facet.corners[corner]).or_else(|| surface.map(|s| s.normal(i, corner)))
    });
    let unit = sums.map(|sum| sum.and_then(unit));
    let computed = facet.corners.iter().all(|c| c.normal == NONE);
    match unit {
        [Some(a), Some(b), Some(c)] if !(computed && a == b && b == c) => Some([a, b, c]),
        _ => None,
    }
}

/// The vector of length 1; `None` for zero.
fn unit(v: [f64; 3]) -> Option<[f32; 3]> {
    let length = dot(v, v).sqrt();
    (length > 0.0).then(|| v.map(|x| (x / length) as f32))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The normal of a facet, as long as twice its area.
fn cross(polygons: &Polygons, facet: &Facet) -> [f64; 3] {
    let [a, b, c] = facet.corners.map(|c| polygons.positions[c.position as usize].map(f64::from));
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// Which faces meet at each vertex.
struct Surface<'a> {
    crosses: &'a [[f64; 3]],
    cos_crease: f64,
    /// Vertex of each corner, three a facet.
    vertices: Vec<u32>,
    /// Where each vertex's faces begin in `faces`.
    first: Vec<u32>,
    faces: Vec<u32>,
    /// The sum of all normals at vertices of many faces.
    crowded: HashMap<u32, [f64; 3]>,
}

impl<'a> Surface<'a> {
    fn new(polygons: &Polygons, facets: &[Facet], crosses: &'a [[f64; 3]], cos_crease: f64) -> Self {
        let mut places = HashMap::new();
        let vertices: Vec<u32> = (facets.iter().flat_map(|f| f.corners))
            .map(|c| {
                // Adding +0 makes one place of both zeros.
                let place = polygons.positions[c.position as usize].map(|x| (x + 0.0).to_bits());
                let next = places.len() as u32;
                *places.entry(place).or_insert(next)
            })
            .collect();
        let (first, faces) = faces_by_vertex(&vertices, places.len());
        let mut surface = Self { crosses, cos_crease, vertices, first, faces, crowded: HashMap::new() };
        for vertex in 0..places.len() as u32 {
            let faces = surface.around(vertex);
            if faces.len() > MAX_FACES {
                let sum = faces.iter().map(|&f| crosses[f as usize]).fold([0.0; 3], add);
                surface.crowded.insert(vertex, sum);
            }
        }
        surface
    }

    fn around(&self, vertex: u32) -> &[u32] {
        let range = self.first[vertex as usize] as usize..self.first[vertex as usize + 1] as usize;
        &self.faces[range]
    }

    /// The normal, of any length, at a corner of a facet.
    fn normal(&self, facet: usize, corner: usize) -> [f64; 3] {
        let vertex = self.vertices[3 * facet + corner];
        if let Some(sum) = self.crowded.get(&vertex) {
            return *sum;
        }
        let own = self.crosses[facet];
        let own_length = dot(own, own).sqrt();
        let near =
            |n: [f64; 3]| own_length == 0.0 || dot(own, n) >= self.cos_crease * own_length * dot(n, n).sqrt();
        let normals = self.around(vertex).iter().map(|&f| self.crosses[f as usize]);
        normals.filter(|n| near(*n)).fold([0.0; 3], add)
    }
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// The facets at each vertex, in order, as one array and where each vertex's part begins.
fn faces_by_vertex(vertices: &[u32], count: usize) -> (Vec<u32>, Vec<u32>) {
    let mut first = vec![0_u32; count + 1];
    for v in vertices {
        first[*v as usize + 1] += 1;
    }
    for v in 0..count {
        first[v + 1] += first[v];
    }
    let mut next = first.clone();
    let mut faces = vec![0; vertices.len()];
    for (corner, v) in vertices.iter().enumerate() {
        faces[next[*v as usize] as usize] = (corner / 3) as u32;
        next[*v as usize] += 1;
    }
    (first, faces)
}

#[cfg(test)]
mod tests {
    use super::super::{Face, Polygons};
    use super::*;

    /// Two unit squares that meet at the z axis' edge at an angle.
    fn folded(angle_deg: f32) -> Polygons {
        let (s, c) = angle_deg.to_radians().sin_cos();
        let positions = vec![
            [-1.0, 0.0, 0.0],
            [-1.0, 0.0, 1.0],
            [0.0, 0.0, 1.0],
            [0.0, 0.0, 0.0],
            [c, s, 1.0],
            [c, s, 0.0],
        ];
        let corner = |position| Corner { position, uv: NONE, normal: NONE };
        let face = |first| Face { first, corners: 4, material: NONE, line: 0 };
        let corners = [0, 1, 2, 3, 3, 2, 4, 5].map(corner).to_vec();
        Polygons { positions, corners, faces: vec![face(0), face(4)], ..Polygons::default() }
    }

    fn triangles(polygons: &Polygons, crease_deg: f32) -> Vec<Triangle> {
        let mut tally = Tally::default();
        let facets = polygons.facets(&mut tally);
        finish(polygons, &facets, crease_deg, &[7], &mut tally)
    }

    #[test]
    fn an_edge_is_round_up_to_the_crease_angle() {
        assert!(triangles(&folded(30.0), 40.0).iter().all(|t| t.smooth == 1 && t.material == 7));
        for flat in
            [triangles(&folded(50.0), 40.0), triangles(&folded(0.0), 40.0), triangles(&folded(30.0), 0.0)]
        {
            assert!(flat.iter().all(|t| t.smooth == 0 && t.normals == [[0.0; 3]; 3]));
        }
    }

    #[test]
    fn the_normals_of_the_file_are_kept() {
        let mut polygons = folded(0.0);
        polygons.normals = vec![[0.0, 0.0, 3.0], [0.0; 3]];
        polygons.corners[..4].iter_mut().for_each(|c| c.normal = 0);
        polygons.corners[4..].iter_mut().for_each(|c| c.normal = 1);
        let triangles = triangles(&polygons, 0.0);
        assert_eq!(triangles[0].normals, [[0.0, 0.0, 1.0]; 3]);
        assert_eq!(triangles[2].smooth, 0, "a normal of length zero is none");
    }

    #[test]
    fn a_vertex_of_many_faces_takes_linear_time() {
        let n = 200_000_u32;
        let rim = (0..=n).map(|i| {
            let (s, c) = (i as f32 * 1e-5).sin_cos();
            [s, 0.0, c]
        });
        let positions: Vec<_> = std::iter::once([0.0, 1.0, 0.0]).chain(rim).collect();
        let corner = |position| Corner { position, uv: NONE, normal: NONE };
        let corners = (1..=n).flat_map(|i| [0, i, i + 1].map(corner)).collect();
        let faces = (0..n).map(|i| Face { first: 3 * i, corners: 3, material: NONE, line: 0 }).collect();
        let start = std::time::Instant::now();
        let triangles = triangles(&Polygons { positions, corners, faces, ..Polygons::default() }, 180.0);
        assert_eq!(triangles.len(), n as usize);
        assert!(start.elapsed().as_secs() < 5);
    }
}
