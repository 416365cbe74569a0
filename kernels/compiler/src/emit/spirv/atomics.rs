//! Atomic operations on words. All are relaxed: only a barrier orders memory.

use super::{EmitError, Emitter};
use crate::ir::{AtomicOp, RootId, Value};
use rspirv::dr::Operand;
use rspirv::spirv::{MemorySemantics, Op, Scope, Word};

/// The instruction of an operation. Words are unsigned in the module, but `SMin` and `SMax` take them as
/// two's complement numbers.
fn opcode(op: AtomicOp) -> Op {
    match op {
        AtomicOp::Add => Op::AtomicIAdd,
        AtomicOp::Sub => Op::AtomicISub,
        AtomicOp::And => Op::AtomicAnd,
        AtomicOp::Or => Op::AtomicOr,
        AtomicOp::Xor => Op::AtomicXor,
        AtomicOp::UMin => Op::AtomicUMin,
        AtomicOp::UMax => Op::AtomicUMax,
        AtomicOp::SMin => Op::AtomicSMin,
        AtomicOp::SMax => Op::AtomicSMax,
        AtomicOp::Exchange => Op::AtomicExchange,
    }
}

impl Emitter<'_> {
    /// Pointer, scope and semantics: what all atomic instructions begin with.
    fn atomic_operands(&mut self, root: RootId, index: &Value) -> Result<Vec<Operand>, EmitError> {
        let pointer = self.word_pointer(root, index)?;
        let scope = if self.is_workgroup(root) { Scope::Workgroup } else { Scope::Device };
        let (scope, relaxed) = (self.word(scope as u32), self.word(MemorySemantics::RELAXED.bits()));
        Ok(vec![Operand::IdRef(pointer), Operand::IdScope(scope), Operand::IdMemorySemantics(relaxed)])
    }

    pub fn atomic(
        &mut self,
        op: AtomicOp,
        root: RootId,
        index: &Value,
        operand: &Value,
    ) -> Result<Word, EmitError> {
        let mut operands = self.atomic_operands(root, index)?;
        operands.push(Operand::IdRef(self.value(operand)?));
        self.make(opcode(op), self.constants.u32, operands)
    }

    pub fn atomic_load(&mut self, root: RootId, index: &Value) -> Result<Word, EmitError> {
        let operands = self.atomic_operands(root, index)?;
        self.make(Op::AtomicLoad, self.constants.u32, operands)
    }

    pub fn atomic_store(&mut self, root: RootId, index: &Value, word: &Value) -> Result<(), EmitError> {
        let mut operands = self.atomic_operands(root, index)?;
        operands.push(Operand::IdRef(self.value(word)?));
        self.perform(Op::AtomicStore, operands)
    }

    pub fn compare_exchange(
        &mut self,
        root: RootId,
        index: &Value,
        expected: &Value,
        new: &Value,
    ) -> Result<Word, EmitError> {
        let mut operands = self.atomic_operands(root, index)?;
        // The semantics once more for when it is not as expected, then the new word before the expected one.
        operands.push(operands[2].clone());
        operands.push(Operand::IdRef(self.value(new)?));
        operands.push(Operand::IdRef(self.value(expected)?));
        self.make(Op::AtomicCompareExchange, self.constants.u32, operands)
    }
}
