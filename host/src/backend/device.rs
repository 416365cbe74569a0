//! A backend that was chosen at run time.

use crate::backend::{Backend, BackendError, Cpu, Gpu};
use bytemuck::Pod;
use kernel_api::{Buffer, Pass};

/// One of the backends, as chosen by [`select`](crate::backend::select).
pub enum Device {
    /// This machine's processor.
    Cpu(Cpu),
    /// A GPU, or what stands in for one.
    Gpu(Box<Gpu>),
}

/// Calls the same method of whichever backend it is.
macro_rules! each {
    ($self:ident, $backend:ident => $call:expr) => {
        match $self {
            Device::Cpu($backend) => $call,
            Device::Gpu($backend) => $call,
        }
    };
}

impl Backend for Device {
    fn describe(&self) -> String {
        each!(self, backend => backend.describe())
    }

    fn create<T: Pod>(&mut self, label: &'static str, len: usize) -> Result<Buffer<T>, BackendError> {
        each!(self, backend => backend.create(label, len))
    }

    fn upload<T: Pod>(&mut self, label: &'static str, data: &[T]) -> Result<Buffer<T>, BackendError> {
        each!(self, backend => backend.upload(label, data))
    }

    fn read<T: Pod>(&mut self, buffer: Buffer<T>) -> Result<Vec<T>, BackendError> {
        each!(self, backend => backend.read(buffer))
    }

    fn release<T: Pod>(&mut self, buffer: Buffer<T>) {
        each!(self, backend => backend.release(buffer))
    }

    fn run<P: Pass>(&mut self, pass: &P, invocations: [u32; 3]) -> Result<(), BackendError> {
        each!(self, backend => backend.run(pass, invocations))
    }

    fn finish(&mut self) -> Result<(), BackendError> {
        each!(self, backend => backend.finish())
    }

    fn max_invocations_hint(&self) -> u32 {
        each!(self, backend => backend.max_invocations_hint())
    }

    fn max_buffer_bytes(&self) -> u64 {
        each!(self, backend => backend.max_buffer_bytes())
    }

    fn take_peak_bytes(&mut self) -> u64 {
        each!(self, backend => backend.take_peak_bytes())
    }
}
