//! Modules of kernels made by hand, checked by `spirv-val` and by looking at the shape that drivers need.

use super::*;
use crate::ir::{BlockId, Op as Ir, Terminator, Type};
use crate::structure::structure;
use crate::testing::operations::operations;
use crate::testing::places::places;
use crate::testing::{KernelBuilder, less, spirv_problems, word};
use rspirv::dr::{Loader, Module};

fn emitted(kernel: &Kernel, contract: bool) -> Vec<u32> {
    emit(&structure(kernel).unwrap(), &SpirvOptions { contract }).unwrap()
}

fn loaded(words: &[u32]) -> Module {
    let mut loader = Loader::new();
    rspirv::binary::parse_words(words, &mut loader).unwrap();
    loader.module()
}

#[test]
fn modules_are_valid() {
    for kernel in [operations().kernel, places().kernel] {
        assert_eq!(spirv_problems(&emitted(&kernel, false)), None);
        assert_eq!(spirv_problems(&emitted(&kernel, true)), None);
    }
}

#[test]
fn the_validator_finds_a_flipped_bit() {
    let mut words = emitted(&places().kernel, false);
    let last = words.len() - 1;
    words[last] ^= 1;
    if std::process::Command::new("spirv-val").arg("--version").output().is_ok() {
        assert!(spirv_problems(&words).is_some());
    }
}

#[test]
fn words_do_not_depend_on_the_run() {
    for kernel in [operations().kernel, places().kernel] {
        assert_eq!(emitted(&kernel, false), emitted(&kernel, false));
    }
}

/// Every result of a float operation is decorated in the strict profile, and none in the fast one.
#[test]
fn float_operations_are_not_contracted() {
    let kernel = operations().kernel;
    let decorated = |module: &Module| -> BTreeSet<Word> {
        let no_contraction = Operand::Decoration(rspirv::spirv::Decoration::NoContraction);
        let of = module.annotations.iter().filter(|i| i.operands.get(1) == Some(&no_contraction));
        of.map(|i| i.operands[0].unwrap_id_ref()).collect()
    };
    let strict = loaded(&emitted(&kernel, false));
    let float = |op: Op| matches!(op, Op::FAdd | Op::FSub | Op::FMul | Op::FDiv | Op::FRem | Op::FNegate);
    let results: Vec<_> =
        strict.all_inst_iter().filter(|i| float(i.class.opcode)).filter_map(|i| i.result_id).collect();
    assert_eq!(results.len(), 7);
    assert!(results.iter().all(|id| decorated(&strict).contains(id)));
    assert!(decorated(&loaded(&emitted(&kernel, true))).is_empty());
}

/// `loop { if done { break } body; done = c }`: the header goes to a block that alone decides, and the
/// continue block only goes back.
#[test]
fn a_loop_is_left_at_its_start() {
    let mut k = KernelBuilder::new(3);
    let (_, next) = k.counter(1, 0);
    let again = k.push(1, less(next, word(5)), Type::BOOL);
    k.end(0, Terminator::Branch(BlockId(1)));
    k.end(1, Terminator::Condition(again, BlockId(1), BlockId(2))).end(2, Terminator::Return);
    let module = loaded(&emitted(&k.build(), false));
    let blocks = &module.functions[0].blocks;
    let block = |id| blocks.iter().find(|b| b.label_id() == Some(id)).unwrap();
    let header =
        blocks.iter().find(|b| b.instructions.iter().any(|i| i.class.opcode == Op::LoopMerge)).unwrap();
    let (merge, next) = match &header.instructions[0].operands[..] {
        [Operand::IdRef(merge), Operand::IdRef(next), ..] => (*merge, *next),
        other => panic!("{other:?}"),
    };
    let test = block(header.instructions[1].operands[0].unwrap_id_ref());
    let opcodes: Vec<_> = test.instructions.iter().map(|i| i.class.opcode).collect();
    assert_eq!(opcodes, [Op::Load, Op::SelectionMerge, Op::BranchConditional]);
    assert_eq!(test.instructions[2].operands[1].unwrap_id_ref(), merge);
    let opcodes: Vec<_> = block(next).instructions.iter().map(|i| i.class.opcode).collect();
    assert_eq!(opcodes, [Op::Branch]);
}

/// What stands for a phi begins as zero, even where the code sets it before it is read; a loop's own variable is set in front of it.
#[test]
fn variables_of_values_begin_as_zero() {
    let mut k = KernelBuilder::new(3);
    let (_, next) = k.counter(1, 0);
    let again = k.push(1, less(next, word(5)), Type::BOOL);
    k.end(0, Terminator::Branch(BlockId(1)));
    k.end(1, Terminator::Condition(again, BlockId(1), BlockId(2))).end(2, Terminator::Return);
    let module = loaded(&emitted(&k.build(), false));
    let zeros: BTreeSet<Word> = module
        .types_global_values
        .iter()
        .filter(|i| i.class.opcode == Op::ConstantNull)
        .filter_map(|i| i.result_id)
        .collect();
    let variables =
        module.functions[0].blocks[0].instructions.iter().filter(|i| i.class.opcode == Op::Variable);
    let (begun, others): (Vec<_>, Vec<_>) = variables.partition(|i| i.operands.len() > 1);
    assert_eq!((begun.len(), others.len()), (1, 1), "the counter, and whether the loop is done");
    assert!(begun.iter().all(|i| zeros.contains(&i.operands[1].unwrap_id_ref())));
}

#[test]
fn a_specialisation_constant_keeps_its_number_and_has_one_default() {
    let mut k = KernelBuilder::new(1);
    k.push(0, Ir::SpecConstant { id: 7, default: 9 }, Type::I32);
    k.end(0, Terminator::Return);
    let module = loaded(&emitted(&k.build(), false));
    let constant = module.types_global_values.iter().find(|i| i.class.opcode == Op::SpecConstant).unwrap();
    assert_eq!(constant.operands, [Operand::LiteralBit32(9)]);
    let id = Operand::Decoration(rspirv::spirv::Decoration::SpecId);
    let decoration = module.annotations.iter().find(|i| i.operands.get(1) == Some(&id)).unwrap();
    assert_eq!(decoration.operands[2], Operand::LiteralBit32(7));

    let mut k = KernelBuilder::new(1);
    k.push(0, Ir::SpecConstant { id: 7, default: 9 }, Type::I32);
    k.push(0, Ir::SpecConstant { id: 7, default: 8 }, Type::I32);
    k.end(0, Terminator::Return);
    let error = emit(&structure(&k.build()).unwrap(), &SpirvOptions::default()).unwrap_err().to_string();
    assert!(error.contains("two defaults 9 and 8"), "{error}");
}

#[test]
fn sixty_four_bits_need_their_capability() {
    let mut k = KernelBuilder::new(1);
    let output = k.buffer(0, true);
    let long = k.push(0, Ir::Cast(crate::ir::CastOp::SExt, word(7)), Type::I64);
    let word = k.push(0, Ir::Cast(crate::ir::CastOp::Trunc, long), Type::I32);
    k.push(0, Ir::StoreWord(output, crate::testing::word(0), word), Type::Void);
    k.end(0, Terminator::Return);
    let words = emitted(&k.build(), false);
    assert_eq!(spirv_problems(&words), None);
    let capability = Operand::Capability(Capability::Int64);
    assert!(loaded(&words).capabilities.iter().any(|i| i.operands[0] == capability));
}
