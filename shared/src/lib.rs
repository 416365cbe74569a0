//! Every algorithm of Parallax, written once: the CPU calls these functions natively, the kernel compiler makes SPIR-V of them, and
//! both give the same bits (see `math` for the arithmetic that this takes).
//!
//! * [`math`]: the only door to arithmetic beyond `+ − ×`.
//! * [`layout`]: the plain data that both backends read; [`scene`]: how a pass sees it; [`effects`]: what a scene calls for.
//! * [`camera`]: the eyes; [`geom`]: primitives; [`traversal`]: the nearest of them on a ray; [`shading`]: what light does at them.
//! * [`stereo`]: the second view from the first; [`sampling`]: several rays for each pixel.
//! * [`output`]: from linear colours to a screen or coloured glasses.
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_code)]

pub mod camera;
pub mod effects;
pub mod geom;
pub mod layout;
pub mod math;
pub mod output;
pub mod sampling;
pub mod scene;
pub mod shading;
pub mod stereo;
pub mod traversal;
