//! The command: compiles a kernel crate into a folder, or checks that the folder holds what would be
//! compiled.

use clap::{Parser, ValueEnum};
use kernel_compiler::compile::{CompileError, Compiled, CrateSource, Options, Progress, compile_reporting};
use kernel_compiler::{Profile, SourcesError};
use std::path::PathBuf;
use std::process::ExitCode;

/// Compiles a Rust kernel crate to SPIR-V modules, WGSL texts and a manifest, with the stable toolchain
/// alone.
///
/// DIR then holds strict/NAME.spv and fast/NAME.spv for each kernel, fast/NAME.wgsl with --wgsl, and
/// manifest.json, which says how to bind and dispatch each module. Modules and texts of kernels that are no
/// more are removed. The bytes depend on the sources and the toolchain only.
///
/// Exit status: 0 when all is well, 1 when kernels are refused or (with --check) files differ, 2 for bad
/// usage.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    /// Folder of the kernel crate (with its Cargo.toml)
    #[arg(value_name = "CRATE")]
    source: PathBuf,
    /// Where the files go
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Write nothing; name each file in DIR that is not what would be written, and fail if there is one
    #[arg(long)]
    check: bool,
    /// Arithmetic: strict gives the CPU's bits, fast lets the driver contract and turns on the crate's
    /// feature `fast`
    #[arg(long, value_enum, default_value_t = Profiles::Both)]
    profile: Profiles,
    /// Write the fast profile's kernels as WGSL too
    #[arg(long)]
    wgsl: bool,
    /// Only these kernels; all other modules in DIR are removed
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    only: Vec<String>,
    /// Cargo features of the crate, besides `device`
    #[arg(long, value_name = "FEATURE,…", value_delimiter = ',')]
    features: Vec<String>,
    /// Where cargo builds [default: a folder in the crate's target folder]
    #[arg(long, value_name = "DIR")]
    target_dir: Option<PathBuf>,
    /// Let 64-bit integers through, which WGSL and some devices lack
    #[arg(long)]
    wide: bool,
    /// Compile with another compiler, into DIR/rust-gpu
    #[cfg(feature = "rust-gpu")]
    #[arg(long, value_enum)]
    with: Option<Other>,
    /// rust-gpu's code generator, the library librustc_codegen_spirv
    #[cfg(feature = "rust-gpu")]
    #[arg(long, value_name = "FILE", required_if_eq("with", "rust-gpu"))]
    codegen: Option<PathBuf>,
    /// The toolchain that the code generator was built for
    #[cfg(feature = "rust-gpu")]
    #[arg(long, value_name = "NAME", default_value = kernel_compiler::rust_gpu::TOOLCHAIN)]
    toolchain: String,
}

/// A compiler besides this one.
#[cfg(feature = "rust-gpu")]
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Other {
    RustGpu,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Profiles {
    Strict,
    Fast,
    Both,
}

/// Kernels are refused, or files differ.
const FAILED: u8 = 1;
/// The arguments make no sense.
const USAGE: u8 = 2;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    if arguments.wgsl && arguments.profile == Profiles::Strict {
        eprintln!("error: --wgsl needs the fast profile: WGSL cannot keep a driver from contracting");
        return ExitCode::from(USAGE);
    }
    #[cfg(feature = "rust-gpu")]
    if let (Some(Other::RustGpu), Some(codegen)) = (arguments.with, &arguments.codegen) {
        return arguments.build_with_rust_gpu(codegen);
    }
    match compile_reporting(&CrateSource::new(&arguments.source), &arguments.options(), &mut tell) {
        Ok(compiled) if arguments.check => arguments.check(&compiled),
        Ok(compiled) => arguments.write(&compiled),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(status(&error))
        }
    }
}

/// That there is no such crate or kernel is the user's affair; that it is refused the kernel's.
fn status(error: &CompileError) -> u8 {
    match error {
        CompileError::Sources(SourcesError::NoCrate(_) | SourcesError::NoPackage(_))
        | CompileError::NoSuchKernel(_) => USAGE,
        _ => FAILED,
    }
}

fn tell(progress: Progress) {
    match progress {
        Progress::Building(profile) => eprintln!("building the kernels ({profile})"),
        Progress::Kernel { name, profile, bytes } => eprintln!("  {profile}/{name}: {bytes} bytes"),
    }
}

impl Arguments {
    fn options(&self) -> Options {
        let profiles = match self.profile {
            Profiles::Strict => vec![Profile::Strict],
            Profiles::Fast => vec![Profile::Fast],
            Profiles::Both => Profile::ALL.to_vec(),
        };
        Options {
            profiles,
            wgsl: self.wgsl,
            features: self.features.clone(),
            only: self.only.clone(),
            target_dir: self.target_dir.clone(),
            wide: self.wide,
        }
    }

    fn write(&self, compiled: &Compiled) -> ExitCode {
        match compiled.write(&self.out) {
            Ok(written) => {
                written.removed.iter().for_each(|path| eprintln!("removed {}", path.display()));
                let (changed, all) = (written.changed.len(), compiled.files().len());
                eprintln!("{}: {changed} of {all} files are new or changed", self.out.display());
                ExitCode::SUCCESS
            }
            Err(error) => failed(&error),
        }
    }

    #[cfg(feature = "rust-gpu")]
    fn build_with_rust_gpu(&self, codegen: &std::path::Path) -> ExitCode {
        let rust_gpu =
            kernel_compiler::rust_gpu::RustGpu { codegen: codegen.into(), toolchain: self.toolchain.clone() };
        match rust_gpu.build(&CrateSource::new(&self.source), &self.features, &self.out) {
            Ok(names) => {
                names.iter().for_each(|name| eprintln!("  rust-gpu/{name}"));
                ExitCode::SUCCESS
            }
            Err(error) => failed(&error),
        }
    }

    fn check(&self, compiled: &Compiled) -> ExitCode {
        let differences = match compiled.differences(&self.out) {
            Ok(differences) => differences,
            Err(error) => return failed(&error),
        };
        for (path, difference) in &differences {
            eprintln!("{} {difference}", self.out.join(path).display());
        }
        if differences.is_empty() {
            eprintln!("{} is up to date: {} files", self.out.display(), compiled.files().len());
            return ExitCode::SUCCESS;
        }
        eprintln!("error: {} is not up to date; run the same command without --check", self.out.display());
        ExitCode::from(FAILED)
    }
}

fn failed(error: &dyn std::error::Error) -> ExitCode {
    eprintln!("error: {error}");
    ExitCode::from(FAILED)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn lists_are_separated_by_commas() {
        let line = ["kernel-compiler", "kernels", "--out", "spirv", "--only", "a,b", "--profile", "fast"];
        let options = Arguments::try_parse_from(line).unwrap().options();
        assert_eq!((options.only.len(), options.profiles), (2, vec![Profile::Fast]));
    }
}
