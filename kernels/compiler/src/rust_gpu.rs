//! The other compiler: rust-gpu's, for whoever has its toolchain. `#[spirv]` becomes spirv-std's own attribute for it, so the same
//! crate builds.
//!
//! Untested: it takes a nightly compiler with `rustc-dev`, and rust-gpu's code generator built for it, which the machines that this
//! project is tested on do not have. That the call fits spirv-builder 0.11 is checked whenever this feature is built, with stable Rust:
//! without its default features spirv-builder loads the code generator as a library.

use crate::CrateSource;
use spirv_builder::{Capability, ModuleResult, SpirvBuilder, SpirvBuilderError};
use std::path::{Path, PathBuf};

/// The nightly that spirv-builder 0.11 wants.
pub const TOOLCHAIN: &str = "nightly-2026-08-15";

/// The target: what wgpu takes on every Vulkan driver.
const TARGET: &str = "spirv-unknown-vulkan1.1";

/// Where rust-gpu is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RustGpu {
    /// The library `librustc_codegen_spirv`.
    pub codegen: PathBuf,
    /// The toolchain that it was built for, as rustup names it.
    pub toolchain: String,
}

/// Why rust-gpu made nothing.
#[derive(Debug, thiserror::Error)]
pub enum RustGpuError {
    /// spirv-builder's error; the compiler's messages are on the terminal.
    #[error("rust-gpu: {0}")]
    Builder(#[from] SpirvBuilderError),
    /// A module cannot be copied.
    #[error("{0}: {1}")]
    File(PathBuf, std::io::Error),
}

impl RustGpu {
    /// Builds the crate and writes a module for each entry point to `out/rust-gpu/NAME.spv`; their names.
    ///
    /// # Errors
    /// When the crate does not build, or a file cannot be written.
    pub fn build(
        &self,
        source: &CrateSource,
        features: &[String],
        out: &Path,
    ) -> Result<Vec<String>, RustGpuError> {
        let mut builder = SpirvBuilder::new(&source.dir, TARGET)
            .release(true)
            .multimodule(true)
            .capability(Capability::GroupNonUniform)
            .capability(Capability::GroupNonUniformArithmetic)
            .capability(Capability::GroupNonUniformBallot)
            .capability(Capability::GroupNonUniformShuffle)
            .capability(Capability::GroupNonUniformVote)
            .shader_crate_features(std::iter::once("device".into()).chain(features.iter().cloned()))
            .rustc_codegen_spirv_location(&self.codegen);
        builder.toolchain_overwrite = Some(self.toolchain.clone());
        // Those lines are for build scripts.
        builder.build_script.dependency_info = Some(false);
        let dir = out.join("rust-gpu");
        std::fs::create_dir_all(&dir).map_err(|error| RustGpuError::File(dir.clone(), error))?;
        let mut names = Vec::new();
        for (entry, module) in modules(builder.build()?.module) {
            // The entry point's name is its path in the crate.
            let name = entry.rsplit("::").next().unwrap_or(&entry).to_string();
            let to = dir.join(format!("{name}.spv"));
            std::fs::copy(module, &to).map_err(|error| RustGpuError::File(to, error))?;
            names.push(name);
        }
        Ok(names)
    }
}

fn modules(result: ModuleResult) -> Vec<(String, PathBuf)> {
    match result {
        ModuleResult::MultiModule(modules) => modules.into_iter().collect(),
        ModuleResult::SingleModule(module) => vec![("kernels".into(), module)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_the_code_generator_it_says_so() {
        let rust_gpu =
            RustGpu { codegen: "/nowhere/librustc_codegen_spirv.so".into(), toolchain: TOOLCHAIN.into() };
        let source = CrateSource::new(env!("CARGO_MANIFEST_DIR"));
        let out = tempfile::tempdir().unwrap();
        let message = rust_gpu.build(&source, &[], out.path()).unwrap_err().to_string();
        assert!(message.starts_with("rust-gpu: "), "{message}");
    }
}
