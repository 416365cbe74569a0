//! What light does where a ray hits: surfaces, textures, the sky, point lights, reflection and refraction, in
//! the model of Whitted (1980) with Phong's (1975) highlights.
//!
//! Every effect looks at its bit of [`Effects`](crate::effects::Effects) first: on a GPU the bits are
//! constants, and the code of what is off is gone.

pub mod bounce;
pub mod fresnel;
pub mod light;
pub mod phong;
pub mod proof;
pub mod shadow;
pub mod sky;
pub mod surface;
pub mod texture;
