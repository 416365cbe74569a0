//! Statements: control flow in SPIR-V's structured form.

use super::{EmitError, Emitter};
use crate::ir::{Id, Value};
use crate::structure::Statement;
use rspirv::dr::Operand;
use rspirv::spirv::{LoopControl, Op, SelectionControl, Word};

impl Emitter<'_> {
    pub fn statements(&mut self, statements: &[Statement]) -> Result<(), EmitError> {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), EmitError> {
        match statement {
            Statement::Instruction(id) => self.instruction(*id),
            Statement::Phi(id) => self.load_phi(*id),
            Statement::Set(values) => self.set_phis(values),
            Statement::If { condition, then, otherwise } => self.selection(condition, then, otherwise),
            Statement::Loop { body, condition, leaves_when } => self.repeat(body, condition, *leaves_when),
            Statement::Return => Ok(self.builder.ret()?),
            Statement::Unreachable => Ok(self.builder.unreachable()?),
        }
    }

    fn load_phi(&mut self, phi: Id) -> Result<(), EmitError> {
        let variable = self.phi_variable(phi)?;
        let ty = self.type_id(&self.kernel.function[phi].ty)?;
        let value = self.make_of(Op::Load, ty, &[variable])?;
        self.values.insert(phi, value);
        Ok(())
    }

    fn set_phis(&mut self, values: &[(Id, Value)]) -> Result<(), EmitError> {
        for (phi, value) in values {
            let (variable, value) = (self.phi_variable(*phi)?, self.value(value)?);
            self.store(variable, value)?;
        }
        Ok(())
    }

    /// The variable of a phi; declared when it is first met.
    ///
    /// It begins as zero, although what is read before it is set is never used: NVIDIA's compiler (driver 580.159) let whole
    /// warps leave nested loops rounds too early when such variables began undefined.
    fn phi_variable(&mut self, phi: Id) -> Result<Word, EmitError> {
        if let Some(&variable) = self.phis.get(&phi) {
            return Ok(variable);
        }
        let ty = self.type_id(&self.kernel.function[phi].ty)?;
        let zero = self.constants.zero(&mut self.builder, ty);
        let variable = self.local(ty, Some(zero));
        self.phis.insert(phi, variable);
        Ok(variable)
    }

    pub fn store(&mut self, pointer: Word, value: Word) -> Result<(), EmitError> {
        self.perform(Op::Store, vec![Operand::IdRef(pointer), Operand::IdRef(value)])
    }

    fn selection(
        &mut self,
        condition: &Value,
        then: &[Statement],
        otherwise: &[Statement],
    ) -> Result<(), EmitError> {
        let condition = self.value(condition)?;
        let merge = self.builder.id();
        let mut label = |side: &[Statement]| if side.is_empty() { merge } else { self.builder.id() };
        let labels = [label(then), label(otherwise)];
        self.builder.selection_merge(merge, SelectionControl::NONE)?;
        self.builder.branch_conditional(condition, labels[0], labels[1], [])?;
        for (label, side) in labels.into_iter().zip([then, otherwise]).filter(|(_, side)| !side.is_empty()) {
            self.builder.begin_block(Some(label))?;
            self.statements(side)?;
            self.go_to(merge)?;
        }
        self.builder.begin_block(Some(merge))?;
        Ok(())
    }

    /// Ends the current block, unless it has ended the invocation, with a branch.
    fn go_to(&mut self, label: Word) -> Result<(), EmitError> {
        if self.builder.selected_block().is_some() {
            self.builder.branch(label)?;
        }
        Ok(())
    }

    /// `done = false; loop { if done { break } body; done = condition == leaves_when }`: the one form that
    /// all drivers get right. What leaves the loop was always written by the round before.
    fn repeat(&mut self, body: &[Statement], condition: &Value, leaves_when: bool) -> Result<(), EmitError> {
        let boolean = self.constants.bool;
        let done = self.local(boolean, None);
        let [header, test, round, next, merge] = std::array::from_fn(|_| self.builder.id());
        let not_yet = self.constants.truth(&mut self.builder, false);
        self.store(done, not_yet)?;
        self.builder.branch(header)?;

        self.builder.begin_block(Some(header))?;
        self.builder.loop_merge(merge, next, LoopControl::NONE, [])?;
        self.builder.branch(test)?;

        self.builder.begin_block(Some(test))?;
        let finished = self.make_of(Op::Load, boolean, &[done])?;
        self.builder.selection_merge(round, SelectionControl::NONE)?;
        self.builder.branch_conditional(finished, merge, round, [])?;

        self.builder.begin_block(Some(round))?;
        self.statements(body)?;
        let condition = self.value(condition)?;
        let leaves = match leaves_when {
            true => condition,
            false => self.make_of(Op::LogicalNot, boolean, &[condition])?,
        };
        self.store(done, leaves)?;
        self.builder.branch(next)?;

        self.builder.begin_block(Some(next))?;
        self.builder.branch(header)?;
        self.builder.begin_block(Some(merge))?;
        Ok(())
    }
}
