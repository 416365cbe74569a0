//! Which backend to use.

use crate::backend::{BackendError, Cpu, Device, Gpu};

/// The arithmetic of a run (see `parallax_shared`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum Profile {
    /// The same bits on every backend.
    #[default]
    Strict,
    /// The driver's own division, square root and contraction: agreement within stated bounds.
    Fast,
}

impl Profile {
    /// Its name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Profile::Strict => "strict",
            Profile::Fast => "fast",
        }
    }
}

/// Which kind of backend is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Choice {
    /// A hardware GPU if there is a usable one, else the CPU; never a software driver.
    #[default]
    Auto,
    /// This machine's processor.
    Cpu,
    /// A GPU, or an error.
    Gpu,
}

/// What a user asks for.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// Kind of backend.
    pub backend: Choice,
    /// Part of the adapter's name, in any case.
    pub adapter: Option<String>,
    /// Arithmetic.
    pub profile: Profile,
    /// Threads of the CPU backend; 0 for one per core.
    pub threads: usize,
}

/// The backend that `selection` describes.
///
/// An automatic choice falls back on the CPU when no hardware GPU can be opened, unless an adapter is named.
/// A forced GPU may be a software driver (the first one listed) when there is no hardware; a named adapter
/// may be anything.
pub fn select(selection: &Selection) -> Result<Device, BackendError> {
    let (profile, name) = (selection.profile, selection.adapter.as_deref());
    let cpu = || Ok(Device::Cpu(Cpu::new(selection.threads)?));
    let gpu = |opened: Result<Gpu, BackendError>| Ok(Device::Gpu(Box::new(opened?)));
    match (selection.backend, name) {
        (Choice::Cpu, None) => cpu(),
        (Choice::Cpu, Some(name)) => Err(BackendError::AdapterOfCpu { name: name.into() }),
        (Choice::Gpu, _) | (Choice::Auto, Some(_)) => gpu(Gpu::open(profile, name)),
        (Choice::Auto, None) => gpu(Gpu::open_hardware(profile)).or_else(|_| cpu()),
    }
}
