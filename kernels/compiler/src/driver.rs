//! Runs cargo.

use crate::front::FrontOptions;
use std::path::Path;

/// Why there is no IR of a crate.
#[derive(Debug, thiserror::Error)]
pub enum DriverError {
    /// Cargo could not be started.
    #[error("cargo cannot be run: {0}")]
    Start(#[from] std::io::Error),
    /// The crate does not compile; what cargo said, whole.
    #[error("the kernel crate does not compile:\n{0}")]
    Cargo(String),
}

/// The text of the crate's optimised, structured IR.
pub fn llvm_ir(_crate_dir: &Path, _options: &FrontOptions) -> Result<String, DriverError> {
    Ok(String::new())
}
