//! A scene as the benchmarks of `parallax bench stereo` measure it.

use crate::render::{Overrides, RenderError, Samples};
use crate::scene::Scene;

/// What becomes of a scene's materials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Materials {
    /// They stay.
    Own,
    /// All matt, as 000 has them.
    Matt,
    /// No mirrors and no glass; highlights stay.
    Opaque,
    /// No glass.
    Mirrors,
    /// No mirrors.
    Glass,
    /// 003's test scene as far as it is told: the first 100 spheres, of which 46 reflect.
    Es,
}

/// One scene as it is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The name of a shipped scene.
    pub scene: &'static str,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Distance of the eyes.
    pub interaxial_px: f32,
    /// Number of lights, if not the scene's own.
    pub lights: Option<u32>,
    /// Materials.
    pub materials: Materials,
    /// Levels of reflection and refraction, if not the scene's own.
    pub levels: Option<u32>,
    /// Rays per pixel.
    pub samples: Samples,
    /// Of how many frames of an animation this is the mean: 1 for a scene at rest.
    pub frames: u32,
}

/// 000's animated spheres.
pub(super) const ANIMATED: &str = "spheres_turned";

/// Frames of a whole turn of them.
const TURN: u32 = 240;

/// How many of these are measured; if it has to be quick, too.
const FRAMES: [u32; 2] = [4, 1];

/// 001's distance of the eyes: the strip that only the right one sees is "at most 11520 pixels" of 512 × 512.
const ADELSON_INTERAXIAL: f32 = 22.5;

impl Setting {
    /// 000's: square, matt, 5 lights.
    pub(super) fn matt(scene: &'static str, side: u32, interaxial_px: f32) -> Self {
        Self {
            scene,
            size: [side; 2],
            interaxial_px,
            lights: Some(5),
            materials: Materials::Matt,
            levels: None,
            samples: Samples::One,
            frames: 1,
        }
    }

    pub(super) fn adelson(scene: &'static str, materials: Materials) -> Self {
        Self {
            scene,
            size: [512; 2],
            interaxial_px: ADELSON_INTERAXIAL,
            lights: None,
            materials,
            levels: None,
            samples: Samples::One,
            frames: 1,
        }
    }

    /// As a mean over frames if the scene is animated.
    pub(super) fn animated(self, quick: bool) -> Self {
        let frames = if self.scene == ANIMATED { FRAMES[usize::from(quick)] } else { 1 };
        Self { frames, ..self }
    }

    /// Half as many columns and rows if it has to be quick; the eyes are then as many fewer of them apart.
    pub(super) fn shrunk(self, quick: bool) -> Self {
        if !quick {
            return self;
        }
        Self { size: self.size.map(|side| side / 2), interaxial_px: self.interaxial_px / 2.0, ..self }
    }

    /// The frames that are measured.
    pub fn frame_numbers(&self) -> impl Iterator<Item = u32> + use<> {
        let frames = self.frames;
        (0..frames).map(move |frame| frame * TURN / frames)
    }

    /// What to call it.
    pub fn label(&self) -> String {
        let Self { scene, size: [width, height], interaxial_px, .. } = self;
        let lights = self.lights.map_or(String::new(), |lights| format!(" lights={lights}"));
        let levels = self.levels.map_or(String::new(), |levels| format!(" levels={levels}"));
        let materials = match self.materials {
            Materials::Own | Materials::Matt | Materials::Es => "",
            Materials::Opaque => " opaque",
            Materials::Mirrors => " mirrors",
            Materials::Glass => " glass",
        };
        let samples = match self.samples {
            Samples::One => String::new(),
            samples => format!(" samples={samples}"),
        };
        format!("{scene} {width}x{height} e={interaxial_px}{lights}{levels}{materials}{samples}")
    }

    /// Makes the scene what the setting says.
    ///
    /// # Errors
    /// When it is beyond what is supported.
    pub fn apply(&self, scene: &mut Scene) -> Result<(), RenderError> {
        match self.materials {
            Materials::Own | Materials::Matt => {}
            Materials::Opaque => without(scene, true, true),
            Materials::Mirrors => without(scene, false, true),
            Materials::Glass => without(scene, true, false),
            Materials::Es => spheres_of_es(scene),
        }
        scene.max_depth = self.levels.unwrap_or(scene.max_depth);
        let overrides = Overrides {
            size: Some(self.size),
            interaxial_px: Some(self.interaxial_px),
            lights: self.lights,
            diffuse: self.materials == Materials::Matt,
        };
        overrides.apply(scene)
    }
}

/// Gives mirrors, or what is transparent, the weights of an ordinary material; highlights stay.
fn without(scene: &mut Scene, mirrors: bool, glass: bool) {
    for material in &mut scene.materials {
        if (mirrors && material.reflection > 0.0) || (glass && material.transmission > 0.0) {
            (material.reflection, material.transmission) = (0.0, 0.0);
            (material.ambient, material.diffuse) = (1.0, 0.8);
        }
    }
}

fn spheres_of_es(scene: &mut Scene) {
    scene.spheres.truncate(100);
    for sphere in scene.spheres.iter().take(46) {
        if let Some(material) = scene.materials.get_mut(sphere.material as usize) {
            material.reflection = 0.5;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::stereo::parts::gather_settings;
    use std::path::Path;

    fn shipped(name: &str) -> Scene {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes"));
        crate::scene::load(&folder.join(name).with_extension("toml")).unwrap()
    }

    #[test]
    fn mirrors_and_glass_can_be_taken_away_each_by_itself() {
        let with = |materials| {
            let mut scene = shipped("ellipsoids_125");
            Setting::adelson("ellipsoids_125", materials).apply(&mut scene).unwrap();
            let count = |of: fn(&crate::scene::Material) -> f32| {
                scene.materials.iter().filter(|material| of(material) > 0.0).count()
            };
            (count(|m| m.reflection), count(|m| m.transmission), count(|m| m.specular) > 0)
        };
        assert_eq!(with(Materials::Opaque), (0, 0, true));
        assert_eq!(with(Materials::Matt), (0, 0, false));
        let both = with(Materials::Own);
        assert!(both.0 > 0 && both.1 > 0);
        assert_eq!(with(Materials::Mirrors), (both.0, 0, true));
        assert_eq!(with(Materials::Glass), (0, both.1, true));
    }

    #[test]
    fn the_scene_of_003_has_its_numbers() {
        let mut scene = shipped("spheres");
        gather_settings()[1].apply(&mut scene).unwrap();
        assert_eq!((scene.spheres.len(), scene.lights.len(), scene.max_depth), (100, 4, 2));
        let reflects = |s: &&crate::scene::Sphere| scene.materials[s.material as usize].reflection > 0.0;
        assert_eq!(scene.spheres.iter().filter(reflects).count(), 46);
        assert_eq!((scene.rig.width, scene.rig.height), (1024, 768));
    }
}
