//! Cylinders and cones as triangles.

use parallax_shared::layout::Triangle;

use super::Shapes;

/// A cylinder or a cut cone without caps.
pub(super) struct Tube {
    pub(super) from: [f64; 3],
    pub(super) to: [f64; 3],
    /// Radii at both ends.
    pub(super) radii: [f64; 2],
    pub(super) segments: u32,
    pub(super) material: u32,
}

/// Triangles of a [`Tube`].
pub(super) fn triangles(segments: u32) -> u64 {
    2 * u64::from(segments)
}

impl Shapes {
    /// Adds a tube as triangles with the normals of the round surface, seen from outside counter-clockwise.
    pub(super) fn tube(&mut self, tube: &Tube) {
        let along = std::array::from_fn(|i| tube.to[i] - tube.from[i]);
        let length = dot(along, along).sqrt();
        let axis = along.map(|x| x / length);
        let [u, v] = across(axis);
        // A cone's normals lean towards its tip.
        let lean = (tube.radii[0] - tube.radii[1]) / length;
        let ring = |segment: u32| {
            let angle = std::f64::consts::TAU * f64::from(segment % tube.segments) / f64::from(tube.segments);
            let (s, c) = angle.sin_cos();
            let out: [f64; 3] = std::array::from_fn(|i| c * u[i] + s * v[i]);
            let normal: [f64; 3] = std::array::from_fn(|i| out[i] + lean * axis[i]);
            let length = dot(normal, normal).sqrt();
            let at = |end: [f64; 3], radius: f64| std::array::from_fn(|i| (end[i] + radius * out[i]) as f32);
            (
                [at(tube.from, tube.radii[0]), at(tube.to, tube.radii[1])],
                normal.map(|x| (x / length) as f32),
                segment as f32 / tube.segments as f32,
            )
        };
        for segment in 0..tube.segments {
            let ([a, b], n, left) = ring(segment);
            let ([c, d], m, right) = ring(segment + 1);
            let uvs = [[left, 0.0], [right, 0.0], [right, 1.0], [left, 1.0]];
            self.smooth([a, c, d], [n, m, m], [uvs[0], uvs[1], uvs[2]], tube.material);
            self.smooth([a, d, b], [n, m, n], [uvs[0], uvs[2], uvs[3]], tube.material);
        }
    }

    /// Adds a smooth triangle.
    pub(super) fn smooth(
        &mut self,
        vertices: [[f32; 3]; 3],
        normals: [[f32; 3]; 3],
        uvs: [[f32; 2]; 3],
        material: u32,
    ) {
        self.triangles.push(Triangle { vertices, material, normals, smooth: 1, uvs, padding: [0; 2] });
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Two unit vectors that make a right-handed frame with a unit `axis`.
fn across(axis: [f64; 3]) -> [[f64; 3]; 2] {
    let helper = if axis[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let u = cross(helper, axis);
    let length = dot(u, u).sqrt();
    let u = u.map(|x| x / length);
    [u, cross(axis, u)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tube_is_closed_around_and_faces_out() {
        let mut shapes = Shapes::default();
        let tube = Tube {
            from: [1.0, 2.0, 3.0],
            to: [1.0, 4.0, 4.0],
            radii: [0.5, 0.25],
            segments: 12,
            material: 3,
        };
        shapes.tube(&tube);
        assert_eq!(shapes.triangles.len() as u64, triangles(12));
        for t in &shapes.triangles {
            let [a, b, c] = t.vertices.map(|v| v.map(f64::from));
            let edge = |p: [f64; 3]| std::array::from_fn(|i| p[i] - a[i]);
            let face = cross(edge(b), edge(c));
            assert!(t.normals.iter().all(|n| dot(face, n.map(f64::from)) > 0.0), "normals face out");
        }
        let first = shapes.triangles[0].vertices[0];
        let last = shapes.triangles[22].vertices[1];
        assert_eq!(first, last, "the seam has the same vertices on both sides");
    }
}
