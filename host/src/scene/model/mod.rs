//! Model files: OBJ with MTL, PLY (ASCII and both binary orders).
//!
//! A file is read whole into [`Polygons`], whatever its format; from there on there is one path: faces are
//! checked and cut into triangles, placed in the world, and given the normals that the file lacks. Nothing is
//! allocated by a count that a file states before the file has proved long enough to hold as much, and each
//! step is linear in the size of the file or has a budget.

mod crease;
mod lines;
mod mtl;
mod obj;
mod place;
mod ply;
mod polygon;

use std::path::{Path, PathBuf};

pub(crate) use mtl::FileMaterial;
pub(crate) use place::{Placement, rotation, times};
pub(crate) use polygon::{Corner, Face, Polygons};

use super::warning::Tally;
use super::{SceneError, Triangle, files};

/// Angle between faces, degrees, up to which an edge looks round where a file has no normals.
pub(crate) const DEFAULT_CREASE_DEG: f32 = 40.0;

/// The largest model file that is read: 1 GiB.
const MAX_BYTES: u64 = 1 << 30;

/// A model as its file tells it.
pub(crate) struct Model {
    path: PathBuf,
    polygons: Polygons,
    /// What [`Face::material`] counts.
    pub(crate) materials: Vec<FileMaterial>,
    tally: Tally,
}

/// Reads a model file; its suffix, in upper or lower case, names the format.
pub(crate) fn read(path: &Path) -> Result<Model, SceneError> {
    let suffix = path.extension().map(|s| s.to_string_lossy().to_lowercase());
    match suffix.as_deref() {
        Some("obj") => obj::read(path, &files::read(path, MAX_BYTES)?),
        Some("ply") => ply::read(path, &files::read(path, MAX_BYTES)?),
        _ => Err(SceneError::UnknownFormat { path: path.into() }),
    }
}

impl Model {
    /// The model's triangles in the world, those of file material `i` with the scene's material
    /// `materials[i]` (the last one for what has none), and what was wrong with the file.
    pub(crate) fn triangles(
        mut self,
        placement: &Placement,
        crease_deg: f32,
        materials: &[u32],
    ) -> (Vec<Triangle>, Vec<super::Warning>) {
        let facets = self.polygons.facets(&mut self.tally);
        placement.apply(&mut self.polygons, &facets);
        let triangles = crease::finish(&self.polygons, &facets, crease_deg, materials, &mut self.tally);
        if triangles.is_empty() {
            self.tally.add(super::Problem::Empty, None);
        }
        (triangles, self.tally.warnings(&self.path))
    }
}
