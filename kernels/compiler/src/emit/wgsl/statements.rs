//! Statements.

use super::{EmitError, Writer};
use crate::ir::{Id, Op, Type, Value};
use crate::structure::Statement;

impl Writer<'_> {
    pub fn statements(&mut self, statements: &[Statement]) -> Result<(), EmitError> {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), EmitError> {
        match statement {
            Statement::Instruction(id) => return self.instruction(*id),
            Statement::Phi(id) => self.line(&format!("let v{0} = p{0};", id.0)),
            // What is set are `let`s and constants, never variables: the order does not matter.
            Statement::Set(values) => {
                for (phi, value) in values {
                    let value = self.value(value)?;
                    self.line(&format!("p{} = {value};", phi.0));
                }
            }
            Statement::If { condition, then, otherwise } => {
                return self.selection(condition, then, otherwise);
            }
            Statement::Loop { body, condition, leaves_when } => {
                return self.repeat(body, condition, *leaves_when);
            }
            Statement::Return => self.line("return;"),
            Statement::Unreachable => {}
        }
        Ok(())
    }

    fn nested(&mut self, statements: &[Statement]) -> Result<(), EmitError> {
        self.depth += 1;
        let written = self.statements(statements);
        self.depth -= 1;
        written
    }

    fn selection(
        &mut self,
        condition: &Value,
        then: &[Statement],
        otherwise: &[Statement],
    ) -> Result<(), EmitError> {
        let condition = self.value(condition)?;
        if then.is_empty() {
            self.line(&format!("if !{condition} {{"));
            self.nested(otherwise)?;
        } else {
            self.line(&format!("if {condition} {{"));
            self.nested(then)?;
            if !otherwise.is_empty() {
                self.line("} else {");
                self.nested(otherwise)?;
            }
        }
        self.line("}");
        Ok(())
    }

    /// The same form as in SPIR-V, which the same drivers get in the end.
    fn repeat(&mut self, body: &[Statement], condition: &Value, leaves_when: bool) -> Result<(), EmitError> {
        let number = self.loops;
        self.loops += 1;
        self.line(&format!("var done{number} = false;"));
        self.line("loop {");
        self.line(&format!("  if done{number} {{ break; }}"));
        self.nested(body)?;
        let condition = self.value(condition)?;
        let not = if leaves_when { "" } else { "!" };
        self.line(&format!("  done{number} = {not}{condition};"));
        self.line("}");
        Ok(())
    }

    fn instruction(&mut self, id: Id) -> Result<(), EmitError> {
        let kernel = self.kernel;
        let instruction = &kernel.function[id];
        match &instruction.op {
            Op::StoreWord(root, index, word) => self.store_word(*root, index, word),
            Op::StoreVec4(root, element, words) => self.store_vec4(*root, element, words),
            Op::StoreComponent(root, element, component, word) => {
                self.store_component(*root, element, component, word)
            }
            Op::AtomicStoreWord(root, index, word) => self.atomic_store(*root, index, word),
            Op::Barrier => {
                self.line("workgroupBarrier();");
                Ok(())
            }
            op => {
                let value = self.expression(op, &instruction.ty)?;
                debug_assert_ne!(instruction.ty, Type::Void);
                self.line(&format!("let v{} = {value};", id.0));
                Ok(())
            }
        }
    }
}
