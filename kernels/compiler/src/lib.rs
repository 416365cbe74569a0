//! From a Rust kernel crate to SPIR-V modules, WGSL texts and a manifest, with the stable toolchain alone.

pub mod check;
pub mod driver;
pub mod front;
pub mod ir;
pub mod manifest;
pub mod profile;
pub mod refusal;
pub mod structure;
#[cfg(test)]
#[allow(dead_code)]
mod testing;

pub use profile::Profile;
