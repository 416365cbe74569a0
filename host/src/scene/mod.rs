//! Scenes: what is to be rendered, read from a scene file, from a model file or generated.
//!
//! [`load`] is the one door. What it returns is typed, validated and in world units: every number is finite,
//! every index within its array, every radius greater than zero; nothing is scaled yet.

mod bare;
mod error;
pub mod file;
mod files;
pub mod generate;
mod material;
mod model;
mod picture;
mod textures;
mod warning;

use std::path::{Path, PathBuf};

pub use error::SceneError;
pub use files::MODELS_PREFIX;
pub use parallax_shared::layout::{Ellipsoid, Light, Material, Sphere, Triangle};
pub use warning::{Problem, Warning};

use crate::rig::StereoRig;

/// The file that `name`, which begins with [`MODELS_PREFIX`], means in the directory of models.
///
/// # Errors
/// Where it was looked for, as text.
pub fn model_file(name: &str) -> Result<PathBuf, String> {
    files::named(Path::new("."), name)
}

/// What is to be rendered and from where, world space, world units, not yet scaled.
///
/// Primitives are numbered through: triangles first, then spheres, then ellipsoids.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What to call it: the stem of its file.
    pub name: String,
    /// The two eyes.
    pub rig: StereoRig,
    /// Linear colour of the ambient light.
    pub ambient: [f32; 3],
    /// Point lights.
    pub lights: Vec<Light>,
    /// What rays that leave the scene see.
    pub sky: Sky,
    /// Levels of reflection and refraction behind the primary hit.
    pub max_depth: u32,
    /// Materials, at least one.
    pub materials: Vec<Material>,
    /// Pictures that materials and the sky refer to.
    pub textures: Vec<Picture>,
    /// Triangles. Faces of zero area are kept (their vertices may close a crack beside them); their geometric
    /// normal is zero.
    pub triangles: Vec<Triangle>,
    /// Spheres.
    pub spheres: Vec<Sphere>,
    /// Ellipsoids.
    pub ellipsoids: Vec<Ellipsoid>,
    /// What the loader put up with.
    pub warnings: Vec<Warning>,
}

/// What rays that leave the scene see; linear colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sky {
    /// From `horizon` to `zenith` (and, mirrored, to the nadir).
    Gradient {
        /// Straight up.
        zenith: [f32; 3],
        /// At the horizon.
        horizon: [f32; 3],
    },
    /// An equirectangular picture: index into [`Scene::textures`].
    Map(u32),
}

/// A decoded picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// `width · height` texels, linear red, green, blue and coverage, rows from top to bottom.
    pub texels: Vec<[f32; 4]>,
}

/// Reads a scene file (`.toml`) or a bare model file (`.obj`, `.ply`).
///
/// # Errors
/// Whatever is wrong with the file, with its name and, where there is one, the line: see [`SceneError`].
pub fn load(path: &Path) -> Result<Scene, SceneError> {
    load_frame(path, 0)
}

/// The same for a frame of an animation, counted from 0. Each frame is worked out from its number alone.
///
/// # Errors
/// Those of [`load`].
pub fn load_frame(path: &Path, frame: u32) -> Result<Scene, SceneError> {
    match path.extension().and_then(|s| s.to_str()) {
        Some(suffix) if suffix.eq_ignore_ascii_case("toml") => file::load(path, frame),
        _ => bare::load(path),
    }
}
