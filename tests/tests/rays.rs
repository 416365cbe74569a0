//! Properties of rays and boxes: whatever the ray and the triangles, both drivers find what brute force finds, in any structure, and
//! what is no proper ray hits nothing.

use bytemuck::Zeroable;
use parallax::build::{Quality, build};
use parallax_shared::layout::{Ellipsoid, Hit, NONE, Ray, Sphere, Triangle};
use parallax_shared::traversal::ray::Prepared;
use parallax_shared::traversal::rules::Exact;
use parallax_shared::traversal::walk::walk;
use parallax_shared::traversal::{closest_hit, occluded};
use parallax_tests::reference::Reference;
use parallax_tests::stage;
use proptest::array::uniform3;
use proptest::collection::vec;
use proptest::prelude::*;

/// Few values, so that vertices coincide and edges are shared, and some that are no multiple of anything.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![(-3..=3i32).prop_map(|x| x as f32 * 0.25), -1.0..1.0f32]
}

/// Ordinary components and those that need care.
fn component() -> impl Strategy<Value = f32> {
    let special = vec![0.0, -0.0, 1e-40, -1e-40, f32::MIN_POSITIVE, 1e-30, -1e-20, 1.0, -1.0];
    prop_oneof![-1.0..1.0f32, proptest::sample::select(special)]
}

fn triangle() -> impl Strategy<Value = Triangle> {
    uniform3(uniform3(coordinate())).prop_map(|vertices| Triangle { vertices, ..Zeroable::zeroed() })
}

fn ray() -> impl Strategy<Value = Ray> {
    let origin = uniform3(prop_oneof![coordinate(), (-8..=8i32).prop_map(|x| x as f32)]);
    let range = prop_oneof![Just((0.0, f32::INFINITY)), (0.0..1.0f32, 1.0..9.0f32)];
    let proper = |dir: &[f32; 3]| dir.iter().any(|d| d.abs() > 1e-3);
    let dir = uniform3(component()).prop_filter("one component must be longer than 1e-18", proper);
    (origin, dir, range).prop_map(|(origin, dir, (t_min, t_max))| Ray { origin, t_min, dir, t_max })
}

/// +0 and −0 are one `t`.
fn bits(hit: Hit) -> (u32, u32) {
    ((hit.t + 0.0).to_bits(), hit.prim_id)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_structure_finds_what_brute_force_finds(triangles in vec(triangle(), 1..60), rays in vec(ray(), 20)) {
        for quality in [Quality::Full, Quality::Quick] {
            let bvh = build(&triangles, &[], &[], quality).unwrap();
            prop_assert_eq!(bvh.validate(&triangles, &[], &[]), Ok(()));
            for ray in &rays {
                let expected = Reference::new(*ray, bvh.extent).brute_force(&triangles).0;
                let found = closest_hit(&bvh.rows, ray, bvh.extent);
                prop_assert_eq!(bits(found), bits(expected), "{:?} {:?}", ray, found);
                let scanned = walk::<Exact, false, true>(&bvh.rows, ray, bvh.extent);
                prop_assert_eq!(bits(scanned), bits(expected), "lane after lane, {:?}", ray);
                prop_assert_eq!(occluded(&bvh.rows, ray, bvh.extent), expected.prim_id != NONE);
            }
        }
    }

    #[test]
    fn round_primitives_are_found_in_any_structure(
        spheres in vec((uniform3(coordinate()), 0.01..0.5f32), 1..40),
        ellipsoids in vec((uniform3(coordinate()), uniform3(0.05..0.5f32)), 1..40),
        rays in vec(ray(), 20),
    ) {
        let sphere = |&(centre, radius): &([f32; 3], f32)| Sphere { centre, radius, ..Zeroable::zeroed() };
        let spheres: Vec<_> = spheres.iter().map(sphere).collect();
        let ellipsoid = |&(centre, half): &([f32; 3], [f32; 3])| {
            let mut world_to_unit = [[0.0; 4]; 3];
            for axis in 0..3 {
                world_to_unit[axis][axis] = 1.0 / half[axis];
                world_to_unit[axis][3] = half[axis];
            }
            Ellipsoid { centre, material: 0, world_to_unit }
        };
        let ellipsoids: Vec<_> = ellipsoids.iter().map(ellipsoid).collect();
        let [full, quick] =
            [Quality::Full, Quality::Quick].map(|quality| build(&[], &spheres, &ellipsoids, quality).unwrap());
        prop_assert_eq!(full.validate(&[], &spheres, &ellipsoids), Ok(()));
        for ray in &rays {
            let found = closest_hit(&full.rows, ray, full.extent);
            prop_assert_eq!(bits(found), bits(closest_hit(&quick.rows, ray, quick.extent)), "{:?}", ray);
            // Brute force: each by itself, padded alike.
            let alone = |hit: Hit, prim_id: u32| if hit.prim_id == NONE { hit } else { Hit { prim_id, ..hit } };
            let mut best = Hit { t: f32::INFINITY, prim_id: NONE };
            for prim_id in 0..(spheres.len() + ellipsoids.len()) as u32 {
                let own = match spheres.get(prim_id as usize) {
                    Some(sphere) => build(&[], &[*sphere], &[], Quality::Full).unwrap(),
                    None => build(&[], &[], &[ellipsoids[prim_id as usize - spheres.len()]], Quality::Full).unwrap(),
                };
                let hit = alone(closest_hit(&own.rows, ray, full.extent), prim_id);
                if hit.t < best.t {
                    best = hit;
                }
            }
            prop_assert_eq!(bits(found), bits(best), "{:?}", ray);
        }
    }

    #[test]
    fn what_is_no_ray_hits_nothing(
        ray in ray(),
        which in 0..8usize,
        bad in proptest::sample::select(vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY]),
    ) {
        // A box around the origin of coordinates, which most rays hit.
        let bvh = build(&parallax_tests::meshes::cube(0.5, [0.0; 3]).triangles, &[], &[], Quality::Full).unwrap();
        let mut broken = ray;
        match which {
            0..3 => broken.origin[which] = bad,
            3..6 => broken.dir[which - 3] = bad,
            6 => broken.t_min = if bad == f32::NEG_INFINITY { f32::NAN } else { bad },
            _ => broken.t_max = if bad == f32::INFINITY { f32::NAN } else { bad },
        }
        prop_assert_eq!(closest_hit(&bvh.rows, &broken, bvh.extent).prim_id, NONE, "{:?}", broken);
        prop_assert!(!occluded(&bvh.rows, &broken, bvh.extent), "{:?}", broken);
        let pointless = Ray { dir: [0.0, -0.0, 1e-40], ..ray };
        prop_assert_eq!(closest_hit(&bvh.rows, &pointless, bvh.extent).prim_id, NONE);
    }
}

#[test]
fn a_range_below_zero_starts_at_zero() {
    let bvh = build(&parallax_tests::meshes::cube(0.5, [0.0; 3]).triangles, &[], &[], Quality::Full).unwrap();
    for t_min in [-0.0, -5.0, -f32::INFINITY] {
        let ray = Ray { origin: [0.1, 0.2, 0.0], t_min, dir: [0.0, 0.0, 1.0], t_max: f32::INFINITY };
        let hit = closest_hit(&bvh.rows, &ray, bvh.extent);
        assert_eq!(hit.t, 0.5, "{t_min}: {hit:?}");
    }
}

/// No constant of a proper ray is infinite, whatever the components of its direction: 0 · ∞ is NaN, and a device need not compare NaN
/// as IEEE 754 says.
#[test]
fn no_direction_has_an_infinite_inverse() {
    for small in [0.0, -0.0, 1e-45, -1e-40, f32::MIN_POSITIVE, -1e-30, 1e-19] {
        let ray = Ray { origin: [0.5; 3], t_min: 0.0, dir: [small, 1.0, -small], t_max: f32::INFINITY };
        let inverse = Prepared::new::<Exact>(&ray, 1.0).inv_dir;
        assert!(inverse.iter().all(|inverse| inverse.abs() <= 1e18), "{ray:?}: {inverse:?}");
    }
}

/// A sphere or an ellipsoid at `t_max` is no hit, and one ULP before it is: a light on a ball is not hidden by it.
#[test]
fn the_end_of_a_range_hits_nothing_round() {
    let ball = stage::sphere([0.0; 3], 1.0, 0);
    let egg = stage::ellipsoid([0.0; 3], [0.5, 0.25, 1.0], 0.0, 0);
    for (spheres, ellipsoids) in [(vec![ball], vec![]), (vec![], vec![egg])] {
        let bvh = build(&[], &spheres, &ellipsoids, Quality::Full).unwrap();
        for (t_max, hits) in [(4.0, false), (4.0f32.next_up(), true)] {
            let ray = Ray { origin: [0.0, 0.0, 5.0], t_min: 0.0, dir: [0.0, 0.0, -1.0], t_max };
            let found = closest_hit(&bvh.rows, &ray, bvh.extent);
            assert_eq!(found.prim_id != NONE, hits, "{ray:?}: {found:?}");
            assert_eq!(occluded(&bvh.rows, &ray, bvh.extent), hits, "{ray:?}");
        }
    }
}
