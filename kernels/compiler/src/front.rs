//! The front half of the compiler: from a crate to lowered kernels.

use crate::driver::{self, DriverError};
use crate::ir::Kernel;
use crate::refusal::Refusal;
use std::path::{Path, PathBuf};

/// What the front half is asked for.
#[derive(Clone, Debug, Default)]
pub struct FrontOptions {
    /// Cargo features of the kernel crate besides `device`.
    pub features: Vec<String>,
    /// Where cargo builds; `target/kernels` in the crate's workspace if `None`.
    pub target_dir: Option<PathBuf>,
    /// Only the kernels of these names, if there are any.
    pub only: Vec<String>,
    /// Whether values of 64 bits are let through (needs the capability Int64).
    pub wide: bool,
    /// Whether records of 16-byte alignment are *not* accessed 128 bits at a time.
    pub no_vec4: bool,
}

/// All kernels of a crate that can be compiled, and why the others cannot.
#[derive(Debug, Default)]
pub struct Front {
    /// The lowered, cleaned kernels, by name.
    pub kernels: Vec<Kernel>,
    /// All problems of all other kernels.
    pub refusals: Vec<Refusal>,
}

/// Builds the crate in `crate_dir` and lowers its kernels.
///
/// # Errors
/// When cargo cannot be run or the crate does not compile.
pub fn kernels(crate_dir: &Path, options: &FrontOptions) -> Result<Front, DriverError> {
    let _text = driver::llvm_ir(crate_dir, options)?;
    Ok(Front::default())
}
