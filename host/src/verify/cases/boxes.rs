//! Directions without a component, flat boxes, slab planes, edges, and what is no ray.

use crate::verify::Outcome;
use crate::verify::input::meshes::{Random, cube, icosphere, towards};
use crate::verify::input::stage::{ellipsoid, sphere};
use crate::verify::suite::{Suite, structure};
use bytemuck::Zeroable;
use parallax_shared::layout::{NONE, Ray, Row, Triangle};
use parallax_shared::traversal::closest_hit;
use std::time::{Duration, Instant};

/// Tiles in three planes of a lattice, one for each axis: every leaf's box is flat, and lattice points are on planes of slabs.
fn tiles() -> Vec<Triangle> {
    let mut tiles = Vec::new();
    for axis in 0..3 {
        for at in 0..64 {
            let corner = |u: i32, v: i32| {
                let (u, v) = ((at % 8 + u) as f32 * 0.25 - 1.0, (at / 8 + v) as f32 * 0.25 - 1.0);
                let mut point = [u, v, 0.0];
                point.rotate_right(axis);
                point
            };
            for vertices in
                [[corner(0, 0), corner(1, 0), corner(0, 1)], [corner(1, 1), corner(0, 1), corner(1, 0)]]
            {
                tiles.push(Triangle { vertices, ..Zeroable::zeroed() });
            }
        }
    }
    tiles
}

const COMPONENTS: [f32; 11] =
    [0.0, -0.0, 1e-45, -1e-45, 1e-40, -1e-40, f32::MIN_POSITIVE, -1e-30, 1e-12, 1.0, -1.0];

/// Every combination of components, from points of the lattice, which lie on planes and edges of boxes, and from beside them.
///
/// Guard: near planes are padded (`traversal::ray::Prepared`). That of 1/d, clamped to ±10¹⁸ (`traversal::ray::clamped_inverse`), is not
/// held by it: without that the slabs' comparisons, which are false for the NaN of 0 · ∞, still leave that axis out.
pub fn directions_without_a_component_meet_what_they_should(suite: &mut Suite) -> Outcome {
    let tiles = tiles();
    let mut random = Random(1);
    let mut rays = Vec::new();
    for i in 0..COMPONENTS.len().pow(3) {
        let dir = [0, 1, 2].map(|k| COMPONENTS[i / COMPONENTS.len().pow(k) % COMPONENTS.len()]);
        if dir.iter().all(|d| d.abs() < 1e-3) {
            continue;
        }
        for _ in 0..40 {
            let place = |random: &mut Random| match random.below(4) {
                0 => 2.0 * random.unit() - 1.0,
                _ => random.below(17) as f32 * 0.125 - 1.0,
            };
            // Off the lattice where a component is so small that what it adds, times a coordinate, is no ordinary number any more:
            // of such a distance to an edge only the shift of the ray decides, not the sign.
            let origin = [0, 1, 2].map(|k| match dir[k].abs() {
                tiny if tiny > 0.0 && tiny < 1e-20 => 1.99 * random.unit() - 0.99,
                _ => place(&mut random),
            });
            rays.push(Ray { origin, t_min: 0.0, dir, t_max: f32::INFINITY });
        }
    }
    let found = suite.brute_force(&tiles, &rays)?;
    let hit_count = found.iter().filter(|hit| hit.prim_id != NONE).count();
    suite.check(hit_count > rays.len() / 10, || format!("only {hit_count} rays hit"));
    suite.tried(rays.len());
    Ok(())
}

/// Rays along the edges of a cube, through its corners, and within its faces; inside and out.
///
/// Guard: a near plane is padded outwards, a far one too (`traversal::ray::Prepared`).
pub fn rays_along_edges_meet_what_they_should(suite: &mut Suite) -> Outcome {
    let mut cases = 0;
    for (half, centre) in [(1.0, [0.0; 3]), (0.3, [10.1, -7.7, 0.3]), (1e-3, [1.0, 1.0, 1.0])] {
        let mesh = cube(half, centre);
        let (low, high) = mesh.bounds();
        let mut rays = Vec::new();
        for i in 0..27 {
            let place = |k: usize, choice: usize| [low[k], high[k], (low[k] + high[k]) * 0.5][choice];
            let at = [place(0, i % 3), place(1, i / 3 % 3), place(2, i / 9)];
            for axis in 0..3 {
                for (sign, back) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 3.0), (-1.0, 3.0), (1.0, -3.0)] {
                    for lift in [0u32, 1, 2] {
                        let mut origin = at;
                        origin[axis] -= sign * back * half;
                        let other = (axis + 1) % 3;
                        origin[other] = lifted(origin[other], lift);
                        let mut dir = [0.0; 3];
                        dir[axis] = sign;
                        rays.push(Ray { origin, t_min: 0.0, dir, t_max: f32::INFINITY });
                    }
                }
            }
        }
        suite.brute_force(&mesh.triangles, &rays)?;
        cases += rays.len();
    }
    suite.tried(cases);
    Ok(())
}

/// A coordinate away from zero by so many ULP; zero by so many of 1, as denormal coordinates are no ordinary ones.
fn lifted(x: f32, ulps: u32) -> f32 {
    if x == 0.0 { ulps as f32 * f32::EPSILON } else { f32::from_bits(x.to_bits() + ulps) }
}

fn broken_rays() -> Vec<Ray> {
    let whole = Ray { origin: [0.1, 0.2, 3.0], t_min: 0.0, dir: [0.0, -0.1, -1.0], t_max: f32::INFINITY };
    let mut rays = Vec::new();
    for bad in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for mask in 1..64 {
            let mut ray = whole;
            for k in 0..3 {
                if mask >> k & 1 == 1 {
                    ray.origin[k] = bad;
                }
                if mask >> (k + 3) & 1 == 1 {
                    ray.dir[k] = bad;
                }
            }
            rays.push(ray);
        }
    }
    rays.push(Ray { t_min: f32::NAN, ..whole });
    rays.push(Ray { t_max: f32::NAN, ..whole });
    rays.push(Ray { dir: [0.0; 3], ..whole });
    rays
}

/// The shortest time in which these rays were walked.
fn least_time(rows: &[Row], extent: f32, rays: &[Ray]) -> Duration {
    let once = || {
        let start = Instant::now();
        for _ in 0..20 {
            for ray in rays {
                std::hint::black_box(closest_hit(rows, std::hint::black_box(ray), extent));
            }
        }
        start.elapsed()
    };
    (0..15).map(|_| once()).min().unwrap_or_default()
}

/// A ray with a NaN or an infinity misses triangles, spheres and ellipsoids, in at most 2.5 times the time of an ordinary ray.
///
/// Guard: a walk begins with a finite ray only (`Prepared::is_proper`); a NaN otherwise meets every box that it asks.
pub fn what_is_no_ray_misses_in_the_time_of_a_ray(suite: &mut Suite) -> Outcome {
    let mesh = icosphere(5, 1.0, [0.0; 3]);
    let ball = sphere([0.0; 3], 1.0, 0);
    let egg = ellipsoid([0.0; 3], [1.0, 0.9, 0.8], 0.3, 0);
    let broken = broken_rays();
    for bvh in
        [structure(&mesh.triangles, &[], &[])?, structure(&[], &[ball], &[])?, structure(&[], &[], &[egg])?]
    {
        for (ray, hit) in broken.iter().zip(suite.hits(&bvh, &broken)?) {
            suite.check(hit.prim_id == NONE, || format!("{ray:?}"));
        }
    }
    let bvh = structure(&mesh.triangles, &[], &[])?;
    let mut random = Random(3);
    let ordinary: Vec<_> = (0..broken.len())
        .map(|_| {
            let target = [(); 3].map(|()| random.unit() - 0.5);
            towards([0.1, 0.2, 3.0], target)
        })
        .collect();
    let [bad, good] = [&broken, &ordinary].map(|rays| least_time(&bvh.rows, bvh.extent, rays));
    suite.check(2 * bad <= 5 * good, || format!("{bad:?} instead of at most 2.5 times {good:?}"));
    suite.tried(3 * broken.len());
    Ok(())
}
