//! What can be wrong with a scene.

use std::path::PathBuf;

use thiserror::Error;

/// Why a scene could not be loaded. Each says which file and, where it can be said, which line.
#[derive(Debug, Error)]
pub enum SceneError {
    /// A file that is not there or cannot be read.
    #[error("{}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A file whose suffix names no format that can be read.
    #[error("{}: unknown format, supported: .toml, .obj, .ply", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// A scene file that does not say what it should.
    #[error("{}:{line}:{column}: {message}", path.display())]
    File {
        /// The scene file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1, in characters.
        column: usize,
        /// What is wrong and what was expected.
        message: String,
    },
    /// A model file that breaks its format's rules.
    #[error("{}: {message}", place(path, *line))]
    Model {
        /// The model file.
        path: PathBuf,
        /// Line, from 1, in text formats.
        line: Option<usize>,
        /// What is wrong.
        message: String,
    },
    /// A picture that cannot be decoded or is too large.
    #[error("{}: {message}", path.display())]
    Picture {
        /// The picture.
        path: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// A file larger than a loader accepts.
    #[error("{}: {bytes} bytes; at most {limit} are accepted", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Its size.
        bytes: u64,
        /// The largest accepted size.
        limit: u64,
    },
}

fn place(path: &std::path::Path, line: Option<usize>) -> String {
    match line {
        Some(line) => format!("{}:{line}", path.display()),
        None => path.display().to_string(),
    }
}
