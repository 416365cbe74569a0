//! Runs a pass natively, and makes of the run a case for everything else.

use super::Case;
use bytemuck::Pod;
use kernel_api::{Access, Binding, Bound, Buffer, Pass};
use parallax::backend::gpu::RawBinding;
use parallax::backend::{Backend, Cpu};
use std::collections::BTreeMap;

/// Buffers of the CPU backend, which can be read as words whatever they hold.
pub struct Native {
    cpu: Cpu,
    words: BTreeMap<u32, Buffer<u32>>,
}

impl Native {
    /// Without buffers.
    pub fn new() -> anyhow::Result<Self> {
        Ok(Self { cpu: Cpu::new(0)?, words: BTreeMap::new() })
    }

    /// A buffer with a copy of `data`.
    pub fn upload<T: Pod>(&mut self, data: &[T]) -> anyhow::Result<Buffer<T>> {
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(data);
        let buffer = self.cpu.upload("input", &words)?;
        self.words.insert(buffer.id, buffer);
        Ok(Buffer::new(buffer.owner, buffer.id, data.len() as u32))
    }

    /// A buffer of so many elements, poisoned.
    pub fn create<T: Pod>(&mut self, len: usize) -> anyhow::Result<Buffer<T>> {
        let buffer = self.cpu.create("output", len * size_of::<T>() / 4)?;
        self.words.insert(buffer.id, buffer);
        Ok(Buffer::new(buffer.owner, buffer.id, len as u32))
    }

    /// Runs `pass` with so many workgroups: what it writes is what every other machine must write.
    pub fn case<P: Pass>(&mut self, pass: &P, groups: [u32; 3]) -> anyhow::Result<Case> {
        let bindings = self.bindings(pass)?;
        let invocations = std::array::from_fn(|axis| groups[axis] * P::THREADS[axis]);
        self.cpu.run(pass, invocations)?;
        let expected = self.bindings(pass)?.into_iter().map(|binding| binding.words).collect();
        let mut case = Case {
            name: P::NAME.into(),
            entry: P::NAME.into(),
            threads: P::THREADS,
            groups,
            bindings,
            push: Vec::new(),
            constants: Vec::new(),
            expected,
        };
        pass.bind(&mut |bound| match bound {
            Bound::Bytes { binding: Binding { access: Access::Push, .. }, bytes } => {
                case.push = bytes.to_vec()
            }
            Bound::Constant { id, bits } => case.constants.push((id, bits)),
            _ => {}
        });
        Ok(case)
    }

    /// What `pass` binds (but a push constant), as it is now.
    fn bindings<P: Pass>(&mut self, pass: &P) -> anyhow::Result<Vec<RawBinding>> {
        let mut found = Vec::new();
        pass.bind(&mut |bound| match bound {
            Bound::Buffer { binding, id, .. } => found.push((binding, Err(id))),
            Bound::Bytes { binding, bytes } if binding.access == Access::Uniform => {
                found.push((binding, Ok(bytemuck::pod_collect_to_vec(bytes))));
            }
            _ => {}
        });
        let bound = found.into_iter().map(|(binding, words)| {
            let words = words.or_else(|id| self.cpu.read(self.words[&id]))?;
            Ok(RawBinding { set: binding.set, binding: binding.binding, access: binding.access, words })
        });
        bound.collect()
    }
}
