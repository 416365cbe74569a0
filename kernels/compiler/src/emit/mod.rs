//! From the structured form to what a driver reads: SPIR-V, and WGSL for the fast profile.

pub mod spirv;
pub mod wgsl;

use crate::refusal::Reason;

/// Why a kernel cannot be written down for a target.
#[derive(Debug, thiserror::Error)]
pub enum EmitError {
    /// The target has no form for this.
    #[error("{0}")]
    Unsupported(String),
    /// The instructions do not make up a module; a defect of this compiler.
    #[error("the module cannot be assembled: {0}")]
    Assembly(#[from] rspirv::dr::Error),
}

impl EmitError {
    fn unsupported(what: impl std::fmt::Debug, target: &str) -> Self {
        EmitError::Unsupported(format!("{what:?} in {target}"))
    }
}

impl From<EmitError> for Reason {
    fn from(error: EmitError) -> Self {
        Reason::NoForm(error.to_string())
    }
}
