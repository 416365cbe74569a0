//! Random kernels: from a seed to a kernel, from many seeds to one crate, which is compiled once for every machine that must agree.
//!
//! A kernel has control flow of every kind that Rust has, integer and float arithmetic, local arrays, a table that it reads, results
//! and atomic cells that it writes. What it computes is the same everywhere by construction: integers wrap, no float is NaN or
//! denormal, the sign of a zero is not looked at (lavapipe takes x · 0 for 0), every loop ends, and atomic operations commute. The
//! native program is compiled without most of LLVM's optimisations, so that it does not share their mistakes with the modules.

mod batch;
mod expressions;
mod generator;
mod report;
mod statements;

pub use batch::{Batch, Compiled};
pub use generator::kernel;
pub use report::{Failure, check};
