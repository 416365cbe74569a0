//! What a frame yields: linear f32 images of both eyes.

use std::collections::TryReserveError;

/// The images of one eye: `width · height` elements each, rows from top to bottom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ViewImages {
    /// Linear colour.
    pub colour: Vec<[f32; 3]>,
    /// Number of the primitive that the primary ray hits, [`NONE`](parallax_shared::layout::NONE) without a
    /// hit.
    pub prim_id: Vec<u32>,
    /// Distance from the eye along the primary ray, in world units; +∞ without a hit.
    pub t: Vec<f32>,
    /// Unit shading normal in world space, zero without a hit.
    pub normal: Vec<[f32; 3]>,
    /// Disparity in pixels.
    pub disparity: Vec<f32>,
}

impl ViewImages {
    /// Makes room for `pixels` elements in each image.
    pub(crate) fn reserve(&mut self, pixels: usize) -> Result<(), TryReserveError> {
        self.colour.try_reserve_exact(pixels)?;
        self.prim_id.try_reserve_exact(pixels)?;
        self.t.try_reserve_exact(pixels)?;
        self.normal.try_reserve_exact(pixels)?;
        self.disparity.try_reserve_exact(pixels)
    }
}

/// The images of a stereo pair.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StereoImages {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The left view, then the right one.
    pub views: [ViewImages; 2],
}
