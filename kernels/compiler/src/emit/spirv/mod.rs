//! SPIR-V 1.3 for Vulkan 1.1.
//!
//! Both drivers on which the modules are tested compute wrong results for some legal code, so the shape is
//! chosen with care:
//!
//! * A loop is `loop { if done { break } body; done = condition }`. lavapipe (Mesa 22.3) miscompiles a break
//!   at the end of the loop, SwiftShader a loop with its condition in the continue block.
//! * Phis are variables of the function, which drivers promote again.
//! * Every float operation is decorated `NoContraction`, unless contraction is asked for.
//! * NaN tests look at the bits, so that no driver may assume NaN away.
//!
//! The words depend on nothing but the kernel: ids are given in the order of the code.

mod arithmetic;
mod atomics;
mod constants;
mod control;
mod device;
mod math;
mod memory;
mod module;

use super::EmitError;
use crate::ir::{Builtin, Id, Kernel, Value};
use crate::structure::Structured;
use constants::Constants;
use memory::RootVariable;
use rspirv::dr::{Builder, Instruction, Operand};
use rspirv::spirv::{Capability, Op, Word};
use std::collections::{BTreeMap, BTreeSet};

/// How a module is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SpirvOptions {
    /// Whether the driver may contract float operations (to a fused multiply-add, say).
    pub contract: bool,
}

/// The words of a module with one entry point, which has the kernel's name.
///
/// # Errors
/// [`EmitError::Unsupported`] when an operation or a type has no form in SPIR-V.
pub fn emit(structured: &Structured, options: &SpirvOptions) -> Result<Vec<u32>, EmitError> {
    Emitter::new(&structured.kernel, *options).module(&structured.body)
}

/// A module in the making.
struct Emitter<'a> {
    kernel: &'a Kernel,
    options: SpirvOptions,
    builder: Builder,
    constants: Constants,
    /// The extended instruction set `GLSL.std.450`.
    glsl: Word,
    /// What has been computed.
    values: BTreeMap<Id, Word>,
    /// The variables of phis.
    phis: BTreeMap<Id, Word>,
    /// The variables of the roots, by number.
    roots: Vec<RootVariable>,
    /// Array types without a layout, by the id of their length.
    plain_arrays: BTreeMap<Word, Word>,
    builtins: BTreeMap<Builtin, Word>,
    /// Specialisation constants with their defaults.
    specialisation: BTreeMap<u32, (u32, Word)>,
    /// Variables of the function, declared at the start of its first block.
    locals: Vec<Instruction>,
    capabilities: BTreeSet<Capability>,
}

impl<'a> Emitter<'a> {
    fn new(kernel: &'a Kernel, options: SpirvOptions) -> Self {
        let mut builder = Builder::new();
        let glsl = module::preamble(&mut builder);
        let constants = Constants::new(&mut builder);
        Self {
            kernel,
            options,
            builder,
            constants,
            glsl,
            values: BTreeMap::new(),
            phis: BTreeMap::new(),
            roots: Vec::new(),
            plain_arrays: BTreeMap::new(),
            builtins: BTreeMap::new(),
            specialisation: BTreeMap::new(),
            locals: Vec::new(),
            capabilities: BTreeSet::new(),
        }
    }

    /// Appends an instruction that makes a value.
    fn make(&mut self, op: Op, ty: Word, operands: Vec<Operand>) -> Result<Word, EmitError> {
        let id = self.builder.id();
        let instruction = Instruction::new(op, Some(ty), Some(id), operands);
        self.builder.insert_into_block(rspirv::dr::InsertPoint::End, instruction)?;
        Ok(id)
    }

    /// Appends an instruction that makes a value of other values.
    fn make_of(&mut self, op: Op, ty: Word, operands: &[Word]) -> Result<Word, EmitError> {
        self.make(op, ty, operands.iter().map(|&id| Operand::IdRef(id)).collect())
    }

    /// Appends an instruction that makes no value.
    fn perform(&mut self, op: Op, operands: Vec<Operand>) -> Result<(), EmitError> {
        let instruction = Instruction::new(op, None, None, operands);
        Ok(self.builder.insert_into_block(rspirv::dr::InsertPoint::End, instruction)?)
    }

    /// The id of an operand.
    fn value(&mut self, value: &Value) -> Result<Word, EmitError> {
        match value {
            Value::Inst(id) => self.values.get(id).copied().ok_or_else(|| {
                let name = &self.kernel.function[*id].name;
                EmitError::Unsupported(format!("the value %{name}, which is used before it is made,"))
            }),
            constant => self.constant(constant),
        }
    }

    fn values(&mut self, values: &[Value]) -> Result<Vec<Word>, EmitError> {
        values.iter().map(|value| self.value(value)).collect()
    }

    /// A constant word.
    fn word(&mut self, value: u32) -> Word {
        self.constants.word(&mut self.builder, value)
    }
}

#[cfg(test)]
mod tests;
