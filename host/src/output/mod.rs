//! Picture files: PNG for looking at, EXR for everything else.
//!
//! All files of a picture are written under temporary names and get their own ones when the last of them is
//! complete, so that an error leaves nothing half-written behind.

mod batch;
mod exr;
mod maps;
mod png;

pub use batch::Batch;
pub use maps::{Diagnostics, KINDS, Scales, write_maps};

use crate::metrics::srgb8;
use crate::render::StereoImages;
use std::path::{Path, PathBuf};

/// Which pictures are made of a stereo pair. The EXR file with both views is always among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// A PNG for each view.
    LeftRight,
    /// One PNG for red/cyan glasses.
    Anaglyph,
    /// One PNG with the left view on the left.
    SideBySide,
    /// All of them.
    All,
}

impl Format {
    fn includes(self, other: Self) -> bool {
        self == other || self == Self::All
    }
}

/// Why a file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The file system refused.
    #[error("cannot {action} {path}: {source}")]
    Files {
        /// What was tried.
        action: &'static str,
        /// Which file or folder.
        path: PathBuf,
        /// What it said.
        source: std::io::Error,
    },
    /// The PNG encoder failed.
    #[error("cannot write {path}: {source}")]
    Png {
        /// Which file.
        path: PathBuf,
        /// What it said.
        source: image::ImageError,
    },
    /// The EXR encoder failed.
    #[error("cannot write {path}: {source}")]
    Exr {
        /// Which file.
        path: PathBuf,
        /// What it said.
        source: ::exr::error::Error,
    },
}

/// Writes the files of a stereo pair into `folder`, which is made if need be, and returns their paths.
///
/// They are `NAME.exr` (linear, both views; with `aov` also the channels `t`, `disparity`, `prim_id` and the
/// layer `normal`, named by the multi-view convention) and, by `format`, `NAME_left.png` and
/// `NAME_right.png`, `NAME_anaglyph.png`, `NAME_side-by-side.png` (8 bit sRGB). Files of these names are
/// replaced.
///
/// # Errors
/// When a file cannot be written; then no file has been changed, unless it is the renaming itself that
/// failed.
pub fn write(
    images: &StereoImages,
    folder: &Path,
    name: &str,
    format: Format,
    aov: bool,
) -> Result<Vec<PathBuf>, OutputError> {
    let mut batch = Batch::new(folder)?;
    let size = [images.width, images.height];
    if format.includes(Format::LeftRight) {
        for (view, eye) in images.views.iter().zip(["left", "right"]) {
            png::write(&mut batch, &format!("{name}_{eye}.png"), size, &srgb8(&view.colour))?;
        }
    }
    if format.includes(Format::Anaglyph) {
        png::write(&mut batch, &format!("{name}_anaglyph.png"), size, &png::anaglyph(images))?;
    }
    if format.includes(Format::SideBySide) {
        let size = [2 * images.width, images.height];
        png::write(&mut batch, &format!("{name}_side-by-side.png"), size, &png::side_by_side(images))?;
    }
    exr::write(&mut batch, &format!("{name}.exr"), images, aov)?;
    batch.commit()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::ViewImages;

    fn written(format: Format) -> Vec<String> {
        let view = ViewImages { colour: vec![[0.5; 3]; 6], ..ViewImages::default() };
        let images = StereoImages { width: 3, height: 2, views: [view.clone(), view] };
        let folder = tempfile::tempdir().unwrap();
        let paths = write(&images, folder.path(), "a", format, false).unwrap();
        assert!(paths.iter().all(|path| path.is_file()));
        paths.iter().map(|path| path.file_name().unwrap().to_string_lossy().into_owned()).collect()
    }

    #[test]
    fn formats_make_their_files() {
        assert_eq!(written(Format::LeftRight), ["a_left.png", "a_right.png", "a.exr"]);
        assert_eq!(written(Format::Anaglyph), ["a_anaglyph.png", "a.exr"]);
        assert_eq!(written(Format::SideBySide), ["a_side-by-side.png", "a.exr"]);
        assert_eq!(written(Format::All).len(), 5);
    }
}
