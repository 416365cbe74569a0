//! What the tests of Parallax share.

pub mod far_things;
pub mod gpu;
pub mod kernels;
pub mod machines;
pub mod models;
pub mod oracle;
pub mod random_kernels;
pub mod scenes;
pub mod small_scenes;
pub mod stereo;
pub mod tables;
pub mod terminal;
pub mod words;

pub use parallax::verify::input::{meshes, reference, stage};
