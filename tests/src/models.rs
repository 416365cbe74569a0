//! Where the models lie that are not shipped, and what every loaded scene must hold to.

use std::path::{Path, PathBuf};

use parallax::scene::{Scene, Sky};

/// The project's folder of scenes.
pub fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// The directory of models: what `PARALLAX_MODELS` says, or `../shared/scenes` beside the project; `None`,
/// and a line that says so, when it is not there.
pub fn models() -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/scenes");
    let directory = std::env::var_os("PARALLAX_MODELS").map_or_else(beside, PathBuf::from);
    if directory.is_dir() {
        return Some(directory);
    }
    println!("SKIPPED: no models in {} (set PARALLAX_MODELS)", directory.display());
    None
}

/// What is wrong with a scene that a loader has let through: numbers that are not finite, indices of nothing,
/// normals that are no unit vectors.
pub fn flaws(scene: &Scene) -> Vec<String> {
    let mut flaws = Vec::new();
    let mut check = |holds: bool, what: &str, i: usize| {
        if !holds {
            flaws.push(format!("{what} {i}"));
        }
    };
    let finite = |v: &[f32]| v.iter().all(|x| x.is_finite());
    let material = |m: u32| (m as usize) < scene.materials.len();
    let texture = |t: u32| t == u32::MAX || (t as usize) < scene.textures.len();
    for (i, t) in scene.triangles.iter().enumerate() {
        check(material(t.material), "material of triangle", i);
        check(finite(t.vertices.as_flattened()), "vertices of triangle", i);
        check(finite(t.uvs.as_flattened()), "texture coordinates of triangle", i);
        let length = |n: &[f32; 3]| n.iter().map(|x| x * x).sum::<f32>();
        let unit = |n: &[f32; 3]| (length(n) - 1.0).abs() < 1e-5;
        check(t.smooth <= 1, "smoothness of triangle", i);
        check(
            if t.smooth == 1 { t.normals.iter().all(unit) } else { t.normals == [[0.0; 3]; 3] },
            "normals",
            i,
        );
    }
    for (i, s) in scene.spheres.iter().enumerate() {
        check(
            material(s.material) && finite(&s.centre) && s.radius > 0.0 && s.radius.is_finite(),
            "sphere",
            i,
        );
    }
    for (i, e) in scene.ellipsoids.iter().enumerate() {
        check(material(e.material) && finite(&e.centre), "ellipsoid", i);
        check(finite(e.world_to_unit.as_flattened()), "matrix of ellipsoid", i);
    }
    for (i, m) in scene.materials.iter().enumerate() {
        check(texture(m.texture) && finite(&m.colour) && m.eta > 0.0, "material", i);
    }
    for (i, p) in scene.textures.iter().enumerate() {
        check(p.texels.len() as u64 == u64::from(p.width) * u64::from(p.height), "size of picture", i);
        check(!p.texels.is_empty() && finite(p.texels.as_flattened()), "texels of picture", i);
    }
    check(!matches!(scene.sky, Sky::Map(map) if !texture(map)), "sky", 0);
    check(!scene.materials.is_empty(), "materials", 0);
    flaws
}
