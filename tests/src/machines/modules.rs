//! Modules and texts, as the tools of others see them.

use crate::gpu;
use std::io::Write;
use std::path::PathBuf;
use std::process::Command;

/// A folder of this workspace.
pub fn workspace(path: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(path)
}

/// Asks `spirv-val` of the module `words`; says so when it is not installed.
///
/// # Errors
/// What it found.
///
/// # Panics
/// When it is not installed and GPU tests are required.
pub fn check_spirv(name: &str, words: &[u32]) -> anyhow::Result<()> {
    let mut file = tempfile::NamedTempFile::new()?;
    file.write_all(bytemuck::cast_slice(words))?;
    let run = Command::new("spirv-val").args(["--target-env", "vulkan1.1"]).arg(file.path()).output();
    match run {
        Ok(run) if run.status.success() => Ok(()),
        Ok(run) => {
            let text = [run.stdout, run.stderr].concat();
            anyhow::bail!("spirv-val refuses `{name}`: {}", String::from_utf8_lossy(&text))
        }
        Err(error) => {
            let required = std::env::var_os("PARALLAX_REQUIRE_GPU").is_some_and(|value| value == "1");
            gpu::require::<()>(Err(format!("spirv-val ({error}): `{name}` is not validated")), required);
            Ok(())
        }
    }
}

/// Asks naga's validator of a WGSL text.
///
/// # Errors
/// What it found.
pub fn check_wgsl(name: &str, text: &str) -> anyhow::Result<()> {
    let module = naga::front::wgsl::parse_str(text)
        .map_err(|error| anyhow::anyhow!("`{name}`: {}", error.emit_to_string(text)))?;
    let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::all());
    naga::valid::Validator::new(flags, capabilities)
        .validate(&module)
        .map_err(|error| anyhow::anyhow!("`{name}`: {}", error.emit_to_string(text)))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_that_are_no_module_are_refused() {
        if Command::new("spirv-val").arg("--version").output().is_ok() {
            let text = check_spirv("nonsense", &[1, 2, 3, 4, 5]).unwrap_err().to_string();
            assert!(text.starts_with("spirv-val refuses `nonsense`"), "{text}");
        }
    }

    #[test]
    fn wrong_texts_are_refused() {
        assert!(check_wgsl("syntax", "fn").is_err());
        assert!(check_wgsl("types", "fn f() -> u32 { return 1.5; }").is_err());
        check_wgsl("right", "fn f() -> u32 { return 1u; }").unwrap();
    }
}
