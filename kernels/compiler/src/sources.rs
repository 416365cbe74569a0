//! What a kernel crate consists of: its own sources and those of its path dependencies, as `cargo metadata`
//! lists them.

use crate::manifest::sha256;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Why the sources of a crate are not known.
#[derive(Debug, thiserror::Error)]
pub enum SourcesError {
    /// There is no manifest in the folder.
    #[error("{0} is not the folder of a crate: it has no Cargo.toml")]
    NoCrate(PathBuf),
    /// The manifest is of a workspace alone.
    #[error("{0} has no package of its own: name the folder of the kernel crate")]
    NoPackage(PathBuf),
    /// Cargo could not be started.
    #[error("cargo cannot be run: {0}")]
    Start(std::io::Error),
    /// Cargo refuses the manifest; what it said.
    #[error("cargo cannot read the crate:\n{0}")]
    Cargo(String),
    /// Cargo's answer is not what this compiler expects.
    #[error("cargo's metadata cannot be read: {0}")]
    Metadata(#[from] serde_json::Error),
    /// A source cannot be read.
    #[error("{path}: {error}")]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
}

/// What is known of a kernel crate before it is built.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sources {
    /// Its cargo features.
    pub features: BTreeSet<String>,
    /// SHA-256 over the names and contents of the manifests, build scripts and library sources of the crate and
    /// of its path dependencies.
    pub sha256: String,
}

impl Sources {
    /// Reads the crate in `dir`.
    ///
    /// # Errors
    /// When there is no crate, cargo refuses it, or a file cannot be read.
    pub fn read(dir: &Path) -> Result<Self, SourcesError> {
        if !dir.join("Cargo.toml").is_file() {
            return Err(SourcesError::NoCrate(dir.to_owned()));
        }
        let metadata = metadata(dir)?;
        let root = metadata.resolve.root.clone().ok_or_else(|| SourcesError::NoPackage(dir.to_owned()))?;
        let mut files = BTreeMap::new();
        for id in local_closure(&metadata, &root) {
            if let Some(package) = metadata.package(id) {
                package.collect_files(&mut files)?;
            }
        }
        let features = metadata.package(&root).map(|p| p.features.keys().cloned().collect());
        Ok(Self { features: features.unwrap_or_default(), sha256: hash(&files) })
    }
}

/// The part of `cargo metadata` that is used here.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
    resolve: Resolve,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    id: String,
    /// `None` for a package that lies on this machine's disk.
    source: Option<String>,
    manifest_path: PathBuf,
    features: BTreeMap<String, Vec<String>>,
    targets: Vec<Target>,
}

#[derive(Deserialize)]
struct Target {
    kind: Vec<String>,
    src_path: PathBuf,
}

#[derive(Deserialize)]
struct Resolve {
    root: Option<String>,
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<DependencyKind>,
}

#[derive(Deserialize)]
struct DependencyKind {
    kind: Option<String>,
}

impl Metadata {
    fn package(&self, id: &str) -> Option<&Package> {
        self.packages.iter().find(|package| package.id == id)
    }

    /// What a package is built from, without its development dependencies.
    fn dependencies<'a>(&'a self, id: &str) -> impl Iterator<Item = &'a str> {
        let node = self.resolve.nodes.iter().find(|node| node.id == id);
        let built = |d: &&Dependency| d.dep_kinds.iter().any(|k| k.kind.as_deref() != Some("dev"));
        node.into_iter().flat_map(|node| &node.deps).filter(built).map(|d| d.pkg.as_str())
    }
}

fn metadata(dir: &Path) -> Result<Metadata, SourcesError> {
    let output = Command::new("cargo")
        .current_dir(dir)
        .args(["metadata", "--format-version", "1", "--quiet"])
        .output()
        .map_err(SourcesError::Start)?;
    if !output.status.success() {
        return Err(SourcesError::Cargo(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

/// The package `root` and all packages that it is built from and that lie on disk.
fn local_closure<'a>(metadata: &'a Metadata, root: &'a str) -> BTreeSet<&'a str> {
    let (mut found, mut open) = (BTreeSet::new(), vec![root]);
    while let Some(id) = open.pop() {
        let local = metadata.package(id).is_some_and(|package| package.source.is_none());
        if local && found.insert(id) {
            open.extend(metadata.dependencies(id));
        }
    }
    found
}

/// Contents by `package/path/in/package`.
type Files = BTreeMap<String, Vec<u8>>;

impl Package {
    fn collect_files(&self, files: &mut Files) -> Result<(), SourcesError> {
        let dir = self.manifest_path.parent().unwrap_or(Path::new("."));
        self.collect(&self.manifest_path, dir, files)?;
        for target in &self.targets {
            match target.kind.first().map(String::as_str) {
                Some("bin" | "test" | "bench" | "example") | None => {}
                Some("custom-build") => self.collect(&target.src_path, dir, files)?,
                Some(_library) => {
                    let folder = target.src_path.parent().unwrap_or(dir);
                    self.collect_sources(folder, dir, files)?;
                }
            }
        }
        Ok(())
    }

    fn collect_sources(&self, folder: &Path, dir: &Path, files: &mut Files) -> Result<(), SourcesError> {
        let failed = |error| SourcesError::Read { path: folder.to_owned(), error };
        for entry in std::fs::read_dir(folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            // A library whose root lies beside its manifest has cargo's output beside it too.
            if path.ends_with("target") {
                continue;
            }
            if path.is_dir() {
                self.collect_sources(&path, dir, files)?;
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                self.collect(&path, dir, files)?;
            }
        }
        Ok(())
    }

    fn collect(&self, path: &Path, dir: &Path, files: &mut Files) -> Result<(), SourcesError> {
        let contents =
            std::fs::read(path).map_err(|error| SourcesError::Read { path: path.to_owned(), error })?;
        let relative = path.strip_prefix(dir).unwrap_or(path);
        let parts: Vec<_> = relative.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        files.insert(format!("{}/{}", self.name, parts.join("/")), contents);
        Ok(())
    }
}

fn hash(files: &Files) -> String {
    let lines: String = files.iter().map(|(name, bytes)| format!("{}  {name}\n", sha256(bytes))).collect();
    sha256(lines.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(dir: &Path, name: &str, text: &str) {
        let path = dir.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    fn made_crate(dir: &Path) {
        write(
            dir,
            "a/Cargo.toml",
            "[package]\nname = \"a\"\nedition = \"2024\"\n[features]\nfast = []\n[dependencies]\nb = { path = \"../b\" }\n[workspace]\n",
        );
        write(dir, "a/src/lib.rs", "pub mod deep;\n");
        write(dir, "a/src/deep/mod.rs", "");
        write(dir, "b/Cargo.toml", "[package]\nname = \"b\"\nedition = \"2024\"\n");
        write(dir, "b/src/lib.rs", "");
    }

    #[test]
    fn the_hash_depends_on_the_sources_and_not_on_the_folder() {
        let (one, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        made_crate(one.path());
        made_crate(other.path());
        let read = |dir: &tempfile::TempDir| Sources::read(&dir.path().join("a")).unwrap();
        let first = read(&one);
        assert_eq!(first, read(&other));
        assert!(first.features.contains("fast"));
        write(other.path(), "b/src/lib.rs", "pub fn changed() {}\n");
        assert_ne!(first.sha256, read(&other).sha256, "a path dependency counts");
        write(one.path(), "a/src/deep/mod.rs", "// changed\n");
        assert_ne!(first.sha256, read(&one).sha256, "a file in a folder counts");
    }

    #[test]
    fn a_folder_without_a_crate_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let message = Sources::read(dir.path()).unwrap_err().to_string();
        assert!(message.contains("it has no Cargo.toml"), "{message}");
    }
}
