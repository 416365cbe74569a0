//! What a kernel may call, and what a backend needs to run it.
//!
//! A kernel is an ordinary function with `#[spirv(compute(threads(x, y, z)))]`, in rust-gpu's dialect. The attribute makes three
//! things of that one declaration: the SPIR-V entry point, a type that implements [`Pass`] (the typed arguments by which a host
//! asks for a run), and the launcher by which a CPU calls the very same function.
//!
//! ```
//! use glam::UVec3;
//! use kernel_api::{At, Out, Pass, spirv};
//!
//! /// Doubles each word.
//! #[spirv(compute(threads(64)))]
//! pub fn double(
//!     #[spirv(global_invocation_id)] id: UVec3,
//!     #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
//!     #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] doubled: Out<u32>,
//! ) {
//!     if id.x < doubled.len() {
//!         doubled.put(id.x, 2 * words.at(id.x));
//!     }
//! }
//!
//! // The function is still a function, and `Double { words, doubled }` is the pass that a backend runs.
//! assert_eq!((Double::NAME, Double::THREADS, Double::BINDINGS.len()), ("double", [64, 1, 1], 2));
//! ```
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
pub use kernel_macros::{rare, spirv};
pub use memory::{At, Index, OpenStack, Out, Stack, Workgroup};
pub use pass::{Access, Binding, Bound, Buffer, Invocation, Memory, Pass};

/// What the expansion of `#[spirv]` refers to. Not for use by hand.
#[doc(hidden)]
pub mod rt {
    #[cfg(all(feature = "device", not(target_arch = "spirv")))]
    pub use crate::device::shim::*;
    pub use bytemuck;
    pub use glam;
    #[cfg(target_arch = "spirv")]
    pub use spirv_std;
}
