//! What can go wrong between a scene and its images.

use super::overrides::{MAX_LIGHTS, MAX_PIXELS};
use crate::backend::BackendError;
use crate::build::BuildError;
use crate::rig::{MAX_SIDE, RigError};

/// Why a scene cannot be rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The picture has no pixels, or too many.
    #[error(
        "a picture of {width}x{height} is not supported: each side has 1 to {MAX_SIDE} pixels, \
         and the whole at most {MAX_PIXELS}"
    )]
    Size {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// More lights than are supported.
    #[error("{count} lights are too many: a scene has at most {MAX_LIGHTS}")]
    Lights {
        /// How many there are.
        count: usize,
    },
    /// Options that do not go together.
    #[error("the method `{method}` {what}")]
    Options {
        /// The method's name.
        method: &'static str,
        /// What is wrong with it.
        what: &'static str,
    },
    /// Rays per pixel that are not supported.
    #[error("{samples} samples per pixel are not supported")]
    Samples {
        /// What was asked for.
        samples: String,
    },
    /// More points than can be numbered.
    #[error(
        "a picture of {width} × {height} pixels with {per_pixel} × {per_pixel} points each is not supported: \
         each side has fewer than {MAX_SIDE} points"
    )]
    Points {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Points from a pixel to the next one.
        per_pixel: u32,
    },
    /// Coordinates too large, or too far apart, for 32 bit floats.
    #[error("{what} is {distance:e} world units away, too far for a scene of size {extent:e}")]
    TooFar {
        /// What is.
        what: String,
        /// Its largest coordinate.
        distance: f32,
        /// The largest coordinate of the geometry and the eyes.
        extent: f32,
    },
    /// The camera rig makes no picture.
    #[error("the camera cannot be used")]
    Rig(#[from] RigError),
    /// The acceleration structure could not be built.
    #[error("the acceleration structure cannot be built")]
    Build(#[from] BuildError),
    /// The backend failed.
    #[error(transparent)]
    Backend(#[from] BackendError),
    /// There is not enough memory for the images.
    #[error("not enough memory for the images of {width}x{height} pixels: use a smaller --size")]
    Memory {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
}
