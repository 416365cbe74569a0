//! What the tests of Parallax share.

pub mod gpu;
pub mod kernels;
pub mod models;
pub mod oracle;
pub mod stage;
