//! What a caller may want otherwise than the scene says: size, distance of the eyes, number of lights.

use crate::render::RenderError;
use crate::rig::MAX_SIDE;
use crate::scene::{Light, Scene};
use glam::DVec3;

/// Most pixels of a picture (16,384 × 16,384).
pub const MAX_PIXELS: u64 = 1 << 28;
/// Most lights.
pub const MAX_LIGHTS: u32 = 4096;

/// Changes to a scene. `None` leaves things as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Columns and rows of each picture. The distance between the eyes is a number of pixels, so it is scaled
    /// with the width (unless it is given too): a larger picture then shows the same depth.
    pub size: Option<[u32; 2]>,
    /// Distance between the eyes in pixels of the zero-parallax plane.
    pub interaxial_px: Option<f32>,
    /// Number of lights: the first of the scene's own, or those and further ones (see [`Overrides::apply`]).
    pub lights: Option<u32>,
    /// Whether all materials become matt: neither specular nor mirrors nor glass, as in the scenes of
    /// Al-Hagri 2012 §4.4.
    pub diffuse: bool,
}

impl Overrides {
    /// Changes `scene`.
    ///
    /// Lights beyond the scene's own are placed around the point looked at, as far from it as the first light
    /// (or as twice the distance of the eye when there is none), in the upper hemisphere at golden angles;
    /// they have the mean colour of the scene's own (or white). All lights are then dimmed so that together
    /// they are as strong as the scene's own were: more lights cost time, they do not bleach the picture.
    /// Each number of lights always gives the same picture.
    ///
    /// # Errors
    /// When the size or the number of lights is beyond what is supported.
    pub fn apply(&self, scene: &mut Scene) -> Result<(), RenderError> {
        if let Some([width, height]) = self.size {
            scene.rig.interaxial_px *= width as f32 / scene.rig.width as f32;
            (scene.rig.width, scene.rig.height) = (width, height);
        }
        if let Some(interaxial_px) = self.interaxial_px {
            scene.rig.interaxial_px = interaxial_px;
        }
        if let Some(count) = self.lights {
            set_lights(scene, count.min(MAX_LIGHTS + 1));
        }
        if self.diffuse {
            for material in &mut scene.materials {
                (material.specular, material.reflection, material.transmission) = (0.0, 0.0, 0.0);
            }
        }
        check_limits(scene)
    }
}

/// Whether a scene can be rendered at its size and with its lights.
///
/// # Errors
/// When it cannot.
pub fn check_limits(scene: &Scene) -> Result<(), RenderError> {
    let (width, height) = (scene.rig.width, scene.rig.height);
    let pixels = u64::from(width) * u64::from(height);
    if width.min(height) < 1 || width.max(height) > MAX_SIDE || pixels > MAX_PIXELS {
        return Err(RenderError::Size { width, height });
    }
    if scene.lights.len() > MAX_LIGHTS as usize {
        return Err(RenderError::Lights { count: scene.lights.len() });
    }
    Ok(())
}

fn set_lights(scene: &mut Scene, count: u32) {
    let own = scene.lights.len() as u32;
    if count <= own {
        scene.lights.truncate(count as usize);
        return;
    }
    let sum = scene.lights.iter().fold(DVec3::ZERO, |sum, light| sum + widened(light.colour));
    let (mean, dimmed) = match own {
        0 => (DVec3::ONE, 1.0 / f64::from(count)),
        _ => (sum / f64::from(own), f64::from(own) / f64::from(count)),
    };
    for light in &mut scene.lights {
        light.colour = (widened(light.colour) * dimmed).as_vec3().to_array();
    }
    let places = Places::of(scene);
    for number in own..count {
        let position = places.position(number - own).as_vec3().to_array();
        let colour = (mean * dimmed).as_vec3().to_array();
        scene.lights.push(Light { position, padding: 0, colour, padding1: 0 });
    }
}

/// Where further lights stand.
struct Places {
    centre: DVec3,
    radius: f64,
    up: DVec3,
    across: DVec3,
}

impl Places {
    fn of(scene: &Scene) -> Self {
        let rig = &scene.rig;
        let (eye, centre) = (widened(rig.eye), widened(rig.target));
        let radius = match scene.lights.first() {
            Some(light) => (widened(light.position) - centre).length(),
            None => 2.0 * (eye - centre).length(),
        };
        let up = widened(rig.up).normalize_or(DVec3::Y);
        let across = up.cross(centre - eye).normalize_or(up.any_orthonormal_vector());
        Self { centre, radius, up, across }
    }

    /// Both the angle around the axis and the height go on by the golden section, so that any number of
    /// lights is spread evenly.
    fn position(&self, number: u32) -> DVec3 {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let turn = (f64::from(number + 1) * GOLDEN).fract();
        let height = 0.3 + 0.6 * (f64::from(number) * GOLDEN * GOLDEN).fract();
        let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
        let level = self.across * cos + self.up.cross(self.across) * sin;
        self.centre + (level * (1.0 - height * height).sqrt() + self.up * height) * self.radius
    }
}

fn widened(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rig::StereoRig;
    use crate::scene::Sky;

    fn scene(lights: usize) -> Scene {
        let light = Light { position: [0.0, 5.0, 0.0], padding: 0, colour: [0.5, 0.25, 1.0], padding1: 0 };
        let rig = StereoRig {
            eye: [0.0, 0.0, 4.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            vertical_fov_deg: 40.0,
            width: 400,
            height: 300,
            interaxial_px: 10.0,
            zero_parallax: 4.0,
        };
        Scene {
            name: "test".into(),
            rig,
            ambient: [0.0; 3],
            lights: vec![light; lights],
            sky: Sky::Gradient { zenith: [0.0; 3], horizon: [0.0; 3] },
            max_depth: 0,
            materials: vec![],
            textures: vec![],
            triangles: vec![],
            spheres: vec![],
            ellipsoids: vec![],
            warnings: vec![],
        }
    }

    fn with_lights(own: usize, wanted: u32) -> Vec<Light> {
        let mut scene = scene(own);
        Overrides { lights: Some(wanted), ..Overrides::default() }.apply(&mut scene).unwrap();
        scene.lights
    }

    #[test]
    fn further_lights_share_what_there_was() {
        assert_eq!(with_lights(2, 1), scene(1).lights);
        let lights = with_lights(2, 7);
        assert_eq!(lights.len(), 7);
        for (axis, total) in [1.0, 0.5, 2.0].into_iter().enumerate() {
            let sum: f32 = lights.iter().map(|light| light.colour[axis]).sum();
            assert!((sum - total).abs() < 1e-5, "{sum}");
        }
        for light in &lights[2..] {
            let [x, y, z] = light.position;
            assert!(((x * x + y * y + z * z).sqrt() - 5.0).abs() < 1e-4 && y > 0.0, "{light:?}");
        }
        assert_eq!(lights, with_lights(2, 7));
    }

    #[test]
    fn lights_without_a_model_are_white() {
        let lights = with_lights(0, 4);
        assert!(lights.iter().all(|light| light.colour == [0.25; 3]));
    }

    #[test]
    fn a_larger_picture_shows_the_same_depth() {
        let mut scene = scene(0);
        let size = Some([800, 600]);
        Overrides { size, ..Overrides::default() }.apply(&mut scene).unwrap();
        assert_eq!(scene.rig.interaxial_px, 20.0);
        Overrides { size, interaxial_px: Some(7.0), ..Overrides::default() }.apply(&mut scene).unwrap();
        assert_eq!((scene.rig.width, scene.rig.interaxial_px), (800, 7.0));
    }
}
