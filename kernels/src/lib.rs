//! The GPU entry points of Parallax: thin shells around the functions of `parallax-shared`. Each declaration
//! also yields the pass by which the CPU backend calls the same function (see `kernel-api`).
#![cfg_attr(not(test), no_std)]
#![forbid(unsafe_op_in_unsafe_fn)]

pub mod arithmetic;
pub mod bounce;
pub mod primary;
pub mod prove;
pub mod rays;
pub mod sampling;
pub mod shade;
pub mod shadow;
pub mod shadow_proven;
pub mod stereo;
pub mod surface;
