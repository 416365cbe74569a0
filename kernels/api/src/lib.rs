//! What a kernel may call, and what a backend needs to run it.
//!
//! A kernel is an ordinary function with `#[spirv(compute(threads(x, y, z)))]`, in rust-gpu's dialect. The attribute makes three
//! things of that one declaration: the SPIR-V entry point, a type that implements [`Pass`] (the typed arguments by which a host
//! asks for a run), and the launcher by which a CPU calls the very same function.
//!
//! * [`memory`]: views of buffers; the only module with `unsafe`.
//! * [`pass`]: what the attribute implements and a backend consumes.
//! * [`device`]: barriers, subgroup operations and other things that plain Rust lacks.
#![no_std]

#[cfg(not(target_arch = "spirv"))]
extern crate std;

pub mod device;
pub mod memory;
pub mod pass;

pub use device::subgroup;
pub use kernel_macros::spirv;
pub use memory::{At, Index, Out, Stack, Workgroup};
pub use pass::{Access, Binding, Bound, Buffer, Invocation, Memory, Pass};

/// What the expansion of `#[spirv]` refers to. Not for use by hand.
#[doc(hidden)]
pub mod rt {
    #[cfg(feature = "device")]
    pub use crate::device::shim::*;
    pub use bytemuck;
    pub use glam;
}
