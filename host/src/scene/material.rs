//! Materials where nothing else is said.

use parallax_shared::layout::{Material, NONE};

/// The largest Phong exponent.
pub(crate) const MAX_SHININESS: f32 = 10_000.0;

/// Light grey with a soft highlight, opaque.
pub(crate) const DEFAULT: Material = Material {
    colour: [0.8; 3],
    texture: NONE,
    checker_colour: [0.0; 3],
    checker_scale: 0.0,
    ambient: 1.0,
    diffuse: 0.9,
    specular: 0.1,
    shininess: 20.0,
    reflection: 0.0,
    transmission: 0.0,
    eta: 1.5,
    padding: 0,
};

/// A matt material of one colour.
pub(crate) fn matt(colour: [f32; 3]) -> Material {
    Material { colour, diffuse: 1.0, specular: 0.0, ..DEFAULT }
}
