//! Atomic accesses.

use super::{Lowering, Result};
use crate::ir::{AtomicOp, CastOp, IntPredicate, Op, RootId, Space, Type, Value};
use crate::refusal::Reason;

impl Lowering<'_> {
    /// Root and word index of an atomic access of a value of type `ty`.
    fn atomic_word(&mut self, pointer: &Value, ty: &Type, writes: bool) -> Result<(RootId, Value)> {
        if *ty != Type::I32 && *ty != Type::F32 {
            return Err(Reason::WideAtomic);
        }
        let (root, offset) = self.single(pointer)?;
        match &mut self.roots[root.index()] {
            memory if matches!(memory.space, Space::Storage { .. } | Space::Workgroup(_)) => {
                memory.written |= writes
            }
            memory => {
                let reason = format!(
                    "an atomic access to {}, which is no buffer and no workgroup memory",
                    memory.name
                );
                return Err(Reason::Pointer(reason));
            }
        }
        if !offset.is_multiple_of(4) {
            return Err(Reason::Unaligned);
        }
        Ok((root, self.scaled(&offset, 4)))
    }

    pub(super) fn atomic(&mut self, op: AtomicOp, pointer: &Value, value: &Value) -> Result<Value> {
        let (root, index) = self.atomic_word(pointer, &self.source.type_of(value), true)?;
        let value = self.build.resolve(value);
        Ok(self.build.emit(Op::AtomicWord(op, root, index, value), Type::I32))
    }

    /// Yields `{ old, whether it was as expected }`.
    pub(super) fn compare_exchange(
        &mut self,
        pointer: &Value,
        expected: &Value,
        new: &Value,
    ) -> Result<Value> {
        let (root, index) = self.atomic_word(pointer, &self.source.type_of(new), true)?;
        let (expected, new) = (self.build.resolve(expected), self.build.resolve(new));
        let old = self.build.emit(Op::CompareExchangeWord(root, index, expected.clone(), new), Type::I32);
        let same = self.build.compare(IntPredicate::Eq, &old, &expected);
        Ok(self.build.pair(old, same))
    }

    pub(super) fn atomic_load(&mut self, pointer: &Value, ty: &Type) -> Result<Value> {
        let (root, index) = self.atomic_word(pointer, ty, false)?;
        let word = self.build.emit(Op::AtomicLoadWord(root, index), Type::I32);
        Ok(self.build.cast(CastOp::Bitcast, &word, ty.clone()))
    }

    pub(super) fn atomic_store(&mut self, pointer: &Value, value: &Value) -> Result<()> {
        let (root, index) = self.atomic_word(pointer, &self.source.type_of(value), true)?;
        let value = self.build.resolve(value);
        let word = self.build.cast(CastOp::Bitcast, &value, Type::I32);
        self.build.effect(Op::AtomicStoreWord(root, index, word));
        Ok(())
    }
}
