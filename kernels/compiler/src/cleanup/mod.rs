//! Clean-up of lowered kernels.
//!
//! Lowering leaves copies, values of odd widths and much that nobody uses. In turn: [copies] are resolved, [odd
//! integers](promote) put into words, then [folding](fold), [spelling out of arithmetic with zeros](zeros), [merging of equal
//! values](equal) and [removal of unused ones](unused) repeat until nothing changes, and last four stores to one record become [one of 128 bits](stores).

pub mod builder;
pub mod copies;
pub mod equal;
pub mod fold;
pub mod promote;
pub mod stores;
pub mod unused;
pub mod zeros;

use crate::ir::{Function, Id, Kernel, Op, Value};

/// Cleans up a kernel that has just been lowered.
pub fn cleanup(kernel: &mut Kernel) {
    copies::resolve(&mut kernel.function);
    promote::odd_widths(&mut kernel.function);
    copies::resolve(&mut kernel.function);
    loop {
        let mut changed = simplify(&mut kernel.function);
        zeros::spell_out(&mut kernel.function);
        copies::resolve(&mut kernel.function);
        changed |= equal::merge(kernel);
        copies::resolve(&mut kernel.function);
        changed |= unused::remove(&mut kernel.function);
        if !changed {
            break;
        }
    }
    stores::merge(kernel);
    unused::remove(&mut kernel.function);
}

/// Makes copies of what folds. Returns whether anything did.
fn simplify(function: &mut Function) -> bool {
    let mut changed = false;
    for id in function.placed().collect::<Vec<_>>() {
        let instruction = &function[id];
        let value = match &instruction.op {
            Op::Phi(edges) => only_value(id, edges.iter().map(|edge| &edge.0)),
            op => fold::fold(function, op, &instruction.ty),
        };
        if let Some(value) = value.filter(|value| *value != Value::Inst(id)) {
            function[id].op = Op::Copy(value);
            changed = true;
        }
    }
    changed
}

/// The one value that a phi has besides itself.
fn only_value<'a>(id: Id, values: impl Iterator<Item = &'a Value>) -> Option<Value> {
    let mut others = values.filter(|value| **value != Value::Inst(id));
    let first = others.next()?;
    others.all(|value| value == first).then(|| first.clone())
}

#[cfg(test)]
mod tests;
