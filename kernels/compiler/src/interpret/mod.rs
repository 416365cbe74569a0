//! Runs lowered kernels on the CPU, word by word: a third opinion beside two drivers, which tells a defect of
//! the compiler's front half from one of its emitters or of a driver.
//!
//! It runs a kernel's blocks as they are, before they are structured. The invocations of a workgroup run one
//! after the other from barrier to barrier (or subgroup operation to subgroup operation); workgroups run one
//! after the other.
//!
//! Where SPIR-V leaves a result undefined, the interpreter is strict: what is out of bounds, divided by zero
//! or not reachable is an error. Only shifts by more than the width (by the amount modulo the width) and
//! conversions out of range (to the nearest integer) go on, since LLVM computes such values and then selects
//! others.

mod arithmetic;
mod invocation;
mod memory;
mod workgroup;

use crate::ir::Kernel;
use std::collections::BTreeMap;

/// What a kernel is run with.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Arguments {
    /// The words of each storage and uniform buffer, by set and binding.
    pub buffers: BTreeMap<(u32, u32), Vec<u32>>,
    /// The words of the push constant.
    pub push: Vec<u32>,
    /// The bits of the specialisation constants that are set; the others have their defaults.
    pub specialisation: BTreeMap<u32, u32>,
    /// Invocations of a subgroup; 0 for the whole workgroup.
    pub subgroup_size: u32,
    /// How many blocks one invocation may execute.
    pub step_limit: u64,
}

impl Default for Arguments {
    /// Nothing bound, subgroups of one invocation, ten million blocks.
    fn default() -> Self {
        Self {
            buffers: BTreeMap::new(),
            push: Vec::new(),
            specialisation: BTreeMap::new(),
            subgroup_size: 1,
            step_limit: 10_000_000,
        }
    }
}

/// Why a kernel cannot be run to its end.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum InterpretError {
    /// A buffer that the kernel accesses is not given.
    #[error("no buffer is bound to set {set}, binding {binding}")]
    Unbound {
        /// Descriptor set.
        set: u32,
        /// Binding.
        binding: u32,
    },
    /// A word outside of its buffer or array is accessed.
    #[error("word {index} of `{root}`, which has {words}, is accessed")]
    OutOfBounds {
        /// Name of the root.
        root: String,
        /// Which word.
        index: u64,
        /// How many there are.
        words: usize,
    },
    /// Memory that cannot be written is written.
    #[error("`{root}` is written, which cannot be")]
    ReadOnly {
        /// Name of the root.
        root: String,
    },
    /// An integer is divided by zero.
    #[error("an integer is divided by zero")]
    DivisionByZero,
    /// A place is reached that the kernel's author or LLVM has ruled out.
    #[error("block `{0}` ends in `unreachable`, and is reached")]
    Unreachable(String),
    /// An invocation executes more blocks than it may.
    #[error("an invocation does not end within {0} blocks")]
    StepLimit(u64),
    /// Invocations of a workgroup wait at different places.
    #[error("the invocations of a workgroup wait at different barriers or subgroup operations")]
    Divergence,
    /// A subgroup operation reads the word of an invocation that does not exist.
    #[error("lane {0} of a subgroup is read, which does not exist")]
    NoSuchLane(u32),
    /// Something that no emitter has a form for either.
    #[error("{0} cannot be interpreted")]
    Unsupported(String),
}

/// Runs `groups` workgroups of `kernel` along x, y and z; what it writes is in the buffers of `arguments`
/// then.
///
/// # Errors
/// The first [`InterpretError`]; the buffers are then as far as the kernel came.
pub fn run(kernel: &Kernel, groups: [u32; 3], arguments: &mut Arguments) -> Result<(), InterpretError> {
    for z in 0..groups[2] {
        for y in 0..groups[1] {
            for x in 0..groups[0] {
                workgroup::run(kernel, [x, y, z], groups, arguments)?;
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
