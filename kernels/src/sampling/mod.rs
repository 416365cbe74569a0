//! Several rays for each pixel.

pub mod aim;
pub mod average;
pub mod begin;
pub mod carry;
pub mod infer;
pub mod refine;
pub mod sample;
