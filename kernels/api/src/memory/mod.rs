//! Views of buffers and of an invocation's own arrays: the only module of `shared`, `kernels` and `kernel-api` with `unsafe` of its
//! own (`device` calls what the kernel compiler replaces).
//!
//! On the CPU every access is checked and a wrong index panics (a defect of the kernel, which tests find). On the device a panic
//! is impossible: accesses are unchecked there, and an index out of range is subject to the driver's robust buffer access. The
//! feature `device` makes the difference; it is for the kernel compiler alone, never for a build that runs on the CPU.

mod at;
mod atomic;
mod out;
mod stack;
mod workgroup;

pub use at::{At, Index};
pub use atomic::signed;
pub use out::Out;
pub use stack::{OpenStack, Stack};
pub use workgroup::Workgroup;
