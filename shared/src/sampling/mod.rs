//! Several rays for each pixel, and what they say together (Adelson and Hodges 1993, "Extending to multiple rays per pixel" and
//! "Reflection and refraction with multiple rays per pixel").

pub mod aim;
pub mod average;
pub mod jitter;
pub mod lattice;
pub mod refine;
pub mod sample;
