//! The front half of the compiler: from a crate to lowered kernels.

use crate::cleanup::cleanup;
use crate::driver::{self, DriverError};
use crate::ir::{Kernel, Locations, Op};
use crate::lower::{self, ENTRY, lower};
use crate::parse::{Problem, Unread, parse};
use crate::refusal::{Reason, Refusal};
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
    /// All problems of all other kernels, by kernel.
    pub refusals: Vec<Refusal>,
    /// Where the kernels' instructions come from.
    pub locations: Locations,
}

/// Builds the crate in `crate_dir` and lowers its kernels.
///
/// # Errors
/// When cargo cannot be run or the crate does not compile.
pub fn kernels(crate_dir: &Path, options: &FrontOptions) -> Result<Front, DriverError> {
    Ok(kernels_of(&driver::llvm_ir(crate_dir, options)?, options))
}

/// Lowers the kernels of a module's text.
pub fn kernels_of(text: &str, options: &FrontOptions) -> Front {
    let wanted = |symbol: &str| {
        let name = symbol.strip_prefix(ENTRY);
        name.is_some_and(|name| options.only.is_empty() || options.only.iter().any(|only| only == name))
    };
    let parsed = parse(text, wanted);
    let mut front = Front::default();
    let origin = |location: Option<u32>| parsed.module.locations.origin(location?);
    for Unread { name, problems } in parsed.unread {
        let entry = name.trim_start_matches(ENTRY);
        let refuse = |problem: Problem| Refusal::new(entry, problem.reason, origin(problem.location));
        front.refusals.extend(problems.into_iter().map(refuse));
    }
    for function in &parsed.module.functions {
        match lower(&parsed.module, function, lower::Options { vec4: !options.no_vec4 }) {
            Ok(mut kernel) => {
                cleanup(&mut kernel);
                let leftovers = leftovers(&kernel, options.wide, &parsed.module.locations);
                if leftovers.is_empty() {
                    front.kernels.push(kernel);
                }
                front.refusals.extend(leftovers);
            }
            Err(refusals) => front.refusals.extend(refusals),
        }
    }
    front.kernels.sort_by(|a, b| a.name.cmp(&b.name));
    front.refusals.sort_by(|a, b| a.entry.cmp(&b.entry));
    front.locations = parsed.module.locations;
    front
}

/// What no device can do and is still there after clean-up: each kind once for each line.
fn leftovers(kernel: &Kernel, wide: bool, locations: &Locations) -> Vec<Refusal> {
    let function = &kernel.function;
    let mut refusals: Vec<Refusal> = Vec::new();
    for id in function.placed() {
        let reason = match &function[id].op {
            Op::Source(op) => Reason::Unknown(format!("an aggregate or vector that stays whole ({op:?})")),
            _ if !wide && kernel.is_wide(id) => Reason::Wide(function[id].name.to_string()),
            _ => continue,
        };
        let origin = function[id].location.and_then(|at| locations.origin(at));
        let new = Refusal::new(&kernel.name, reason, origin);
        let kind = |refusal: &Refusal| (std::mem::discriminant(&refusal.reason), refusal.place.clone());
        if refusals.iter().all(|old| kind(old) != kind(&new)) {
            refusals.push(new);
        }
    }
    refusals
}
