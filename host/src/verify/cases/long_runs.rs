//! Many frames, many lights, large pictures.

use crate::render::RenderError;
use crate::rig::StereoRig;
use crate::verify::Outcome;
use crate::verify::input::small_scenes::ball_under_lamp;
use crate::verify::input::stage::{Stage, Stages, light};
use crate::verify::suite::Suite;
use parallax_kernels::arithmetic::{SIDE, operation::PIXEL};
use parallax_shared::layout::View;
use parallax_shared::stereo::source;

/// Frame N is made from N alone: after 10⁴ frames of a whole turn the eyes are where they began, bit for bit, and on the way within
/// rounding of where f64 has them.
///
/// Guard: views are derived from the rig alone, in f64, and keep no state (`StereoRig::views`).
pub fn ten_thousand_frames_do_not_drift(suite: &mut Suite) -> Outcome {
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
    let first: Vec<[View; 2]> = (0..1000).map(|frame| rig(frame).views(1.0)).collect::<Result<_, _>>()?;
    for frame in 0..FRAMES {
        let views = rig(frame).views(1.0)?;
        let (view, before) = (&views[0], &first[frame as usize % 1000][0]);
        let is_same = bytemuck::bytes_of(view) == bytemuck::bytes_of(before);
        suite.check(is_same, || format!("frame {frame} is not as it was a turn before"));
        let angle = f64::from(frame % 1000) * std::f64::consts::TAU / 1000.0;
        let middle = |k: usize| 0.5 * (f64::from(views[0].eye[k]) + f64::from(views[1].eye[k]));
        let expected = [5.0 * angle.sin(), 1.0, 5.0 * angle.cos()];
        for (k, expected) in expected.into_iter().enumerate() {
            suite.check((middle(k) - expected).abs() < 2e-6, || {
                format!("frame {frame}: {} not {expected}", middle(k))
            });
        }
    }
    suite.tried(FRAMES as usize);
    Ok(())
}

/// 4090 lights have a bit each in 128 words, in order, and the sum of their light is that of one light as bright. On the CPU; 500 on both
/// backends, as lavapipe ends loops after 65,535 rounds of an invocation in all (`probes` tells), which 4090 rays exceed.
///
/// Guard: words are counted in whole ones from the number of lights (`shadow::words`).
pub fn four_thousand_lights_have_a_bit_each(suite: &mut Suite) -> Outcome {
    assert_adds_up(suite, 500, |suite, stage| suite.stages(stage))?;
    assert_adds_up(suite, 4090, |suite, stage| stage.render(suite.cpu))
}

fn assert_adds_up(
    suite: &mut Suite,
    lights: usize,
    render: impl Fn(&mut Suite, &Stage) -> Result<Stages, RenderError>,
) -> Outcome {
    let mut stage = ball_under_lamp();
    let place = [0.0, 4.0, 0.0];
    stage.lights = vec![light(place, [1.0 / lights as f32; 3]); lights];
    // One that nothing sees, below the floor.
    stage.lights[lights - 1].position = [0.0, -4.0, 0.0];
    let many = render(suite, &stage)?;
    stage.lights = vec![light(place, [(lights - 1) as f32 / lights as f32; 3])];
    let one = render(suite, &stage)?;
    let words = lights.div_ceil(32);
    suite.check(many.seen.len() == words * many.hits.len(), || {
        format!("{lights} lights have not {words} words")
    });
    // The bits of the last word, of which the topmost is that of the hidden light.
    let (own, hidden) = (u32::MAX >> (32 * words - lights), 1 << ((lights - 1) % 32));
    for (pixel, (seen, lit)) in many.seen.chunks_exact(words).zip(&one.seen).enumerate() {
        let (last, rest) = (seen[words - 1], &seen[..words - 1]);
        let expected = if *lit == 1 { u32::MAX } else { 0 };
        let is_as_one = rest.iter().all(|word| *word == expected) && last == expected & own & !hidden;
        suite.check(is_as_one, || format!("pixel {pixel} of {lights} lights: {last:08x}, {rest:x?}"));
        let (a, b) = (many.colours[pixel], one.colours[pixel]);
        // So many sums, each rounded by half an ULP of what is there.
        suite.check((0..3).all(|k| (a[k] - b[k]).abs() < 3e-4), || format!("pixel {pixel}: {a:?} {b:?}"));
    }
    suite.tried(lights * many.hits.len());
    Ok(())
}

/// Index arithmetic of pictures of 16384 × 16384, the last pixel included: no two pixels share an index, none leaves 32 bits, and a
/// source's column fits its word.
///
/// Guard: a pixel's word has 16 bits for the column (`stereo::source`).
pub fn large_pictures_are_addressed_without_overflow(suite: &mut Suite) -> Outcome {
    let (mut columns, mut rows) = (Vec::new(), Vec::new());
    for row in (0..SIDE).step_by(1021).chain([SIDE - 1]) {
        for x in (0..SIDE).step_by(17).chain([SIDE - 1]) {
            columns.push(x);
            rows.push(row);
        }
    }
    let indices = suite.same_values("index of a pixel", PIXEL, &columns, &rows)?;
    for ((x, row), index) in columns.into_iter().zip(rows).zip(indices) {
        let column = SIDE - 1 - x;
        let wide = u64::from(row) * u64::from(SIDE) + u64::from(column);
        suite.check(u64::from(index) == wide, || format!("column {x}, row {row}: {index}, not {wide}"));
        let word = source::from_column(source::VERIFIED, column);
        let read = (source::column(word), source::kind(word));
        suite.check(read == (column, source::VERIFIED), || format!("column {column} is read as {read:?}"));
    }
    Ok(())
}
