//! The memory of a workgroup: what is bound, what the workgroup shares, and the tables of constants.

use super::{Arguments, InterpretError};
use crate::ir::{AtomicOp, Kernel, Root, RootId, Space};

/// What memory holds that nobody has written.
const POISON: u32 = 0xdead_beef;

/// The arrays of one invocation or of one workgroup, by root; those of other roots are empty.
pub struct Arrays(Vec<Vec<u32>>);

impl Arrays {
    /// Poisoned arrays for the roots in the spaces that are `own`.
    pub fn new(kernel: &Kernel, own: impl Fn(&Space) -> bool) -> Self {
        let array = |root: &Root| match own(&root.space) {
            true => vec![POISON; root.words as usize],
            false => Vec::new(),
        };
        Self(kernel.roots.iter().map(array).collect())
    }
}

/// The memory that an invocation sees.
pub struct Memory<'a> {
    pub kernel: &'a Kernel,
    pub arguments: &'a mut Arguments,
    /// Workgroup memory.
    pub shared: Arrays,
}

impl Memory<'_> {
    /// The words of a root; `own` are the invocation's arrays.
    fn words<'w>(&'w self, root: RootId, own: &'w Arrays) -> Result<&'w [u32], InterpretError> {
        match &self.kernel.root(root).space {
            Space::Storage { set, binding } | Space::Uniform { set, binding } => {
                let (set, binding) = (*set, *binding);
                let buffer = self.arguments.buffers.get(&(set, binding));
                Ok(buffer.ok_or(InterpretError::Unbound { set, binding })?)
            }
            Space::Push => Ok(&self.arguments.push),
            Space::Workgroup(_) => Ok(&self.shared.0[root.index()]),
            Space::Local => Ok(&own.0[root.index()]),
            Space::Constant(words) => Ok(words),
        }
    }

    fn words_mut<'w>(
        &'w mut self,
        root: RootId,
        own: &'w mut Arrays,
    ) -> Result<&'w mut [u32], InterpretError> {
        match self.kernel.root(root).space {
            Space::Storage { set, binding } => {
                let buffer = self.arguments.buffers.get_mut(&(set, binding));
                Ok(buffer.ok_or(InterpretError::Unbound { set, binding })?)
            }
            Space::Workgroup(_) => Ok(&mut self.shared.0[root.index()]),
            Space::Local => Ok(&mut own.0[root.index()]),
            Space::Uniform { .. } | Space::Push | Space::Constant(_) => {
                Err(InterpretError::ReadOnly { root: self.kernel.root(root).name.clone() })
            }
        }
    }

    fn out_of_bounds(&self, root: RootId, index: u64, words: usize) -> InterpretError {
        InterpretError::OutOfBounds { root: self.kernel.root(root).name.clone(), index, words }
    }

    /// How many words a root has.
    pub fn word_count(&self, root: RootId, own: &Arrays) -> Result<u32, InterpretError> {
        Ok(self.words(root, own)?.len() as u32)
    }

    /// A word.
    pub fn load(&self, root: RootId, index: u64, own: &Arrays) -> Result<u32, InterpretError> {
        let words = self.words(root, own)?;
        let word = usize::try_from(index).ok().and_then(|index| words.get(index).copied());
        word.ok_or_else(|| self.out_of_bounds(root, index, words.len()))
    }

    /// Replaces a word by what `new` makes of it; the result is the old one.
    pub fn update(
        &mut self,
        root: RootId,
        index: u64,
        own: &mut Arrays,
        new: impl FnOnce(u32) -> u32,
    ) -> Result<u32, InterpretError> {
        let words = self.words_mut(root, own)?;
        let count = words.len();
        match usize::try_from(index).ok().and_then(|index| words.get_mut(index)) {
            Some(word) => {
                let old = *word;
                *word = new(old);
                Ok(old)
            }
            None => Err(self.out_of_bounds(root, index, count)),
        }
    }
}

/// What an atomic operation makes of a word.
pub fn atomic(op: AtomicOp, old: u32, operand: u32) -> u32 {
    match op {
        AtomicOp::Add => old.wrapping_add(operand),
        AtomicOp::Sub => old.wrapping_sub(operand),
        AtomicOp::And => old & operand,
        AtomicOp::Or => old | operand,
        AtomicOp::Xor => old ^ operand,
        AtomicOp::UMin => old.min(operand),
        AtomicOp::UMax => old.max(operand),
        AtomicOp::SMin => (old as i32).min(operand as i32) as u32,
        AtomicOp::SMax => (old as i32).max(operand as i32) as u32,
        AtomicOp::Exchange => operand,
    }
}
