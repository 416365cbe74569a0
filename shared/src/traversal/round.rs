//! Packs of spheres and ellipsoids, lane after lane for both drivers.

use super::ray::Prepared;
use super::rows::{ELLIPSOID_ROWS, KIND, Kind, LANES, ROW, SPHERE_ROWS};
use super::rules::{Rules, closer};
use super::slab::own_box;
use crate::geom::ellipsoid::{self, ToUnit};
use crate::geom::sphere;
use crate::layout::{Ellipsoid, Hit, NONE, Ray, Row};
use kernel_api::{At, rare};

/// Tests the pack behind `link`; returns the better one of `best` and its nearest hit.
///
/// Out of line on a CPU, from the ray as it was given and by value: a walk through triangles keeps its registers, and does not pay.
#[rare]
pub(super) fn pack<R: Rules>(rows: &[Row], link: u32, ray: Ray, extent: f32, mut best: Hit) -> Hit {
    let ray = Prepared::new::<R>(&ray, extent);
    if link & KIND == Kind::Spheres as u32 {
        spheres::<R>(rows.window(link & ROW), &ray, &mut best);
    } else {
        ellipsoids::<R>(rows.window(link & ROW), &ray, &mut best);
    }
    best
}

#[inline(always)]
fn spheres<R: Rules>(pack: &[Row; SPHERE_ROWS], ray: &Prepared, best: &mut Hit) {
    for lane in 0..LANES {
        let at = |row: usize| f32::from_bits(pack[row].0[lane]);
        let prim_id = pack[SPHERE_ROWS - 1].0[lane];
        if prim_id != NONE {
            let (centre, radius) = ([at(0), at(1), at(2)], at(3));
            let (low, high) = sphere::bounds(centre, radius);
            let (enter, leave) = own_box(low, high, ray);
            offer::<R>(sphere::intersect(centre, radius, &ray.ray, enter, leave), prim_id, ray, best);
        }
    }
}

#[inline(always)]
fn ellipsoids<R: Rules>(pack: &[Row; ELLIPSOID_ROWS], ray: &Prepared, best: &mut Hit) {
    for lane in 0..LANES {
        let at = |row: usize| f32::from_bits(pack[row].0[lane]);
        let prim_id = pack[ELLIPSOID_ROWS - 1].0[lane];
        if prim_id != NONE {
            let world_to_unit = [3, 7, 11].map(|row| [at(row), at(row + 1), at(row + 2), at(row + 3)]);
            let ellipsoid = Ellipsoid { centre: [at(0), at(1), at(2)], material: 0, world_to_unit };
            let (low, high) = ellipsoid::bounds(&ellipsoid);
            let (enter, leave) = own_box(low, high, ray);
            let to_unit = ToUnit::new(&ellipsoid);
            let t = ellipsoid::intersect(ellipsoid.centre, &to_unit, &ray.ray, enter, leave);
            offer::<R>(t, prim_id, ray, best);
        }
    }
}

/// Makes a hit at `t`, NaN for none, the best one if it is.
#[inline(always)]
fn offer<R: Rules>(t: f32, prim_id: u32, ray: &Prepared, best: &mut Hit) {
    if (t >= ray.t_min) & closer::<R>(t, prim_id, best) {
        *best = Hit { t, prim_id };
    }
}
