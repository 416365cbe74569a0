//! Several rays for each pixel (Adelson and Hodges 1993): which, and how the views of a pair are made of them.
//!
//! A view is sampled at the points of a lattice (see [`parallax_shared::sampling::lattice`]), level by level, and its pixels are means
//! of their points. Points of the second view come from those of the first, by the same tables as pixels do. What is not a colour
//! (hits, surfaces) is that of the ray through the middle of the pixel, which is traced for it where it is wanted, and not counted.

pub mod buffers;
mod grid;
pub mod pair;
mod samples;

pub use grid::Grid;
pub use samples::{Samples, TOLERANCE};
