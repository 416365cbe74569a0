//! Where scenes are.

use super::failure::{Blame, Failure};
use anyhow::{Context, anyhow};
use parallax::scene::{self, MODELS_PREFIX, Scene, model_file};
use std::path::{Path, PathBuf};

/// The scene that is rendered when none is named.
const DEFAULT: &str = "default";

/// The file of the scene that a user names: a path, the name of a shipped scene, or a model as scene files name
/// it; the default scene when none is named.
///
/// # Errors
/// When nothing of that name exists. What the file holds is not looked at.
pub fn scene(named: Option<&Path>) -> anyhow::Result<PathBuf> {
    let name = named.unwrap_or(Path::new(DEFAULT));
    if named.is_some() && name.exists() {
        return Ok(name.to_owned());
    }
    if let Some(model) = name.to_str().filter(|name| name.starts_with(MODELS_PREFIX)) {
        return model_file(model).map_err(|error| anyhow!(error));
    }
    let is_path = name.components().count() > 1 || name.extension().is_some();
    if is_path {
        return Err(anyhow!("{}: no such file", name.display()));
    }
    let candidates = folders().into_iter().map(|folder| folder.join(name).with_extension("toml"));
    let missing = || anyhow!("{}: no such file, and no shipped scene of that name", name.display());
    candidates.into_iter().find(|path| path.is_file()).ok_or_else(missing)
}

/// Reads frame `frame` of a scene.
pub fn load(path: &Path, frame: u32) -> Result<Scene, Failure> {
    scene::load_frame(path, frame).with_context(|| format!("bad scene {}", path.display())).usage()
}

/// Folders that may hold the shipped scenes: of the source tree that this was built from, above the
/// executable, and here.
fn folders() -> Vec<PathBuf> {
    let executable = std::env::current_exe().unwrap_or_default();
    let beside = executable.ancestors().skip(1).map(|folder| folder.join("scenes"));
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    // Without `..` in it the path reads better in what is printed.
    let source = source.canonicalize().unwrap_or(source);
    std::iter::once(source).chain(beside).chain([PathBuf::from("scenes")]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_taken_as_it_is() {
        let file = tempfile::NamedTempFile::new().unwrap();
        assert_eq!(scene(Some(file.path())).unwrap(), file.path());
    }

    #[test]
    fn what_does_not_exist_is_named() {
        let told = |name: &str| scene(Some(Path::new(name))).unwrap_err().to_string();
        assert_eq!(told("nowhere/a.toml"), "nowhere/a.toml: no such file");
        assert!(told("$PARALLAX_MODELS/nowhere/a.ply").starts_with("the model `nowhere/a.ply` is not in "));
        assert!(told("nowhere").contains("no shipped scene of that name"));
    }
}
