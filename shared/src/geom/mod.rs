//! Primitives: where a ray meets one, as a function of that ray and that primitive and of nothing else, and
//! how it looks there.

pub mod ellipsoid;
pub mod sphere;
pub mod triangle;
