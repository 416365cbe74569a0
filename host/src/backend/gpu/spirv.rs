//! Reads what a dispatch must know of a SPIR-V module, and sets its specialisation constants. The numbers are
//! those of the SPIR-V specification 1.6, section 3.

use std::collections::BTreeMap;
use thiserror::Error;

const MAGIC: u32 = 0x0723_0203;
const HEADER_WORDS: usize = 5;

/// The instructions that are looked at.
pub(super) mod op {
    pub const ENTRY_POINT: u16 = 15;
    pub const EXECUTION_MODE: u16 = 16;
    pub const CAPABILITY: u16 = 17;
    pub const CONSTANT_TRUE: u16 = 41;
    pub const CONSTANT_FALSE: u16 = 42;
    pub const CONSTANT: u16 = 43;
    pub const SPEC_CONSTANT_TRUE: u16 = 48;
    pub const SPEC_CONSTANT_FALSE: u16 = 49;
    pub const SPEC_CONSTANT: u16 = 50;
    pub const DECORATE: u16 = 71;
}

const LOCAL_SIZE: u32 = 17;
const DECORATION_BINDING: u32 = 33;
const DECORATION_SET: u32 = 34;
const CAPABILITY_INT64: u32 = 11;
const CAPABILITIES_SUBGROUP: std::ops::RangeInclusive<u32> = 61..=68;

/// Words that are no SPIR-V module.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SpirvError {
    /// The header is not there.
    #[error("this is no SPIR-V module: its header is missing")]
    Header,
    /// An instruction has no length, or reaches beyond the end.
    #[error("the SPIR-V module is damaged at word {0}")]
    Instruction(usize),
}

/// An instruction: its opcode, and its words after the first one.
#[derive(Clone, Copy)]
pub(super) struct Instruction<'a> {
    pub opcode: u16,
    pub operands: &'a [u32],
    /// All its words.
    pub words: &'a [u32],
}

/// The header and the instructions of a module.
pub(super) fn instructions(words: &[u32]) -> Result<(&[u32], Vec<Instruction<'_>>), SpirvError> {
    if words.len() < HEADER_WORDS || words[0] != MAGIC {
        return Err(SpirvError::Header);
    }
    let (header, mut rest) = words.split_at(HEADER_WORDS);
    let mut found = Vec::new();
    while let Some(&first) = rest.first() {
        let (opcode, length) = (first as u16, (first >> 16) as usize);
        if length == 0 || length > rest.len() {
            return Err(SpirvError::Instruction(words.len() - rest.len()));
        }
        let (instruction, behind) = rest.split_at(length);
        found.push(Instruction { opcode, operands: &instruction[1..], words: instruction });
        rest = behind;
    }
    Ok((header, found))
}

/// What a dispatch must know of a module.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Facts {
    /// Entry points and their workgroup sizes.
    pub entries: Vec<(String, [u32; 3])>,
    /// Descriptor set and binding of each resource.
    pub bindings: Vec<(u32, u32)>,
    /// Whether it needs 64-bit integers.
    pub int64: bool,
    /// Whether it uses subgroup operations.
    pub subgroup: bool,
}

impl Facts {
    /// The facts of the module `words`.
    pub fn of(words: &[u32]) -> Result<Self, SpirvError> {
        let (mut names, mut sizes) = (Vec::new(), BTreeMap::new());
        let (mut sets, mut bindings) = (BTreeMap::new(), BTreeMap::new());
        let mut facts = Self::default();
        for instruction in instructions(words)?.1 {
            match (instruction.opcode, instruction.operands) {
                (op::ENTRY_POINT, [_, id, name @ ..]) => names.push((*id, literal(name))),
                (op::EXECUTION_MODE, &[id, LOCAL_SIZE, x, y, z]) => {
                    sizes.insert(id, [x, y, z]);
                }
                (op::CAPABILITY, &[capability]) => {
                    facts.int64 |= capability == CAPABILITY_INT64;
                    facts.subgroup |= CAPABILITIES_SUBGROUP.contains(&capability);
                }
                (op::DECORATE, &[id, DECORATION_SET, set]) => {
                    sets.insert(id, set);
                }
                (op::DECORATE, &[id, DECORATION_BINDING, binding]) => {
                    bindings.insert(id, binding);
                }
                _ => {}
            }
        }
        let size_of = |id| sizes.get(&id).copied().unwrap_or([1; 3]);
        facts.entries = names.into_iter().map(|(id, name)| (name, size_of(id))).collect();
        facts.bindings =
            bindings.iter().map(|(id, &binding)| (sets.get(id).copied().unwrap_or(0), binding)).collect();
        Ok(facts)
    }

    /// The workgroup size of `entry`, if there is such an entry point.
    pub fn workgroup_size(&self, entry: &str) -> Option<[u32; 3]> {
        self.entries.iter().find(|(name, _)| name == entry).map(|&(_, size)| size)
    }
}

/// A string literal: bytes up to the first zero.
fn literal(words: &[u32]) -> String {
    let bytes = words.iter().flat_map(|word| word.to_le_bytes()).take_while(|&byte| byte != 0);
    String::from_utf8_lossy(&bytes.collect::<Vec<u8>>()).into_owned()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub fn instruction(opcode: u16, operands: &[u32]) -> Vec<u32> {
        [&[(operands.len() as u32 + 1) << 16 | opcode as u32], operands].concat()
    }

    pub fn module(instructions: &[Vec<u32>]) -> Vec<u32> {
        [vec![MAGIC, 0x0001_0300, 0, 100, 0], instructions.concat()].concat()
    }

    #[test]
    fn the_facts_of_a_module() {
        let name = [u32::from_le_bytes(*b"trac"), u32::from_le_bytes([b'e', 0, 0, 0])];
        let words = module(&[
            instruction(op::CAPABILITY, &[1]),
            instruction(op::CAPABILITY, &[CAPABILITY_INT64]),
            instruction(op::CAPABILITY, &[63]),
            instruction(op::ENTRY_POINT, &[5, 9, name[0], name[1], 4]),
            instruction(op::EXECUTION_MODE, &[9, LOCAL_SIZE, 8, 4, 2]),
            instruction(op::DECORATE, &[7, DECORATION_SET, 1]),
            instruction(op::DECORATE, &[7, DECORATION_BINDING, 3]),
        ]);
        let facts = Facts::of(&words).unwrap();
        assert_eq!(facts.workgroup_size("trace"), Some([8, 4, 2]));
        assert_eq!(facts.workgroup_size("trac"), None);
        assert_eq!(facts.bindings, [(1, 3)]);
        assert!(facts.int64 && facts.subgroup);
    }

    #[test]
    fn damaged_modules_are_refused() {
        assert_eq!(Facts::of(&[]), Err(SpirvError::Header));
        assert_eq!(Facts::of(&[1, 2, 3, 4, 5, 6]), Err(SpirvError::Header));
        assert_eq!(Facts::of(&module(&[vec![0]])), Err(SpirvError::Instruction(5)));
        let words = module(&[instruction(op::CAPABILITY, &[1]), vec![3 << 16 | 71, 1]]);
        assert_eq!(Facts::of(&words), Err(SpirvError::Instruction(7)));
    }
}
