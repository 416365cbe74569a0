//! Proofs that serve many rays: of a shaft that is clear no ray hits anything, whatever is rounded; a shaft without its padding misses
//! something; and a floor does not hide the sky from what stands on it.

use bytemuck::Zeroable;
use glam::{DVec3, Vec3};
use parallax::build::{Bvh, Quality, build};
use parallax_shared::layout::{NONE, Ray, Triangle};
use parallax_shared::traversal::occluded;
use parallax_shared::traversal::occluder::occluder;
use parallax_shared::traversal::rules::{Exact, Rules};
use parallax_shared::traversal::shaft::{Shaft, is_clear};
use parallax_tests::meshes::{Mesh, Random, Vector, cube, icosphere};

const FAR_OFF: Vector = [148_376.0, 1234.0, -223_423.0];

struct Unpadded;

impl Rules for Unpadded {
    const PADDING: f32 = 0.0;
}

fn structure(mesh: &Mesh) -> Bvh {
    build(&mesh.triangles, &[], &[], Quality::Quick).unwrap()
}

/// Between −`size` and `size`.
fn vector(random: &mut Random, size: f32) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| (2.0 * random.unit() - 1.0) * size))
}

fn soup(count: usize, size: f32, centre: Vector) -> Mesh {
    let mut random = Random(count as u64 + 1);
    let mut triangle = || {
        let at = Vec3::from_array(centre) + vector(&mut random, 1.0);
        Triangle {
            vertices: std::array::from_fn(|_| (at + vector(&mut random, size)).into()),
            ..Zeroable::zeroed()
        }
    };
    let triangles = (0..count).map(|_| triangle()).collect();
    Mesh { name: format!("{count} triangles at {centre:?}"), triangles }
}

fn meshes() -> Vec<Mesh> {
    let origin = [0.0; 3];
    [
        icosphere(3, 1.0, origin),
        icosphere(3, 1.0, FAR_OFF),
        icosphere(2, 1e-3, [1.0, 0.0, 0.5]),
        cube(1.0, origin),
        cube(50.0, FAR_OFF),
        soup(60, 0.2, origin),
        soup(60, 200.0, FAR_OFF),
        soup(2000, 0.05, origin),
    ]
    .map(Mesh::scaled)
    .into()
}

/// A box and a target, of which the rays come close to an edge or a vertex of the mesh: what rounding could decide.
fn case(mesh: &Mesh, random: &mut Random) -> (Vec3, Vec3, Vec3) {
    let (low, high) = mesh.bounds();
    let extent = low.iter().chain(&high).fold(0f32, |most, x| most.max(x.abs()));
    let [a, b, _] = mesh.triangles[random.below(mesh.triangles.len())].vertices.map(Vec3::from_array);
    let weight = if random.below(2) == 0 { 0.0 } else { random.unit() };
    let beside = extent * [0.0, 1e-7, 1e-6, 1e-3, 0.3][random.below(5)];
    let aim = a + (b - a) * weight + vector(random, beside);
    let far = [1.0, 1.0, 3.0, 1e4, 1e12][random.below(5)];
    let mut target = vector(random, extent * far);
    // Along an axis, and at right angles to one.
    match random.below(4) {
        0 => target = aim + Vec3::AXES[random.below(3)] * extent * far,
        1 => target[random.below(3)] = aim[random.below(3)],
        _ => {}
    }
    let at = aim + (aim - target) * [1e-6, 1e-3, 0.1, 1.0][random.below(4)] / far;
    let size = extent * [0.0, 0.0, 1e-7, 1e-5, 1e-2, 0.3][random.below(6)];
    let flat = Vec3::from_array(std::array::from_fn(|_| random.below(3).min(1) as f32));
    (at - vector(random, size).abs() * flat, at + vector(random, size).abs() * flat, target)
}

/// Rays from the corners and from within a box.
fn rays(low: Vec3, high: Vec3, target: Vec3, random: &mut Random) -> Vec<Ray> {
    let ray = |origin: Vec3| {
        let dir = (target - origin).to_array();
        Ray { origin: origin.to_array(), t_min: 0.0, dir, t_max: 1.0 }
    };
    let corner =
        |i: usize| Vec3::from_array(std::array::from_fn(|k| if i >> k & 1 == 0 { low[k] } else { high[k] }));
    let within = |random: &mut Random| {
        let at = Vec3::from_array(std::array::from_fn(|k| low[k] + (high[k] - low[k]) * random.unit()));
        at.max(low).min(high)
    };
    let corners: Vec<_> = (0..8).map(|i| ray(corner(i))).collect();
    corners.into_iter().chain((0..8).map(|_| ray(within(random)))).collect()
}

#[derive(Debug, Default)]
struct Outcome {
    clear: usize,
    not_clear: usize,
    hidden_although_clear: usize,
}

fn outcome<R: Rules>(mesh: &Mesh, cases: usize) -> Outcome {
    let bvh = structure(mesh);
    let (mut random, mut outcome) = (Random(11), Outcome::default());
    for _ in 0..cases {
        let (low, high, target) = case(mesh, &mut random);
        let rays = rays(low, high, target, &mut random);
        if !is_clear(&bvh.rows, &Shaft::new::<R>(low, high, target, bvh.extent)) {
            outcome.not_clear += 1;
            continue;
        }
        outcome.clear += 1;
        outcome.hidden_although_clear +=
            usize::from(rays.iter().any(|ray| occluded(&bvh.rows, ray, bvh.extent)));
    }
    outcome
}

#[test]
fn no_ray_of_a_clear_shaft_is_hidden_and_without_padding_some_are() {
    let (mut clear, mut not_clear, mut missed) = (0, 0, 0);
    for mesh in meshes() {
        let exact = outcome::<Exact>(&mesh, 40_000);
        assert_eq!(exact.hidden_although_clear, 0, "{}: {exact:?}", mesh.name);
        clear += exact.clear;
        not_clear += exact.not_clear;
        missed += outcome::<Unpadded>(&mesh, 40_000).hidden_although_clear;
    }
    assert!(clear > 20_000 && not_clear > 20_000, "{clear} clear, {not_clear} not");
    assert!(missed > 0, "padding is not needed: this test cannot fail");
    println!("{clear} shafts were clear, {not_clear} were not; without padding {missed} were wrongly so");
}

/// Whether the segment and the box have a point in common, in double precision.
fn meets(from: DVec3, to: DVec3, low: DVec3, high: DVec3) -> bool {
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for k in 0..3 {
        let way = to[k] - from[k];
        if way == 0.0 {
            if from[k] < low[k] || from[k] > high[k] {
                return false;
            }
            continue;
        }
        let (a, b) = ((low[k] - from[k]) / way, (high[k] - from[k]) / way);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    enter <= leave
}

#[test]
fn a_shaft_meets_every_box_that_one_of_its_rays_meets() {
    let mut random = Random(5);
    let (mut met, mut clear) = (0, 0);
    for round in 0..30_000 {
        let centre = if round % 3 == 0 { Vec3::from_array(FAR_OFF) } else { Vec3::ZERO };
        let size = [1e-3, 1.0, 100.0][random.below(3)];
        let (a, b) = (centre + vector(&mut random, size), centre + vector(&mut random, size));
        let (box_low, box_high) = (a.min(b), a.max(b));
        let vertices = [box_low, box_high, Vec3::new(box_low.x, box_high.y, box_low.z)];
        let triangle = Triangle { vertices: vertices.map(|v| v.to_array()), ..Zeroable::zeroed() };
        let bvh = structure(&Mesh { name: String::new(), triangles: vec![triangle] });
        let at = centre + vector(&mut random, 2.0 * size);
        let (wide, far) = ([0.0, 1e-6, 0.1, 1.0][random.below(4)], [1.0, 4.0, 1e6][random.below(3)]);
        let half = vector(&mut random, size * wide).abs();
        let mut target = centre + vector(&mut random, size * far);
        if random.below(4) == 0 {
            target.y = at.y;
        }
        let (low, high) = (at - half, at + half);
        let is_clear = is_clear(&bvh.rows, &Shaft::new::<Exact>(low, high, target, bvh.extent));
        clear += usize::from(is_clear);
        for ray in rays(low, high, target, &mut random) {
            let from = Vec3::from_array(ray.origin).as_dvec3();
            if meets(from, target.as_dvec3(), box_low.as_dvec3(), box_high.as_dvec3()) {
                met += 1;
                assert!(!is_clear, "{low} {high} to {target}, past {box_low} {box_high}");
            }
        }
    }
    assert!(met > 10_000 && clear > 5_000, "{met} rays met a box, {clear} shafts were clear");
}

/// What the proofs are good for. The points are as far above the floor as rays that leave it start.
#[test]
fn a_floor_hides_no_light_from_what_stands_on_it() {
    let half = 1.5f32;
    let corner = |x: f32, z: f32| [x * half, -0.25, z * half];
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let triangle = |ids: [usize; 3]| Triangle { vertices: ids.map(|i| corners[i]), ..Zeroable::zeroed() };
    let mesh = Mesh { name: "floor".into(), triangles: vec![triangle([0, 1, 2]), triangle([0, 2, 3])] };
    let bvh = structure(&mesh);
    let mut random = Random(9);
    for _ in 0..1000 {
        let at = vector(&mut random, 1.0);
        let above = -0.25 + 8.0 * f32::EPSILON * (1.0 + 2.0 * half);
        let (low, high) = (Vec3::new(at.x, above, at.z), Vec3::new(at.x + 0.01, above, at.z + 0.01));
        let target = Vec3::new(at.z * 5.0, 0.5 + 4.0 * random.unit(), at.x * 5.0);
        assert!(
            is_clear(&bvh.rows, &Shaft::new::<Exact>(low, high, target, bvh.extent)),
            "{low} to {target}"
        );
        let (below, upright) = (Vec3::new(at.x, -1.0, at.z), Vec3::new(at.x, 3.0, at.z));
        assert!(!is_clear(&bvh.rows, &Shaft::new::<Exact>(below, below, upright, bvh.extent)));
    }
}

/// Whatever pack is tried first, the answer is that of the walk; and the right one is found again.
#[test]
fn an_expected_occluder_changes_no_answer() {
    for mesh in meshes() {
        let bvh = structure(&mesh);
        let mut random = Random(17);
        let mut last = NONE;
        for _ in 0..4000 {
            let (low, high, target) = case(&mesh, &mut random);
            for ray in rays(low, high, target, &mut random) {
                let hidden = occluded(&bvh.rows, &ray, bvh.extent);
                let found = occluder(&bvh.rows, &ray, bvh.extent, last);
                assert_eq!(found != NONE, hidden, "{}: {ray:?}", mesh.name);
                if hidden {
                    assert_eq!(occluder(&bvh.rows, &ray, bvh.extent, found), found);
                    last = found;
                }
            }
        }
        assert_ne!(last, NONE, "{}: nothing was hidden", mesh.name);
    }
}
