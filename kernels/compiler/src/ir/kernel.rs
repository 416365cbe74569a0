//! A lowered kernel and the memory that it names.

use super::{Function, Id, RootId, Type};
use std::sync::Arc;

/// Where a root lives.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Space {
    /// A storage buffer.
    Storage {
        /// Descriptor set.
        set: u32,
        /// Binding.
        binding: u32,
    },
    /// A uniform buffer.
    Uniform {
        /// Descriptor set.
        set: u32,
        /// Binding.
        binding: u32,
    },
    /// The push constants.
    Push,
    /// Memory that a workgroup shares; numbered.
    Workgroup(u32),
    /// An array of the invocation's own.
    Local,
    /// A table of constants.
    Constant(Arc<[u32]>),
}

/// Memory that a kernel can access: an array of words.
#[derive(Clone, PartialEq, Debug)]
pub struct Root {
    /// Where it lives.
    pub space: Space,
    /// A name for messages.
    pub name: String,
    /// Whether the kernel writes it (atomically too).
    pub written: bool,
    /// Whether the kernel accesses it atomically. Then `vec4` is false.
    pub atomic: bool,
    /// Whether it is an array of four words each: records of 16-byte alignment in a storage buffer.
    pub vec4: bool,
    /// Size in words; of one element if it is a storage buffer (whose length is not known).
    pub words: u32,
    /// Size of one element as declared, in bytes.
    pub element_bytes: u32,
}

/// A kernel whose memory accesses are of words.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Name of the entry point.
    pub name: String,
    /// Invocations of a workgroup along x, y and z.
    pub threads: [u32; 3],
    /// The code.
    pub function: Function,
    /// The memory.
    pub roots: Vec<Root>,
}

impl Kernel {
    /// The root of this number.
    pub fn root(&self, id: RootId) -> &Root {
        &self.roots[id.index()]
    }

    /// The names of the values that are wider than 32 bits.
    pub fn wide_values(&self) -> Vec<Arc<str>> {
        let wide = self.function.placed().filter(|id| self.is_wide(*id));
        wide.map(|id| self.function[id].name.clone()).collect()
    }

    /// Whether an instruction makes or takes a value wider than 32 bits.
    pub fn is_wide(&self, id: Id) -> bool {
        let wide = |ty: &Type| matches!(ty, Type::Int(33..));
        let mut found = wide(&self.function[id].ty);
        self.function[id].op.for_each_operand(|value| found |= wide(&self.function.type_of(value)));
        found
    }
}
