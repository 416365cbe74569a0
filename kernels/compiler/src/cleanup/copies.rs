//! Copies are replaced by what they copy.

use crate::ir::{Function, Instruction, Op, Value};

/// Lets every user of a copy use the original, and removes the copies.
pub fn resolve(function: &mut Function) {
    let originals: Vec<Option<Value>> = function.instructions.iter().map(original).collect();
    let follow = |value: &mut Value| {
        // A chain of copies has no more links than there are instructions.
        for _ in 0..originals.len() {
            match value.as_inst().and_then(|id| originals[id.index()].as_ref()) {
                Some(original) => *value = original.clone(),
                None => return,
            }
        }
    };
    for instruction in &mut function.instructions {
        instruction.op.for_each_operand_mut(follow);
    }
    for block in &mut function.blocks {
        block.instructions.retain(|id| originals[id.index()].is_none());
        if let Some(value) = block.terminator.operand_mut() {
            follow(value);
        }
    }
}

fn original(instruction: &Instruction) -> Option<Value> {
    match &instruction.op {
        Op::Copy(value) => Some(value.clone()),
        _ => None,
    }
}
