//! Where a scene's files may lie, and reading them without trusting their size.
//!
//! A name inside a scene or model file is relative to the directory of the file that says it and may not
//! leave that directory (no `..`, no absolute name): whoever opens a stranger's scene reads nothing else. A
//! scene file reaches other models by the prefix `$PARALLAX_MODELS/`. Symbolic links are followed: they are
//! the reader's own doing.

use std::fs::File;
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use super::SceneError;

/// The prefix of names that lie in the directory of models.
pub const MODELS_PREFIX: &str = "$PARALLAX_MODELS/";

/// The environment variable that names the directory of models.
const MODELS_VARIABLE: &str = "PARALLAX_MODELS";

/// Where models are looked for when [`MODELS_VARIABLE`] is not set: beside the project.
const MODELS_DEFAULT: &str = "../shared/scenes";

/// Reads a whole regular file of at most `limit` bytes.
pub(crate) fn read(path: &Path, limit: u64) -> Result<Vec<u8>, SceneError> {
    let unreadable = |source| SceneError::Unreadable { path: path.into(), source };
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if !metadata.is_file() {
        return Err(unreadable(std::io::Error::other("not a regular file")));
    }
    let too_large = |bytes| SceneError::TooLarge { path: path.into(), bytes, limit };
    if metadata.len() > limit {
        return Err(too_large(metadata.len()));
    }
    let mut bytes = Vec::new();
    let mut file = File::open(path).map_err(unreadable)?.take(limit + 1);
    file.read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > limit { Err(too_large(bytes.len() as u64)) } else { Ok(bytes) }
}

/// The file that `name` means inside a file of directory `directory`; `None` when it lies outside.
///
/// Backslashes separate directories too: material files are often written on Windows.
pub(crate) fn beside(directory: &Path, name: &str) -> Option<PathBuf> {
    let name = name.replace('\\', "/");
    let inside = |c| matches!(c, Component::Normal(_) | Component::CurDir);
    let drive = name.as_bytes().get(1) == Some(&b':');
    let path = Path::new(&name);
    (!name.is_empty() && !name.contains('\0') && !drive && path.components().all(inside))
        .then(|| directory.join(path))
}

/// The file that `name` means in a scene file of directory `directory`: beside it, or in the directory of
/// models.
///
/// # Errors
/// What was expected instead, as text.
pub(crate) fn named(directory: &Path, name: &str) -> Result<PathBuf, String> {
    let outside =
        || format!("expected a file in the scene's own directory or `{MODELS_PREFIX}…`, found `{name}`");
    let Some(rest) = name.strip_prefix(MODELS_PREFIX) else {
        return beside(directory, name).ok_or_else(outside);
    };
    let tried = models_directories(directory);
    let inside = |d: &PathBuf| beside(d, rest).ok_or_else(outside);
    for candidate in &tried {
        let path = inside(candidate)?;
        if path.is_file() {
            return Ok(path);
        }
    }
    let tried: Vec<_> = tried.iter().map(|d| d.display().to_string()).collect();
    Err(format!(
        "the model `{rest}` is not in {} (set {MODELS_VARIABLE} to the directory that holds it)",
        tried.join(" nor in ")
    ))
}

/// Where models are looked for: where [`MODELS_VARIABLE`] says, or beside the project, seen from the current
/// directory and from the scene file's.
fn models_directories(scene: &Path) -> Vec<PathBuf> {
    match std::env::var_os(MODELS_VARIABLE) {
        Some(directory) => vec![directory.into()],
        None => vec![MODELS_DEFAULT.into(), scene.join("..").join(MODELS_DEFAULT)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_inside_their_directory() {
        let directory = Path::new("models");
        assert_eq!(beside(directory, ".\\a\\b.png"), Some("models/./a/b.png".into()));
        for outside in ["", "../a.mtl", "a/../../b", "/etc/hostname", "C:\\a.mtl", "C:a.mtl", "\\a", "a\0b"] {
            assert_eq!(beside(directory, outside), None, "{outside}");
        }
        assert!(named(directory, "$PARALLAX_MODELS/../x.ply").is_err());
    }

    #[test]
    fn a_large_or_odd_file_is_refused_before_it_is_read() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("a");
        std::fs::write(&path, [0; 100]).unwrap();
        assert_eq!(read(&path, 100).unwrap().len(), 100);
        assert!(matches!(read(&path, 99), Err(SceneError::TooLarge { bytes: 100, limit: 99, .. })));
        assert!(matches!(read(directory.path(), 99), Err(SceneError::Unreadable { .. })));
    }
}
