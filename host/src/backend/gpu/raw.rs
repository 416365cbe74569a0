//! Runs any module over plain words, without a declaration: for tests of the kernel compiler, and for trying
//! things out.

use super::Gpu;
use super::pipeline::{Code, Declaration, Pipeline, Slot};
use super::store::DeviceBuffer;
use crate::backend::BackendError;
use kernel_api::Access;

/// What is bound for one run of a module.
#[derive(Clone, Debug)]
pub struct RawBinding {
    /// Descriptor set.
    pub set: u32,
    /// Binding in the set.
    pub binding: u32,
    /// Uniform, read, written or atomic.
    pub access: Access,
    /// Contents before the run and, if the module can write them, after it.
    pub words: Vec<u32>,
}

impl Gpu {
    /// Runs the entry point `entry`, whose workgroups have `threads` invocations, of the SPIR-V module
    /// `words` with `groups` workgroups, and waits for it. Specialisation constants are set before, by
    /// [`specialise`](fn@super::specialise).
    ///
    /// # Errors
    /// When the module does not fit what is bound, or the device refuses it. Words that `spirv-val` would
    /// refuse may crash the driver.
    pub fn run_module(
        &self,
        words: &[u32],
        entry: &str,
        threads: [u32; 3],
        groups: [u32; 3],
        bindings: &mut [RawBinding],
        push: &[u8],
    ) -> Result<(), BackendError> {
        self.run_raw(
            &declare(entry, threads, bindings, push),
            Code::Spirv(words),
            &[],
            groups,
            bindings,
            push,
        )
    }

    /// Runs the entry point `entry` of a WGSL text with `groups` workgroups, and waits for it. `constants`
    /// (number, value) set `@id(number) override`s.
    pub fn run_wgsl(
        &self,
        text: &str,
        entry: &str,
        constants: &[(u32, u32)],
        groups: [u32; 3],
        bindings: &mut [RawBinding],
        push: &[u8],
    ) -> Result<(), BackendError> {
        let declaration = declare(entry, [1; 3], bindings, push);
        self.run_raw(&declaration, Code::Wgsl(text), constants, groups, bindings, push)
    }

    fn run_raw(
        &self,
        declaration: &Declaration<'_>,
        code: Code<'_>,
        constants: &[(u32, u32)],
        groups: [u32; 3],
        bindings: &mut [RawBinding],
        push: &[u8],
    ) -> Result<(), BackendError> {
        let connection = &self.connection;
        let pipeline = Pipeline::new(connection, declaration, code, constants)?;
        let buffers = bindings.iter().map(|binding| self.place(binding)).collect::<Result<Vec<_>, _>>()?;
        let resources: Vec<_> =
            bindings.iter().zip(&buffers).map(|(b, placed)| (b.set, b.binding, &placed.buffer)).collect();
        let mut encoder = connection.encoder();
        pipeline.record(connection, &mut encoder, &resources, push, groups);
        connection.queue.submit([encoder.finish()]);
        connection.check(|| format!("module `{}`", declaration.entry))?;
        for (binding, buffer) in bindings.iter_mut().zip(&buffers) {
            if matches!(binding.access, Access::Write | Access::Atomic) {
                binding.words = bytemuck::pod_collect_to_vec(&buffer.read(connection)?);
            }
        }
        connection.wait();
        connection.check(|| format!("module `{}`", declaration.entry))
    }

    fn place(&self, binding: &RawBinding) -> Result<DeviceBuffer, BackendError> {
        let data = bytemuck::cast_slice(&binding.words);
        if matches!(binding.access, Access::Uniform | Access::Push) {
            return DeviceBuffer::uniform(&self.connection, "uniform", data);
        }
        let buffer = DeviceBuffer::storage(&self.connection, "storage", data.len() as u64)?;
        buffer.fill(&self.connection, data);
        Ok(buffer)
    }
}

fn declare<'a>(entry: &'a str, threads: [u32; 3], bindings: &[RawBinding], push: &[u8]) -> Declaration<'a> {
    let slots = bindings.iter().map(|b| Slot { set: b.set, binding: b.binding, access: b.access });
    Declaration { entry, threads, slots: slots.collect(), push_bytes: push.len() as u32 }
}
