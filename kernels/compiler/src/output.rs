//! The files of a compilation: writing them, and comparing them with what is there.

use crate::Profile;
use crate::compile::Compiled;
use std::collections::BTreeMap;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A file that could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {error}")]
pub struct OutputError {
    /// The file or folder.
    pub path: PathBuf,
    /// Why.
    pub error: io::Error,
}

/// How a file differs from what the compiler makes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Difference {
    /// It is not there.
    Missing,
    /// It is there, with other contents.
    Changed,
    /// It is there, but nothing makes it any more.
    Stale,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Difference::Missing => "is missing",
            Difference::Changed => "differs",
            Difference::Stale => "belongs to no kernel any more",
        })
    }
}

/// What [`Compiled::write`] did.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Written {
    /// Files with new contents.
    pub changed: Vec<PathBuf>,
    /// Files that belonged to no kernel any more and were removed.
    pub removed: Vec<PathBuf>,
}

impl Compiled {
    /// All files, by path relative to the folder: `strict/NAME.spv`, `fast/NAME.spv`, `fast/NAME.wgsl`,
    /// `manifest.json`.
    pub fn files(&self) -> BTreeMap<PathBuf, Vec<u8>> {
        let mut files = BTreeMap::new();
        for entry in &self.entries {
            files.insert(entry.module_path().into(), entry.module_bytes());
            if let Some(text) = &entry.wgsl {
                files.insert(entry.wgsl_path().into(), text.clone().into_bytes());
            }
        }
        files.insert("manifest.json".into(), self.manifest.to_json().into_bytes());
        files
    }

    /// Writes all files under `dir` and removes modules and texts of kernels that are no more. A file whose
    /// contents stay the same is not touched. Each file appears whole or not at all.
    ///
    /// # Errors
    /// The first file or folder that cannot be read, written or removed.
    pub fn write(&self, dir: &Path) -> Result<Written, OutputError> {
        let files = self.files();
        let mut written = Written::default();
        for (path, difference) in self.differences(dir)? {
            let target = dir.join(&path);
            let failed = |error| OutputError { path: target.clone(), error };
            match (difference, files.get(&path)) {
                (Difference::Missing | Difference::Changed, Some(contents)) => {
                    replace(&target, contents).map_err(failed)?;
                    written.changed.push(path);
                }
                _ => {
                    std::fs::remove_file(&target).map_err(failed)?;
                    written.removed.push(path);
                }
            }
        }
        Ok(written)
    }

    /// Every file under `dir` that is not what [`Compiled::write`] would leave there. Nothing is written.
    ///
    /// # Errors
    /// The first file or folder that cannot be read.
    pub fn differences(&self, dir: &Path) -> Result<Vec<(PathBuf, Difference)>, OutputError> {
        let files = self.files();
        let mut differences = Vec::new();
        for (path, contents) in &files {
            let target = dir.join(path);
            match std::fs::read(&target) {
                Ok(there) if there == *contents => {}
                Ok(_) => differences.push((path.clone(), Difference::Changed)),
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    differences.push((path.clone(), Difference::Missing));
                }
                Err(error) => return Err(OutputError { path: target, error }),
            }
        }
        let stale = existing(dir)?.into_iter().filter(|path| !files.contains_key(path));
        differences.extend(stale.map(|path| (path, Difference::Stale)));
        Ok(differences)
    }
}

/// The modules and texts under `dir`.
fn existing(dir: &Path) -> Result<Vec<PathBuf>, OutputError> {
    let mut paths = Vec::new();
    for folder in Profile::ALL.map(Profile::name) {
        let target = dir.join(folder);
        let failed = |error| OutputError { path: target.clone(), error };
        let entries = match std::fs::read_dir(&target) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(error) => return Err(failed(error)),
        };
        for entry in entries {
            let path = Path::new(folder).join(entry.map_err(failed)?.file_name());
            if path.extension().is_some_and(|extension| extension == "spv" || extension == "wgsl") {
                paths.push(path);
            }
        }
    }
    paths.sort();
    Ok(paths)
}

/// Writes beside the file and renames, so that nobody sees half of it.
fn replace(path: &Path, contents: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".new");
    let beside = path.with_file_name(name);
    std::fs::write(&beside, contents)?;
    std::fs::rename(&beside, path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::Entry;
    use crate::ir::Terminator;
    use crate::record;
    use crate::testing::KernelBuilder;

    fn compiled(names: &[&str]) -> Compiled {
        let entry = |name: &&str| {
            let mut k = KernelBuilder::new(1);
            k.end(0, Terminator::Return);
            let (name, wgsl) = (name.to_string(), Some("// text".to_owned()));
            Entry { name, profile: Profile::Fast, spirv: vec![0x0723_0203, 7], wgsl, kernel: k.build() }
        };
        let entries: Vec<_> = names.iter().map(entry).collect();
        let manifest = record::manifest(&entries, "0".into());
        Compiled { entries, manifest }
    }

    #[test]
    fn a_flipped_byte_and_a_missing_and_a_stale_file_are_named() {
        let dir = tempfile::tempdir().unwrap();
        let both = compiled(&["a", "b"]);
        both.write(dir.path()).unwrap();
        assert_eq!(both.differences(dir.path()).unwrap(), []);

        let module = dir.path().join("fast/a.spv");
        let mut bytes = std::fs::read(&module).unwrap();
        bytes[4] ^= 1;
        std::fs::write(&module, &bytes).unwrap();
        std::fs::remove_file(dir.path().join("fast/b.wgsl")).unwrap();
        std::fs::create_dir(dir.path().join("strict")).unwrap();
        std::fs::write(dir.path().join("strict/old.spv"), b"").unwrap();
        let expected = [
            ("fast/a.spv", Difference::Changed),
            ("fast/b.wgsl", Difference::Missing),
            ("strict/old.spv", Difference::Stale),
        ];
        let expected = expected.map(|(path, difference)| (PathBuf::from(path), difference));
        assert_eq!(both.differences(dir.path()).unwrap(), expected);
        assert_eq!(std::fs::read(&module).unwrap(), bytes, "a comparison writes nothing");
    }

    #[test]
    fn writing_removes_what_is_stale_and_leaves_other_files_alone() {
        let dir = tempfile::tempdir().unwrap();
        compiled(&["a", "b"]).write(dir.path()).unwrap();
        std::fs::write(dir.path().join("fast/README"), b"").unwrap();
        let written = compiled(&["b"]).write(dir.path()).unwrap();
        assert_eq!(written.changed, [PathBuf::from("manifest.json")]);
        assert_eq!(written.removed, ["fast/a.spv", "fast/a.wgsl"].map(PathBuf::from));
        assert!(dir.path().join("fast/README").exists() && !dir.path().join("fast/a.spv").exists());
    }
}
