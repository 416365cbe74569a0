//! Machines that run a compiled kernel: two software drivers, which are independent compilers of the same module, and the
//! interpreter of what the module was made from.

use super::{Case, Difference};
use crate::gpu;
use kernel_compiler::Entry;
use kernel_compiler::interpret::{self, Arguments};
use kernel_compiler::ir::Kernel;
use parallax::backend::gpu::specialise;
use parallax::backend::{self, Gpu};
use std::fmt;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Drivers are opened and used by one test at a time: two of them in one process, opened at once, have crashed.
static DRIVERS: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    DRIVERS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Something that runs kernels.
pub enum Machine {
    /// The interpreter, with subgroups of so many invocations (0: of the whole workgroup).
    Interpreter(u32),
    /// A driver.
    Driver(gpu::Driver, Box<Gpu>),
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Machine::Interpreter(0) => write!(f, "the interpreter"),
            Machine::Interpreter(size) => write!(f, "the interpreter with subgroups of {size}"),
            Machine::Driver(driver, _) => write!(f, "{driver:?}"),
        }
    }
}

impl Machine {
    /// The interpreter and the drivers of this machine; [`gpu::open`] says what is missing.
    ///
    /// # Panics
    /// When a driver is missing that is required.
    pub fn all() -> Vec<Machine> {
        let interpreters = [0, 8].map(Machine::Interpreter);
        interpreters.into_iter().chain(gpu::Driver::SOFTWARE.into_iter().filter_map(Machine::open)).collect()
    }

    /// A driver, if it is there.
    ///
    /// # Panics
    /// When it is required and missing.
    pub fn open(driver: gpu::Driver) -> Option<Machine> {
        let _alone = alone();
        let gpu = gpu::open(driver, backend::Profile::Strict)?;
        Some(Machine::Driver(driver, Box::new(gpu)))
    }

    /// Runs `case` by the compiled kernel `entry` and compares what it writes.
    ///
    /// # Errors
    /// The machine's, or the first difference.
    pub fn check(&self, case: &Case, entry: &Entry) -> Result<(), Trouble> {
        match self {
            Machine::Interpreter(size) => interpret(case, &entry.kernel, *size),
            Machine::Driver(_, gpu) => dispatch(gpu, case, &entry.spirv),
        }
    }

    /// Runs `case` by the WGSL text of a kernel, on a driver.
    ///
    /// # Errors
    /// The driver's, or the first difference.
    pub fn check_wgsl(&self, case: &Case, text: &str) -> Result<(), Trouble> {
        let Machine::Driver(_, gpu) = self else { return Ok(()) };
        let _alone = alone();
        let mut bindings = case.bindings.clone();
        let run = gpu.run_wgsl(text, &case.entry, &case.constants, case.groups, &mut bindings, &case.push);
        run.map_err(|error| Trouble::Machine(error.to_string()))?;
        Ok(case.compare(&bindings)?)
    }
}

/// Why a machine does not do what it should.
#[derive(Debug, thiserror::Error)]
pub enum Trouble {
    /// It writes something else.
    #[error("{0}")]
    Difference(#[from] Difference),
    /// It does not run the kernel.
    #[error("{0}")]
    Machine(String),
}

/// Runs the SPIR-V module `words` on a driver and compares.
///
/// # Errors
/// The driver's, or the first difference.
pub fn dispatch(gpu: &Gpu, case: &Case, words: &[u32]) -> Result<(), Trouble> {
    let _alone = alone();
    let words = specialise(words, &case.constants).map_err(|error| Trouble::Machine(error.to_string()))?;
    let mut bindings = case.bindings.clone();
    let run = gpu.run_module(&words, &case.entry, case.threads, case.groups, &mut bindings, &case.push);
    run.map_err(|error| Trouble::Machine(error.to_string()))?;
    Ok(case.compare(&bindings)?)
}

fn interpret(case: &Case, kernel: &Kernel, subgroup_size: u32) -> Result<(), Trouble> {
    let buffers = case.bindings.iter().map(|b| ((b.set, b.binding), b.words.clone())).collect();
    let mut arguments = Arguments {
        buffers,
        push: bytemuck::pod_collect_to_vec(&case.push),
        specialisation: case.constants.iter().copied().collect(),
        subgroup_size,
        ..Arguments::default()
    };
    let run = interpret::run(kernel, case.groups, &mut arguments);
    run.map_err(|error| Trouble::Machine(error.to_string()))?;
    let mut bindings = case.bindings.clone();
    for binding in &mut bindings {
        binding.words = arguments.buffers.remove(&(binding.set, binding.binding)).unwrap_or_default();
    }
    Ok(case.compare(&bindings)?)
}
