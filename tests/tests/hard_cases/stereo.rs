//! Points near the eyes' plane, negative parallax, pillars a pixel wide, walls between the eyes: pairs and positions.

use super::backends::tried;
use glam::DVec3;
use parallax::backend::Profile;
use parallax::render::{First, Method, SceneData, Verify};
use parallax::rig::StereoRig;
use parallax::scene::{Scene, Sky, Triangle};
use parallax_shared::camera::disparity_px;
use parallax_shared::layout::{NONE, View};
use parallax_shared::stereo::reprojection::shift_px;
use parallax_tests::gpu::{Driver, open};
use parallax_tests::oracle::{direction, wide};
use parallax_tests::stage::{quad, white};
use parallax_tests::stereo::{REPROJECTING, inferred, naive, pair, pair_on, verified};

fn scene(triangles: Vec<Triangle>, interaxial_px: f32) -> SceneData {
    let rig = StereoRig {
        eye: [0.0, 0.0, 4.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        vertical_fov_deg: 40.0,
        width: 96,
        height: 24,
        interaxial_px,
        zero_parallax: 4.0,
    };
    let scene = Scene {
        name: "hard".into(),
        rig,
        ambient: [1.0; 3],
        lights: vec![],
        sky: Sky::Gradient { zenith: [0.2; 3], horizon: [0.1; 3] },
        max_depth: 0,
        materials: vec![parallax::scene::Material { ambient: 1.0, ..white() }],
        textures: vec![],
        triangles,
        spheres: vec![],
        ellipsoids: vec![],
        warnings: vec![],
    };
    SceneData::new(&scene, Default::default()).unwrap()
}

/// A wall across the view at depth `z`.
fn wall(z: f32) -> Vec<Triangle> {
    quad([-40.0, -40.0, z], [80.0, 0.0, 0.0], [0.0, 80.0, 0.0], 0).to_vec()
}

/// Upright strips `width` wide, at z, every half a unit.
fn pillars(z: f32, width: f32) -> Vec<Triangle> {
    (-12..=12)
        .flat_map(|i| quad([i as f32 * 0.51, -9.0, z], [width, 0.0, 0.0], [0.0, 18.0, 0.0], 0))
        .collect()
}

fn scenes() -> Vec<(&'static str, SceneData)> {
    let pixel = 4.0 * 2.0 * 20f32.to_radians().tan() / 24.0;
    let with = |a: Vec<Triangle>, b: Vec<Triangle>| a.into_iter().chain(b).collect::<Vec<_>>();
    vec![
        ("pillars a pixel wide", scene(with(pillars(0.0, pixel), wall(-6.0)), 12.0)),
        ("pillars in front of the plane", scene(with(pillars(2.0, 0.5 * pixel), wall(-6.0)), 12.0)),
        ("equal depths", scene(with(pillars(-1.0, 0.4), wall(-1.0)), 12.0)),
        (
            "a wall between the eyes",
            scene(
                with(quad([0.0, -9.0, 3.99], [0.0, 0.0, -4.0], [0.0, 18.0, 0.0], 0).into(), wall(-6.0)),
                12.0,
            ),
        ),
        ("just in front of the eyes", scene(with(pillars(3.999, 1e-4), wall(-6.0)), 12.0)),
        ("sky alone", scene(vec![], 12.0)),
        ("pillars before the sky", scene(pillars(-3.0, pixel), 12.0)),
        ("eyes wider apart than the picture", scene(with(pillars(1.0, pixel), wall(-6.0)), 300.0)),
        ("no distance between the eyes", scene(with(pillars(1.0, pixel), wall(-6.0)), 0.0)),
    ]
}

/// All methods, fully verified, in both backends: the same pair, and nothing nearer than what they show by more than a pixel of disparity.
///
/// Guards: candidates in gaps and in the strip that only one eye sees are verified, and of equal depths the right column wins
/// (`stereo::settle`, `stereo::run`, `render::stereo::unseen`).
#[test]
fn pairs_hide_nothing_that_is_nearer() {
    let mut gpu = open(Driver::Lavapipe, Profile::Strict);
    let mut pixels = 0;
    for (name, data) in scenes() {
        for first in [First::Left, First::Right] {
            let truth = naive(&data, first);
            for method in REPROJECTING {
                let options = verified(method, Verify::All, first);
                let made = pair(&data, &options);
                if let (Some(gpu), Method::Atomic) = (&mut gpu, method) {
                    let other = pair_on(gpu, &data, &options);
                    let bits = |pair: &parallax::render::band::Pair| {
                        bytemuck::cast_slice::<_, u32>(pair.second.colour()).to_vec()
                    };
                    assert!(bits(&made) == bits(&other), "{name}, {first:?}: CPU and GPU");
                }
                let shown = inferred(made);
                for (shown, truth) in shown.hits.iter().zip(&truth.hits) {
                    let disparity = |t: f32| disparity_px(data.views[0].interaxial_px, t);
                    let (shown, truth) = (disparity(shown.t), disparity(truth.t));
                    assert!(
                        truth >= shown - 1.001,
                        "{name}, {first:?}, {}: {truth} is nearer than {shown}",
                        method.name()
                    );
                }
                pixels += truth.hits.len();
            }
        }
    }
    tried("stereo/pairs", pixels);
}

/// Column of a point in a view, in f64.
fn column(view: &View, point: DVec3) -> f64 {
    let from_eye = point - wide(view.eye);
    let t = from_eye.dot(wide(view.forward)) / f64::from(view.distance);
    let step = wide(view.step_x);
    (from_eye / t - wide(view.corner)).dot(step) / step.length_squared()
}

/// Every hit of every scene, seen by the left eye, is put within half a pixel of where f64 projects it in the right eye's view.
///
/// Guard: the shift is the disparity rounded to the nearest, half up (`reprojection::shift_px`).
#[test]
fn reprojected_positions_are_within_half_a_pixel() {
    let mut cases = 0;
    for (name, data) in scenes() {
        let source = pair(&data, &verified(Method::Atomic, Verify::None, First::Left)).source;
        let [left, right] = &data.views;
        for (i, hit) in source.hits.iter().enumerate().filter(|(_, hit)| hit.prim_id != NONE) {
            let (x, y) = (i as u32 % left.width, i as u32 / left.width);
            let dir = direction(left, f64::from(x), f64::from(y));
            let expected = column(right, wide(left.eye) + dir * f64::from(hit.t));
            let got = f64::from(x as i32 + shift_px(disparity_px(left.interaxial_px, hit.t)));
            // What 24 digits of the views' vectors leave of a position.
            let rounding = 1e-4 * (1.0 + f64::from(left.interaxial_px) / f64::from(hit.t) / 100.0);
            assert!((got - expected).abs() <= 0.5 + rounding, "{name}: {got}, not {expected}, t {}", hit.t);
            cases += 1;
        }
    }
    tried("stereo/reprojected positions", cases);
}
