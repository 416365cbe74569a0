//! From a scene to the images of both eyes: the frame as an ordered list of passes, on whichever backend.
//!
//! * [`images`]: what comes out.

pub mod images;

pub use images::{StereoImages, ViewImages};
