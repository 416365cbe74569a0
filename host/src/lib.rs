//! Parallax: stereo and multi-view ray tracing with one source for CPU and GPU and the same bits on both.

pub mod backend;
pub mod bench;
pub mod build;
pub mod compare;
pub mod diff;
mod html;
pub mod metrics;
pub mod output;
pub mod render;
pub mod rig;
pub mod scene;
pub mod study;
pub mod verify;
