//! The rays: those of a camera, diffuse ones from where these hit, and shadow rays from there to a light.

use super::contender::{Contender, Parallax};
use crate::scene::Scene;
use glam::Vec3;
use parallax_shared::layout::{Hit, NONE, Ray, Triangle};

/// A model, and from where it is seen and lit.
#[derive(Clone, Debug)]
pub struct Case {
    /// For reports.
    pub name: String,
    /// The model. Spheres and ellipsoids do not take part: nobody else has them.
    pub triangles: Vec<Triangle>,
    /// The camera's place, what it looks at, and what is up.
    pub eye: [f32; 3],
    /// See `eye`.
    pub target: [f32; 3],
    /// See `eye`.
    pub up: [f32; 3],
    /// Vertical field of view.
    pub vertical_fov_deg: f32,
    /// Where shadow rays go.
    pub light: [f32; 3],
}

impl Case {
    /// A model framed from its front, lit from above.
    pub fn framed(name: &str, triangles: Vec<Triangle>) -> Self {
        let (low, high) = bounds(&triangles);
        let (centre, size) = ((low + high) * 0.5, (high - low).length());
        Self {
            name: name.into(),
            triangles,
            eye: (centre + Vec3::new(0.15, 0.2, 1.0) * size).into(),
            target: centre.into(),
            up: [0.0, 1.0, 0.0],
            vertical_fov_deg: 45.6,
            light: (high + Vec3::new(0.3, 0.8, 0.4) * size).into(),
        }
    }

    /// A hall, seen and lit from inside, along x.
    pub fn inside(name: &str, triangles: Vec<Triangle>) -> Self {
        let (low, high) = bounds(&triangles);
        let at = |x: f32, y: f32, z: f32| (low + (high - low) * Vec3::new(x, y, z)).into();
        Self {
            name: name.into(),
            triangles,
            eye: at(0.18, 0.25, 0.53),
            target: at(1.0, 0.3, 0.45),
            up: [0.0, 1.0, 0.0],
            vertical_fov_deg: 73.7,
            light: at(0.55, 0.8, 0.5),
        }
    }

    /// What a scene shows: its rig and its first light (without one, from above).
    pub fn of(scene: &Scene) -> Self {
        let framed = Self::framed(&scene.name, scene.triangles.clone());
        let light = scene.lights.first().map_or(framed.light, |light| light.position);
        let rig = &scene.rig;
        let (eye, target, up) = (rig.eye, rig.target, rig.up);
        Self { eye, target, up, vertical_fov_deg: rig.vertical_fov_deg, light, ..framed }
    }
}

fn bounds(triangles: &[Triangle]) -> (Vec3, Vec3) {
    let mut bounds = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for vertex in triangles.iter().flat_map(|triangle| triangle.vertices) {
        bounds = (bounds.0.min(vertex.into()), bounds.1.max(vertex.into()));
    }
    bounds
}

/// The rays of a case.
pub struct RaySets {
    pub primary: Vec<Ray>,
    pub diffuse: Vec<Ray>,
    pub shadow: Vec<Ray>,
}

impl RaySets {
    /// Generates them; `ours` finds where secondary ones start.
    pub fn new(case: &Case, size: [u32; 2], ours: &Parallax) -> Self {
        let primary = primary(case, size);
        let mut hits = vec![Hit { t: f32::INFINITY, prim_id: NONE }; primary.len()];
        ours.trace(&primary, false, &mut hits);
        let (low, high) = bounds(&case.triangles);
        let offset = (high - low).length() * 1e-4;
        let (mut diffuse, mut shadow) = (Vec::new(), Vec::new());
        for (number, (ray, hit)) in primary.iter().zip(&hits).enumerate() {
            let Some(triangle) = case.triangles.get(hit.prim_id as usize) else { continue };
            let Some(normal) = normal_against(triangle, ray) else { continue };
            let point = Vec3::from(ray.origin) + Vec3::from(ray.dir) * hit.t + normal * offset;
            diffuse.push(ray_from(point, cosine_direction(normal, number as u32), f32::INFINITY));
            shadow.push(ray_from(point, Vec3::from(case.light) - point, 1.0));
        }
        Self { primary, diffuse, shadow }
    }
}

fn ray_from(origin: Vec3, dir: Vec3, t_max: f32) -> Ray {
    Ray { origin: origin.into(), t_min: 0.0, dir: dir.into(), t_max }
}

fn primary(case: &Case, [width, height]: [u32; 2]) -> Vec<Ray> {
    let eye = Vec3::from(case.eye);
    let forward = (Vec3::from(case.target) - eye).normalize();
    let right = forward.cross(case.up.into()).normalize();
    let up = right.cross(forward);
    let half = (case.vertical_fov_deg.to_radians() * 0.5).tan();
    let aspect = width as f32 / height as f32;
    let ray = |i: u32| {
        let x = ((i % width) as f32 + 0.5) / width as f32 * 2.0 - 1.0;
        let y = 1.0 - ((i / width) as f32 + 0.5) / height as f32 * 2.0;
        let dir = forward + right * (x * half * aspect) + up * (y * half);
        ray_from(eye, dir.normalize(), f32::INFINITY)
    };
    (0..width * height).map(ray).collect()
}

/// The unit normal on the side that the ray comes from; none for a degenerate triangle.
fn normal_against(triangle: &Triangle, ray: &Ray) -> Option<Vec3> {
    let [a, b, c] = triangle.vertices.map(Vec3::from);
    let normal = (b - a).cross(c - a).try_normalize()?;
    Some(if normal.dot(ray.dir.into()) > 0.0 { -normal } else { normal })
}

/// A direction about `normal` whose density goes with the cosine, the same in each run.
fn cosine_direction(normal: Vec3, number: u32) -> Vec3 {
    let unit = |n: u32| hash(n) as f32 / 4_294_967_296.0;
    let (around, height) = (unit(2 * number + 1) * std::f32::consts::TAU, unit(2 * number + 2));
    let (tangent, bitangent) = normal.any_orthonormal_pair();
    let radius = height.sqrt();
    let dir = tangent * (radius * around.cos()) + bitangent * (radius * around.sin());
    (dir + normal * (1.0 - height).max(0.0).sqrt()).normalize()
}

fn hash(mut x: u32) -> u32 {
    x = (x ^ (x >> 16)).wrapping_mul(0x7feb_352d);
    x = (x ^ (x >> 15)).wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}
