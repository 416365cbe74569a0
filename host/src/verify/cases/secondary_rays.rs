//! Rays that leave a surface: no acne, no leak, in corners and far from the origin.

use crate::verify::Outcome;
use crate::verify::input::small_scenes::view;
use crate::verify::input::stage::{Stage, light, quad, white};
use crate::verify::suite::Suite;

/// A closed box from `low`, of the width `size`, seen from inside, with lights within (even numbers) and without (odd ones).
fn room(low: [f32; 3], size: f32) -> Stage {
    let at = |x: f32, y: f32, z: f32| [low[0] + x * size, low[1] + y * size, low[2] + z * size];
    let mut stage = Stage::new(view(at(0.25, 0.75, 0.75), at(0.875, 0.125, 0.125)));
    stage.materials = vec![white()];
    let [x, y, z] = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
    for (corner, u, v) in [
        (at(0.0, 0.0, 0.0), x, y),
        (at(0.0, 0.0, 1.0), x, y),
        (at(0.0, 0.0, 0.0), y, z),
        (at(1.0, 0.0, 0.0), y, z),
        (at(0.0, 0.0, 0.0), x, z),
        (at(0.0, 1.0, 0.0), x, z),
    ] {
        stage.triangles.extend(quad(corner, u, v, 0));
    }
    for i in 0..16 {
        let place = |k: u32| if i >> k & 1 == 0 { 0.0625 } else { 0.9375 };
        let within = at(place(0), place(1), if i < 8 { place(2) } else { 0.5 });
        let mut without = within;
        without[i % 3] = low[i % 3] + if i % 2 == 0 { -0.0625 } else { 1.0625 } * size;
        stage.lights.extend([light(within, [0.1; 3]), light(without, [0.1; 3])]);
    }
    stage
}

/// In a convex room every light that a wall faces is seen from everywhere, corners too, and none from outside comes in.
///
/// Guard: secondary rays begin off the surface by the error bound of what was computed (`surface::leave`).
pub fn rooms_have_no_acne_and_no_leak(suite: &mut Suite) -> Outcome {
    let mut rays = 0;
    for (low, size) in [
        ([-0.5; 3], 1.0),
        ([0.0; 3], 1e-3),
        ([100.0, -300.0, 7.0], 8.0),
        ([1e6, -1e6, 5e5], 1024.0),
        ([-5e5; 3], 1e6),
    ] {
        let all = suite.stages(&room(low, size))?;
        for (pixel, seen) in all.seen.iter().enumerate() {
            let faced = all.counts[1][pixel].shadow;
            suite.check(seen & 0xaaaa_aaaa == 0, || {
                format!("size {size} at {low:?}: a leak at {:?}", all.surfaces[pixel])
            });
            suite.check(seen.count_ones() <= faced, || {
                format!("pixel {pixel} sees more lights than it faces")
            });
            rays += faced as usize;
        }
        // Without the lights outside, what is faced is seen.
        let mut within = room(low, size);
        within.lights = within.lights.into_iter().step_by(2).collect();
        let inner = suite.stages(&within)?;
        for (pixel, seen) in inner.seen.iter().enumerate() {
            let faced = inner.counts[1][pixel].shadow;
            suite.check(seen.count_ones() == faced, || {
                format!("size {size} at {low:?}: acne at {:?}", inner.surfaces[pixel])
            });
        }
    }
    suite.check(rays > 100_000, || format!("{rays}"));
    suite.tried(rays);
    Ok(())
}
