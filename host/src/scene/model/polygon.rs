//! Faces of any number of corners, checked and cut into triangles.

use parallax_shared::layout::NONE;

use crate::scene::Problem;
use crate::scene::warning::Tally;

/// The largest absolute coordinate of a usable vertex. The products of exact hits overflow beyond (the host
/// scales a scene by its largest coordinate, and what is smaller than 10⁻³⁰ of that is lost).
const MAX_COORDINATE: f32 = 1e15;

/// Point-in-triangle tests that cutting one file's concave polygons may take; the rest is cut into fans.
const EAR_BUDGET: u64 = 20_000_000;

/// One corner of a face: indices into the arrays of [`Polygons`], not yet checked. [`NONE`] is an attribute
/// that the face does not name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    pub(crate) position: u32,
    pub(crate) uv: u32,
    pub(crate) normal: u32,
}

/// A face: a range of [`Polygons::corners`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Face {
    pub(crate) first: u32,
    pub(crate) corners: u32,
    /// Index into the file's materials, or [`NONE`].
    pub(crate) material: u32,
    /// Line in the file, or zero.
    pub(crate) line: u32,
}

/// What a file says: vertices and faces that may refer to anything.
#[derive(Debug, Default)]
pub(crate) struct Polygons {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) uvs: Vec<[f32; 2]>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) corners: Vec<Corner>,
    pub(crate) faces: Vec<Face>,
}

/// A triangle whose positions exist and are usable; its attributes are usable or [`NONE`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    pub(crate) corners: [Corner; 3],
    pub(crate) material: u32,
}

impl Polygons {
    /// The faces, cut into triangles; unusable ones are counted and left out.
    pub(crate) fn facets(&self, tally: &mut Tally) -> Vec<Facet> {
        let mut facets = Vec::with_capacity(self.faces.len());
        let mut budget = EAR_BUDGET;
        let mut corners = Vec::new();
        for face in &self.faces {
            let line = (face.line > 0).then_some(face.line as usize);
            if let Some(problem) = self.problem(face) {
                tally.add(problem, line);
                continue;
            }
            corners.clear();
            for corner in self.corners_of(face) {
                corners.push(self.with_usable_attributes(*corner, line, tally));
            }
            let emit = |[a, b, c]: [usize; 3]| {
                facets.push(Facet { corners: [corners[a], corners[b], corners[c]], material: face.material })
            };
            if !cut(&corners, &self.positions, &mut budget, emit) {
                tally.add(Problem::NotSimple, line);
            }
        }
        facets
    }

    fn corners_of(&self, face: &Face) -> &[Corner] {
        let first = face.first as usize;
        self.corners.get(first..first + face.corners as usize).unwrap_or(&[])
    }

    /// Why a face cannot be used.
    fn problem(&self, face: &Face) -> Option<Problem> {
        let corners = self.corners_of(face);
        if corners.len() < 3 {
            return Some(Problem::FewCorners);
        }
        let usable = |p: &[f32; 3]| p.iter().all(|x| x.abs() <= MAX_COORDINATE);
        let mut position = corners.iter().map(|c| self.positions.get(c.position as usize));
        if position.clone().any(|p| p.is_none()) {
            return Some(Problem::IndexOutOfRange);
        }
        (!position.all(|p| p.is_some_and(usable))).then_some(Problem::NotFinite)
    }

    /// The corner without the attributes that do not exist or mean nothing.
    fn with_usable_attributes(&self, mut corner: Corner, line: Option<usize>, tally: &mut Tally) -> Corner {
        let uv = self.uvs.get(corner.uv as usize);
        if corner.uv != NONE && !uv.is_some_and(|uv| uv.iter().all(|x| x.abs() <= MAX_COORDINATE)) {
            corner.uv = NONE;
            tally.add(Problem::BadAttribute, line);
        }
        let length = |n: &[f32; 3]| n.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>();
        let normal = self.normals.get(corner.normal as usize).map(length);
        if corner.normal != NONE && !normal.is_some_and(|l| l > 0.0 && l.is_finite()) {
            corner.normal = NONE;
            tally.add(Problem::BadAttribute, line);
        }
        corner
    }
}

/// Cuts a polygon into triangles of its corners, wound alike. `false` when no ear is left (it crosses itself)
/// or the budget is spent: then what is left of it was cut into a fan. Convex polygons, triangles among them,
/// are always cut into the fan around their first corner.
fn cut(
    corners: &[Corner],
    positions: &[[f32; 3]],
    budget: &mut u64,
    mut emit: impl FnMut([usize; 3]),
) -> bool {
    let fan = |rest: &[usize], emit: &mut dyn FnMut([usize; 3])| {
        rest.windows(2).skip(1).for_each(|pair| emit([rest[0], pair[0], pair[1]]));
    };
    if let [_, _, _] = corners {
        emit([0, 1, 2]);
        return true;
    }
    let points = flattened(corners, positions);
    let mut rest: Vec<usize> = (0..corners.len()).collect();
    if convex(&points) {
        fan(&rest, &mut emit);
        return true;
    }
    let mut at = 0;
    let mut refused = 0;
    while rest.len() > 3 && refused < rest.len() {
        let n = rest.len();
        let ear = [rest[(at + n - 1) % n], rest[at % n], rest[(at + 1) % n]];
        *budget = budget.saturating_sub(n as u64);
        if *budget == 0 {
            break;
        }
        if is_ear(ear, &rest, &points) {
            emit(ear);
            rest.remove(at % n);
            refused = 0;
        } else {
            at += 1;
            refused += 1;
        }
        at %= rest.len();
    }
    let simple = rest.len() == 3;
    fan(&rest, &mut emit);
    simple
}

/// The polygon in the coordinate plane in which it looks largest, wound counter-clockwise (Newell's normal).
fn flattened(corners: &[Corner], positions: &[[f32; 3]]) -> Vec<[f64; 2]> {
    let points: Vec<[f64; 3]> =
        corners.iter().map(|c| positions[c.position as usize].map(f64::from)).collect();
    let mut normal = [0.0_f64; 3];
    for (i, p) in points.iter().enumerate() {
        let q = points[(i + 1) % points.len()];
        for (axis, sum) in normal.iter_mut().enumerate() {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            *sum += (p[u] - q[u]) * (p[v] + q[v]);
        }
    }
    let axis = (0..3).fold(0, |best, i| if f64::abs(normal[i]) > f64::abs(normal[best]) { i } else { best });
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let (u, v) = if normal[axis] < 0.0 { (v, u) } else { (u, v) };
    points.iter().map(|p| [p[u], p[v]]).collect()
}

/// Twice the signed area of a triangle, positive when it is wound counter-clockwise.
fn area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the polygon turns left at every corner, and once around in all.
fn convex(points: &[[f64; 2]]) -> bool {
    let n = points.len();
    let at = |i: usize| points[i % n];
    let left = (0..n).all(|i| area([at(i), at(i + 1), at(i + 2)]) >= 0.0);
    let steps = |i: usize| (at(i + 1)[0] - at(i)[0]).total_cmp(&0.0).is_ge();
    let turns = (0..n).filter(|&i| steps(i) != steps((i + 1) % n)).count();
    left && turns <= 2
}

/// Whether a triangle of three successive corners lies in the polygon and holds no other corner of it.
fn is_ear(ear: [usize; 3], rest: &[usize], points: &[[f64; 2]]) -> bool {
    let [a, b, c] = ear.map(|i| points[i]);
    if a == b || b == c || a == c {
        return true;
    }
    if area([a, b, c]) <= 0.0 {
        return false;
    }
    rest.iter()
        .filter(|i| !ear.contains(i))
        .map(|&i| points[i])
        .filter(|p| ![a, b, c].contains(p))
        .all(|p| area([a, b, p]) < 0.0 || area([b, c, p]) < 0.0 || area([c, a, p]) < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut_outline(outline: &[[f32; 2]]) -> (Vec<[usize; 3]>, bool) {
        let positions: Vec<_> = outline.iter().map(|p| [2.0, p[0], p[1]]).collect();
        let corners: Vec<_> =
            (0..outline.len()).map(|i| Corner { position: i as u32, uv: NONE, normal: NONE }).collect();
        let mut triangles = Vec::new();
        let simple = cut(&corners, &positions, &mut 1_000_000, |t| triangles.push(t));
        (triangles, simple)
    }

    fn areas(outline: &[[f32; 2]], triangles: &[[usize; 3]]) -> Vec<f64> {
        triangles.iter().map(|t| area(t.map(|i| outline[i].map(f64::from)))).collect()
    }

    #[test]
    fn a_concave_polygon_is_covered_once() {
        // A comb with three teeth: a fan would cover what is between them.
        let comb =
            [[0.0, 0.0], [5.0, 0.0], [5.0, 3.0], [4.0, 1.0], [3.0, 3.0], [2.0, 1.0], [1.0, 3.0], [0.0, 1.0]];
        for turn in 0..comb.len() {
            let mut outline = comb;
            outline.rotate_left(turn);
            let (triangles, simple) = cut_outline(&outline);
            let areas = areas(&outline, &triangles);
            assert!(simple && triangles.len() == 6 && areas.iter().all(|a| *a > 0.0), "{areas:?}");
            assert_eq!(areas.iter().sum::<f64>(), 20.0);
            outline.reverse();
            assert!(cut_outline(&outline).1);
        }
    }

    #[test]
    fn a_convex_polygon_is_a_fan() {
        let octagon: Vec<_> = (0..8).map(|i| (i as f32 * 0.785).sin_cos().into()).collect();
        let (triangles, simple) = cut_outline(&octagon);
        assert!(simple && triangles.iter().all(|t| t[0] == 0) && triangles.len() == 6);
    }

    #[test]
    fn a_polygon_without_an_ear_becomes_a_fan() {
        let (triangles, simple) = cut_outline(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.5, 0.0]]);
        assert!(!simple);
        assert_eq!(triangles, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    #[test]
    fn the_budget_ends_the_search() {
        let n = 3000;
        let spiral: Vec<_> = (0..n)
            .map(|i| {
                let (out, t) = if i < n / 2 { (1.0, i) } else { (0.9, n - i) };
                let (s, c) = (t as f32 * 0.05).sin_cos();
                [out * (1.0 + t as f32) * c, out * (1.0 + t as f32) * s]
            })
            .collect();
        let (triangles, simple) = cut_outline(&spiral);
        assert!(!simple);
        assert_eq!(triangles.len(), n - 2);
    }
}
