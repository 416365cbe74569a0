//! The passes against an independent brute-force ray tracer in double precision, and ray-quadric
//! intersections against the exact formula.
//!
//! CPU = GPU says nothing about correctness, since both run one source; this does.

use glam::{DMat3, DVec3, Vec3};
use parallax::backend::Cpu;
use parallax::rig::StereoRig;
use parallax_shared::geom::ellipsoid::{self, ToUnit};
use parallax_shared::geom::sphere;
use parallax_shared::layout::{Ellipsoid, Material, NONE, Ray, Texture, View};
use parallax_tests::oracle::Oracle;
use parallax_tests::reference::{direction, wide};
use parallax_tests::stage::{self, Stage, light, quad, white};

const SIDE: u32 = 64;

fn view(eye: [f32; 3], target: [f32; 3]) -> View {
    let rig = StereoRig {
        eye,
        target,
        up: [0.0, 1.0, 0.0],
        vertical_fov_deg: 45.0,
        width: SIDE,
        height: SIDE,
        interaxial_px: 8.0,
        zero_parallax: 5.0,
    };
    rig.views(1.0).unwrap()[1]
}

/// Splits a seed into numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

/// Matt, shiny, mirrored, checkered, textured and transparent things in a room without walls.
fn room() -> Stage {
    let mut stage = Stage::new(view([0.4, 1.7, 5.2], [0.0, 0.6, 0.0]));
    stage.ambient = [0.15, 0.12, 0.1];
    (stage.zenith, stage.horizon) = ([0.2, 0.4, 0.9], [0.9, 0.8, 0.7]);
    let matt = Material { ambient: 1.0, diffuse: 0.7, ..white() };
    stage.materials = vec![
        Material { checker_colour: [0.9, 0.2, 0.1], checker_scale: 1.0, colour: [0.2, 0.8, 0.3], ..matt },
        Material { specular: 0.4, shininess: 30.0, colour: [0.8, 0.5, 0.2], ..matt },
        Material { reflection: 0.8, diffuse: 0.2, ..matt },
        Material {
            ambient: 0.0,
            diffuse: 0.0,
            specular: 0.3,
            shininess: 12.5,
            transmission: 0.9,
            eta: 1.5,
            ..matt
        },
        Material { texture: 0, ..matt },
    ];
    stage.textures = vec![Texture { first: 0, width: 4, height: 4, padding: 0 }];
    stage.texels = (0..16).map(|i| [(i % 4) as f32 / 3.0, (i / 4) as f32 / 3.0, 0.5, 1.0]).collect();
    stage.triangles = quad([-6.0, 0.0, 4.0], [12.0, 0.0, 0.0], [0.0, 0.0, -12.0], 0).to_vec();
    stage.triangles.extend(quad([-2.5, 0.1, -2.0], [2.0, 0.0, 0.4], [0.0, 2.0, 0.0], 4));
    stage.spheres = vec![
        stage::sphere([-0.9, 0.6, 0.6], 0.6, 1),
        stage::sphere([0.9, 0.7, -0.7], 0.7, 2),
        stage::sphere([0.45, 0.45, 1.3], 0.45, 3),
    ];
    stage.ellipsoids = vec![
        stage::ellipsoid([-1.8, 0.5, 1.2], [0.7, 0.5, 0.2], 0.6, 4),
        stage::ellipsoid([2.0, 0.4, 0.8], [0.3, 0.4, 0.8], -0.4, 2),
        stage::ellipsoid([-0.2, 1.7, -0.4], [0.6, 0.25, 0.4], 1.0, 3),
    ];
    stage.lights = vec![light([3.0, 5.0, 4.0], [0.6, 0.6, 0.5]), light([-4.0, 4.0, 1.0], [0.3, 0.3, 0.4])];
    stage.max_depth = 5;
    stage
}

/// A smooth glass and a mirror icosphere-like mesh under a picture of a sky.
fn meshes() -> Stage {
    let mut stage = room();
    (stage.spheres, stage.ellipsoids) = (Vec::new(), Vec::new());
    stage.triangles.extend(globe(DVec3::new(-0.8, 0.9, 0.5), 0.8, 3));
    stage.triangles.extend(globe(DVec3::new(1.0, 0.7, 0.0), 0.65, 2));
    stage.triangles.extend(globe(DVec3::new(0.4, 0.4, 1.6), 0.35, 1));
    stage.textures.push(Texture { first: 16, width: 6, height: 3, padding: 0 });
    stage.texels.extend((0..18).map(|i| [0.2 + (i % 6) as f32 * 0.1, 0.1 + (i / 6) as f32 * 0.3, 0.6, 1.0]));
    stage.sky_texture = 1;
    stage
}

/// A sphere of triangles with smooth normals.
fn globe(centre: DVec3, radius: f64, material: u32) -> Vec<parallax_shared::layout::Triangle> {
    let (rings, sectors) = (10, 16);
    let normal = |i: usize, j: usize| {
        let (polar, around) = (
            i as f64 / rings as f64 * std::f64::consts::PI,
            (j % sectors) as f64 / sectors as f64 * std::f64::consts::TAU,
        );
        DVec3::new(polar.sin() * around.sin(), polar.cos(), polar.sin() * around.cos())
    };
    let corner = |[i, j]: [usize; 2]| (centre + normal(i, j) * radius).as_vec3().to_array();
    let face = |at: [[usize; 2]; 3]| {
        let mut face = stage::triangle(at.map(corner), material);
        (face.smooth, face.normals) = (1, at.map(|[i, j]| normal(i, j).as_vec3().to_array()));
        face
    };
    let quads = (0..rings).flat_map(|i| (0..sectors).map(move |j| [i, j]));
    quads
        .flat_map(|[i, j]| {
            let upper = (i > 0).then(|| face([[i, j], [i + 1, j], [i, j + 1]]));
            let lower = (i + 1 < rings).then(|| face([[i, j + 1], [i + 1, j], [i + 1, j + 1]]));
            upper.into_iter().chain(lower)
        })
        .collect()
}

/// What the oracle sees at a pixel and close around it, in pixels.
const AROUND: [[f64; 2]; 5] =
    [[0.0, 0.0], [0.004, 0.001], [-0.004, -0.001], [0.001, -0.004], [-0.001, 0.004]];

fn compare(name: &str, stage: &Stage, least_stable: f64) {
    let mut cpu = Cpu::new(1).unwrap();
    let got = stage.render(&mut cpu).unwrap();
    let eye = DVec3::from(stage.view.eye.map(f64::from));
    let (mut stable, mut worst) = ([0, 0], [0f64; 4]);
    for pixel in 0..(SIDE * SIDE) as usize {
        let (x, y) = ((pixel as u32 % SIDE) as f64, (pixel as u32 / SIDE) as f64);
        let dirs = AROUND.map(|[dx, dy]| direction(&stage.view, x + dx, y + dy));
        let found = dirs.map(|dir| Oracle(stage).nearest(eye, dir, 0.0));
        let id = |i: usize| found[i].map_or(NONE, |f| f.prim_id);
        let (hit, surface) = (got.hits[pixel], got.surfaces[pixel]);
        if (0..5).all(|i| id(i) == id(0)) {
            stable[0] += 1;
            assert_eq!(hit.prim_id, id(0), "{name} pixel {x} {y}");
            if let Some(f) = found[0] {
                worst[0] = worst[0].max((hit.t as f64 / f.t - 1.0).abs());
                let error = |got: [f32; 3], want: DVec3| (DVec3::from(got.map(f64::from)) - want).length();
                worst[1] = worst[1].max(error(surface.normal, f.normal));
                worst[1] = worst[1].max(error(surface.shading_normal, f.shading_normal));
                worst[2] = worst[2].max(error(surface.position, eye + dirs[0] * f.t));
                let disparity = stage.view.interaxial_px as f64 * (1.0 - 1.0 / f.t);
                assert!((surface.disparity as f64 - disparity).abs() < 1e-4);
            }
        }
        let colours = dirs.map(|dir| Oracle(stage).radiance(eye, dir, DVec3::ONE, 0));
        if colours.iter().all(|c| (*c - colours[0]).abs().max_element() < 4e-3) {
            stable[1] += 1;
            let got = Vec3::new(got.colours[pixel][0], got.colours[pixel][1], got.colours[pixel][2]);
            worst[3] = worst[3].max((got.as_dvec3() - colours[0]).abs().max_element());
        }
    }
    let share = stable.map(|s| s as f64 / f64::from(SIDE * SIDE));
    println!("{name}: stable {share:?}, worst t, normal, position, colour {worst:?}");
    assert!(share[0] > 0.95 && share[1] > least_stable, "{name}: {share:?}");
    // At a silhouette an error across the ray shows with its square root along it.
    assert!(worst[0] < 4e-6 && worst[1] < 1e-4 && worst[2] < 1.5e-5, "{name}: t, normal, position {worst:?}");
    assert!(worst[3] < 1e-3, "{name}: colour {worst:?}");
}

#[test]
fn spheres_ellipsoids_mirrors_glass_and_textures_are_what_the_oracle_sees() {
    compare("room", &room(), 0.85);
}

#[test]
fn smooth_meshes_and_a_sky_map_are_what_the_oracle_sees() {
    compare("meshes", &meshes(), 0.7);
}

/// The comparison can fail: a mirror that is a little weaker is found.
#[test]
#[should_panic(expected = "colour")]
fn a_wrong_colour_is_found() {
    let mut stage = room();
    let right = stage.clone();
    stage.materials[2].reflection = 0.79;
    let mut cpu = Cpu::new(1).unwrap();
    let (got, want) = (stage.render(&mut cpu).unwrap(), right.render(&mut cpu).unwrap());
    let differs = got.colours.iter().zip(&want.colours).any(|(a, b)| (a[0] - b[0]).abs() > 1e-3);
    assert!(!differs, "colour");
}

/// Roots of the exact quadratic for `ray` and the ellipsoid, from f32 data in f64.
fn exact_roots(to_unit: DMat3, centre: DVec3, ray: &Ray) -> Option<[f64; 2]> {
    let (o, d) = (DVec3::from(ray.origin.map(f64::from)) - centre, DVec3::from(ray.dir.map(f64::from)));
    // From the point nearest to the centre, so that f64 keeps digits for the discriminant even at a distance
    // of 10⁸ radii.
    let shift = -o.dot(d) / d.dot(d);
    let (u, v) = (to_unit * (o + d * shift), to_unit * d);
    let (a, b) = (v.dot(v), u.dot(v));
    let across = u - v * (b / a);
    let gap = 1.0 - across.dot(across);
    let half = (gap / a).sqrt();
    (gap >= 0.0).then(|| [shift - b / a - half, shift - b / a + half])
}

struct Tally {
    hits: u32,
    doubtful: u32,
    worst: f64,
}

/// Compares `t` with the exact first root at 0 or more. `unit` is the distance in which errors are counted.
fn tally(tally: &mut Tally, t: f32, ray: &Ray, roots: Option<[f64; 2]>, miss_by: f64, unit: f64) {
    let want = roots.and_then(|roots| roots.into_iter().find(|root| *root >= 0.0));
    let length = DVec3::from(ray.dir.map(f64::from)).length();
    match want {
        Some(want) if !t.is_nan() => {
            tally.hits += 1;
            tally.worst = tally.worst.max((t as f64 - want).abs() * length / unit);
        }
        None if t.is_nan() => {}
        _ => {
            tally.doubtful += 1;
            assert!(miss_by < 1e-5, "{ray:?}: {t} instead of {want:?}, {miss_by} radii from the rim");
        }
    }
}

/// Radii from 10⁻⁴ at a distance of 10⁴ to huge spheres near by; origins outside and inside; rays at the rim.
#[test]
fn spheres_are_hit_where_the_exact_formula_says() {
    let mut random = Random(11);
    for (radius, distance) in
        [(1e-4, 1e4), (1.0, 1e4), (1.0, 3.0), (1e3, 1e3 + 0.01), (1.0, 0.3), (300.0, 100.0)]
    {
        let mut count = Tally { hits: 0, doubtful: 0, worst: 0.0 };
        let mut worst_normal = 0f64;
        for _ in 0..20_000 {
            let (to_eye, rim) = (random.direction(), random.direction());
            let centre = (random.direction() * random.between(0.0, 10.0)).as_vec3();
            let origin = (centre.as_dvec3() + to_eye * distance).as_vec3();
            let aim = rim.cross(to_eye).normalize_or(DVec3::X) * radius * random.between(0.0, 1.05);
            let dir = (centre.as_dvec3() + aim - origin.as_dvec3()) * random.between(0.1, 2.0);
            let ray = Ray {
                origin: origin.to_array(),
                t_min: 0.0,
                dir: dir.as_vec3().to_array(),
                t_max: f32::INFINITY,
            };
            let radius = radius as f32;
            let t = sphere::intersect(centre.to_array(), radius, &ray, f32::NEG_INFINITY, f32::INFINITY);
            let scale = DMat3::from_diagonal(DVec3::splat(1.0 / f64::from(radius)));
            let roots = exact_roots(scale, centre.as_dvec3(), &ray);
            let (o, d) =
                (origin.as_dvec3() - centre.as_dvec3(), DVec3::from(ray.dir.map(f64::from)).normalize());
            let miss_by = (o.cross(d).length() / f64::from(radius) - 1.0).abs();
            tally(&mut count, t, &ray, roots, miss_by, distance + f64::from(radius));
            if let Some(root) =
                roots.and_then(|roots| roots.into_iter().find(|t| *t >= 0.0)).filter(|_| !t.is_nan())
            {
                let (_, normal) = sphere::point_and_normal(centre.to_array(), radius, &ray, t);
                let exact = (o + DVec3::from(ray.dir.map(f64::from)) * root).normalize();
                worst_normal = worst_normal.max((normal.as_dvec3() - exact).length());
            }
        }
        println!(
            "sphere {radius} at {distance}: {} hits, {} at the rim, worst {}",
            count.hits, count.doubtful, count.worst
        );
        assert!(count.hits > 5_000 && count.doubtful < 20);
        assert!(count.worst < 1e-6, "{radius} {distance}: {}", count.worst);
        assert!(worst_normal < 2e-3, "{radius} {distance}: normal {worst_normal}");
    }
}

/// Flat and long ones, 1 : 10⁴, near and far, from outside and inside.
#[test]
fn ellipsoids_are_hit_where_the_exact_formula_says() {
    let mut random = Random(12);
    for half in [[1.0, 1.0, 1.0], [1.0, 1e-4, 1.0], [1e-4, 1.0, 1e-4], [3.0, 0.5, 0.02]] {
        for distance in [0.0, 4.0, 1e3] {
            let mut count = Tally { hits: 0, doubtful: 0, worst: 0.0 };
            let mut off_surface = 0f64;
            for _ in 0..10_000 {
                let shape: Ellipsoid =
                    stage::ellipsoid([0.5, -0.25, 0.125], half, random.between(0.0, 6.0), 0);
                let centre = DVec3::from(shape.centre.map(f64::from));
                let row = |i: usize| {
                    Vec3::new(shape.world_to_unit[i][0], shape.world_to_unit[i][1], shape.world_to_unit[i][2])
                };
                let rows = [row(0), row(1), row(2)];
                let to_unit =
                    DMat3::from_cols(rows[0].as_dvec3(), rows[1].as_dvec3(), rows[2].as_dvec3()).transpose();
                let on_it = to_unit.inverse() * (random.direction() * random.between(0.0, 0.999));
                let origin = (centre
                    + random.direction() * distance
                    + if distance == 0.0 { on_it } else { DVec3::ZERO })
                .as_vec3();
                let target = centre + to_unit.inverse() * (random.direction() * random.between(0.0, 1.02));
                let dir = (target - origin.as_dvec3()).as_vec3();
                let ray =
                    Ray { origin: origin.to_array(), t_min: 0.0, dir: dir.to_array(), t_max: f32::INFINITY };
                let t = ellipsoid::intersect(
                    shape.centre,
                    &ToUnit::new(&shape),
                    &ray,
                    f32::NEG_INFINITY,
                    f32::INFINITY,
                );
                let roots = exact_roots(to_unit, centre, &ray);
                let (o, d) = (to_unit * (origin.as_dvec3() - centre), to_unit * dir.as_dvec3());
                let miss_by = (o.cross(d).length() / d.length() - 1.0).abs();
                let from_inside = o.length() > 0.99 && distance == 0.0;
                if !from_inside {
                    tally(&mut count, t, &ray, roots, miss_by * 1e-3, distance + 1.0);
                }
                if !t.is_nan() {
                    let point = o + d * f64::from(t);
                    let off = (point.length() - 1.0) / (to_unit.transpose() * point.normalize()).length();
                    let want = roots.and_then(|roots| roots.into_iter().find(|root| *root >= 0.0));
                    // The way along the ray bounds the distance too (the first bound is a tangent's, no good
                    // far away).
                    let along =
                        want.map_or(0.0, |want| (f64::from(t) - want).abs() * f64::from(dir.length()));
                    off_surface = off_surface.max(off.abs().min(along) / (distance + 1.0));
                }
            }
            println!(
                "ellipsoid {half:?} at {distance}: {} hits, {} at the rim, worst {}",
                count.hits, count.doubtful, count.worst
            );
            assert!(count.hits > 4_000 && count.doubtful < 100);
            // Along a ray that grazes a flat side errors are larger than across it, where they count.
            assert!(off_surface < 1e-6, "{half:?} {distance}: {off_surface}");
            assert!(count.worst < 2e-3, "{half:?} {distance}: {}", count.worst);
        }
    }
}

/// A disc 10⁴ times as wide as thick, 10³ radii away: what is hit and where does not suffer from the digits that the distance takes.
#[test]
fn flat_ellipsoids_far_away_are_hit_where_they_are() {
    let mut random = Random(13);
    let (mut hits, mut misses, mut worst) = (0, 0, 0f64);
    for _ in 0..20_000 {
        let shape = stage::ellipsoid([0.5, -0.25, 0.125], [1.0, 1e-4, 1.0], random.between(0.0, 6.0), 0);
        let (centre, rows) = (wide(shape.centre), shape.world_to_unit.map(|[x, y, z, _]| [x, y, z]));
        let [x, y, z] = rows.map(wide);
        let to_unit = DMat3::from_cols(x, y, z).transpose();
        let origin = (centre + random.direction() * 1e3).as_vec3();
        let target = centre + to_unit.inverse() * (random.direction() * random.between(0.0, 1.5));
        let dir = (target - origin.as_dvec3()).as_vec3();
        let ray = Ray { origin: origin.to_array(), t_min: 0.0, dir: dir.to_array(), t_max: f32::INFINITY };
        let (o, d) = (to_unit * (origin.as_dvec3() - centre), to_unit * dir.as_dvec3());
        let to_rim = o.cross(d).length() / d.length() - 1.0;
        // Along the disc a ray's own digits decide too little.
        if to_rim.abs() < 1e-2 || d.normalize().y.abs() < 0.999 {
            continue;
        }
        let to = ToUnit::new(&shape);
        let t = ellipsoid::intersect(shape.centre, &to, &ray, f32::NEG_INFINITY, f32::INFINITY);
        assert_eq!(t.is_nan(), to_rim > 0.0, "{ray:?}: {to_rim} radii beyond the rim");
        if let Some([near, _]) = exact_roots(to_unit, centre, &ray).filter(|_| !t.is_nan()) {
            let got = ellipsoid::point(&shape, &ray, t).on_unit_sphere.as_dvec3();
            worst = worst.max((got - (o + d * near)).length());
            hits += 1;
        } else {
            misses += 1;
        }
    }
    println!("flat ellipsoids far away: {hits} hits, {misses} misses, worst {worst}");
    assert!(hits > 2_000 && misses > 2_000, "{hits} {misses}");
    assert!(worst < 1e-4, "{worst} radii beside where it is");
}

/// `t` is moved into the primitive's own box, and a primitive whose box is missed is missed.
#[test]
fn the_own_box_bounds_the_hit() {
    let ray = Ray { origin: [0.0, 0.0, 5.0], t_min: 0.0, dir: [0.0, 0.0, -1.0], t_max: f32::INFINITY };
    let hit = |enter, leave| sphere::intersect([0.0; 3], 1.0, &ray, enter, leave);
    assert_eq!(hit(3.9, 6.1), 4.0);
    assert_eq!(hit(4.1, 6.1), 4.1);
    assert_eq!(hit(1.0, 3.9), 3.9);
    assert!(hit(4.1, 3.9).is_nan());
}

#[test]
fn the_first_root_not_before_t_min_is_the_hit() {
    let ray = |t_min| Ray { origin: [0.0, 0.0, 5.0], t_min, dir: [0.0, 0.0, -1.0], t_max: f32::INFINITY };
    let hit = |t_min| sphere::intersect([0.0; 3], 1.0, &ray(t_min), 3.9, 6.1);
    assert_eq!((hit(0.0), hit(4.0), hit(4.5), hit(6.0)), (4.0, 4.0, 6.0, 6.0));
    assert!(hit(6.1).is_nan());
}
