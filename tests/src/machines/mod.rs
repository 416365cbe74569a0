//! Runs compiled kernels everywhere they can run, and compares what they write.

mod case;
pub mod features;
mod machine;
mod modules;
mod native;
mod numbers;
mod workgroups;

pub use case::{Case, Difference};
pub use machine::{Machine, Trouble, dispatch};
pub use modules::{check_spirv, check_wgsl, workspace};
pub use native::Native;
pub use numbers::Numbers;
