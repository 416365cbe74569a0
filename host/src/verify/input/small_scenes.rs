//! Small scenes that several tests look at, and materials to make more of.

use super::stage::{Stage, ellipsoid, light, quad, sphere, white};
use crate::rig::StereoRig;
use parallax_shared::layout::{Material, Texture, Triangle, View};

/// Columns and rows of [`view`].
pub const SIDE: u32 = 48;

/// A square view.
pub fn view(eye: [f32; 3], target: [f32; 3]) -> View {
    let rig = StereoRig {
        eye,
        target,
        up: [0.0, 1.0, 0.01],
        vertical_fov_deg: 50.0,
        width: SIDE,
        height: SIDE,
        interaxial_px: 0.0,
        zero_parallax: 4.0,
    };
    rig.views(1.0).expect("a rig that looks at something")[0]
}

/// A perfect mirror.
pub fn mirror() -> Material {
    Material { diffuse: 0.0, reflection: 1.0, ..white() }
}

/// Clear glass.
pub fn glass() -> Material {
    Material { diffuse: 0.0, transmission: 1.0, eta: 1.5, ..white() }
}

/// A floor at y = 0 under a blue sky, and material 0.
pub fn floor(material: Material) -> Stage {
    let mut stage = Stage::new(view([0.0, 2.0, 5.0], [0.0, 0.5, 0.0]));
    stage.zenith = [0.1, 0.3, 0.9];
    stage.horizon = [0.9, 0.8, 0.7];
    stage.materials = vec![material];
    stage.triangles = quad([-50.0, 0.0, 50.0], [100.0, 0.0, 0.0], [0.0, 0.0, -100.0], 0).to_vec();
    stage
}

/// A lamp straight above a ball above a floor.
pub fn ball_under_lamp() -> Stage {
    let mut stage = floor(Material { ambient: 0.5, ..white() });
    stage.ambient = [0.2, 0.2, 0.2];
    stage.spheres = vec![sphere([0.0, 1.0, 0.0], 0.5, 0)];
    stage.lights = vec![light([0.0, 4.0, 0.0], [0.6; 3])];
    stage
}

/// A closed room of these white walls, seen from inside, with lights within (even numbers) and without (odd ones). `at` puts the unit
/// cube where the room is.
pub fn room(walls: Vec<Triangle>, at: impl Fn([f32; 3]) -> [f32; 3]) -> Stage {
    let mut stage = Stage::new(view(at([0.25, 0.75, 0.75]), at([0.875, 0.125, 0.125])));
    stage.materials = vec![white()];
    stage.triangles = walls;
    for i in 0..16 {
        let place = |k: usize| if i >> k & 1 == 0 { 0.0625 } else { 0.9375 };
        let within = [place(0), place(1), if i < 8 { place(2) } else { 0.5 }];
        let mut without = within;
        without[i % 3] = if i % 2 == 0 { -0.0625 } else { 1.0625 };
        stage.lights.extend([light(at(within), [0.1; 3]), light(at(without), [0.1; 3])]);
    }
    stage
}

/// Three columns, two rows, of different colours.
pub fn picture() -> (Texture, Vec<[f32; 4]>) {
    let texels = (0..6).map(|i| [i as f32, (i * i) as f32, 1.0 - i as f32, 1.0]).collect();
    (Texture { first: 0, width: 3, height: 2, padding: 0 }, texels)
}

/// One of everything.
pub fn everything() -> Stage {
    let mut stage = ball_under_lamp();
    let checkered =
        Material { checker_colour: [0.2; 3], checker_scale: 1.0, specular: 0.5, shininess: 20.0, ..white() };
    stage.materials = vec![checkered, glass(), Material { reflection: 0.5, texture: 0, ..white() }];
    (stage.textures, stage.texels) = (vec![picture().0], picture().1);
    stage.sky_texture = 0;
    stage.spheres.push(sphere([1.2, 0.6, 1.0], 0.6, 1));
    stage.ellipsoids = vec![ellipsoid([-1.3, 0.6, 0.5], [0.8, 0.4, 0.6], 0.5, 2)];
    stage
}
