//! Slivers, zero area, coincident faces, scales and offsets, origins on the surface, ends of the range.

use crate::verify::Outcome;
use crate::verify::input::meshes::{Mesh, Random, cube, icosphere, rays_from_inside, towards};
use crate::verify::input::reference::wide;
use crate::verify::suite::{Suite, structure};
use bytemuck::Zeroable;
use glam::{DVec3, Vec3};
use parallax_shared::layout::{NONE, Ray, Triangle};

fn triangle(vertices: [Vec3; 3]) -> Triangle {
    Triangle { vertices: vertices.map(|v| v.to_array()), ..Zeroable::zeroed() }
}

/// In a cube of half width 1.
fn vector(random: &mut Random) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
}

/// A ray from within `spread` of `centre` at a point of one of the triangles.
fn aimed(random: &mut Random, triangles: &[Triangle], spread: f32, centre: Vec3) -> Ray {
    let [a, b, c] = triangles[random.below(triangles.len())].vertices.map(Vec3::from_array);
    let target = a + (b - a) * (0.5 * random.unit()) + (c - a) * (0.5 * random.unit());
    towards((vector(random) * spread + centre).to_array(), target.to_array())
}

/// How far the line of a ray passes from a triangle, at the nearest, in f64.
fn distance_to(ray: &Ray, triangle: &Triangle) -> f64 {
    let (o, d) = (wide(ray.origin), wide(ray.dir));
    let [a, b, c] = triangle.vertices.map(wide);
    let across = (b - a).cross(c - a);
    let det = d.dot(across);
    let at = o + d * ((a - o).dot(across) / det);
    let inside = |p: DVec3, q: DVec3| (q - p).cross(at - p).dot(across) >= 0.0;
    if det != 0.0 && inside(a, b) && inside(b, c) && inside(c, a) {
        return 0.0;
    }
    [(a, b), (b, c), (c, a)]
        .into_iter()
        .map(|(p, q)| line_to_segment(o, d, p, q))
        .fold(f64::INFINITY, f64::min)
}

fn line_to_segment(o: DVec3, d: DVec3, p: DVec3, q: DVec3) -> f64 {
    // In the plane across the line it is a point and a segment.
    let flat = |v: DVec3| v - d * (v.dot(d) / d.dot(d));
    let (from, along) = (flat(p - o), flat(q - p));
    let s = if along.length_squared() > 0.0 { -from.dot(along) / along.length_squared() } else { 0.0 };
    (from + along * s.clamp(0.0, 1.0)).length()
}

/// Rays from inside of closed meshes at their vertices, edges and faces: none slips through, and each finds the owner that brute force
/// finds; with each triangle many times, too.
///
/// Guards: the shift of the ray that decides on an edge, the padding of boxes, and that of equal `t` the smaller number owns the hit
/// (`traversal::rules`).
pub fn closed_meshes_have_no_holes(suite: &mut Suite) -> Outcome {
    let far_off = [1000.0, 2000.0, -500.0];
    let meshes =
        [icosphere(3, 100.0, far_off), cube(1.0, [0.0; 3]), icosphere(1, 1.0, [0.0; 3]).repeated(20)];
    for (seed, mesh) in meshes.into_iter().map(Mesh::scaled).enumerate() {
        let rays = rays_from_inside(&mesh, 20_000, seed as u64);
        for (ray, hit) in rays.iter().zip(suite.brute_force(&mesh.triangles, &rays)?) {
            suite.check(hit.prim_id != NONE, || format!("{}: {ray:?} slips through", mesh.name));
        }
        suite.tried(rays.len());
    }
    Ok(())
}

/// Triangles 10⁶ times as long as high, met at all angles down to nearly parallel ones.
///
/// Guard: an edge function that rounds to zero is decided by the errors of its products (`geom::triangle::edge_sign`).
pub fn slivers_are_hit_where_they_are(suite: &mut Suite) -> Outcome {
    let mut random = Random(1);
    let slivers: Vec<_> = (0..40)
        .map(|_| {
            let (a, along) = (vector(&mut random), vector(&mut random).normalize());
            let aside = along.any_orthonormal_vector() * 1e-6;
            triangle([a, a + along, a + along * random.unit() + aside])
        })
        .collect();
    let mut rays = Vec::new();
    for i in 0..60_000 {
        let [a, b, c] = slivers[random.below(slivers.len())].vertices.map(Vec3::from_array);
        let target = a + (b - a) * random.unit() + (c - a) * (random.unit() * 0.5);
        let beside = [0.0, 1e-7, 1e-6, 1e-5][i % 4];
        let origin = match i % 3 {
            // In the direction of the sliver, but for a little.
            0 => target - (b - a) * (1.0 + random.unit()) + vector(&mut random) * [1e-6, 1e-3][i / 3 % 2],
            _ => vector(&mut random) * 3.0,
        };
        rays.push(towards(origin.to_array(), (target + vector(&mut random) * beside).to_array()));
    }
    let found = suite.brute_force(&slivers, &rays)?;
    let hit: Vec<_> = rays.iter().zip(&found).filter(|(_, hit)| hit.prim_id != NONE).collect();
    for (ray, hit) in &hit {
        let away = distance_to(ray, &slivers[hit.prim_id as usize]);
        // A vertex is rounded once when it is moved to the origin and twice when it is sheared.
        suite.check(away < 8.0 * 6e-7, || format!("a false hit, {away} away: {ray:?}"));
    }
    suite.check(hit.len() > 3000, || format!("{} hits", hit.len()));
    suite.tried(rays.len());
    Ok(())
}

/// What has no area is hit by nothing: points, segments, and folded triangles.
///
/// Guard: a vertex on the ray has an edge function of zero for any other one, and the shift of the ray gives both edges of a degenerate
/// triangle opposite signs (`geom::triangle::edge_sign`).
pub fn zero_area_is_no_hit(suite: &mut Suite) -> Outcome {
    let mut random = Random(2);
    let mut cases = 0;
    for kind in 0..3 {
        let flat: Vec<_> = (0..200)
            .map(|_| {
                let a = (vector(&mut random) * 8.0).round() * 0.125;
                let step = (vector(&mut random) * 8.0).round() * 0.0625;
                triangle([[a, a, a], [a, a, a + step], [a, a + step * 2.0, a + step]][kind])
            })
            .collect();
        let rays: Vec<_> = (0..15_000)
            .map(|i| {
                let [a, b, c] = flat[random.below(flat.len())].vertices.map(Vec3::from_array);
                let target = [a, b, c, (a + b) * 0.5][i % 4];
                let origin = if i % 5 == 0 {
                    target + Vec3::AXES[i % 3] * 4.0
                } else {
                    (vector(&mut random) * 16.0).round() * 0.125
                };
                towards(origin.to_array(), target.to_array())
            })
            .filter(|ray| ray.dir != [0.0; 3])
            .collect();
        let found = suite.brute_force(&flat, &rays)?;
        // The projections are exact where the ray runs along an axis.
        let is_exact = |ray: &Ray| ray.dir.iter().filter(|d| **d != 0.0).count() == 1;
        for (ray, hit) in rays.iter().zip(&found).filter(|(ray, _)| is_exact(ray)) {
            suite.check(hit.prim_id == NONE, || format!("{ray:?}"));
        }
        cases += rays.len();
    }
    suite.tried(cases);
    Ok(())
}

/// Faces that lie on each other or cut each other: the same owner in any order of the list.
///
/// The rule that equal `t` goes to the smaller number is not needed here, where copies come in order: `hits` takes it away.
pub fn coincident_faces_have_the_first_as_their_owner(suite: &mut Suite) -> Outcome {
    let mut random = Random(3);
    let one: Vec<_> = (0..30).map(|_| triangle(std::array::from_fn(|_| vector(&mut random)))).collect();
    let mut all = Vec::new();
    for copy in 0..6 {
        for face in &one {
            let mut face = *face;
            // Some are turned over, some are other triangles in the same plane.
            if copy == 4 {
                face.vertices.swap(0, 1);
            }
            all.push(face);
        }
    }
    let rays: Vec<_> = (0..30_000).map(|_| aimed(&mut random, &one, 3.0, Vec3::ZERO)).collect();
    let found = suite.brute_force(&all, &rays)?;
    let owners = found.iter().filter(|hit| hit.prim_id != NONE);
    let copies = owners.clone().filter(|hit| hit.prim_id as usize >= one.len()).count();
    suite.check(owners.count() > 20_000, || "rays are not aimed at faces".into());
    suite.check(copies < found.len() / 100, || format!("{copies} hits of copies with other roundings"));
    suite.tried(rays.len());
    Ok(())
}

/// Any unit and any place: scales from 10⁻⁶ to 10⁶, offsets up to 10⁶ sizes, against brute force, and `t` against f64.
///
/// Guards: the padding of boxes, and that `t` stays in the triangle's own box (`traversal::rules`, `geom::triangle`).
pub fn scales_and_offsets_change_nothing_but_rounding(suite: &mut Suite) -> Outcome {
    let mut random = Random(4);
    let mut cases = 0;
    for (scale, offset) in
        [(1e-6, 0.0), (1e-3, 1e3), (1.0, 0.0), (1.0, 1e6), (1e3, 1e3), (1e6, 0.0), (1e6, 1e6), (1e-6, 1.0)]
    {
        let centre = Vec3::new(0.7, -1.0, 0.3) * offset;
        let soup: Vec<_> = (0..60)
            .map(|_| triangle(std::array::from_fn(|_| vector(&mut random) * scale + centre)))
            .collect();
        let rays: Vec<_> = (0..6000)
            .map(|_| aimed(&mut random, &soup, 3.0 * scale, centre))
            .filter(|ray| ray.dir != [0.0; 3])
            .collect();
        let found = suite.brute_force(&soup, &rays)?;
        let step = f64::from(f32::EPSILON) * f64::from(3.0 * scale + 2.0 * offset);
        for (ray, hit) in rays.iter().zip(&found).filter(|(_, hit)| hit.prim_id != NONE) {
            let away = distance_to(ray, &soup[hit.prim_id as usize]);
            suite.check(away <= 8.0 * step, || format!("scale {scale}, offset {offset}: {away}"));
        }
        cases += rays.len();
    }
    suite.tried(cases);
    Ok(())
}

/// Rays that begin on a face, and ranges that end just before or behind it, by one ULP.
///
/// Guard: `t_min <= t < t_max` decides by comparison, without any tolerance (`geom::triangle::accept`).
pub fn a_range_is_decided_to_the_last_bit(suite: &mut Suite) -> Outcome {
    let mut random = Random(5);
    let soup: Vec<_> = (0..50).map(|_| triangle(std::array::from_fn(|_| vector(&mut random)))).collect();
    let free: Vec<_> = (0..5000).map(|_| aimed(&mut random, &soup, 3.0, Vec3::ZERO)).collect();
    let bvh = structure(&soup, &[], &[])?;
    let first = suite.hits(&bvh, &free)?;
    let (mut ends, mut starts, mut on_it) = (Vec::new(), Vec::new(), Vec::new());
    for (ray, hit) in free.iter().zip(&first).filter(|(_, hit)| hit.prim_id != NONE && hit.t > 0.01) {
        let next = f32::from_bits(hit.t.to_bits() + 1);
        ends.push((Ray { t_max: hit.t, ..*ray }, NONE));
        ends.push((Ray { t_max: next, ..*ray }, hit.prim_id));
        starts.push((Ray { t_min: hit.t, ..*ray }, hit.prim_id, hit.t));
        starts.push((Ray { t_min: next, ..*ray }, NONE, hit.t));
        on_it.push(Ray { origin: std::array::from_fn(|k| ray.origin[k] + ray.dir[k] * hit.t), ..*ray });
    }
    let rays: Vec<_> = ends.iter().map(|(ray, _)| *ray).collect();
    for ((ray, expected), hit) in ends.iter().zip(suite.brute_force(&soup, &rays)?) {
        suite.check(hit.prim_id == *expected, || format!("{ray:?}"));
    }
    let rays: Vec<_> = starts.iter().map(|(ray, ..)| *ray).collect();
    for ((ray, expected, t), hit) in starts.iter().zip(suite.brute_force(&soup, &rays)?) {
        if *expected == NONE {
            suite.check(hit.t > *t, || format!("{ray:?}: behind its first hit"));
        } else {
            suite.check((hit.prim_id, hit.t) == (*expected, *t), || format!("{ray:?}"));
        }
    }
    suite.brute_force(&soup, &on_it)?;
    suite.tried(ends.len() + starts.len() + on_it.len());
    Ok(())
}
