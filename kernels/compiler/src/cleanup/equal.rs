//! Equal values are computed once (common subexpression elimination over dominators).

use crate::ir::{BlockId, Id, Kernel, Op, Type, Value};
use crate::structure::dominators::Dominators;
use std::collections::HashMap;

/// Makes copies of values that a dominating instruction has computed already. Returns whether there were any.
pub fn merge(kernel: &mut Kernel) -> bool {
    let successors = kernel.function.blocks.iter().map(|block| block.terminator.successors());
    let successors: Vec<Vec<usize>> =
        successors.map(|blocks| blocks.into_iter().map(BlockId::index).collect()).collect();
    let dominators = Dominators::new(&successors, 0);
    let mut known: HashMap<(Op, Type), Vec<(usize, Id)>> = HashMap::new();
    let mut changed = false;
    for &block in &dominators.reverse_postorder {
        for id in kernel.function.blocks[block].instructions.clone() {
            resolve_operands(kernel, id);
            let instruction = &kernel.function[id];
            if !is_pure(kernel, &instruction.op) {
                continue;
            }
            let places = known.entry((ordered(&instruction.op), instruction.ty.clone())).or_default();
            match places.iter().find(|(earlier, _)| dominators.dominates(*earlier, block)) {
                Some((_, earlier)) => {
                    kernel.function[id].op = Op::Copy(Value::Inst(*earlier));
                    changed = true;
                }
                None => places.push((block, id)),
            }
        }
    }
    changed
}

/// Lets `id` use what its operands have just become copies of.
fn resolve_operands(kernel: &mut Kernel, id: Id) {
    let mut op = kernel.function[id].op.clone();
    op.for_each_operand_mut(|operand| {
        while let Some(Op::Copy(original)) = kernel.function.op_of(operand) {
            *operand = original.clone();
        }
    });
    kernel.function[id].op = op;
}

/// Whether it yields the same wherever and how often it is done.
fn is_pure(kernel: &Kernel, op: &Op) -> bool {
    match op {
        Op::LoadWord(root, _) | Op::LoadVec4(root, _) => !kernel.root(*root).written,
        Op::Phi(_) | Op::Copy(_) => false,
        op => !op.has_effect(),
    }
}

/// The same operation with exchangeable operands in order.
fn ordered(op: &Op) -> Op {
    match op {
        Op::Binary(op, a, b) if op.commutes() && rank(a) > rank(b) => Op::Binary(*op, b.clone(), a.clone()),
        op => op.clone(),
    }
}

fn rank(value: &Value) -> (u32, u128) {
    match value {
        Value::Inst(id) => (0, id.0.into()),
        Value::Int(bits, value) => (*bits, *value),
        _ => (u32::MAX, 0),
    }
}
