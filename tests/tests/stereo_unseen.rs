//! What only the second eye sees: beside the source's picture, in front of the zero-parallax plane (001 fig. 14; 003 §5.5.1).

use parallax::render::{First, Method, SceneData, StereoOptions, Verify};
use parallax::rig::StereoRig;
use parallax::scene::{Scene, Sky, Sphere};
use parallax_shared::stereo::source;
use parallax_tests::stage::white;
use parallax_tests::stereo::{ORDERS, REPROJECTING, inferred, naive, pair, verified};

const WIDTH: u32 = 96;

/// A sky, a far wall of spheres, and a ball in front of the plane that only the second eye sees when `beside` is its place in x as
/// seen on the plane (in halves of the picture's width).
fn with_ball(first: First, beside: f32) -> SceneData {
    let rig = StereoRig {
        eye: [0.0, 0.0, 4.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        vertical_fov_deg: 40.0,
        width: WIDTH,
        height: 64,
        interaxial_px: 12.0,
        zero_parallax: 4.0,
    };
    let half = 4.0 * (20.0_f32).to_radians().tan() * 1.5;
    let side = if first == First::Left { 1.0 } else { -1.0 };
    let sphere = |centre, radius| Sphere { centre, radius, material: 0, padding: [0; 3] };
    // At half the distance to the plane everything is half as wide.
    let ball = sphere([side * beside * half * 0.5, 0.0, 2.0], 0.03);
    let wall = (-20..=20).map(|i| sphere([i as f32, 0.0, -6.0], 1.0));
    let scene = Scene {
        name: "ball".into(),
        rig,
        ambient: [1.0; 3],
        lights: vec![],
        sky: Sky::Gradient { zenith: [0.2; 3], horizon: [0.1; 3] },
        max_depth: 0,
        materials: vec![parallax::scene::Material { ambient: 1.0, ..white() }],
        textures: vec![],
        triangles: vec![],
        spheres: std::iter::once(ball).chain(wall).collect(),
        ellipsoids: vec![],
        warnings: vec![],
    };
    SceneData::new(&scene, Default::default()).unwrap()
}

fn pixels_of_ball(hits: &[parallax_shared::layout::Hit]) -> usize {
    hits.iter().filter(|hit| hit.prim_id == 0).count()
}

#[test]
fn a_ball_that_only_the_second_eye_sees_is_found_by_all_methods() {
    for first in ORDERS {
        let data = with_ball(first, 0.98);
        let truth = naive(&data, first);
        let there = pixels_of_ball(&truth.hits);
        let options = verified(Method::Atomic, Verify::None, first);
        assert_eq!(pixels_of_ball(&pair(&data, &options).source.hits), 0, "the source must not see it");
        assert!(there > 0, "the second eye must");
        for method in REPROJECTING {
            for verify in [Verify::None, Verify::Edges, Verify::All] {
                let shown = inferred(pair(&data, &verified(method, verify, first)));
                assert_eq!(pixels_of_ball(&shown.hits), there, "{first:?}, {}, {verify:?}", method.name());
            }
        }
        let copied = StereoOptions { first, ..Method::Ideal.into() };
        assert_eq!(pixels_of_ball(&pair(&data, &copied).second.hits), 0, "a copy loses it");
    }
}

/// A strip is verified only for what may be there.
#[test]
fn without_anything_beside_nothing_is_verified_for_it() {
    for first in ORDERS {
        let options = verified(Method::Atomic, Verify::None, first);
        let verified_pixels = |data: &SceneData| {
            let shown = inferred(pair(data, &options));
            shown.inferred.source.iter().filter(|&&word| source::kind(word) == source::VERIFIED).count()
        };
        assert_eq!(verified_pixels(&with_ball(first, 0.0)), 0);
        assert!(verified_pixels(&with_ball(first, 0.98)) > 0);
    }
}
