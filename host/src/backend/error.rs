//! What can go wrong between asking a backend for something and having it.

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
}
