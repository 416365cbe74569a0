//! Clean-up of lowered kernels.

pub mod builder;
pub mod fold;
