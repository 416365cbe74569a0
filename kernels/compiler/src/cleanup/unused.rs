//! What nobody uses is removed.

use crate::ir::{Function, Id, Value};

/// Removes instructions without effect whose values nobody uses, phis that only use each other too. Returns whether any was there.
pub fn remove(function: &mut Function) -> bool {
    let used = used(function);
    let mut removed = false;
    for block in &mut function.blocks {
        let before = block.instructions.len();
        block.instructions.retain(|id| used[id.index()]);
        removed |= block.instructions.len() < before;
    }
    removed
}

/// For each instruction whether something that has an effect needs it.
fn used(function: &Function) -> Vec<bool> {
    let conditions = function.blocks.iter().filter_map(|block| block.terminator.operand()?.as_inst());
    let effects = function.placed().filter(|id| function[*id].op.has_effect());
    let mut open: Vec<Id> = conditions.chain(effects).collect();
    let mut used = vec![false; function.instructions.len()];
    while let Some(id) = open.pop() {
        if !std::mem::replace(&mut used[id.index()], true) {
            function[id].op.for_each_operand(|operand| open.extend(Value::as_inst(operand)));
        }
    }
    used
}
