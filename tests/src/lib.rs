//! What the tests of Parallax share.

pub mod far_things;
pub mod gpu;
pub mod kernels;
pub mod machines;
pub mod meshes;
pub mod models;
pub mod oracle;
pub mod random_kernels;
pub mod reference;
pub mod scenes;
pub mod small_scenes;
pub mod stage;
pub mod stereo;
pub mod tables;
