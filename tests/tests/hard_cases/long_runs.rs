//! Many frames, many lights, large pictures.

use super::backends::{stages, tried};
use parallax::rig::StereoRig;
use parallax_shared::layout::Reprojection;
use parallax_shared::stereo::{reprojection, source};
use parallax_tests::small_scenes::{ball_under_lamp, render};
use parallax_tests::stage::{Stage, Stages, light};

/// Frame N is made from N alone: after 10⁴ frames of a whole turn the eyes are where they began, bit for bit, and on the way within
/// rounding of where f64 has them.
///
/// Guard: views are derived from the rig in f64 and keep no state (`StereoRig::views`).
#[test]
fn ten_thousand_frames_do_not_drift() {
    const FRAMES: u32 = 10_000;
    let rig = |frame: u32| {
        let angle = f64::from(frame % 1000) * std::f64::consts::TAU / 1000.0;
        StereoRig {
            eye: [(5.0 * angle.sin()) as f32, 1.0, (5.0 * angle.cos()) as f32],
            target: [0.0, 0.5, 0.0],
            up: [0.0, 1.0, 0.0],
            vertical_fov_deg: 40.0,
            width: 640,
            height: 480,
            interaxial_px: 15.0,
            zero_parallax: 5.0,
        }
    };
    let first: Vec<_> = (0..1000).map(|frame| rig(frame).views(1.0).unwrap()).collect();
    for frame in 0..FRAMES {
        let views = rig(frame).views(1.0).unwrap();
        assert!(
            bytemuck::bytes_of(&views[0]) == bytemuck::bytes_of(&first[frame as usize % 1000][0]),
            "{frame}"
        );
        let angle = f64::from(frame % 1000) * std::f64::consts::TAU / 1000.0;
        let middle = |k: usize| 0.5 * (f64::from(views[0].eye[k]) + f64::from(views[1].eye[k]));
        let expected = [5.0 * angle.sin(), 1.0, 5.0 * angle.cos()];
        for (k, expected) in expected.into_iter().enumerate() {
            assert!((middle(k) - expected).abs() < 2e-6, "frame {frame}: {} not {expected}", middle(k));
        }
    }
    tried("long runs/frames", FRAMES as usize);
}

/// 4096 lights have a bit each in 128 words, in order, and the sum of their light is that of one light as bright. On the CPU; 512 on both
/// backends, as lavapipe leaves loops after so many iterations of an invocation in all (65,535 in its source), which 4096 rays exceed.
///
/// Guard: words are counted in whole ones from the number of lights (`shadow::words`).
#[test]
fn four_thousand_lights_have_a_bit_each() {
    assert_adds_up(512, stages);
    assert_adds_up(4096, render);
}

fn assert_adds_up(lights: usize, render: impl Fn(&Stage) -> Stages) {
    let mut stage = ball_under_lamp();
    let place = [0.0, 4.0, 0.0];
    stage.lights = vec![light(place, [1.0 / lights as f32; 3]); lights];
    // One that nothing sees, below the floor.
    stage.lights[lights - 1].position = [0.0, -4.0, 0.0];
    let many = render(&stage);
    stage.lights = vec![light(place, [(lights - 1) as f32 / lights as f32; 3])];
    let one = render(&stage);
    let words = lights / 32;
    for pixel in 0..many.hits.len() {
        let (last, rest) = many.seen[pixel * words..][..words].split_last().unwrap();
        let expected = if one.seen[pixel] == 1 { u32::MAX } else { 0 };
        assert!(rest.iter().all(|word| *word == expected), "pixel {pixel}");
        assert_eq!(*last & 0x7fff_ffff, expected & 0x7fff_ffff, "pixel {pixel}");
        assert_eq!(*last >> 31, 0, "pixel {pixel} sees a light behind the floor");
        let (a, b) = (many.colours[pixel], one.colours[pixel]);
        // So many sums, each rounded by half an ULP of what is there.
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 3e-4), "pixel {pixel}: {a:?} {b:?}");
    }
    tried("long runs/lights", lights * many.hits.len());
}

/// Index arithmetic of pictures of 16384 × 16384, the last pixel included: no two pixels share an index, none leaves 32 bits, and a
/// source's column fits its word.
///
/// Guard: a pixel's word has 16 bits for the column (`stereo::source`).
#[test]
fn large_pictures_are_addressed_without_overflow() {
    const SIDE: u32 = 16_384;
    let mut cases = 0;
    for mirrored in [0, 1] {
        let p = Reprojection { width: SIDE, rows: SIDE, mirrored, ..bytemuck::Zeroable::zeroed() };
        for row in (0..SIDE).step_by(1021).chain([SIDE - 1]) {
            for x in (0..SIDE).step_by(17).chain([SIDE - 1]) {
                let column = if mirrored == 1 { SIDE - 1 - x } else { x };
                let wide = u64::from(row) * u64::from(SIDE) + u64::from(column);
                assert_eq!(u64::from(reprojection::pixel(&p, x, row)), wide);
                let word = source::from_column(source::VERIFIED, column);
                assert_eq!((source::column(word), source::kind(word)), (column, source::VERIFIED));
                cases += 1;
            }
        }
    }
    tried("long runs/16k addressing", cases);
}
