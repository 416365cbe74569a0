//! What can go wrong between asking a backend for something and having it.

use crate::backend::gpu::SpirvError;
use thiserror::Error;

/// An error of a backend. Each text says what to do where something can be done.
#[derive(Debug, Error)]
pub enum BackendError {
    /// A handle of one backend was given to another one.
    #[error("{what}: the buffer belongs to another backend; upload the data to this one")]
    WrongOwner {
        /// The binding or the operation.
        what: String,
    },
    /// A handle outlived its buffer.
    #[error("{what}: the buffer has been released")]
    StaleBuffer {
        /// The binding or the operation.
        what: String,
    },
    /// A buffer is written by a pass and bound to it a second time.
    #[error(
        "pass `{pass}` binds one buffer both as `{first}` and as `{second}`, and writes it: use two buffers"
    )]
    Aliased {
        /// The pass.
        pass: &'static str,
        /// The first parameter.
        first: &'static str,
        /// The second parameter.
        second: &'static str,
    },
    /// Handles count elements in 32 bits.
    #[error("buffer `{label}` would have {len} elements; a buffer holds at most {max}", max = u32::MAX)]
    TooLong {
        /// The buffer's label.
        label: &'static str,
        /// Elements that were asked for.
        len: usize,
    },
    /// Memory of the machine or of the device is used up.
    #[error("not enough memory on {place} for {what}; use a smaller picture or scene, or the other backend")]
    OutOfMemory {
        /// The backend.
        place: String,
        /// What the memory was for.
        what: String,
    },
    /// More invocations along an axis than invocation ids reach.
    #[error("pass `{pass}` was asked for {invocations:?} invocations; run it in bands")]
    TooManyInvocations {
        /// The pass.
        pass: &'static str,
        /// What was asked for.
        invocations: [u32; 3],
    },
    /// A pass panicked on the CPU: a defect of the kernel. What it writes is unspecified.
    #[error("pass `{pass}` panicked: {message}")]
    Panicked {
        /// The pass.
        pass: &'static str,
        /// The panic's message.
        message: String,
    },
    /// The CPU backend's threads could not be started.
    #[error("cannot start {threads} threads: {message}")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// What the system said.
        message: String,
    },
    /// No adapter can be used.
    #[error("no usable GPU: {reason}")]
    NoAdapter {
        /// Why.
        reason: String,
    },
    /// No adapter has the name that was asked for.
    #[error("no adapter is called `{name}`; there are {available}")]
    UnknownAdapter {
        /// What was asked for.
        name: String,
        /// The names that there are.
        available: String,
    },
    /// An adapter that was asked for lacks something.
    #[error("`{adapter}` cannot be used: {reason}")]
    Unusable {
        /// The adapter.
        adapter: String,
        /// What it lacks, and what to do.
        reason: String,
    },
    /// An adapter was asked for, and the CPU.
    #[error("an adapter (`{name}`) is no CPU: leave out `--adapter`, or ask for `--backend gpu`")]
    AdapterOfCpu {
        /// What was asked for.
        name: String,
    },
    /// A kernel needs what the adapter does not have.
    #[error("`{adapter}` has no {feature}, which `{entry}` needs; use another adapter, or `--backend cpu`")]
    MissingFeature {
        /// The adapter.
        adapter: String,
        /// The entry point.
        entry: String,
        /// What is missing.
        feature: &'static str,
    },
    /// There is no device code of an entry point.
    #[error(
        "there is no {profile} module of `{entry}`: compile its crate with kernel-compiler and add it by `with_modules`"
    )]
    NoModule {
        /// The entry point.
        entry: &'static str,
        /// The profile.
        profile: &'static str,
    },
    /// The device code of an entry point is not that of its declaration.
    #[error("the module of `{entry}` does not fit its declaration ({what}): compile the kernels again")]
    StaleModule {
        /// The entry point.
        entry: String,
        /// What does not fit.
        what: String,
    },
    /// The device code of an entry point is damaged.
    #[error("the module of `{entry}` cannot be read: {source}")]
    BadModule {
        /// The entry point.
        entry: String,
        /// What is wrong with it.
        source: SpirvError,
    },
    /// More of something than an adapter has.
    #[error(
        "{what}: {wanted} is more than the {limit} that `{adapter}` takes; use smaller bands, or `--backend cpu`"
    )]
    Limit {
        /// The adapter.
        adapter: String,
        /// What there is too much of.
        what: String,
        /// How much was asked for.
        wanted: u64,
        /// How much there is.
        limit: u64,
    },
    /// The driver has given the device up. Nothing that it held can be read any more.
    #[error(
        "`{adapter}` was lost ({reason}); drivers do that when a run takes too long: render in smaller bands, \
         or use `--backend cpu`"
    )]
    DeviceLost {
        /// The adapter.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// wgpu or the driver refuses something: a defect of this library, of a kernel or of the driver.
    #[error("{what} was refused by the device: {message}")]
    Rejected {
        /// What was refused.
        what: String,
        /// Why.
        message: String,
    },
}
