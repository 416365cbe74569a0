//! A scene has no favourite unit: scaled by a power of two it is the same picture, bit for bit (DESIGN §3.1.7).

use parallax::render::SceneData;
use parallax::render::band::Values;
use parallax::render::scale::Scaled;
use parallax::scene::Scene;
use parallax_tests::scenes::{file, load_at};
use parallax_tests::stereo::left;

/// The same scene in units that are 1 / `factor` as large.
fn in_other_units(scene: &Scene, factor: f32) -> Scene {
    let mut scene = scene.clone();
    scene.rig.eye = scene.rig.eye.scaled(factor);
    scene.rig.target = scene.rig.target.scaled(factor);
    scene.rig.zero_parallax *= factor;
    scene.lights.iter_mut().for_each(|light| *light = light.scaled(factor));
    scene.materials.iter_mut().for_each(|material| *material = material.scaled(factor));
    scene.triangles.iter_mut().for_each(|triangle| *triangle = triangle.scaled(factor));
    scene.spheres.iter_mut().for_each(|sphere| *sphere = sphere.scaled(factor));
    scene.ellipsoids.iter_mut().for_each(|ellipsoid| *ellipsoid = ellipsoid.scaled(factor));
    scene
}

/// What the left eye sees.
fn picture(scene: &Scene) -> Values {
    let data = SceneData::new(scene, Default::default()).expect("a scene that renders");
    left(&data)
}

/// Units from 2⁻⁶⁰ to 2⁶⁰ of the scene's own: everything but lengths is the same.
#[test]
fn a_scene_looks_the_same_in_any_unit() {
    for name in ["default", "cornell", "ellipsoids_20"] {
        let path = file(name);
        let scene = load_at(&path, [60, 45]).expect("a scene that ships whole");
        let own = picture(&scene);
        for exponent in [-60, -40, -20, 20, 40, 60] {
            let other = picture(&in_other_units(&scene, 2f32.powi(exponent)));
            assert!(own == other, "{name} times 2^{exponent}");
        }
    }
}
