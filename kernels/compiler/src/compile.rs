//! The whole way: from a crate to its modules.

use crate::driver::DriverError;
use crate::emit::{spirv, wgsl};
use crate::front::{self, Front, FrontOptions};
use crate::ir::{Kernel, Locations};
use crate::manifest::Manifest;
use crate::parse::Problem;
use crate::refusal::{Reason, Refusal};
use crate::sources::{Sources, SourcesError};
use crate::structure::structure;
use crate::{Profile, check, record};
use std::fmt;
use std::path::PathBuf;

/// A kernel crate on disk.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CrateSource {
    /// The folder with its `Cargo.toml`.
    pub dir: PathBuf,
}

impl CrateSource {
    /// The crate in the folder `dir`.
    pub fn new(dir: impl Into<PathBuf>) -> Self {
        Self { dir: dir.into() }
    }
}

/// What is made of a crate, and how.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// In which arithmetics; each kernel is compiled in each.
    pub profiles: Vec<Profile>,
    /// Whether WGSL is written too. Only the fast profile has any.
    pub wgsl: bool,
    /// Cargo features of the crate, besides `device` and, in the fast profile, `fast` if the crate has it.
    pub features: Vec<String>,
    /// The kernels to compile; all if there are none.
    pub only: Vec<String>,
    /// Where cargo builds; a folder in the crate's own target folder if `None`.
    pub target_dir: Option<PathBuf>,
    /// Lets 64-bit integers through, which SwiftShader and WGSL lack.
    pub wide: bool,
}

impl Default for Options {
    /// All kernels, strict, without WGSL and 64-bit integers.
    fn default() -> Self {
        Self {
            profiles: vec![Profile::Strict],
            wgsl: false,
            features: Vec::new(),
            only: Vec::new(),
            target_dir: None,
            wide: false,
        }
    }
}

/// A compiled kernel.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name of the entry point.
    pub name: String,
    /// Arithmetic in which it was compiled.
    pub profile: Profile,
    /// The SPIR-V module.
    pub spirv: Vec<u32>,
    /// The WGSL text, if it was asked for.
    pub wgsl: Option<String>,
    /// The lowered kernel, for the [interpreter](crate::interpret).
    pub kernel: Kernel,
}

/// Everything that was made of a crate.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// By profile and name.
    pub entries: Vec<Entry>,
    /// What a host must know of them.
    pub manifest: Manifest,
}

/// Why nothing was made of a crate.
#[derive(Debug, thiserror::Error)]
pub enum CompileError {
    /// The crate's sources cannot be found.
    #[error(transparent)]
    Sources(#[from] SourcesError),
    /// The crate does not build.
    #[error(transparent)]
    Driver(#[from] DriverError),
    /// The crate has no kernels.
    #[error("the crate has no kernels: no function with #[spirv(compute(threads(…)))]")]
    NoKernels,
    /// A kernel that was asked for does not exist.
    #[error("the crate has no kernel `{0}`")]
    NoSuchKernel(String),
    /// Kernels are refused; all problems of the crate.
    #[error("{}", Listed(.0))]
    Refused(Vec<Refusal>),
}

struct Listed<'a>(&'a [Refusal]);

impl fmt::Display for Listed<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = if self.0.len() == 1 { "problem" } else { "problems" };
        write!(f, "{} {plural}:", self.0.len())?;
        self.0.iter().try_for_each(|refusal| write!(f, "\n  {refusal}"))
    }
}

/// How far a compilation has come.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Progress<'a> {
    /// Cargo builds the crate.
    Building(Profile),
    /// A kernel is done.
    Kernel {
        /// Its name.
        name: &'a str,
        /// Its arithmetic.
        profile: Profile,
        /// Size of its module.
        bytes: usize,
    },
}

/// Compiles all kernels of a crate.
///
/// The result is a function of the sources, the options and the toolchain: the same bytes in another folder.
///
/// # Errors
/// When the crate does not build, and when kernels are refused: then all problems of all kernels come
/// together.
pub fn compile(source: &CrateSource, options: &Options) -> Result<Compiled, CompileError> {
    compile_reporting(source, options, &mut |_| {})
}

/// As [`compile`], and says how far it has come.
///
/// # Errors
/// As [`compile`].
pub fn compile_reporting(
    source: &CrateSource,
    options: &Options,
    report: &mut dyn FnMut(Progress),
) -> Result<Compiled, CompileError> {
    let sources = Sources::read(&source.dir)?;
    let (mut entries, mut refusals) = (Vec::new(), Vec::new());
    let mut profiles = options.profiles.clone();
    profiles.sort();
    profiles.dedup();
    for profile in profiles {
        report(Progress::Building(profile));
        let options_of_front = front_options(options, profile, &sources);
        let Front { kernels, refusals: found, locations } = front::kernels(&source.dir, &options_of_front)?;
        refusals.extend(found);
        for kernel in kernels {
            match entry(kernel, &locations, profile, options) {
                Ok(entry) => {
                    let (name, bytes) = (entry.name.as_str(), 4 * entry.spirv.len());
                    report(Progress::Kernel { name, profile, bytes });
                    entries.push(entry);
                }
                Err(found) => refusals.extend(found),
            }
        }
    }
    accepted(&entries, refusals, options)?;
    entries.sort_by(|a, b| (a.profile, &a.name).cmp(&(b.profile, &b.name)));
    let manifest = record::manifest(&entries, sources.sha256);
    Ok(Compiled { entries, manifest })
}

fn front_options(options: &Options, profile: Profile, sources: &Sources) -> FrontOptions {
    let mut features = options.features.clone();
    if profile == Profile::Fast && sources.features.contains("fast") {
        features.push("fast".into());
    }
    FrontOptions {
        features,
        target_dir: options.target_dir.clone(),
        only: options.only.clone(),
        wide: options.wide,
        ..FrontOptions::default()
    }
}

/// Structures, checks and emits one kernel; or all that is wrong with it.
fn entry(
    kernel: Kernel,
    locations: &Locations,
    profile: Profile,
    options: &Options,
) -> Result<Entry, Vec<Refusal>> {
    let name = kernel.name.clone();
    let refuse = |reason: Reason| Refusal::new(&name, reason, None);
    let structured = structure(&kernel).map_err(|reason| vec![refuse(reason)])?;
    let problems = check::problems(&structured, options.wide);
    if !problems.is_empty() {
        let origin = |location: Option<u32>| locations.origin(location?);
        let refuse = |problem: Problem| Refusal::new(&name, problem.reason, origin(problem.location));
        return Err(problems.into_iter().map(refuse).collect());
    }
    let spirv_options = spirv::SpirvOptions { contract: profile == Profile::Fast };
    let spirv = spirv::emit(&structured, &spirv_options).map_err(|e| vec![refuse(e.into())])?;
    let wgsl = match options.wgsl && profile == Profile::Fast {
        true => Some(wgsl::emit(&structured).map_err(|e| vec![refuse(e.into())])?),
        false => None,
    };
    Ok(Entry { name, profile, spirv, wgsl, kernel })
}

fn accepted(entries: &[Entry], refusals: Vec<Refusal>, options: &Options) -> Result<(), CompileError> {
    let mut distinct: Vec<Refusal> = Vec::new();
    for refusal in refusals {
        // Both profiles find the same.
        if !distinct.contains(&refusal) {
            distinct.push(refusal);
        }
    }
    if !distinct.is_empty() {
        return Err(CompileError::Refused(distinct));
    }
    let missing = options.only.iter().find(|name| entries.iter().all(|entry| entry.name != **name));
    match missing {
        Some(name) => Err(CompileError::NoSuchKernel(name.clone())),
        None if entries.is_empty() => Err(CompileError::NoKernels),
        None => Ok(()),
    }
}
