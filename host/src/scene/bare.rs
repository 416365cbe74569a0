//! A bare model file as a scene: a camera that sees all of it, two lights, a sky.

use std::path::Path;

use super::model::{self, DEFAULT_CREASE_DEG, Placement};
use super::textures::Textures;
use super::{Light, Scene, SceneError, Sky, Triangle, material};
use crate::rig::StereoRig;

/// Vertical angle of view, degrees.
const FOV_DEG: f32 = 35.0;

/// From the middle of the model towards the eyes: from the front (+z), a little from the right and from
/// above.
const FROM: [f32; 3] = [0.35, 0.35, 1.0];

/// Size of the pictures, columns and rows.
pub(super) const SIZE: [u32; 2] = [800, 600];

/// Columns of a picture per pixel between the eyes: the picture plane of Adelson and Hodges is about 40 times
/// as wide as the distance between the eyes.
pub(super) const COLUMNS_PER_INTERAXIAL: f32 = 40.0;

/// Levels of reflection and refraction.
pub(super) const MAX_DEPTH: u32 = 5;

/// Ambient light.
pub(super) const AMBIENT: [f32; 3] = [0.15; 3];

/// The sky.
pub(super) const SKY: Sky = Sky::Gradient { zenith: [0.25, 0.45, 0.85], horizon: [0.85, 0.9, 0.95] };

/// Reads a model file with its own materials.
pub(super) fn load(path: &Path) -> Result<Scene, SceneError> {
    let model = model::read(path)?;
    let mut textures = Textures::default();
    let (mut materials, mut warnings) = textures.materials(path, &model.materials)?;
    materials.push(material::DEFAULT);
    let numbers: Vec<u32> = (0..materials.len() as u32).collect();
    let (triangles, found) = model.triangles(&Placement::default(), DEFAULT_CREASE_DEG, &numbers);
    warnings.extend(found);
    let (middle, radius) = ball(&triangles);
    Ok(Scene {
        name: path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default(),
        rig: rig(middle, radius),
        ambient: AMBIENT,
        lights: lights(middle, radius),
        sky: SKY,
        max_depth: MAX_DEPTH,
        materials,
        textures: textures.pictures,
        triangles,
        spheres: Vec::new(),
        ellipsoids: Vec::new(),
        warnings,
    })
}

/// Middle of the box of the triangles and half its diagonal; the unit ball when there are none.
fn ball(triangles: &[Triangle]) -> ([f32; 3], f32) {
    let vertices = triangles.iter().flat_map(|t| t.vertices);
    let bounds = vertices.map(|p| [p, p]).reduce(|[low, high], [p, _]| {
        [std::array::from_fn(|i| low[i].min(p[i])), std::array::from_fn(|i| high[i].max(p[i]))]
    });
    let [low, high] = bounds.unwrap_or([[-1.0; 3], [1.0; 3]]);
    let middle = std::array::from_fn(|i| low[i] / 2.0 + high[i] / 2.0);
    let radius = (0..3).map(|i| f64::from(high[i] / 2.0 - low[i] / 2.0).powi(2)).sum::<f64>().sqrt() as f32;
    (middle, if radius > 0.0 { radius } else { 1.0 })
}

/// Eyes so far away that the ball fills the picture, and nothing of it is nearer than half the distance of
/// zero parallax, which is that of the middle (Es 2.3.2 asks for both).
fn rig(middle: [f32; 3], radius: f32) -> StereoRig {
    let length = FROM.iter().map(|x| x * x).sum::<f32>().sqrt();
    let distance = radius / (FOV_DEG.to_radians() / 2.0).sin();
    StereoRig {
        eye: std::array::from_fn(|i| middle[i] + FROM[i] / length * distance),
        target: middle,
        up: [0.0, 1.0, 0.0],
        vertical_fov_deg: FOV_DEG,
        width: SIZE[0],
        height: SIZE[1],
        interaxial_px: SIZE[0] as f32 / COLUMNS_PER_INTERAXIAL,
        zero_parallax: distance,
    }
}

/// A white light over the right shoulder and a dimmer, bluish one from the left.
fn lights(middle: [f32; 3], radius: f32) -> Vec<Light> {
    let light = |at: [f32; 3], colour| Light {
        position: std::array::from_fn(|i| middle[i] + at[i] * radius),
        padding: 0,
        colour,
        padding1: 0,
    };
    vec![light([3.0, 5.0, 4.0], [0.75, 0.73, 0.7]), light([-5.0, 2.0, 3.0], [0.2, 0.22, 0.25])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_the_model_is_nearer_than_half_way() {
        let rig = rig([1.0, 2.0, 3.0], 10.0);
        let distance = rig.zero_parallax;
        assert!(distance - 10.0 > distance / 2.0);
        let to_target: f32 = (0..3).map(|i| (rig.eye[i] - rig.target[i]).powi(2)).sum::<f32>().sqrt();
        assert!((to_target - distance).abs() < 1e-4);
    }
}
