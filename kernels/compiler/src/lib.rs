//! From a Rust kernel crate to SPIR-V modules, WGSL texts and a manifest, with the stable toolchain alone.
//!
//! A kernel crate is an ordinary `no_std` library whose entry points carry `#[spirv(compute(threads(x, y,
//! z)))]` of `kernel-api`. It is compiled in stages, each a module of this crate with tests of its own:
//!
//! 1. [`driver`]: cargo builds the crate and prints its IR, which rustc's own LLVM has optimised, inlined and
//!    structured.
//! 2. [`front`]: the IR is parsed and lowered to [`ir::Kernel`]s: words of named buffers instead of pointers.
//! 3. [`structure`]: blocks and branches become nested statements, in loop-closed form.
//! 4. [`check`]: barriers stand under uniform control flow, and nothing is left that a target lacks.
//! 5. [`emit`]: SPIR-V, and WGSL for the fast profile.
//!
//! [`interpret`] runs lowered kernels on the CPU, word by word, which tells a defect of this compiler from
//! one of a driver. What cannot be compiled is refused with the entry point, the function and what to write
//! instead ([`refusal`]); all problems of a crate come in one run.
//!
//! ```no_run
//! use kernel_compiler::{CrateSource, Options, Profile, compile};
//!
//! let options = Options { profiles: Profile::ALL.to_vec(), wgsl: true, ..Options::default() };
//! let compiled = compile(&CrateSource::new("kernels"), &options)?;
//! for entry in &compiled.entries {
//!     println!("{} ({}): {} words", entry.name, entry.profile, entry.spirv.len());
//! }
//! compiled.write("kernels/spirv".as_ref())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod check;
pub mod cleanup;
pub mod compile;
pub mod demangle;
pub mod driver;
pub mod emit;
pub mod front;
pub mod interpret;
pub mod ir;
pub mod lower;
pub mod manifest;
pub mod output;
pub mod parse;
pub mod profile;
mod record;
pub mod refusal;
#[cfg(feature = "rust-gpu")]
pub mod rust_gpu;
pub mod sources;
pub mod structure;
#[cfg(test)]
mod testing;

pub use compile::{CompileError, Compiled, CrateSource, Entry, Options, compile};
pub use manifest::Manifest;
pub use profile::Profile;
pub use sources::SourcesError;
