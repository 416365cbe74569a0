//! The scenes that ship with the project, small enough for tests.

use crate::gpu::say_skipped;
use parallax::render::{Overrides, SceneData};
use parallax::scene::{Scene, load};
use std::path::{Path, PathBuf};

/// The root of the source tree.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The file of the shipped scene of this name.
pub fn file(name: &str) -> PathBuf {
    root().join("scenes").join(name).with_extension("toml")
}

/// Every scene file under `scenes/`, by name.
pub fn shipped() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("scenes")).expect("the scenes ship with the project");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let mut scenes: Vec<_> = paths.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect();
    scenes.sort();
    assert!(scenes.len() >= 5, "too few scenes to be all of them: {scenes:?}");
    scenes
}

/// The stem of a scene's file.
pub fn name(path: &Path) -> &str {
    path.file_stem().and_then(|stem| stem.to_str()).expect("scenes have plain names")
}

/// The scene at `size`; `None`, and a line that says so, when its models do not ship with the project and are
/// not there.
pub fn load_at(path: &Path, size: [u32; 2]) -> Option<Scene> {
    let mut scene = match load(path) {
        Ok(scene) => scene,
        Err(error) if wants_models(path) => {
            say_skipped(&format!("{}: {error}", name(path)));
            return None;
        }
        Err(error) => panic!("{}: {error}", path.display()),
    };
    let overrides = Overrides { size: Some(size), ..Overrides::default() };
    overrides.apply(&mut scene).expect("a small picture");
    Some(scene)
}

/// Like [`load_at`], ready to be rendered.
pub fn data_at(path: &Path, size: [u32; 2]) -> Option<SceneData> {
    load_at(path, size).map(|scene| SceneData::new(&scene, Default::default()).expect("a scene that renders"))
}

/// Whether a scene names models that may not ship with the project.
pub fn wants_models(path: &Path) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text.contains("$PARALLAX_MODELS/"))
}
