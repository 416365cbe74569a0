//! Which lights points see, with what is known of all points of a tile, and of points that another view shows.
//!
//! Of each tile of a view and each light it is known whether nothing can hide the light from any point of a box around the tile's points
//! ([`crate::traversal::shaft`]). A point in the box, of whichever view, then needs no ray. And what hides a light from a point is likely
//! to hide it from where another view shows the same surface. The answers are those of a walk through everything, bit for bit: the proof
//! is one, and the guess is tried.

use super::{light, shadow, surface};
use crate::effects::Effects;
use crate::layout::{NONE, RayCounts, Surface, View};
use crate::math::{max, min};
use crate::scene::SceneView;
use crate::traversal::occluder::occluder;
use crate::traversal::rules::Exact;
use crate::traversal::shaft::{Shaft, is_clear};
use glam::Vec3;
use kernel_api::At;

/// Side of a tile in pixels, a power of two.
pub const TILE: u32 = 8;
/// Words of a tile's box: the smallest x, y, z and the largest ones.
const BOX: u32 = 6;

/// How many words a tile has: its box, then one for each light, 1 if nothing can hide it.
#[inline(always)]
pub fn words(lights: u32) -> u32 {
    BOX + lights
}

/// Tiles along a side of so many pixels.
#[inline(always)]
pub fn tiles(pixels: u32) -> u32 {
    (pixels + (TILE - 1)) >> TILE.trailing_zeros()
}

/// Number of the tile of a pixel in a band of `view`.
#[inline(always)]
pub fn tile_of(view: &View, x: u32, y: u32) -> u32 {
    (y / TILE) * tiles(view.width) + x / TILE
}

/// A tile of a band.
#[derive(Clone, Copy)]
pub struct Tile {
    /// Its number.
    pub number: u32,
    /// How many pixels it has; none beyond the band.
    pub count: u32,
    corner: u32,
    width: u32,
}

impl Tile {
    /// The tile in column `x` and line `y` of the tiles of a band of `view`.
    #[inline(always)]
    pub fn new(view: &View, x: u32, y: u32) -> Self {
        let side = |at: u32, pixels: u32| {
            let left = pixels.saturating_sub(at * TILE);
            if left < TILE { left } else { TILE }
        };
        let (width, height) = (side(x, view.width), side(y, view.rows));
        let corner = y * TILE * view.width + x * TILE;
        Self { number: y * tiles(view.width) + x, count: width * height, corner, width }
    }

    /// Its pixel `i`, which must be below `count`.
    #[inline(always)]
    pub fn pixel(&self, view: &View, i: u32) -> u32 {
        let (mut x, mut line) = (i, 0);
        while x >= self.width && line < TILE {
            x -= self.width;
            line += 1;
        }
        self.corner + line * view.width + x
    }
}

/// Whether light from points shows at `surface`.
#[inline(always)]
fn is_lit(scene: &SceneView<'_>, surface: &Surface) -> bool {
    scene.effects.has(Effects::LIGHTS)
        && surface.prim_id != NONE
        && light::is_lit(&light::material_of(scene, surface))
}

/// Where the rays from `surface` to the lights that it faces begin.
#[inline(always)]
fn origin(surface: &Surface) -> Vec3 {
    surface::leave(surface, Vec3::from_array(surface.normal))
}

/// The box of what rays from the points of a tile begin at, as (+∞, −∞) if there are none.
#[inline(always)]
fn bounds(scene: &SceneView<'_>, count: u32, surfaces: impl Fn(u32) -> Surface) -> (Vec3, Vec3) {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    let mut i = 0;
    while i < count {
        let surface = surfaces(i);
        if is_lit(scene, &surface) {
            let at = origin(&surface).to_array();
            for axis in 0..3 {
                low[axis] = min(low[axis], at[axis]);
                high[axis] = max(high[axis], at[axis]);
            }
        }
        i += 1;
    }
    (low.into(), high.into())
}

/// Writes the words of a tile with `count` pixels, whose surfaces `surfaces` has. The box is larger than that of the points by `margin`
/// of its size on each side.
#[inline(always)]
pub fn prove(
    scene: &SceneView<'_>,
    margin: f32,
    count: u32,
    surfaces: impl Fn(u32) -> Surface,
    mut put: impl FnMut(u32, u32),
) {
    let (low, high) = bounds(scene, count, surfaces);
    let some = low.x <= high.x;
    let more = (high - low) * margin;
    let (low, high) = (low - more, high + more);
    put(0, low.x.to_bits());
    put(1, low.y.to_bits());
    put(2, low.z.to_bits());
    put(3, high.x.to_bits());
    put(4, high.y.to_bits());
    put(5, high.z.to_bits());
    let mut number = 0;
    while number < scene.info.lights {
        let target = Vec3::from_array(scene.light(number).position);
        let clear = some && is_clear(scene.rows, &Shaft::new::<Exact>(low, high, target, scene.info.extent));
        put(BOX + number, clear.into());
        number += 1;
    }
}

/// Whether `point` is in the box of the tile whose words begin at `tile`.
#[inline(always)]
fn holds(proofs: &[u32], tile: u32, point: Vec3) -> bool {
    let at = |i: u32| f32::from_bits(proofs.at(tile + i));
    (point.x >= at(0))
        & (point.y >= at(1))
        & (point.z >= at(2))
        & (point.x <= at(3))
        & (point.y <= at(4))
        & (point.z <= at(5))
}

/// [`shadow::trace`] with the proofs of the tile whose words begin at `tile` ([`NONE`]: no tile). `expected` says for a light which pack
/// is likely to hide it, or [`NONE`]; `keep` is told which pack does, or [`NONE`], of each light that is asked for.
///
/// The bits are those of [`shadow::trace`]; the counts are of the rays that were needed.
#[inline(always)]
pub fn trace(
    scene: &SceneView<'_>,
    surface: &Surface,
    proofs: &[u32],
    tile: u32,
    expected: impl Fn(u32) -> u32,
    mut keep: impl FnMut(u32, u32),
    mut put: impl FnMut(u32, u32),
) -> RayCounts {
    let mut counts = RayCounts { primary: 0, shadow: 0, reflected: 0, refracted: 0 };
    let lit = is_lit(scene, surface);
    let proven = lit && tile != NONE && holds(proofs, tile, origin(surface));
    let mut word = 0;
    while word < shadow::words(scene.info.lights) {
        let (mut bits, mut bit) = (0, 0);
        while bit < 32 && word * 32 + bit < scene.info.lights {
            let number = word * 32 + bit;
            let mut hidden = NONE;
            if lit && let Some(ray) = light::shadow_ray(surface, &scene.light(number)) {
                let clear = proven && proofs.at(tile + BOX + number) == 1;
                if !clear {
                    counts.shadow += 1;
                    hidden = occluder(scene.rows, &ray, scene.info.extent, expected(number));
                }
                bits |= ((hidden == NONE) as u32) << bit;
            }
            keep(number, hidden);
            bit += 1;
        }
        put(word, bits);
        word += 1;
    }
    counts
}
