//! Four stores to one 16-byte record become one.

use crate::ir::{BinaryOp, BlockId, Function, Id, Kernel, Op, RootId, Value};
use std::collections::HashSet;

/// Merges the stores of each block.
pub fn merge(kernel: &mut Kernel) {
    for block in kernel.function.block_ids() {
        merge_block(kernel, block);
    }
}

/// The stores to one record that have been seen.
struct Record {
    root: RootId,
    element: Value,
    stores: [Option<(Value, Id)>; 4],
}

fn merge_block(kernel: &mut Kernel, block: BlockId) {
    let mut records: Vec<Record> = Vec::new();
    let mut merged = HashSet::new();
    for id in kernel.function[block].instructions.clone() {
        match kernel.function[id].op.clone() {
            Op::StoreComponent(root, element, component, word) => {
                let Some(component @ 0..4) = component.as_u32() else {
                    records.retain(|record| record.root != root);
                    continue;
                };
                let record = record_of(&kernel.function, &mut records, root, element);
                records[record].stores[component as usize] = Some((word, id));
                if let Some(words) = complete(&records[record]) {
                    let record = records.swap_remove(record);
                    merged.extend(
                        record.stores.into_iter().flatten().map(|store| store.1).filter(|store| *store != id),
                    );
                    kernel.function[id].op = Op::StoreVec4(root, record.element, words);
                }
            }
            Op::LoadVec4(root, _) => records.retain(|record| record.root != root),
            Op::StoreWord(..) => {} // to another root: this one is made of records
            op if op.has_effect() => records.clear(),
            _ => {}
        }
    }
    kernel.function[block].instructions.retain(|id| !merged.contains(id));
}

/// The record's number; a new one pushes out those that it might be the same as.
fn record_of(function: &Function, records: &mut Vec<Record>, root: RootId, element: Value) -> usize {
    let known = records.iter().position(|record| record.root == root && record.element == element);
    known.unwrap_or_else(|| {
        records.retain(|record| record.root != root || differ(function, &record.element, &element));
        records.push(Record { root, element, stores: Default::default() });
        records.len() - 1
    })
}

fn complete(record: &Record) -> Option<[Value; 4]> {
    let words: Vec<Value> = record.stores.iter().flatten().map(|store| store.0.clone()).collect();
    words.try_into().ok()
}

/// Whether two indices are never equal: they differ by a constant.
fn differ(function: &Function, a: &Value, b: &Value) -> bool {
    let split = |value: &Value| match function.op_of(value) {
        Some(Op::Binary(BinaryOp::Add, base, offset)) if offset.as_u32().is_some() => {
            (Some(base.clone()), offset.as_u32())
        }
        _ => match value.as_u32() {
            Some(constant) => (None, Some(constant)),
            None => (Some(value.clone()), Some(0)),
        },
    };
    let (a, b) = (split(a), split(b));
    a.0 == b.0 && a.1 != b.1
}
