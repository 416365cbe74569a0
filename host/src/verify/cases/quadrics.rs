//! Spheres and ellipsoids: small ones far away, origins inside, tangents, flat ones; through the structure, on both backends.

use crate::verify::Outcome;
use crate::verify::input::meshes::Random;
use crate::verify::input::reference::wide;
use crate::verify::input::stage;
use crate::verify::suite::{Suite, structure};
use glam::{DMat3, DVec3};
use parallax_shared::layout::{Ellipsoid, NONE, Ray};

fn direction(random: &mut Random) -> DVec3 {
    loop {
        let v = DVec3::from_array([(); 3].map(|()| f64::from(2.0 * random.unit() - 1.0)));
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}

fn matrix(shape: &Ellipsoid) -> DMat3 {
    let row = |i: usize| {
        let [x, y, z, _] = shape.world_to_unit[i].map(f64::from);
        DVec3::new(x, y, z)
    };
    DMat3::from_cols(row(0), row(1), row(2)).transpose()
}

/// What f64 says of a ray and an ellipsoid: the first root at 0 or more, and by how much of a radius the line passes inside the rim.
fn exact(ray: &Ray, centre: DVec3, to_unit: DMat3) -> (Option<f64>, f64) {
    let (o, d) = (wide(ray.origin) - centre, wide(ray.dir));
    // Counted from the point nearest to the centre: digits are left for the discriminant even far away.
    let shift = -o.dot(d) / d.dot(d);
    let (u, v) = (to_unit * (o + d * shift), to_unit * d);
    let (a, b) = (v.dot(v), u.dot(v));
    let across = u - v * (b / a);
    let gap = 1.0 - across.dot(across);
    let half = (gap / a).max(0.0).sqrt();
    let roots = [shift - b / a - half, shift - b / a + half];
    (roots.into_iter().find(|t| gap >= 0.0 && *t >= 0.0), 1.0 - across.length())
}

/// Spheres of radius 10⁻⁴ at a distance of 10⁴, from all sides and up to their rims.
///
/// Guard: the origin is moved to the point nearest to the centre by exact sums and products (`Offset::along`).
pub fn small_spheres_far_away_are_hit_where_they_are(suite: &mut Suite) -> Outcome {
    let mut random = Random(1);
    let mut cases = 0;
    for (radius, distance) in [(1e-4, 1e4), (1e-2, 1e4), (1.0, 1e6)] {
        let centre = (direction(&mut random) * 0.5).as_vec3();
        let ball = stage::sphere(centre.to_array(), radius, 0);
        let rays: Vec<_> = (0..20_000)
            .map(|_| {
                let towards = direction(&mut random);
                let origin = (centre.as_dvec3() + towards * distance).as_vec3();
                let rim = towards.cross(direction(&mut random)).normalize();
                let target = centre.as_dvec3() + rim * (f64::from(radius) * 1.1 * f64::from(random.unit()));
                let dir = (target - origin.as_dvec3()).as_vec3().to_array();
                Ray { origin: origin.to_array(), t_min: 0.0, dir, t_max: f32::INFINITY }
            })
            .collect();
        let scale = DMat3::from_diagonal(DVec3::splat(1.0 / f64::from(radius)));
        let found = suite.hits(&structure(&[], &[ball], &[])?, &rays)?;
        let mut hit_count = 0;
        for (ray, hit) in rays.iter().zip(&found) {
            let (t, depth) = exact(ray, centre.as_dvec3(), scale);
            if depth.abs() > 1e-5 {
                suite.check((hit.prim_id != NONE) == t.is_some(), || {
                    format!("radius {radius}: {ray:?}, {depth} radii inside")
                });
            }
            if let (Some(t), true) = (t, hit.prim_id != NONE) {
                suite.check((f64::from(hit.t) - t).abs() <= 1e-6 * t.max(1.0), || {
                    format!("{ray:?}: {} not {t}", hit.t)
                });
                hit_count += 1;
            }
        }
        suite.check(hit_count > 5000, || format!("radius {radius}: {hit_count} hits"));
        cases += rays.len();
    }
    suite.tried(cases);
    Ok(())
}

/// From inside the far side is met, whatever the direction; from the surface inwards as well.
///
/// Guard: the second root is taken where the first is before `t_min` (`Chord::first_root`).
pub fn from_inside_the_far_side_is_met(suite: &mut Suite) -> Outcome {
    let mut random = Random(2);
    let mut cases = 0;
    for (centre, radius) in [([0.0; 3], 1.0), ([100.0, -7.0, 3.0], 0.25), ([0.1, 0.2, 0.3], 1e3)] {
        let ball = stage::sphere(centre, radius, 0);
        let rays: Vec<_> = (0..20_000)
            .map(|_| {
                let inside = direction(&mut random) * (f64::from(radius) * 0.999 * f64::from(random.unit()));
                let origin = (wide(centre) + inside).as_vec3().to_array();
                let dir = direction(&mut random).as_vec3().to_array();
                Ray { origin, t_min: 0.0, dir, t_max: f32::INFINITY }
            })
            .collect();
        let scale = DMat3::from_diagonal(DVec3::splat(1.0 / f64::from(radius)));
        for (ray, hit) in rays.iter().zip(suite.hits(&structure(&[], &[ball], &[])?, &rays)?) {
            // A ray from inside leaves.
            let t = exact(ray, wide(centre), scale).0.unwrap_or(f64::NAN);
            let size = f64::from(radius) + wide(centre).length();
            suite.check(hit.prim_id == 0, || format!("{ray:?}"));
            suite
                .check((f64::from(hit.t) - t).abs() <= 1e-6 * size, || format!("{ray:?}: {} not {t}", hit.t));
        }
        cases += rays.len();
    }
    suite.tried(cases);
    Ok(())
}

/// Rays along a tangent, exactly, and one ULP to either side: a hit within, a miss without, never a NaN.
///
/// Guard: a negative discriminant is a miss before the root is taken (`Chord::new`).
pub fn tangents_are_decided(suite: &mut Suite) -> Outcome {
    let mut rays = Vec::new();
    for (axis, sign) in (0..3).flat_map(|axis| [(axis, 1.0f32), (axis, -1.0)]) {
        for away in [2.0f32, 16.0, 1024.0] {
            for (ulps, expected) in
                [(0, Some(true)), (-8, Some(true)), (-1, None), (1, None), (8, Some(false))]
            {
                let (mut origin, mut dir) = ([0.0; 3], [0.0; 3]);
                origin[axis] = -sign * away;
                dir[axis] = sign;
                origin[(axis + 1) % 3] = f32::from_bits((1f32.to_bits() as i32 + ulps) as u32);
                rays.push((Ray { origin, t_min: 0.0, dir, t_max: f32::INFINITY }, away, expected));
            }
        }
    }
    let given: Vec<_> = rays.iter().map(|(ray, ..)| *ray).collect();
    let found = suite.hits(&structure(&[], &[stage::sphere([0.0; 3], 1.0, 0)], &[])?, &given)?;
    for ((ray, away, expected), hit) in rays.iter().zip(found) {
        suite.check(!hit.t.is_nan(), || format!("{ray:?}: NaN"));
        suite.check(expected.is_none_or(|is_hit| is_hit == (hit.prim_id != NONE)), || {
            format!("{ray:?}: {hit:?}")
        });
        suite.check(hit.prim_id == NONE || (hit.t - away).abs() < 3e-3, || format!("{ray:?}: {hit:?}"));
    }
    suite.tried(rays.len());
    Ok(())
}

/// Discs and a needle, 10⁴ times as wide as thick: half axes, and the thin one of a disc in unit space.
const FLAT: [([f64; 3], Option<DVec3>); 3] =
    [([1.0, 1e-4, 1.0], Some(DVec3::Y)), ([1e-4, 1.0, 1e-4], None), ([1.0, 1.0, 1e-4], Some(DVec3::Z))];

/// Flat ellipsoids, turned, near and far: what passes through them hits, and hits lie on them.
///
/// Guard: the origin is moved in world space before the matrix, whose rows differ by 10⁴, is applied (`ellipsoid::chord_of`). A test
/// of `oracle` holds it, which sees the point on the unit sphere: `t` has too few digits for the thickness.
pub fn flat_ellipsoids_are_hit_where_they_are(suite: &mut Suite) -> Outcome {
    let mut random = Random(4);
    for (half, thin) in FLAT {
        for (distance, angle) in [(3.0, 0.3), (100.0, 1.1), (1e3, 2.0)] {
            let shape = stage::ellipsoid([0.5, -0.25, 0.125], half, angle, 0);
            let (centre, to_unit) = (wide(shape.centre), matrix(&shape));
            let from_unit = to_unit.inverse();
            let mut ray = || {
                let origin = (centre + direction(&mut random) * distance).as_vec3();
                let target = centre + from_unit * (direction(&mut random) * (1.5 * f64::from(random.unit())));
                let dir = (target - origin.as_dvec3()).as_vec3().to_array();
                Ray { origin: origin.to_array(), t_min: 0.0, dir, t_max: f32::INFINITY }
            };
            let rays: Vec<_> = (0..5000).map(|_| ray()).collect();
            for (ray, hit) in rays.iter().zip(suite.hits(&structure(&[], &[], &[shape])?, &rays)?) {
                let (t, depth) = exact(ray, centre, to_unit);
                // Of lines along a disc too few digits are left to decide; across it the rim does.
                let is_across = thin.is_some_and(|thin| {
                    (to_unit * wide(ray.dir)).normalize().dot(thin).abs() > 0.999 && depth.abs() > 1e-2
                });
                if is_across || depth.abs() > 1e-3 * distance {
                    suite.check((hit.prim_id != NONE) == t.is_some(), || {
                        format!("{half:?} at {distance}: {ray:?}, {depth} radii inside")
                    });
                }
                if hit.prim_id != NONE {
                    let away = distance_to(ray, hit.t, t, to_unit, centre);
                    suite.check(away < 1e-6 * (distance + 1.0), || {
                        format!("{half:?} at {distance}: {away} beside the surface")
                    });
                }
            }
            suite.tried(rays.len());
        }
    }
    Ok(())
}

/// How far the point at `t` of a ray is from the ellipsoid, or along the ray from the point at `exact`, whichever is nearer.
fn distance_to(ray: &Ray, t: f32, exact: Option<f64>, to_unit: DMat3, centre: DVec3) -> f64 {
    let unit = to_unit * (wide(ray.origin) + wide(ray.dir) * f64::from(t) - centre);
    let to_surface = (unit.length() - 1.0).abs() / (to_unit.transpose() * unit.normalize()).length();
    let along = exact.map_or(f64::INFINITY, |exact| (f64::from(t) - exact).abs() * wide(ray.dir).length());
    to_surface.min(along)
}
