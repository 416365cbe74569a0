//! Colours of surfaces: flat, checkerboard, bitmap.

use crate::effects::Effects;
use crate::layout::{Material, NONE, Surface, Texture};
use crate::math::{self, vector};
use crate::scene::SceneView;
use glam::{Vec2, Vec3};
use kernel_api::At;

/// How far the checkerboard's pattern is moved, in squares: a face that lies in one of its planes but for
/// rounding then has one colour.
const CHECKER_SHIFT: f32 = 1.0 / 1024.0;

/// What lies beyond the edges of a picture.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// The picture again.
    Repeat,
    /// Its last row (of a sky, which ends at its poles).
    Clamp,
}

/// The colour of `material` at `surface`: its flat colour or checkerboard, times its texture.
#[inline(always)]
pub fn colour(scene: &SceneView<'_>, material: &Material, surface: &Surface) -> Vec3 {
    let mut colour = Vec3::from_array(material.colour);
    if scene.effects.has(Effects::CHECKERBOARD) && material.checker_scale > 0.0 {
        let odd = is_odd_square(Vec3::from_array(surface.position) * material.checker_scale);
        colour = if odd { Vec3::from_array(material.checker_colour) } else { colour };
    }
    if scene.effects.has(Effects::TEXTURES) && material.texture != NONE {
        let texture = scene.texture(material.texture);
        colour *= sample(scene.texels, &texture, Vec2::from_array(surface.uv), Edge::Repeat);
    }
    colour
}

/// Whether `position`, in squares, lies in an odd one of the cubes that fill space like a checkerboard.
#[inline(always)]
fn is_odd_square(position: Vec3) -> bool {
    let cell = |x: f32| math::floor_to_int(x + CHECKER_SHIFT);
    (cell(position.x) ^ cell(position.y) ^ cell(position.z)) & 1 == 1
}

/// The picture at `uv` (v upwards), interpolated bilinearly between the centres of its texels. It repeats to
/// the left and right; `vertical` says what is above and below.
#[inline(always)]
pub fn sample(texels: &[[f32; 4]], texture: &Texture, uv: Vec2, vertical: Edge) -> Vec3 {
    let (left, right, across) = neighbours(uv.x, texture.width, Edge::Repeat);
    let (above, below, down) = neighbours(1.0 - uv.y, texture.height, vertical);
    let at = |x: u32, y: u32| {
        let [red, green, blue, _] = texels.at(texture.first + y * texture.width + x);
        Vec3::new(red, green, blue)
    };
    let upper = vector::lerp(at(left, above), at(right, above), across);
    let lower = vector::lerp(at(left, below), at(right, below), across);
    vector::lerp(upper, lower, down)
}

/// The two of `count` texels between whose centres `position` lies (0 to 1 across all of them), and how far
/// it is from the first to the second. Both are texels for every number and for NaN.
#[inline(always)]
fn neighbours(position: f32, count: u32, edge: Edge) -> (u32, u32, f32) {
    let last = count as i32 - 1;
    let scaled = match edge {
        Edge::Repeat => (position - math::floor(position)) * count as f32 - 0.5,
        Edge::Clamp => math::clamp(position * count as f32 - 0.5, 0.0, last as f32),
    };
    let first = math::floor_to_int(scaled);
    let fraction = scaled - first as f32;
    let beyond = if edge == Edge::Repeat { 0 } else { last };
    // −1 is the last texel of the picture to the left.
    let first = if first < 0 || first > last { last } else { first };
    let second = if first == last { beyond } else { first + 1 };
    (first as u32, second as u32, fraction)
}
