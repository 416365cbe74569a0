//! One invocation: its values, and running it up to the next place where it waits for others.

use super::memory::{Arrays, Memory, atomic};
use super::{InterpretError, arithmetic};
use crate::ir::{
    BlockId, Builtin, Id, Instruction, Kernel, Op, RootId, Space, SubgroupOp, Terminator, Value,
};

/// Where an invocation is in its workgroup and its workgroup in the dispatch.
#[derive(Clone, Copy)]
pub struct Position {
    pub local: [u32; 3],
    pub group: [u32; 3],
    pub groups: [u32; 3],
    /// Invocations of a subgroup.
    pub subgroup_size: u32,
}

/// Why an invocation has stopped.
#[derive(Clone, PartialEq, Debug)]
pub enum Stop {
    /// At a barrier.
    Barrier(Id),
    /// At a subgroup operation, with the operands that it brings.
    Subgroup(Id, SubgroupOp, Vec<u128>),
    /// At its end.
    Finished,
}

/// An invocation in the middle of its kernel.
pub struct Invocation<'a> {
    kernel: &'a Kernel,
    position: Position,
    /// By instruction; a `<4 x i32>` has its first word lowest.
    values: Vec<u128>,
    arrays: Arrays,
    block: BlockId,
    /// The next instruction of the block.
    next: usize,
    steps: u64,
}

impl<'a> Invocation<'a> {
    /// An invocation before its first instruction.
    pub fn new(kernel: &'a Kernel, position: Position) -> Self {
        let values = vec![0; kernel.function.instructions.len()];
        let arrays = Arrays::new(kernel, |space| *space == Space::Local);
        Self { kernel, position, values, arrays, block: BlockId(0), next: 0, steps: 0 }
    }

    /// Gives the instruction at which the invocation waits its value, if it has one; the invocation then goes
    /// on behind it.
    pub fn resume(&mut self, waiting: Id, value: u128) {
        self.values[waiting.index()] = value;
        self.next += 1;
    }

    /// Runs up to the next barrier or subgroup operation, or to the end.
    pub fn run(&mut self, memory: &mut Memory) -> Result<Stop, InterpretError> {
        let kernel = self.kernel;
        loop {
            let block = &kernel.function[self.block];
            while let Some(&id) = block.instructions.get(self.next) {
                match &kernel.function[id].op {
                    Op::Barrier => return Ok(Stop::Barrier(id)),
                    Op::Subgroup(op, operands) => {
                        let operands = operands.iter().map(|v| self.value(v)).collect::<Result<_, _>>()?;
                        return Ok(Stop::Subgroup(id, *op, operands));
                    }
                    Op::Phi(_) => {}
                    _ => self.values[id.index()] = self.execute(&kernel.function[id], memory)?,
                }
                self.next += 1;
            }
            match self.successor(&block.terminator, &block.name)? {
                Some(to) => self.enter(to, memory.arguments.step_limit)?,
                None => return Ok(Stop::Finished),
            }
        }
    }

    fn successor(&self, terminator: &Terminator, name: &str) -> Result<Option<BlockId>, InterpretError> {
        Ok(match terminator {
            Terminator::Branch(to) => Some(*to),
            Terminator::Condition(condition, then, otherwise) => {
                Some(if self.value(condition)? != 0 { *then } else { *otherwise })
            }
            Terminator::Switch(value, default, cases) => {
                let value = self.value(value)?;
                Some(cases.iter().find(|case| case.0 == value).map_or(*default, |case| case.1))
            }
            Terminator::Return => None,
            Terminator::Unreachable => return Err(InterpretError::Unreachable(name.to_owned())),
        })
    }

    /// Goes to the start of a block; all its phis take their values at once.
    fn enter(&mut self, to: BlockId, limit: u64) -> Result<(), InterpretError> {
        self.steps += 1;
        if self.steps > limit {
            return Err(InterpretError::StepLimit(limit));
        }
        let function = &self.kernel.function;
        let mut phis = Vec::new();
        for &id in &function[to].instructions {
            if let Op::Phi(edges) = &function[id].op
                && let Some((value, _)) = edges.iter().find(|edge| edge.1 == self.block)
            {
                phis.push((id, self.value(value)?));
            }
        }
        phis.into_iter().for_each(|(id, value)| self.values[id.index()] = value);
        (self.block, self.next) = (to, 0);
        Ok(())
    }

    fn value(&self, value: &Value) -> Result<u128, InterpretError> {
        match value {
            Value::Inst(id) => Ok(self.values[id.index()]),
            Value::Int(_, value) => Ok(*value),
            Value::F32(bits) => Ok((*bits).into()),
            Value::Undef(_) | Value::Zero(_) => Ok(0),
            other => Err(InterpretError::Unsupported(format!("{other:?}"))),
        }
    }

    fn word(&self, value: &Value) -> Result<u32, InterpretError> {
        Ok(self.value(value)? as u32)
    }

    /// An index in words; of the first word of an element of four if `scale` is 4.
    fn index(&self, value: &Value, scale: u64) -> Result<u64, InterpretError> {
        Ok(u64::from(self.word(value)?) * scale)
    }

    /// The value that an instruction makes; 0 if it makes none.
    fn execute(&mut self, instruction: &Instruction, memory: &mut Memory) -> Result<u128, InterpretError> {
        let ty = |value: &Value| self.kernel.function.type_of(value);
        match &instruction.op {
            Op::Binary(op, a, b) => arithmetic::binary(*op, &instruction.ty, self.value(a)?, self.value(b)?),
            Op::IntCompare(predicate, a, b) => {
                Ok(arithmetic::compare_integers(*predicate, &ty(a), self.value(a)?, self.value(b)?).into())
            }
            Op::FloatCompare(predicate, a, b) => {
                Ok(arithmetic::compare_floats(*predicate, self.value(a)?, self.value(b)?).into())
            }
            Op::Select(condition, a, b) => self.value(if self.value(condition)? != 0 { a } else { b }),
            Op::Cast(op, value) => arithmetic::cast(*op, &ty(value), &instruction.ty, self.value(value)?),
            Op::FloatNegate(value) => Ok(self.value(value)? ^ 0x8000_0000),
            Op::Copy(value) => self.value(value),
            Op::Component(vector, component) => {
                Ok(self.value(vector)? >> (32 * (self.word(component)? % 4)) & 0xffff_ffff)
            }
            Op::Math(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|v| self.value(v)).collect::<Result<_, _>>()?;
                arithmetic::math(*function, &arguments)
            }
            Op::MulHigh(a, b) => Ok((self.value(a)? * self.value(b)?) >> 32),
            Op::Builtin(builtin, component) => Ok(self.builtin(*builtin, *component).into()),
            Op::SpecConstant { id, default } => {
                Ok(memory.arguments.specialisation.get(id).copied().unwrap_or(*default).into())
            }
            op => self.access(op, memory),
        }
    }

    /// An access of memory.
    fn access(&mut self, op: &Op, memory: &mut Memory) -> Result<u128, InterpretError> {
        match op {
            Op::LoadWord(root, index) | Op::AtomicLoadWord(root, index) => {
                Ok(memory.load(*root, self.index(index, 1)?, &self.arrays)?.into())
            }
            Op::LoadVec4(root, element) => {
                let first = self.index(element, 4)?;
                (0..4).try_fold(0, |words, k| {
                    let word = memory.load(*root, first + k, &self.arrays)?;
                    Ok(words | u128::from(word) << (32 * k))
                })
            }
            Op::StoreWord(root, index, word) | Op::AtomicStoreWord(root, index, word) => {
                let (index, word) = (self.index(index, 1)?, self.word(word)?);
                self.update(memory, *root, index, |_| word).map(|_| 0)
            }
            Op::StoreVec4(root, element, words) => {
                for (word, k) in words.iter().zip(0..) {
                    let (index, word) = (self.index(element, 4)? + k, self.word(word)?);
                    self.update(memory, *root, index, |_| word)?;
                }
                Ok(0)
            }
            Op::StoreComponent(root, element, component, word) => {
                let index = self.index(element, 4)? + self.index(component, 1)?;
                let word = self.word(word)?;
                self.update(memory, *root, index, |_| word).map(|_| 0)
            }
            Op::AtomicWord(op, root, index, operand) => {
                let (index, operand) = (self.index(index, 1)?, self.word(operand)?);
                self.update(memory, *root, index, |old| atomic(*op, old, operand))
            }
            Op::CompareExchangeWord(root, index, expected, new) => {
                let (index, expected, new) = (self.index(index, 1)?, self.word(expected)?, self.word(new)?);
                self.update(memory, *root, index, |old| if old == expected { new } else { old })
            }
            Op::WordCount(root) => Ok(memory.word_count(*root, &self.arrays)?.into()),
            other => Err(InterpretError::Unsupported(format!("{other:?}"))),
        }
    }

    fn update(
        &mut self,
        memory: &mut Memory,
        root: RootId,
        index: u64,
        new: impl FnOnce(u32) -> u32,
    ) -> Result<u128, InterpretError> {
        memory.update(root, index, &mut self.arrays, new).map(u128::from)
    }

    fn builtin(&self, builtin: Builtin, component: u32) -> u32 {
        let (threads, at, k) = (self.kernel.threads, self.position, component as usize % 3);
        let local_index = (at.local[2] * threads[1] + at.local[1]) * threads[0] + at.local[0];
        match builtin {
            Builtin::GlobalInvocationId => at.group[k] * threads[k] + at.local[k],
            Builtin::LocalInvocationId => at.local[k],
            Builtin::WorkgroupId => at.group[k],
            Builtin::NumWorkgroups => at.groups[k],
            Builtin::LocalInvocationIndex => local_index,
            Builtin::SubgroupSize => at.subgroup_size,
            Builtin::SubgroupLane => local_index % at.subgroup_size,
        }
    }
}
