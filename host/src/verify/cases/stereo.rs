//! Points near the eyes' plane, negative parallax, pillars a pixel wide, walls between the eyes: pairs and positions.

use crate::render::{First, Method, RenderError, SceneData, StereoOptions, Verify};
use crate::rig::StereoRig;
use crate::scene::{Scene, Sky, Triangle};
use crate::verify::Outcome;
use crate::verify::input::pairs::{REPROJECTING, verified};
use crate::verify::input::reference::{direction, wide};
use crate::verify::input::stage::{quad, white};
use crate::verify::suite::Suite;
use glam::DVec3;
use parallax_kernels::arithmetic::operation::SHIFT;
use parallax_shared::camera::disparity_px;
use parallax_shared::layout::{NONE, View};

fn scene(triangles: Vec<Triangle>, interaxial_px: f32) -> Result<SceneData, RenderError> {
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
        materials: vec![crate::scene::Material { ambient: 1.0, ..white() }],
        textures: vec![],
        triangles,
        spheres: vec![],
        ellipsoids: vec![],
        warnings: vec![],
    };
    SceneData::new(&scene, Default::default())
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

fn scenes() -> Result<Vec<(&'static str, SceneData)>, RenderError> {
    let pixel = 4.0 * 2.0 * 20f32.to_radians().tan() / 24.0;
    let with = |a: Vec<Triangle>, b: Vec<Triangle>| a.into_iter().chain(b).collect::<Vec<_>>();
    Ok(vec![
        ("pillars a pixel wide", scene(with(pillars(0.0, pixel), wall(-6.0)), 12.0)?),
        ("pillars in front of the plane", scene(with(pillars(2.0, 0.5 * pixel), wall(-6.0)), 12.0)?),
        ("equal depths", scene(with(pillars(-1.0, 0.4), wall(-1.0)), 12.0)?),
        (
            "a wall between the eyes",
            scene(
                with(quad([0.0, -9.0, 3.99], [0.0, 0.0, -4.0], [0.0, 18.0, 0.0], 0).into(), wall(-6.0)),
                12.0,
            )?,
        ),
        ("just in front of the eyes", scene(with(pillars(3.999, 1e-4), wall(-6.0)), 12.0)?),
        ("sky alone", scene(vec![], 12.0)?),
        ("pillars before the sky", scene(pillars(-3.0, pixel), 12.0)?),
        ("eyes wider apart than the picture", scene(with(pillars(1.0, pixel), wall(-6.0)), 300.0)?),
        ("no distance between the eyes", scene(with(pillars(1.0, pixel), wall(-6.0)), 0.0)?),
    ])
}

/// All methods, fully verified, from both eyes: nothing is nearer than what they show by more than a pixel of disparity.
///
/// Guard: what is asked to be verified is (`stereo::settle::Plan`). Other tests hold what is verified without being asked
/// (`stereo_unseen`) and which column wins (`stereo_tables`).
pub fn pairs_hide_nothing_that_is_nearer(suite: &mut Suite) -> Outcome {
    for (name, data) in scenes()? {
        let disparity = |t: f32| disparity_px(data.views[0].interaxial_px, t);
        for first in [First::Left, First::Right] {
            let truth = suite.pair(&data, &StereoOptions { first, ..StereoOptions::default() })?.second.hits;
            for method in REPROJECTING {
                let shown = suite.pair(&data, &verified(method, Verify::All, first))?.second.hits;
                for (shown, truth) in shown.iter().zip(&truth) {
                    let (shown, truth) = (disparity(shown.t), disparity(truth.t));
                    suite.check(truth >= shown - 1.001, || {
                        format!("{name}, {first:?}, {}: {truth} is nearer than {shown}", method.name())
                    });
                }
                suite.tried(truth.len());
            }
        }
    }
    Ok(())
}

/// The same scenes by all methods: every stage of both views has the same bits on both backends.
pub fn pairs_have_the_same_bits(suite: &mut Suite) -> Outcome {
    let traced = [StereoOptions::default(), Method::Guided.into()];
    for (name, data) in scenes()? {
        for options in traced {
            suite.compare_pair(name, &data, &options)?;
        }
        for method in REPROJECTING {
            suite.compare_pair(name, &data, &verified(method, Verify::Edges, First::Left))?;
        }
    }
    Ok(())
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
pub fn reprojected_positions_are_within_half_a_pixel(suite: &mut Suite) -> Outcome {
    for (name, data) in scenes()? {
        let source = suite.pair(&data, &verified(Method::Atomic, Verify::None, First::Left))?.source.hits;
        let [left, right] = &data.views;
        let seen: Vec<_> = (0u32..).zip(&source).filter(|(_, hit)| hit.prim_id != NONE).collect();
        let depths: Vec<_> = seen.iter().map(|(_, hit)| hit.t.to_bits()).collect();
        let eyes = vec![left.interaxial_px.to_bits(); depths.len()];
        let shifts = suite.same_values("shift", SHIFT, &eyes, &depths)?;
        for ((i, hit), shift) in seen.into_iter().zip(shifts) {
            let (x, y) = (i % left.width, i / left.width);
            let dir = direction(left, f64::from(x), f64::from(y));
            let expected = column(right, wide(left.eye) + dir * f64::from(hit.t));
            let got = f64::from(x as i32 + shift as i32);
            // What 24 digits of the views' vectors leave of a position.
            let rounding = 1e-4 * (1.0 + f64::from(left.interaxial_px) / f64::from(hit.t) / 100.0);
            suite.check((got - expected).abs() <= 0.5 + rounding, || {
                format!("{name}: {got}, not {expected}, t {}", hit.t)
            });
        }
    }
    Ok(())
}
