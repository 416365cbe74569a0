//! Rays that leave a surface: no acne, no leak, in corners and far from the origin.

use crate::verify::Outcome;
use crate::verify::input::small_scenes::room;
use crate::verify::input::stage::{Stage, quad};
use crate::verify::suite::Suite;

/// A closed box from `low`, of the width `size`.
fn box_from(low: [f32; 3], size: f32) -> Stage {
    let at = |p: [f32; 3]| [0, 1, 2].map(|k| low[k] + p[k] * size);
    let [x, y, z] = [[size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
    let walls = [
        ([0.0, 0.0, 0.0], x, y),
        ([0.0, 0.0, 1.0], x, y),
        ([0.0, 0.0, 0.0], y, z),
        ([1.0, 0.0, 0.0], y, z),
        ([0.0, 0.0, 0.0], x, z),
        ([0.0, 1.0, 0.0], x, z),
    ];
    room(walls.into_iter().flat_map(|(corner, u, v)| quad(at(corner), u, v, 0)).collect(), at)
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
        let all = suite.stages(&box_from(low, size))?;
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
        let mut within = box_from(low, size);
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
