//! Texts of kernels made by hand, checked by naga's validator.

use super::*;
use crate::ir::{AtomicOp, Op, Space, Terminator};
use crate::structure::structure;
use crate::testing::operations::operations;
use crate::testing::places::places;
use crate::testing::{KernelBuilder, wgsl_problems, word};

fn emitted(kernel: &Kernel) -> Result<String, EmitError> {
    emit(&structure(kernel).unwrap())
}

#[test]
fn texts_are_valid() {
    for kernel in [operations().kernel, places().kernel] {
        let text = emitted(&kernel).unwrap();
        assert_eq!(wgsl_problems(&text), None, "{text}");
    }
}

#[test]
fn the_validator_finds_a_wrong_type() {
    let text = emitted(&places().kernel).unwrap();
    assert!(wgsl_problems(&text.replacen("u32(", "f32(", 1).replacen(" 1u", " 1f", 1)).is_some());
}

#[test]
fn the_loop_has_the_form_that_drivers_get_right() {
    let text = emitted(&places().kernel).unwrap();
    assert!(text.contains("  loop {\n    if done0 { break; }\n"), "{text}");
}

#[test]
fn what_has_no_form_is_refused_by_name() {
    let mut k = KernelBuilder::new(1);
    let push = k.root(Space::Push, false, 4);
    let index = k.push(0, Op::SpecConstant { id: 0, default: 0 }, Type::I32);
    k.push(0, Op::LoadWord(push, index), Type::I32);
    k.end(0, Terminator::Return);
    assert!(emitted(&k.build()).unwrap_err().to_string().contains("push constant"));

    let mut k = KernelBuilder::new(1);
    let counters = k.buffer(0, true);
    k.root_mut(counters).atomic = true;
    for op in [AtomicOp::SMin, AtomicOp::UMax] {
        k.push(0, Op::AtomicWord(op, counters, word(0), word(1)), Type::I32);
    }
    k.end(0, Terminator::Return);
    assert!(emitted(&k.build()).unwrap_err().to_string().contains("signed and unsigned"));
}

#[test]
fn a_kernel_keeps_its_name_or_is_refused() {
    let mut kernel = places().kernel;
    kernel.name = "pass".into();
    let message = emitted(&kernel).unwrap_err().to_string();
    assert!(message.contains("`pass`, which is a reserved word"), "{message}");
}
