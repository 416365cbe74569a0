//! The interpreter against values that were worked out by hand.

use super::*;
use crate::ir::{BinaryOp, BlockId, Builtin, Op, Terminator, Type};
use crate::testing::operations::operations;
use crate::testing::places::places;
use crate::testing::{KernelBuilder, less, word};

#[test]
fn every_operation_has_its_value() {
    let operations = operations();
    let mut arguments = Arguments::default();
    arguments.buffers.insert((0, 0), vec![0; operations.expected.len()]);
    arguments.buffers.insert((0, 1), operations.inputs);
    run(&operations.kernel, [1, 1, 1], &mut arguments).unwrap();
    assert_eq!(arguments.buffers[&(0, 0)], operations.expected);
}

#[test]
fn every_kind_of_memory_and_what_invocations_do_together() {
    let mut places = places();
    run(&places.kernel, [2, 1, 1], &mut places.arguments).unwrap();
    assert_eq!(places.arguments.buffers[&(0, 0)], places.expected);
    let counters = &places.arguments.buffers[&(1, 0)];
    assert_eq!((counters[0], counters[1] as i32), ((1..=8).sum(), -7));
}

/// Stores the global id at the place that it gives in a grid of three dimensions.
#[test]
fn ids_of_three_dimensions() {
    let mut k = KernelBuilder::new(1);
    k.threads([2, 3, 2]);
    let output = k.buffer(0, true);
    let mut id = |axis| k.push(0, Op::Builtin(Builtin::GlobalInvocationId, axis), Type::I32);
    let [x, y, z] = [id(0), id(1), id(2)];
    let mut binary = |op, a, b| k.push(0, Op::Binary(op, a, b), Type::I32);
    let row = binary(BinaryOp::Mul, z, word(3));
    let row = binary(BinaryOp::Add, row, y);
    let index = binary(BinaryOp::Mul, row, word(4));
    let index = binary(BinaryOp::Add, index, x);
    k.push(0, Op::StoreWord(output, index.clone(), index), Type::Void);
    k.end(0, Terminator::Return);
    let mut arguments = Arguments::default();
    arguments.buffers.insert((0, 0), vec![u32::MAX; 4 * 3 * 2]);
    run(&k.build(), [2, 1, 1], &mut arguments).unwrap();
    assert_eq!(arguments.buffers[&(0, 0)], (0..24).collect::<Vec<_>>());
}

/// What a kernel of one block does with a buffer of four words.
fn error_of(op: impl FnOnce(crate::ir::RootId) -> Op, ty: Type) -> InterpretError {
    let mut k = KernelBuilder::new(1);
    let buffer = k.buffer(0, true);
    k.push(0, op(buffer), ty);
    k.end(0, Terminator::Return);
    let mut arguments = Arguments::default();
    arguments.buffers.insert((0, 0), vec![0; 4]);
    run(&k.build(), [1, 1, 1], &mut arguments).unwrap_err()
}

#[test]
fn what_is_undefined_is_an_error() {
    let outside = error_of(|buffer| Op::LoadWord(buffer, word(4)), Type::I32);
    assert_eq!(outside, InterpretError::OutOfBounds { root: "root0".into(), index: 4, words: 4 });
    let divided = error_of(|_| Op::Binary(BinaryOp::UDiv, word(1), word(0)), Type::I32);
    assert_eq!(divided, InterpretError::DivisionByZero);
}

#[test]
fn a_missing_buffer_an_endless_loop_and_an_unreachable_place() {
    let mut k = KernelBuilder::new(1);
    let buffer = k.buffer(5, false);
    k.push(0, Op::LoadWord(buffer, word(0)), Type::I32);
    k.end(0, Terminator::Return);
    let mut arguments = Arguments { step_limit: 1000, ..Arguments::default() };
    let error = run(&k.build(), [1, 1, 1], &mut arguments).unwrap_err();
    assert_eq!(error, InterpretError::Unbound { set: 0, binding: 5 });

    let mut k = KernelBuilder::new(1);
    k.end(0, Terminator::Branch(BlockId(0)));
    assert_eq!(run(&k.build(), [1, 1, 1], &mut arguments), Err(InterpretError::StepLimit(1000)));
    let unreachable = KernelBuilder::new(1).build();
    let error = run(&unreachable, [1, 1, 1], &mut arguments).unwrap_err();
    assert_eq!(error, InterpretError::Unreachable("block0".into()));
}

#[test]
fn a_barrier_that_not_all_reach_is_an_error() {
    let mut k = KernelBuilder::new(3);
    k.threads([2, 1, 1]);
    let id = k.push(0, Op::Builtin(Builtin::LocalInvocationId, 0), Type::I32);
    let first = k.push(0, less(id, word(1)), Type::BOOL);
    k.push(1, Op::Barrier, Type::Void);
    k.end(0, Terminator::Condition(first, BlockId(1), BlockId(2)));
    k.end(1, Terminator::Branch(BlockId(2))).end(2, Terminator::Return);
    let error = run(&k.build(), [1, 1, 1], &mut Arguments::default()).unwrap_err();
    assert_eq!(error, InterpretError::Divergence);
}
