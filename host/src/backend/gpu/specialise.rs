//! Sets specialisation constants in the words of a module: wgpu hands modules on as they are and has no way
//! to pass them along.
//!
//! A constant that is set becomes an ordinary one, so that the driver's compiler sees a number and removes
//! what it switches off.

use super::spirv::{Instruction, SpirvError, instructions, op};
use std::collections::BTreeMap;

const DECORATION_SPEC_ID: u32 = 1;

/// The module `words` with each constant of `set` (its number and its bits) frozen to its value.
///
/// Constants that the module does not have are ignored (a compiler drops what no instruction uses), constants
/// that are not set keep their default.
///
/// # Errors
/// When `words` are no SPIR-V module.
pub fn specialise(words: &[u32], set: &[(u32, u32)]) -> Result<Vec<u32>, SpirvError> {
    let (header, instructions) = instructions(words)?;
    let set: BTreeMap<u32, u32> = set.iter().copied().collect();
    let values: BTreeMap<u32, u32> = instructions
        .iter()
        .filter_map(spec_id)
        .filter_map(|(id, number)| Some((id, *set.get(&number)?)))
        .collect();
    let mut out = header.to_vec();
    for instruction in &instructions {
        match spec_id(instruction) {
            // A frozen constant has no number.
            Some((id, _)) if values.contains_key(&id) => {}
            _ => freeze(instruction, &values, &mut out),
        }
    }
    Ok(out)
}

/// The constant that a `SpecId` decoration is about, and its number.
fn spec_id(instruction: &Instruction<'_>) -> Option<(u32, u32)> {
    match (instruction.opcode, instruction.operands) {
        (op::DECORATE, &[id, DECORATION_SPEC_ID, number]) => Some((id, number)),
        _ => None,
    }
}

/// Appends the instruction, as an ordinary constant if it is one that `values` sets.
fn freeze(instruction: &Instruction<'_>, values: &BTreeMap<u32, u32>, out: &mut Vec<u32>) {
    let frozen = match (instruction.opcode, instruction.operands) {
        (op::SPEC_CONSTANT, &[ty, id, _]) => {
            values.get(&id).map(|&bits| vec![4 << 16 | op::CONSTANT as u32, ty, id, bits])
        }
        (op::SPEC_CONSTANT_TRUE | op::SPEC_CONSTANT_FALSE, &[ty, id]) => values.get(&id).map(|&bits| {
            let opcode = if bits != 0 { op::CONSTANT_TRUE } else { op::CONSTANT_FALSE };
            vec![3 << 16 | opcode as u32, ty, id]
        }),
        _ => None,
    };
    out.extend_from_slice(frozen.as_deref().unwrap_or(instruction.words));
}

#[cfg(test)]
mod tests {
    use super::super::spirv::tests::{instruction, module};
    use super::*;

    const TYPE: u32 = 3;

    fn spec_number(id: u32, number: u32) -> Vec<u32> {
        instruction(op::DECORATE, &[id, DECORATION_SPEC_ID, number])
    }

    #[test]
    fn a_set_constant_becomes_an_ordinary_one() {
        let words = module(&[
            spec_number(10, 1),
            spec_number(11, 2),
            instruction(op::SPEC_CONSTANT, &[TYPE, 10, 77]),
            instruction(op::SPEC_CONSTANT, &[TYPE, 11, 78]),
        ]);
        let expected = module(&[
            spec_number(11, 2),
            instruction(op::CONSTANT, &[TYPE, 10, 5]),
            instruction(op::SPEC_CONSTANT, &[TYPE, 11, 78]),
        ]);
        assert_eq!(specialise(&words, &[(1, 5)]).unwrap(), expected);
    }

    #[test]
    fn truth_values_are_constants_too() {
        let words = module(&[
            spec_number(10, 1),
            spec_number(11, 2),
            instruction(op::SPEC_CONSTANT_FALSE, &[TYPE, 10]),
            instruction(op::SPEC_CONSTANT_TRUE, &[TYPE, 11]),
        ]);
        let expected = module(&[
            instruction(op::CONSTANT_TRUE, &[TYPE, 10]),
            instruction(op::CONSTANT_FALSE, &[TYPE, 11]),
        ]);
        assert_eq!(specialise(&words, &[(1, 1), (2, 0)]).unwrap(), expected);
    }

    #[test]
    fn nothing_else_changes() {
        let words = module(&[
            spec_number(10, 4),
            instruction(op::SPEC_CONSTANT, &[TYPE, 10, 77]),
            instruction(op::CONSTANT, &[TYPE, 12, 4]),
        ]);
        assert_eq!(specialise(&words, &[]).unwrap(), words);
        assert_eq!(specialise(&words, &[(10, 1), (12, 1)]).unwrap(), words, "those are ids, not numbers");
    }

    #[test]
    fn what_is_no_module_is_refused() {
        assert_eq!(specialise(&[0; 9], &[(1, 1)]), Err(SpirvError::Header));
    }
}
