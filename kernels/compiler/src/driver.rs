//! Runs cargo on a kernel crate and yields the text of its optimised, structured LLVM IR.
//!
//! LLVM's own passes do the structuring, inside rustc: this is why the stable toolchain is enough. `cargo rustc` hands the flags to
//! the kernel crate alone, because build scripts and procedural macros unwind, and the structuriser crashes on that.

use crate::front::FrontOptions;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The release of rustc whose IR text this compiler reads.
pub const TOOLCHAIN: &str = "1.95.0";

/// Why there is no IR of a crate.
#[derive(Debug, thiserror::Error)]
pub enum DriverError {
    /// A program could not be started.
    #[error("`{0}` cannot be run: {1}")]
    Start(&'static str, std::io::Error),
    /// The crate does not compile; what cargo said, whole.
    #[error("the kernel crate does not compile:\n{0}")]
    Cargo(String),
    /// Cargo ended well but there is no IR, or it cannot be read.
    #[error("cargo wrote no IR to {0} ({1}): remove that folder's parent and try again")]
    NoIr(PathBuf, std::io::Error),
    /// The IR comes from another compiler.
    #[error(
        "the IR was written by {found}, but this compiler reads that of rustc {TOOLCHAIN}: pin it in rust-toolchain.toml"
    )]
    Toolchain {
        /// What the IR says of its origin.
        found: String,
    },
}

/// The passes after rustc's own: only if/else regions and loops with one latch are left.
const STRUCTURE: &str =
    "lower-switch,mergereturn,loop-simplify,fix-irreducible,unify-loop-exits,structurizecfg";

/// Everything is inlined; nothing is unrolled without need, nor widened to 64 bits, nor moved into shapes that must be undone.
const LLVM: [&str; 8] = [
    "-inline-threshold=1000000",
    "-unroll-runtime=0",
    "-unroll-allow-peeling=0",
    "-unroll-threshold=100",
    "-sink-common-insts=0",
    "-enable-gvn-hoist=0",
    "-indvars-widen-indvars=0",
    "-replexitval=never",
];

/// Calls that LLVM must neither copy nor move under other conditions.
const CONVERGENT: [&str; 9] = [
    "weight",
    "barrier",
    "subgroup_add",
    "subgroup_umin",
    "subgroup_umax",
    "subgroup_any",
    "subgroup_all",
    "subgroup_readlane",
    "subgroup_count",
];

/// The profile `kernel`, for crates whose workspace does not define it (and against one that defines it otherwise).
const PROFILE: [&str; 9] = [
    "inherits=\"release\"",
    "panic=\"abort\"",
    "opt-level=3",
    "codegen-units=1",
    "lto=false",
    "debug=false",
    "incremental=false",
    "overflow-checks=false",
    "debug-assertions=false",
];

/// Builds the library of `crate_dir` with the feature `device` (and those of `options`) and returns its IR.
///
/// Flags from the environment and from cargo's configuration are left out (`CARGO_ENCODED_RUSTFLAGS` overrides them), so that a kernel
/// does not depend on who compiles it.
///
/// # Errors
/// See [`DriverError`].
pub fn llvm_ir(crate_dir: &Path, options: &FrontOptions) -> Result<String, DriverError> {
    let crate_dir = crate_dir.canonicalize().map_err(|e| DriverError::Start("cargo", e))?;
    let target_dir = match &options.target_dir {
        Some(dir) => std::path::absolute(dir).map_err(|e| DriverError::Start("cargo", e))?,
        None => workspace_root(&crate_dir)?.join("target").join("kernels"),
    };
    let flags = rustc_flags(&crate_dir);
    let ir = target_dir.join(format!("kernels-{:016x}.ll", key(&crate_dir, &flags, options)));
    let features = std::iter::once("device").chain(options.features.iter().map(String::as_str));
    let mut cargo = cargo(&crate_dir);
    cargo.args(["rustc", "--lib", "--quiet", "--profile", "kernel", "--features"]);
    cargo.arg(features.collect::<Vec<_>>().join(",")).arg("--target-dir").arg(&target_dir);
    for setting in PROFILE {
        cargo.arg("--config").arg(format!("profile.kernel.{setting}"));
    }
    cargo.arg("--").arg(format!("--emit=llvm-ir={}", ir.display())).args(&flags);
    succeed(cargo)?;
    let text = std::fs::read_to_string(&ir).map_err(|e| DriverError::NoIr(ir, e))?;
    check_toolchain(&text)?;
    Ok(text)
}

/// What rustc is told of the kernel crate.
fn rustc_flags(crate_dir: &Path) -> Vec<String> {
    let convergent = CONVERGENT.map(|name| format!("-force-attribute=__k_{name}:convergent"));
    let llvm: Vec<&str> = LLVM.into_iter().chain(convergent.iter().map(String::as_str)).collect();
    vec![
        "-Cdebuginfo=line-tables-only".into(), // so that a refusal can say where
        "-Cno-vectorize-slp".into(),
        "-Cno-vectorize-loops".into(),
        format!("-Cllvm-args={}", llvm.join(" ")),
        format!("-Cpasses={STRUCTURE}"),
        format!("--remap-path-prefix={}=.", crate_dir.display()),
    ]
}

/// A name for the IR that differs whenever the crate or anything that is asked of rustc does: cargo does not write the IR of a fresh
/// build again. FNV-1a.
fn key(crate_dir: &Path, flags: &[String], options: &FrontOptions) -> u64 {
    let crate_dir = crate_dir.to_string_lossy();
    let parts = flags.iter().chain(&options.features).map(String::as_str).chain([&*crate_dir]);
    let bytes = parts.flat_map(|part| part.bytes().chain([0]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// `cargo` of the pinned toolchain, to be run in the crate.
fn cargo(crate_dir: &Path) -> Command {
    let mut cargo = Command::new("cargo");
    // For all crates, since functions that must be inlined into a kernel ask for it.
    cargo.current_dir(crate_dir).env("CARGO_ENCODED_RUSTFLAGS", "--cfg=kernel_ir");
    if !runs_pinned_toolchain(crate_dir) {
        cargo.env("RUSTUP_TOOLCHAIN", TOOLCHAIN);
    }
    cargo
}

/// Whether rustc, called in the crate, is the pinned one already: then it need not be named, which only rustup understands.
fn runs_pinned_toolchain(crate_dir: &Path) -> bool {
    let version = Command::new("rustc").arg("--version").current_dir(crate_dir).output();
    version.is_ok_and(|out| String::from_utf8_lossy(&out.stdout).starts_with(&format!("rustc {TOOLCHAIN} ")))
}

fn workspace_root(crate_dir: &Path) -> Result<PathBuf, DriverError> {
    let mut cargo = cargo(crate_dir);
    cargo.args(["locate-project", "--workspace", "--message-format", "plain"]);
    let manifest = PathBuf::from(String::from_utf8_lossy(&succeed(cargo)?.stdout).trim_end());
    Ok(manifest.parent().map_or_else(|| crate_dir.to_path_buf(), Path::to_path_buf))
}

/// Runs `cargo`; if it fails, all that it said is the error.
fn succeed(mut cargo: Command) -> Result<Output, DriverError> {
    let output = cargo.output().map_err(|e| DriverError::Start("cargo", e))?;
    if output.status.success() {
        return Ok(output);
    }
    Err(DriverError::Cargo(String::from_utf8_lossy(&output.stderr).into_owned()))
}

/// The IR's text form belongs to the compiler that printed it.
fn check_toolchain(ir: &str) -> Result<(), DriverError> {
    let ident = ir.lines().rev().find_map(|line| line.split_once("!{!\"rustc version "));
    let found = ident.map_or("an unknown compiler", |(_, rest)| rest.trim_end_matches("\"}"));
    if found.starts_with(&format!("{TOOLCHAIN} ")) {
        return Ok(());
    }
    Err(DriverError::Toolchain { found: found.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_compiler_is_refused() {
        assert!(check_toolchain("!0 = !{!\"rustc version 1.95.0 (59807616e 2026-04-14)\"}\n").is_ok());
        for other in ["!0 = !{!\"rustc version 1.96.0 (0 2026-06-01)\"}\n", "; nothing\n"] {
            assert!(matches!(check_toolchain(other), Err(DriverError::Toolchain { .. })));
        }
    }

    #[test]
    fn the_name_depends_on_features_and_their_borders() {
        let key = |features: &[&str]| {
            let features = features.iter().map(|f| f.to_string()).collect();
            super::key(Path::new("/crate"), &[], &FrontOptions { features, ..Default::default() })
        };
        assert_ne!(key(&[]), key(&["fast"]));
        assert_ne!(key(&["a", "b"]), key(&["ab"]));
    }

    #[test]
    fn a_folder_without_a_crate_says_what_cargo_says() {
        let dir = tempfile::tempdir().expect("a temporary folder");
        let options = FrontOptions { target_dir: Some(dir.path().join("t")), ..Default::default() };
        let error = llvm_ir(dir.path(), &options).expect_err("no crate is there").to_string();
        assert!(error.contains("could not find `Cargo.toml`"), "{error}");
    }
}
