//! What a frame yields: linear f32 images of both eyes.

/// The images of one eye: `width · height` elements each, rows from top to bottom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ViewImages {
    /// Linear colour.
    pub colour: Vec<[f32; 3]>,
    /// Number of the primitive that the primary ray hits, [`NONE`](parallax_shared::layout::NONE) without a hit.
    pub prim_id: Vec<u32>,
    /// Distance along the primary ray, in lengths of its direction; +∞ without a hit.
    pub t: Vec<f32>,
    /// Unit shading normal in world space, zero without a hit.
    pub normal: Vec<[f32; 3]>,
    /// Disparity in pixels.
    pub disparity: Vec<f32>,
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
