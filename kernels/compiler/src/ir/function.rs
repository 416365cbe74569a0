//! Functions, blocks and the module around them.

use super::{BlockId, Id, Instruction, Locations, Op, Type, Value};
use std::collections::{BTreeMap, HashSet};
use std::ops::{Index, IndexMut};
use std::sync::Arc;

/// How a block ends.
#[derive(Clone, PartialEq, Debug)]
pub enum Terminator {
    /// Goes to the block.
    Branch(BlockId),
    /// Goes to the first block if the value holds, else to the second.
    Condition(Value, BlockId, BlockId),
    /// Goes to the block of the value's case, or to the default. (rustc is told to lower these.)
    Switch(Value, BlockId, Vec<(u128, BlockId)>),
    /// Ends the invocation.
    Return,
    /// Never reached.
    Unreachable,
}

impl Terminator {
    /// The blocks that control may go to.
    pub fn successors(&self) -> Vec<BlockId> {
        match self {
            Terminator::Branch(to) => vec![*to],
            Terminator::Condition(_, then, other) => vec![*then, *other],
            Terminator::Switch(_, default, cases) => {
                std::iter::once(*default).chain(cases.iter().map(|case| case.1)).collect()
            }
            Terminator::Return | Terminator::Unreachable => vec![],
        }
    }
}

/// A sequence of instructions with one entry and one end.
#[derive(Clone, Debug)]
pub struct Block {
    /// The name in the IR, for messages.
    pub name: String,
    /// The instructions in order; phis first.
    pub instructions: Vec<Id>,
    /// How it ends.
    pub terminator: Terminator,
}

/// A function without parameters and result. Block 0 is the entry.
#[derive(Clone, Debug, Default)]
pub struct Function {
    /// The symbol.
    pub name: String,
    /// The blocks.
    pub blocks: Vec<Block>,
    /// All instructions, those that no block holds any more too.
    pub instructions: Vec<Instruction>,
}

impl Function {
    /// Adds an instruction, which no block holds yet.
    pub fn push(&mut self, op: Op, ty: Type) -> Id {
        self.instructions.push(Instruction { op, ty, exact: false, name: "".into(), location: None });
        Id::new(self.instructions.len() - 1)
    }

    /// The type of a value.
    pub fn type_of(&self, value: &Value) -> Type {
        match value {
            Value::Inst(id) => self[*id].ty.clone(),
            Value::Int(bits, _) => Type::Int(*bits),
            Value::F32(_) => Type::F32,
            Value::F64(_) => Type::F64,
            Value::Undef(ty) | Value::Zero(ty) | Value::Aggregate(ty, _) => ty.clone(),
            Value::Bytes(bytes) => Type::Array(bytes.len() as u64, Box::new(Type::Int(8))),
            Value::Global(..) => Type::Pointer,
        }
    }

    /// The operation that makes a value, if an instruction does.
    pub fn op_of(&self, value: &Value) -> Option<&Op> {
        value.as_inst().map(|id| &self[id].op)
    }

    /// The numbers of all blocks.
    pub fn block_ids(&self) -> impl DoubleEndedIterator<Item = BlockId> + use<> {
        (0..self.blocks.len()).map(BlockId::new)
    }

    /// The numbers of all instructions that blocks hold, in order.
    pub fn placed(&self) -> impl Iterator<Item = Id> {
        self.blocks.iter().flat_map(|block| block.instructions.iter().copied())
    }

    /// For each block the blocks that go to it, each once.
    pub fn predecessors(&self) -> Vec<Vec<BlockId>> {
        let mut predecessors = vec![vec![]; self.blocks.len()];
        for from in self.block_ids() {
            for to in self[from].terminator.successors() {
                if !predecessors[to.index()].contains(&from) {
                    predecessors[to.index()].push(from);
                }
            }
        }
        predecessors
    }
}

impl Index<Id> for Function {
    type Output = Instruction;

    fn index(&self, id: Id) -> &Instruction {
        &self.instructions[id.index()]
    }
}

impl IndexMut<Id> for Function {
    fn index_mut(&mut self, id: Id) -> &mut Instruction {
        &mut self.instructions[id.index()]
    }
}

impl Index<BlockId> for Function {
    type Output = Block;

    fn index(&self, id: BlockId) -> &Block {
        &self.blocks[id.index()]
    }
}

impl IndexMut<BlockId> for Function {
    fn index_mut(&mut self, id: BlockId) -> &mut Block {
        &mut self.blocks[id.index()]
    }
}

/// A global of the module.
#[derive(Clone, PartialEq, Debug)]
pub struct Global {
    /// Its type.
    pub ty: Type,
    /// Its value, unless that is not plain data (or is elsewhere).
    pub initializer: Option<Value>,
    /// Whether it is never written.
    pub constant: bool,
}

/// What was read of a module.
#[derive(Clone, Debug, Default)]
pub struct Module {
    /// Globals by name.
    pub globals: BTreeMap<Arc<str>, Global>,
    /// The kernels' entry functions, in the order of the text.
    pub functions: Vec<Function>,
    /// The names of all functions that have a body.
    pub defined: HashSet<String>,
    /// Where instructions come from.
    pub locations: Locations,
}
