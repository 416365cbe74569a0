//! The off-axis stereo rig (Es 2.3.2; Adelson and Hodges).

/// Two eyes side by side that look the same way at one common picture plane.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoRig {
    /// The point midway between the eyes, world space.
    pub eye: [f32; 3],
    /// The point looked at, world space.
    pub target: [f32; 3],
    /// A direction that is up in the picture, any length, not parallel to the line of sight.
    pub up: [f32; 3],
    /// Full vertical angle of view, degrees.
    pub vertical_fov_deg: f32,
    /// Columns of each picture.
    pub width: u32,
    /// Rows of each picture.
    pub height: u32,
    /// Distance between the eyes in pixels of the zero-parallax plane (e of the papers).
    pub interaxial_px: f32,
    /// Distance to the zero-parallax plane in world units (d of the papers).
    pub zero_parallax: f32,
}
