//! From a Rust kernel crate to SPIR-V modules, WGSL texts and a manifest, with the stable toolchain alone.

pub mod driver;
pub mod front;
pub mod ir;
pub mod refusal;
