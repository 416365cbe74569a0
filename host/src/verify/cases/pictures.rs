//! Whole pairs with every effect, stage by stage.

use crate::backend::{Cpu, Gpu, Profile};
use crate::build::Quality;
use crate::diff;
use crate::render::{Method, Reflections, RenderError, SceneData, Shadows, StereoOptions, Verify};
use crate::rig::StereoRig;
use crate::scene::{Picture, Scene, Sky};
use crate::verify::Outcome;
use crate::verify::input::small_scenes::everything;
use crate::verify::suite::Suite;

/// One of everything, for a pair of 61 × 43 pixels: no multiple of a workgroup's 8 × 8, and more than one of them either way.
///
/// # Errors
/// When the scene cannot be built, which is a defect.
pub fn scene() -> Result<SceneData, RenderError> {
    let stage = everything();
    let rig = StereoRig {
        eye: [0.0, 2.0, 5.0],
        target: [0.0, 0.5, 0.0],
        up: [0.0, 1.0, 0.01],
        vertical_fov_deg: 50.0,
        width: 61,
        height: 43,
        interaxial_px: 6.0,
        zero_parallax: 4.0,
    };
    let texture = stage.textures[0];
    let picture = Picture { width: texture.width, height: texture.height, texels: stage.texels };
    let scene = Scene {
        name: "everything".into(),
        rig,
        ambient: stage.ambient,
        lights: stage.lights,
        sky: Sky::Map(0),
        max_depth: stage.max_depth,
        materials: stage.materials,
        textures: vec![picture],
        triangles: stage.triangles,
        spheres: stage.spheres,
        ellipsoids: stage.ellipsoids,
        warnings: vec![],
    };
    SceneData::new(&scene, Quality::Full)
}

/// Traced, guided, proven and reprojected pairs: every stage of both views has the same bits on both backends.
pub fn every_effect_has_the_same_bits(suite: &mut Suite) -> Outcome {
    let data = scene()?;
    let atomic = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
    for options in [
        StereoOptions::default(),
        Method::Guided.into(),
        StereoOptions { shadows: Shadows::Prove, ..Method::Guided.into() },
        atomic,
        StereoOptions { shadows: Shadows::Trace, ..atomic },
        StereoOptions { reflections: Reflections::Within(5.0), ..atomic },
        Method::Buffer.into(),
        Method::Gather1.into(),
        Method::Gather2.into(),
    ] {
        suite.compare_pair("everything", &data, &options)?;
    }
    Ok(())
}

/// Elements of the fast profile's stages that are further from the processor's than its bounds allow, of how many.
///
/// # Errors
/// When a backend fails.
pub fn beyond_the_fast_bounds(cpu: &mut Cpu, gpu: &mut Gpu) -> Result<(u64, u64), RenderError> {
    let stages = diff::stages(cpu, gpu, &scene()?, &StereoOptions::default(), Profile::Fast, &mut |_, _| {})?;
    let elements = stages.iter().map(|stage| stage.elements as u64).sum();
    let beyond = stages.iter().filter(|stage| !stage.equal).map(|stage| stage.differing as u64).sum();
    Ok((beyond, elements))
}
