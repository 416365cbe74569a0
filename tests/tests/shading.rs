//! Scenes whose pictures can be worked out by hand.

use glam::{DVec3, Vec3};
use parallax_shared::camera;
use parallax_shared::layout::{BACK, Light, Material, NONE, Texture, View};
use parallax_shared::math;
use parallax_shared::shading::bounce;
use parallax_tests::small_scenes::{SIDE, ball_under_lamp, floor, glass, mirror, picture, render, view};
use parallax_tests::stage::{Stage, Stages, light, quad, sphere, triangle, white};

fn colour(stages: &Stages, pixel: usize) -> Vec3 {
    let [red, green, blue, one] = stages.colours[pixel];
    assert_eq!(one, 1.0);
    Vec3::new(red, green, blue)
}

/// Unit direction of a pixel.
fn direction(view: &View, pixel: usize) -> DVec3 {
    camera::pixel_direction(view, pixel as u32 % SIDE, pixel as u32 / SIDE).as_dvec3().normalize()
}

fn assert_close(got: Vec3, want: DVec3, tolerance: f64, what: &str) {
    assert!((got.as_dvec3() - want).abs().max_element() <= tolerance, "{what}: {got} instead of {want}");
}

fn sky(stage: &Stage, dir: DVec3) -> DVec3 {
    let (horizon, zenith) =
        (DVec3::from(stage.horizon.map(f64::from)), DVec3::from(stage.zenith.map(f64::from)));
    horizon + (zenith - horizon) * dir.normalize().y.abs()
}

#[test]
fn a_plane_mirror_shows_the_sky_upside_down() {
    let stage = floor(mirror());
    let stages = render(&stage);
    let mut seen = 0;
    for pixel in 0..(SIDE * SIDE) as usize {
        let dir = direction(&stage.view, pixel);
        assert_close(colour(&stages, pixel), sky(&stage, dir), 1e-5, "sky or its mirror image");
        seen += (stages.hits[pixel].prim_id != NONE) as u32;
    }
    assert!(seen > SIDE * SIDE / 2 && seen < SIDE * SIDE, "{seen} pixels see the floor");
}

#[test]
fn a_mirror_sphere_shows_the_sky_around_it() {
    let mut stage = floor(mirror());
    stage.triangles.clear();
    stage.spheres = vec![sphere([0.0, 0.5, 0.0], 1.0, 0)];
    let stages = render(&stage);
    let mut seen = 0;
    for pixel in 0..(SIDE * SIDE) as usize {
        if stages.hits[pixel].prim_id == NONE {
            continue;
        }
        seen += 1;
        let (dir, surface) = (direction(&stage.view, pixel), &stages.surfaces[pixel]);
        let normal = (DVec3::from(surface.position.map(f64::from)) - DVec3::new(0.0, 0.5, 0.0)).normalize();
        assert_close(Vec3::from(surface.normal), normal, 1e-5, "normal");
        assert_close(
            colour(&stages, pixel),
            sky(&stage, dir - normal * (2.0 * dir.dot(normal))),
            1e-4,
            "mirrored sky",
        );
    }
    assert!(seen > 100);
}

/// Under a sky that is 1 everywhere, what neither absorbs nor shines looks like the sky; what the depth limit
/// cuts off is missing.
#[test]
fn a_closed_furnace_makes_no_light() {
    let mixed = Material { reflection: 0.3, transmission: 0.7, ..glass() };
    for (material, least) in [(mirror(), 0.95f32), (glass(), 0.95), (mixed, 0.75)] {
        let mut stage = floor(material);
        stage.triangles.clear();
        (stage.zenith, stage.horizon, stage.max_depth) = ([1.0; 3], [1.0; 3], bounce::MAX_DEPTH);
        stage.spheres = vec![sphere([0.0, 0.5, 0.0], 1.0, 0), sphere([1.5, 0.5, -1.0], 0.7, 0)];
        let stages = render(&stage);
        let values = stages.colours.iter().flat_map(|c| c[..3].to_vec());
        let (low, high) = values.fold((2.0f32, 0.0f32), |(low, high), c| (low.min(c), high.max(c)));
        assert!(high <= 1.0 + 1e-5, "{high}");
        if material.transmission == 0.0 {
            assert!(low > 0.9, "{low}: what is between two mirrors for ever");
        }
        let mean = stages.colours.iter().map(|c| c[0]).sum::<f32>() / stages.colours.len() as f32;
        assert!(mean >= least, "{mean}");
    }
}

#[test]
fn a_ball_throws_a_round_shadow_and_lambert_falls_off_around_it() {
    let stage = ball_under_lamp();
    let stages = render(&stage);
    // Tangents from the lamp, 3 above the ball's centre of radius ½, meet the floor in a circle.
    let radius = 4.0 * 0.5 / (9.0f64 - 0.25).sqrt();
    let (mut dark, mut lit) = (0, 0);
    for pixel in 0..(SIDE * SIDE) as usize {
        let surface = &stages.surfaces[pixel];
        if surface.prim_id >= 2 {
            continue;
        }
        let [x, y, z] = surface.position.map(f64::from);
        assert!(y.abs() < 1e-6);
        let distance = x.hypot(z);
        if (distance - radius).abs() < 1e-3 {
            continue;
        }
        let shadow = distance < radius;
        assert_eq!(stages.seen[pixel], !shadow as u32, "at {distance} from the axis");
        let cosine = 4.0 / 4.0f64.hypot(distance);
        let want = 0.1 + if shadow { 0.0 } else { 0.6 * cosine };
        assert_close(colour(&stages, pixel), DVec3::splat(want), 1e-5, "floor");
        assert_eq!(stages.counts[1][pixel].shadow, 1);
        (dark, lit) = (dark + shadow as u32, lit + !shadow as u32);
    }
    assert!(dark > 20 && lit > 500, "{dark} {lit}");
}

#[test]
fn what_turns_away_from_a_light_needs_no_ray() {
    let mut stage = ball_under_lamp();
    stage.lights[0].position = [0.0, -4.0, 0.0];
    let stages = render(&stage);
    let floor = (0..stages.surfaces.len()).filter(|&i| stages.surfaces[i].prim_id < 2);
    assert!(floor.map(|i| stages.counts[1][i].shadow + stages.seen[i]).sum::<u32>() == 0);
}

#[test]
fn forty_lights_have_two_words() {
    let mut stage = ball_under_lamp();
    stage.lights = (0..40).map(|i| light([i as f32 - 20.0, 4.0, 0.0], [0.01; 3])).collect();
    let many = render(&stage);
    assert_eq!(many.seen.len(), 2 * many.hits.len());
    for i in [0, 17, 31, 32, 39] {
        let one = render(&Stage { lights: vec![stage.lights[i]], ..stage.clone() });
        for pixel in 0..many.hits.len() {
            assert_eq!(
                (many.seen[2 * pixel + i / 32] >> (i % 32)) & 1,
                one.seen[pixel],
                "light {i}, pixel {pixel}"
            );
        }
    }
}

/// Any surface whose normal faces a light that nothing covers sees it: no shadow acne, on flat and round
/// things, near and far from the origin.
#[test]
fn nothing_shadows_itself() {
    for offset in [0.0f32, 100.0, 1e4, 1e6] {
        let mut stage = Stage::new(view([offset, 2.0, 5.0], [offset, 0.5, 0.0]));
        stage.materials = vec![white()];
        let scale = 1.0 + offset * 1e-3;
        stage.view = view([offset, 2.0 * scale, 5.0 * scale], [offset, 0.5 * scale, 0.0]);
        stage.spheres = vec![sphere([offset, 0.5 * scale, 0.0], scale, 0)];
        stage.lights = (0..64)
            .map(|i| (i as f32 * 0.7).sin_cos())
            .map(|(s, c)| {
                light([offset + 9.0 * scale * s, 3.0 * scale + scale * c, 9.0 * scale * c], [0.1; 3])
            })
            .collect();
        let stages = render(&stage);
        let mut rays = 0;
        for (pixel, surface) in stages.surfaces.iter().enumerate() {
            let seen = stages.seen[2 * pixel].count_ones() + stages.seen[2 * pixel + 1].count_ones();
            assert_eq!(seen, stages.counts[1][pixel].shadow, "offset {offset}, {surface:?}");
            rays += seen;
        }
        assert!(rays > 5_000, "{rays}");
    }
}

/// A large triangle seen from near by, lit at all angles down to grazing ones.
#[test]
fn a_plane_does_not_shadow_itself_even_when_light_grazes_it() {
    let mut stage = floor(white());
    let tilt = [0.3, -0.2, 0.1];
    for triangle in &mut stage.triangles {
        for [x, y, z] in &mut triangle.vertices {
            *y += tilt[0] * *x + tilt[1] * *z + tilt[2];
        }
    }
    stage.lights = (0..32)
        .map(|i| {
            let height = 10f32.powf(1.0 - i as f32 * 0.125);
            let (x, z) = (-40.0 + i as f32, 30.0);
            light([x, tilt[0] * x + tilt[1] * z + tilt[2] + height, z], [0.1; 3])
        })
        .collect();
    let stages = render(&stage);
    let rays: u32 = stages.counts[1].iter().map(|c| c.shadow).sum();
    let seen: u32 = stages.seen.iter().map(|s| s.count_ones()).sum();
    assert_eq!(rays, seen);
    assert!(rays > 20_000, "{rays}");
}

#[test]
fn a_checkerboard_alternates_and_a_face_in_its_plane_is_not_torn() {
    let mut stage =
        floor(Material { checker_colour: [1.0, 0.0, 0.0], checker_scale: 2.0, ambient: 1.0, ..white() });
    stage.ambient = [1.0; 3];
    let stages = render(&stage);
    let mut colours = [0, 0];
    for (pixel, surface) in stages.surfaces.iter().enumerate().filter(|(_, s)| s.prim_id != NONE) {
        let cell = |x: f32| (x as f64 * 2.0 + 1.0 / 1024.0).floor() as i64;
        let near_border = |x: f32| ((x as f64 * 2.0 + 1.0 / 1024.0).rem_euclid(1.0) - 0.5).abs() > 0.4999;
        let [x, _, z] = surface.position;
        if near_border(x) || near_border(z) {
            continue;
        }
        let odd = (cell(x) + cell(z)).rem_euclid(2) == 1;
        let want = if odd { DVec3::X } else { DVec3::ONE };
        assert_close(colour(&stages, pixel), want, 0.0, "square");
        colours[odd as usize] += 1;
    }
    assert!(colours[0] > 200 && colours[1] > 200, "{colours:?}");
}

/// Two mirrors face each other: every level of the tree costs one ray, up to the limit.
#[test]
fn the_depth_limit_counts_rays() {
    for depth in [0, 1, 2, 7, bounce::MAX_DEPTH, 1000] {
        let mut stage = Stage::new(view([0.0, 0.0, 0.0], [0.0, 0.0, -4.0]));
        stage.materials = vec![mirror()];
        stage.max_depth = depth;
        stage.triangles = quad([-90.0, -90.0, -2.0], [180.0, 0.0, 0.0], [0.0, 180.0, 0.0], 0).to_vec();
        stage.triangles.extend(quad([-90.0, -90.0, 2.0], [180.0, 0.0, 0.0], [0.0, 180.0, 0.0], 0));
        let stages = render(&stage);
        let centre = (SIDE * SIDE / 2 + SIDE / 2) as usize;
        assert_eq!(stages.counts[2][centre].reflected, depth.min(bounce::MAX_DEPTH));
        assert_eq!(stages.counts[0][centre].primary, 1);
    }
}

#[test]
fn rays_of_no_weight_are_not_traced() {
    let mut stage = floor(Material { reflection: 0.0009, ..white() });
    assert_eq!(render(&stage).counts[2].iter().map(|c| c.reflected).max(), Some(0));
    stage.materials[0].reflection = 0.002;
    assert_eq!(render(&stage).counts[2].iter().map(|c| c.reflected).max(), Some(1));
}

#[test]
fn a_pane_of_glass_of_the_same_index_is_invisible() {
    let mut stage = floor(Material { eta: 1.0, ..glass() });
    stage.triangles.clear();
    stage.spheres = vec![sphere([0.0, 0.5, 0.0], 1.0, 0)];
    let stages = render(&stage);
    for pixel in 0..stages.hits.len() {
        assert_close(
            colour(&stages, pixel),
            sky(&stage, direction(&stage.view, pixel)),
            1e-4,
            "straight through",
        );
    }
}

#[test]
fn a_texture_stands_upright_on_a_quad() {
    let (texture, texels) = picture();
    let mut stage = Stage::new(view([0.0, 0.0, 4.0], [0.0, 0.0, 0.0]));
    stage.ambient = [1.0; 3];
    stage.materials = vec![Material { texture: 0, ambient: 1.0, ..white() }];
    (stage.textures, stage.texels) = (vec![texture], texels);
    stage.triangles = quad([-1.5, -1.0, 0.0], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0], 0).to_vec();
    let stages = render(&stage);
    for (pixel, surface) in stages.surfaces.iter().enumerate().filter(|(_, s)| s.prim_id != NONE) {
        let [x, y, _] = surface.position;
        let [u, v] = surface.uv;
        assert!((u - (x + 1.5) / 3.0).abs() < 1e-5 && (v - (y + 1.0) / 2.0).abs() < 1e-5);
        if (x - 1.0).abs() < 0.04 && (y - 0.5).abs() < 0.04 {
            assert!((colour(&stages, pixel).x - 2.0).abs() < 0.2, "upper right is texel 2");
        }
    }
}

#[test]
fn the_sky_map_has_its_middle_ahead_and_its_top_above() {
    let mut stage = Stage::new(view([0.0; 3], [0.0, 0.0, -4.0]));
    stage.materials = vec![white()];
    // Eight columns, four rows; red counts columns, green rows.
    stage.textures = vec![Texture { first: 0, width: 8, height: 4, padding: 0 }];
    stage.texels = (0..32).map(|i| [(i % 8) as f32, (i / 8) as f32, 0.0, 1.0]).collect();
    stage.sky_texture = 0;
    let stages = render(&stage);
    for pixel in 0..stages.hits.len() {
        let dir = direction(&stage.view, pixel);
        let u = dir.x.atan2(-dir.z) / std::f64::consts::TAU + 0.5;
        let down = dir.y.acos() / std::f64::consts::PI;
        let want = DVec3::new(u * 8.0 - 0.5, down * 4.0 - 0.5, 0.0);
        assert_close(colour(&stages, pixel), want, 1e-4, "map");
    }
}

#[test]
fn normals_are_interpolated_and_face_the_eye() {
    let mut smooth = triangle([[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [0.0, 3.0, 0.0]], 0);
    let tilted = |x: f32, y: f32| Vec3::new(x, y, -1.0).normalize().to_array();
    // The vertex normals point to the other side than the vertices' order says.
    (smooth.smooth, smooth.normals) = (1, [tilted(-0.5, -0.5), tilted(0.5, -0.5), tilted(0.0, 0.5)]);
    for z in [4.0, -4.0] {
        let mut stage = Stage::new(view([0.0, 0.0, z], [0.0, 0.0, 0.0]));
        stage.materials = vec![white()];
        stage.triangles = vec![smooth];
        let stages = render(&stage);
        let mut count = 0;
        for surface in stages.surfaces.iter().filter(|s| s.prim_id != NONE) {
            count += 1;
            assert_eq!(surface.normal, [0.0, 0.0, z.signum()]);
            assert_eq!(surface.material, if z > 0.0 { 0 } else { BACK });
            let shading = Vec3::from(surface.shading_normal);
            assert!(shading.z * z > 0.0 && (shading.length() - 1.0).abs() < 1e-6);
            let [x, y, _] = surface.position;
            let w = (y + 2.0) / 5.0;
            let v = (x + 2.0 - 2.0 * w) / 4.0;
            let [a, b, c] = smooth.normals.map(Vec3::from);
            let want = (a * (1.0 - v - w) + b * v + c * w).normalize() * -z.signum();
            assert_close(shading, want.as_dvec3(), 1e-5, "shading normal");
        }
        assert!(count > 100);
    }
}

#[test]
fn an_empty_scene_is_sky() {
    let mut stage = Stage::new(view([0.0, 1.0, 3.0], [0.0; 3]));
    (stage.zenith, stage.horizon) = ([0.0, 0.0, 1.0], [1.0, 1.0, 1.0]);
    stage.lights = vec![Light { colour: [1.0; 3], ..light([0.0; 3], [1.0; 3]) }];
    let stages = render(&stage);
    for pixel in 0..stages.hits.len() {
        assert_eq!((stages.hits[pixel].prim_id, stages.hits[pixel].t), (NONE, f32::INFINITY));
        assert_eq!(stages.seen[pixel], 0);
        assert_close(colour(&stages, pixel), sky(&stage, direction(&stage.view, pixel)), 1e-6, "sky");
        assert!(math::is_finite(stages.surfaces[pixel].disparity));
    }
}
