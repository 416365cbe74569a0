//! What a loader puts up with, counted.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// Something odd in a file that did not keep it from being loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The file.
    pub path: PathBuf,
    /// What is odd.
    pub problem: Problem,
    /// How often it was found.
    pub count: u64,
    /// The first place, in text formats: a line, from 1.
    pub first_line: Option<usize>,
}

/// Kinds of [`Warning`], and what is done about each.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Problem {
    /// Triangles of zero area: kept.
    ZeroArea,
    /// Faces with a vertex that is not finite: dropped.
    NotFinite,
    /// Faces of fewer than three corners: dropped.
    FewCorners,
    /// Faces that name a vertex that does not exist: dropped.
    IndexOutOfRange,
    /// Texture coordinates or normals that do not exist or are not finite: left out.
    BadAttribute,
    /// Polygons in which no ear is found (they cross themselves, or are too large): cut into a fan.
    NotSimple,
    /// A file that a model names and that is missing, outside its directory or unreadable: done without.
    FileMissing(String),
    /// A material that no file defines: the default is used.
    MaterialMissing(String),
    /// No triangle at all.
    Empty,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ZeroArea => write!(f, "triangles of zero area (kept)"),
            Self::NotFinite => write!(f, "faces with a vertex that is not finite (dropped)"),
            Self::FewCorners => write!(f, "faces of fewer than three corners (dropped)"),
            Self::IndexOutOfRange => write!(f, "faces that name a vertex that does not exist (dropped)"),
            Self::BadAttribute => {
                write!(f, "corners whose normal or texture coordinates are unusable (left out)")
            }
            Self::NotSimple => write!(f, "polygons without an ear, or too large (cut into a fan)"),
            Self::FileMissing(reason) => write!(f, "file left out: {reason}"),
            Self::MaterialMissing(name) => write!(f, "material `{name}` is defined nowhere (default used)"),
            Self::Empty => write!(f, "nothing to render"),
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some(line) = self.first_line {
            write!(f, ":{line}")?;
        }
        write!(f, ": ")?;
        match self.count {
            0 | 1 => write!(f, "{}", self.problem),
            n => write!(f, "{n} × {}", self.problem),
        }
    }
}

/// Counts the oddities of one file.
#[derive(Default)]
pub(crate) struct Tally {
    found: BTreeMap<Problem, (u64, Option<usize>)>,
}

impl Tally {
    /// One more `problem`, at `line` when the file has lines.
    pub(crate) fn add(&mut self, problem: Problem, line: Option<usize>) {
        self.found.entry(problem).or_insert((0, line)).0 += 1;
    }

    /// What was found in the file `path`.
    pub(crate) fn warnings(self, path: &Path) -> Vec<Warning> {
        let warning =
            |(problem, (count, first_line))| Warning { path: path.into(), problem, count, first_line };
        self.found.into_iter().map(warning).collect()
    }
}
