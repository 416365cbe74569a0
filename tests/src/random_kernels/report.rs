//! Lets machines run a batch, and tells what goes wrong.

use super::Compiled;
use crate::machines::{Machine, Trouble};
use std::fmt;
use std::path::PathBuf;

/// A machine that does not do what the native program does.
#[derive(Debug)]
pub struct Failure {
    /// Which kernel.
    pub seed: u32,
    /// Which machine.
    pub machine: String,
    /// The first difference, or why it does not run.
    pub trouble: Trouble,
    /// The source of the kernel.
    pub source: PathBuf,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failure { seed, machine, trouble, source } = self;
        write!(f, "seed {seed} on {machine}: {trouble} (`k_{seed}` in {})", source.display())
    }
}

/// Runs every kernel on every machine.
pub fn check(batch: &Compiled, machines: &[Machine]) -> Vec<Failure> {
    let mut failures = Vec::new();
    for (seed, case, entry) in &batch.kernels {
        for machine in machines {
            if let Err(trouble) = machine.check(case, entry) {
                let (machine, source) = (machine.to_string(), batch.source.clone());
                failures.push(Failure { seed: *seed, machine, trouble, source });
            }
        }
    }
    failures
}
