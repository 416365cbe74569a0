//! An independent ray tracer for comparison: double precision, recursion, every primitive tested, textbook
//! formulas. It shares nothing with what it checks but the layout of the scene's data and the model that is
//! documented there.

use crate::reference::wide;
use crate::stage::Stage;
use glam::{DMat3, DVec3};
use parallax_shared::layout::{Material, NONE, Texture, Triangle};
use std::ops::Deref;

/// Rays of no more weight than this are not followed (`shading::bounce`).
const LEAST_WEIGHT: f64 = 1.0 / 1024.0;

/// How far along a secondary ray begins, in units of its scene's size.
const LEAVE: f64 = 1e-9;

/// The nearest hit.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// Distance in lengths of the direction.
    pub t: f64,
    /// Number of the primitive.
    pub prim_id: u32,
    /// Unit geometric normal, against the ray.
    pub normal: DVec3,
    /// Unit shading normal, on the same side.
    pub shading_normal: DVec3,
    /// Texture coordinates.
    pub uv: [f64; 2],
    /// Whether the ray comes from inside or behind.
    pub back: bool,
    /// Index of the material.
    pub material: u32,
}

/// Both roots of |`o` + t·`d`| = 1, the smaller one first.
pub fn unit_sphere(o: DVec3, d: DVec3) -> Option<[f64; 2]> {
    let (a, b) = (d.dot(d), o.dot(d));
    let foot = o - d * (b / a);
    let gap = 1.0 - foot.dot(foot);
    let half = (gap / a).sqrt();
    (gap >= 0.0).then(|| [-b / a - half, -b / a + half])
}

fn sphere_uv(n: DVec3) -> [f64; 2] {
    [n.x.atan2(n.z) / std::f64::consts::TAU + 0.5, 1.0 - n.y.clamp(-1.0, 1.0).acos() / std::f64::consts::PI]
}

/// A stage, traced in f64.
pub struct Oracle<'a>(pub &'a Stage);

impl Deref for Oracle<'_> {
    type Target = Stage;

    fn deref(&self) -> &Stage {
        self.0
    }
}

impl Oracle<'_> {
    /// Every primitive as (number, candidates).
    fn quadrics(&self) -> impl Iterator<Item = (DVec3, DMat3, u32)> + '_ {
        let spheres = self.spheres.iter().map(|s| {
            (wide(s.centre), DMat3::from_diagonal(DVec3::splat(1.0 / f64::from(s.radius))), s.material)
        });
        let ellipsoids = self.ellipsoids.iter().map(|e| {
            let row = |i: usize| {
                DVec3::new(
                    e.world_to_unit[i][0].into(),
                    e.world_to_unit[i][1].into(),
                    e.world_to_unit[i][2].into(),
                )
            };
            (wide(e.centre), DMat3::from_cols(row(0), row(1), row(2)).transpose(), e.material)
        });
        spheres.chain(ellipsoids)
    }

    /// The nearest hit with `t` > `least`.
    pub fn nearest(&self, origin: DVec3, dir: DVec3, least: f64) -> Option<Found> {
        let mut best: Option<Found> = None;
        let mut keep = |found: Found| {
            if found.t > least && best.is_none_or(|b| found.t < b.t) {
                best = Some(found);
            }
        };
        for (number, triangle) in (0u32..).zip(&self.triangles) {
            meet_triangle(number, triangle, origin, dir).into_iter().for_each(&mut keep);
        }
        for (number, (centre, to_unit, material)) in (self.triangles.len() as u32..).zip(self.quadrics()) {
            let (o, d) = (to_unit * (origin - centre), to_unit * dir);
            for t in unit_sphere(o, d).into_iter().flatten() {
                let on_sphere = o + d * t;
                let outwards = (to_unit.transpose() * on_sphere).normalize();
                let back = outwards.dot(dir) > 0.0;
                let normal = if back { -outwards } else { outwards };
                keep(Found {
                    t,
                    prim_id: number,
                    normal,
                    shading_normal: normal,
                    uv: sphere_uv(on_sphere),
                    back,
                    material,
                });
            }
        }
        best
    }

    /// Linear colour of what a ray sees; `dir` of any length.
    pub fn radiance(&self, origin: DVec3, dir: DVec3, weight: DVec3, depth: u32) -> DVec3 {
        let dir = dir.normalize();
        let Some(found) = self.nearest(origin, dir, if depth == 0 { 0.0 } else { LEAVE }) else {
            return self.sky(dir);
        };
        let material = &self.materials[found.material as usize];
        let position = origin + dir * found.t;
        let mut sum = self.local(&found, material, position, dir);
        if depth < self.max_depth {
            for (dir, share) in self.bounces(&found, material, dir) {
                if (weight * share).max_element() >= LEAST_WEIGHT {
                    sum += share * self.radiance(position, dir, weight * share, depth + 1);
                }
            }
        }
        sum
    }

    fn local(&self, found: &Found, material: &Material, position: DVec3, dir: DVec3) -> DVec3 {
        let mut diffuse = wide(self.ambient) * f64::from(material.ambient);
        let mut specular = DVec3::ZERO;
        for light in &self.lights {
            let to_light = wide(light.position) - position;
            let behind = found.normal.dot(to_light) <= 0.0 || found.shading_normal.dot(to_light) <= 0.0;
            if behind || self.nearest(position, to_light, LEAVE).is_some_and(|hit| hit.t < 1.0) {
                continue;
            }
            let (light, l) = (wide(light.colour), to_light.normalize());
            let cosine = found.shading_normal.dot(l);
            let mirrored = found.shading_normal * (2.0 * cosine) - l;
            diffuse += light * (f64::from(material.diffuse) * cosine);
            specular += light
                * f64::from(material.specular)
                * mirrored.dot(-dir).max(0.0).powf(material.shininess.into());
        }
        self.surface_colour(found, material, position) * diffuse + specular
    }

    fn surface_colour(&self, found: &Found, material: &Material, position: DVec3) -> DVec3 {
        let cell = |x: f64| (x * f64::from(material.checker_scale) + 1.0 / 1024.0).floor() as i64;
        let odd = (cell(position.x) + cell(position.y) + cell(position.z)).rem_euclid(2) == 1;
        let odd = material.checker_scale > 0.0 && odd;
        let colour = wide(if odd { material.checker_colour } else { material.colour });
        if material.texture == NONE { colour } else { colour * self.texel(material.texture, found.uv, true) }
    }

    /// Where reflected and refracted rays go, and their shares.
    fn bounces(&self, found: &Found, material: &Material, dir: DVec3) -> Vec<(DVec3, f64)> {
        let (reflection, transmission) = (f64::from(material.reflection), f64::from(material.transmission));
        let mirror = |n: DVec3| dir - n * (2.0 * dir.dot(n));
        let shading = found.shading_normal;
        let usable = dir.dot(shading) < 0.0 && mirror(shading).dot(found.normal) > 0.0;
        let normal = if usable { shading } else { found.normal };
        let mut mirrored = reflection;
        let mut rays = Vec::new();
        if transmission > 0.0 {
            let eta = if found.back { 1.0 / f64::from(material.eta) } else { f64::from(material.eta) };
            let (cos_i, sin_i) = (-dir.dot(normal), dir.cross(normal).length());
            let sin_t = sin_i / eta;
            let share =
                if sin_t >= 1.0 { 1.0 } else { reflectance(cos_i, (1.0 - sin_t * sin_t).sqrt(), eta) };
            mirrored += transmission * share;
            if sin_t < 1.0 {
                let tangent = (dir + normal * cos_i) / eta;
                rays.push((tangent - normal * (1.0 - sin_t * sin_t).sqrt(), transmission * (1.0 - share)));
            }
        }
        if mirrored > 0.0 {
            rays.push((mirror(normal), mirrored));
        }
        rays
    }

    fn sky(&self, dir: DVec3) -> DVec3 {
        if self.sky_texture == NONE {
            return wide(self.horizon).lerp(wide(self.zenith), dir.y.abs());
        }
        self.texel(self.sky_texture, sphere_uv(DVec3::new(dir.x, dir.y, -dir.z)), false)
    }

    /// Bilinear, as a sum over the whole picture of tent functions.
    fn texel(&self, number: u32, uv: [f64; 2], wrap_rows: bool) -> DVec3 {
        let Texture { first, width, height, .. } = self.textures[number as usize];
        let tent = |position: f64, index: u32, count: u32, wrap: bool| {
            let copies = if wrap { -1..=1 } else { 0..=0 };
            let at = |copy: i32| position - 0.5 - f64::from(index) - f64::from(copy) * f64::from(count);
            copies.map(|copy| (1.0 - at(copy).abs()).max(0.0)).sum::<f64>()
        };
        let x = uv[0].rem_euclid(1.0) * f64::from(width);
        let y = if wrap_rows {
            (1.0 - uv[1]).rem_euclid(1.0) * f64::from(height)
        } else {
            ((1.0 - uv[1]) * f64::from(height)).clamp(0.5, f64::from(height) - 0.5)
        };
        let mut sum = DVec3::ZERO;
        for row in 0..height {
            for column in 0..width {
                let [red, green, blue, _] =
                    self.texels[(first + row * width + column) as usize].map(f64::from);
                let weight = tent(x, column, width, true) * tent(y, row, height, wrap_rows);
                sum += DVec3::new(red, green, blue) * weight;
            }
        }
        sum
    }
}

/// Where a ray meets a triangle, if it does, before or behind its origin.
pub fn meet_triangle(number: u32, triangle: &Triangle, origin: DVec3, dir: DVec3) -> Option<Found> {
    let [a, b, c] = triangle.vertices.map(wide);
    let (ab, ac) = (b - a, c - a);
    let across = ab.cross(ac);
    let det = -dir.dot(across);
    let from_a = origin - a;
    let t = from_a.dot(across) / det;
    let moment = from_a.cross(dir);
    let (v, w) = (ac.dot(moment) / det, -ab.dot(moment) / det);
    if det == 0.0 || v < 0.0 || w < 0.0 || v + w > 1.0 {
        return None;
    }
    let back = det < 0.0;
    let normal = if back { -across } else { across }.normalize();
    let mix = |at: [DVec3; 3]| at[0] * (1.0 - v - w) + at[1] * v + at[2] * w;
    let smooth = if triangle.smooth == 1 { mix(triangle.normals.map(wide)).normalize() } else { normal };
    let uv = [0, 1].map(|i| {
        let at = triangle.uvs.map(|uv| f64::from(uv[i]));
        at[0] * (1.0 - v - w) + at[1] * v + at[2] * w
    });
    let shading_normal = if smooth.dot(normal) < 0.0 { -smooth } else { smooth };
    Some(Found { t, prim_id: number, normal, shading_normal, uv, back, material: triangle.material })
}

/// Fresnel, from the amplitudes by sines and cosines.
fn reflectance(cos_i: f64, cos_t: f64, eta: f64) -> f64 {
    let perpendicular = ((cos_i - eta * cos_t) / (cos_i + eta * cos_t)).powi(2);
    let parallel = ((cos_t - eta * cos_i) / (cos_t + eta * cos_i)).powi(2);
    0.5 * (perpendicular + parallel)
}
