//! What a ray hits, by brute force and in words of its own: the rules of DESIGN §3.1 with edge signs from exact f64 products.

use super::meshes::Vector;
use glam::DVec3;
use parallax_shared::layout::{Hit, NONE, Ray, Triangle, View};

/// A vector in f64.
pub fn wide(v: Vector) -> DVec3 {
    DVec3::from(v.map(f64::from))
}

/// Direction of the ray through pixel (`x`, `y`), which may be fractional.
pub fn direction(view: &View, x: f64, y: f64) -> DVec3 {
    wide(view.corner) + wide(view.step_x) * x + wide(view.step_y) * y
}

/// A ray for brute force.
pub struct Reference {
    ray: Ray,
    /// x, y, z with the largest component of the direction last.
    order: [usize; 3],
    inverse: Vector,
    padding: f32,
}

impl Reference {
    /// Prepares a ray; `extent` is the largest absolute coordinate of all vertices.
    pub fn new(ray: Ray, extent: f32) -> Self {
        let size = ray.dir.map(f32::abs);
        let last = match size {
            [x, y, z] if x > y && x > z => 0,
            [x, y, z] if x <= y && y > z => 1,
            _ => 2,
        };
        let farthest = ray.origin.iter().fold(0f32, |most, x| most.max(x.abs()));
        Self {
            ray,
            order: [(last + 1) % 3, (last + 2) % 3, last],
            inverse: ray.dir.map(|x| (1.0 / x).clamp(-1e18, 1e18)),
            padding: (farthest + extent) * (8.0 * f32::EPSILON),
        }
    }

    /// `t` of the triangle, if the ray hits it.
    pub fn triangle(&self, vertices: [Vector; 3]) -> Option<f32> {
        let projected = vertices.map(|vertex| self.project(vertex));
        let [a, b, c] = projected;
        let signs = [sign(c, b), sign(a, c), sign(b, a)];
        if !(signs.iter().all(|&s| s > 0.0) || signs.iter().all(|&s| s < 0.0)) {
            return None;
        }
        let edge = |p: Vector, q: Vector| p[0] * q[1] - p[1] * q[0];
        let (u, v, w) = (edge(c, b), edge(a, c), edge(b, a));
        let t = (u * a[2] + v * b[2] + w * c[2]) / (u + v + w);
        let (near, far) = self.own_box(vertices);
        let t = if t > near { t } else { near };
        let t = if t < far { t } else { far };
        (near <= far && t >= self.ray.t_min && t < self.ray.t_max).then_some(t)
    }

    fn project(&self, vertex: Vector) -> Vector {
        let ([x, y, z], o, d) = (self.order, self.ray.origin, self.ray.dir);
        let height = (vertex[z] - o[z]) * self.inverse[z];
        [(vertex[x] - o[x]) - d[x] * height, (vertex[y] - o[y]) - d[y] * height, height]
    }

    fn own_box(&self, vertices: [Vector; 3]) -> (f32, f32) {
        let (mut near, mut far) = (f32::NEG_INFINITY, f32::INFINITY);
        for axis in 0..3 {
            let low = vertices.iter().fold(f32::INFINITY, |m, v| m.min(v[axis]));
            let high = vertices.iter().fold(f32::NEG_INFINITY, |m, v| m.max(v[axis]));
            let low = (low - (self.ray.origin[axis] + self.padding)) * self.inverse[axis];
            let high = (high - (self.ray.origin[axis] - self.padding)) * self.inverse[axis];
            near = near.max(low.min(high));
            far = far.min(low.max(high));
        }
        (near, far)
    }

    /// The nearest hit among all triangles, and how many triangles are hit.
    pub fn brute_force(&self, triangles: &[Triangle]) -> (Hit, usize) {
        let mut best = Hit { t: f32::INFINITY, prim_id: NONE };
        let mut owners = 0;
        for (number, triangle) in triangles.iter().enumerate() {
            if let Some(t) = self.triangle(triangle.vertices) {
                owners += 1;
                if best.prim_id == NONE || t < best.t {
                    best = Hit { t, prim_id: number as u32 };
                }
            }
        }
        (best, owners)
    }
}

/// The sign of the edge function; both products are exact in f64. On the edge the ray is shifted by (ε, ε²).
fn sign(p: Vector, q: Vector) -> f64 {
    let area = p[0] as f64 * q[1] as f64 - p[1] as f64 * q[0] as f64;
    if area != 0.0 {
        area
    } else if p[1] != q[1] {
        p[1] as f64 - q[1] as f64
    } else {
        q[0] as f64 - p[0] as f64
    }
}
