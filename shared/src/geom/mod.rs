//! Primitives: where a ray meets them, and how they look there.

pub mod ellipsoid;
pub mod sphere;
