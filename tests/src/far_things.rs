//! One scene thrice: as it is, with one light more that most of it turns away from, and with a mirror far away that most of it does
//! not see. For what a pixel pays for what it does not see.

use crate::small_scenes::floor;
use crate::stage::{Stage, light, quad, sphere, white};
use parallax_shared::layout::Material;

/// Lights of the scene as it is.
pub const LIGHTS: usize = 16;

/// Shiny balls on a floor under sixteen lights. No mirrors.
pub fn plain() -> Stage {
    let shiny = Material { ambient: 0.5, specular: 0.5, shininess: 20.0, ..white() };
    let mut stage = floor(shiny);
    stage.ambient = [0.1; 3];
    stage.spheres = (0..5).map(|i| sphere([i as f32 - 2.0, 0.5, -(i % 2) as f32], 0.45, 0)).collect();
    stage.lights = (0..LIGHTS).map(|i| (i as f32).sin_cos()).map(over).collect();
    stage
}

fn over((x, z): (f32, f32)) -> parallax_shared::layout::Light {
    light([8.0 * x, 6.0 + z, 8.0 * z], [0.05; 3])
}

/// [`plain`] with a 17th light, below the floor: only the undersides of the balls face it.
pub fn with_light() -> Stage {
    let mut stage = plain();
    stage.lights.push(light([0.0, -3.0, 0.0], [0.3; 3]));
    stage
}

/// [`plain`] with a mirror behind everything, which hides no light; within the floor's extent, so that the padding of boxes stays.
pub fn with_mirror() -> Stage {
    let mut stage = plain();
    stage.materials.push(Material { diffuse: 0.0, reflection: 1.0, ..white() });
    stage.triangles.extend(quad([-6.0, 0.5, -45.0], [12.0, 0.0, 0.0], [0.0, 8.0, 0.0], 1));
    stage
}
