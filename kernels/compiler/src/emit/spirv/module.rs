//! The frame of a module: what stands before and around the code of its one function.

use super::{EmitError, Emitter};
use crate::structure::Statement;
use rspirv::binary::Assemble;
use rspirv::dr::{Builder, Instruction, Operand};
use rspirv::spirv::{self, AddressingModel, Capability, ExecutionMode, ExecutionModel, MemoryModel, Word};

/// The version, the memory model and the extended instructions; the result is the id of these.
pub fn preamble(builder: &mut Builder) -> Word {
    builder.set_version(1, 3);
    builder.capability(Capability::Shader);
    builder.memory_model(AddressingModel::Logical, MemoryModel::GLSL450);
    builder.ext_inst_import("GLSL.std.450")
}

impl Emitter<'_> {
    /// The whole module.
    pub fn module(mut self, body: &[Statement]) -> Result<Vec<u32>, EmitError> {
        self.declare_roots();
        self.declare_builtins();
        let void = self.builder.type_void();
        let signature = self.builder.type_function(void, []);
        let main = self.builder.begin_function(void, None, spirv::FunctionControl::NONE, signature)?;
        self.builder.begin_block(None)?;
        self.statements(body)?;
        if self.builder.selected_block().is_some() {
            self.builder.ret()?;
        }
        self.builder.end_function()?;
        self.insert_locals();
        self.entry_point(main);
        Ok(self.assemble())
    }

    /// A variable of the function, which begins with `initial` if there is one.
    pub fn local(&mut self, ty: Word, initial: Option<Word>) -> Word {
        let class = spirv::StorageClass::Function;
        let pointer = self.builder.type_pointer(None, class, ty);
        let id = self.builder.id();
        let operands = std::iter::once(Operand::StorageClass(class)).chain(initial.map(Operand::IdRef));
        self.locals.push(Instruction::new(spirv::Op::Variable, Some(pointer), Some(id), operands.collect()));
        id
    }

    /// SPIR-V wants all variables of a function first in its first block.
    fn insert_locals(&mut self) {
        let locals = std::mem::take(&mut self.locals);
        if let Some(block) =
            self.builder.module_mut().functions.first_mut().and_then(|f| f.blocks.first_mut())
        {
            block.instructions.splice(0..0, locals);
        }
    }

    fn declare_builtins(&mut self) {
        let function = &self.kernel.function;
        for id in function.placed() {
            if let Some(builtin) = super::device::builtin_of(&function[id].op) {
                self.declare_builtin(builtin);
            }
        }
    }

    fn entry_point(&mut self, main: Word) {
        let interface: Vec<Word> = self.builtins.values().copied().collect();
        self.builder.entry_point(ExecutionModel::GLCompute, main, self.kernel.name.clone(), interface);
        self.builder.execution_mode(main, ExecutionMode::LocalSize, self.kernel.threads);
    }

    fn assemble(mut self) -> Vec<u32> {
        for &capability in &self.capabilities {
            self.builder.capability(capability);
        }
        self.builder.module().assemble()
    }
}
