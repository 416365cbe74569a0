//! Loop-closed form: a value that is made in a loop and used behind it goes through a variable, written at
//! the end of the body and read behind the loop.
//!
//! Drivers that run several invocations in lockstep get plain live-out values of divergent loops wrong, and
//! WGSL scopes need it.

use super::Statement;
use crate::ir::{Function, Id, Op, Value};
use std::collections::BTreeMap;

/// Brings `body` into loop-closed form, with new phis in `function`.
pub fn close_loops(function: &mut Function, body: &mut Vec<Statement>) {
    let mut uses = Uses::new();
    count_uses(function, body, &mut uses);
    Closing { function, uses, leaves_as: BTreeMap::new() }.statements(body);
}

/// How often each value is an operand.
pub(super) type Uses = BTreeMap<Id, usize>;

pub(super) fn count_uses(function: &Function, statements: &[Statement], uses: &mut Uses) {
    let mut count = |value: &Value| {
        if let Value::Inst(id) = value {
            *uses.entry(*id).or_default() += 1;
        }
    };
    for statement in statements {
        match statement {
            Statement::Instruction(id) => function[*id].op.for_each_operand(&mut count),
            Statement::Set(values) => values.iter().for_each(|(_, value)| count(value)),
            Statement::If { condition, .. } | Statement::Loop { condition, .. } => count(condition),
            Statement::Phi(_) | Statement::Return | Statement::Unreachable => {}
        }
    }
    for statement in statements {
        statement.nested().for_each(|inner| count_uses(function, inner, uses));
    }
}

/// The values that are made in `statements`, in order.
fn definitions(statements: &[Statement]) -> Vec<Id> {
    let mut made = Vec::new();
    super::for_each_statement(statements, &mut |statement| {
        if let Statement::Instruction(id) | Statement::Phi(id) = statement {
            made.push(*id);
        }
    });
    made
}

struct Closing<'a> {
    function: &'a mut Function,
    /// Uses in the whole kernel.
    uses: Uses,
    /// By which phi a value has left its loop, behind which all uses are of that phi.
    leaves_as: BTreeMap<Id, Id>,
}

impl Closing<'_> {
    fn statements(&mut self, statements: &mut Vec<Statement>) {
        let mut closed = Vec::with_capacity(statements.len());
        for mut statement in statements.drain(..) {
            let mut leaving = Vec::new();
            match &mut statement {
                Statement::Instruction(id) => self.instruction(*id),
                Statement::Set(values) => values.iter_mut().for_each(|(_, value)| self.rename(value)),
                Statement::If { condition, then, otherwise } => {
                    self.rename(condition);
                    self.statements(then);
                    self.statements(otherwise);
                }
                Statement::Loop { body, condition, .. } => {
                    self.statements(body);
                    self.rename(condition);
                    leaving = self.close(body, condition);
                }
                Statement::Phi(_) | Statement::Return | Statement::Unreachable => {}
            }
            closed.push(statement);
            closed.extend(leaving.into_iter().map(Statement::Phi));
        }
        *statements = closed;
    }

    fn instruction(&mut self, id: Id) {
        let mut op = self.function[id].op.clone();
        op.for_each_operand_mut(|value| self.rename(value));
        self.function[id].op = op;
    }

    fn rename(&self, value: &mut Value) {
        while let Value::Inst(id) = value
            && let Some(phi) = self.leaves_as.get(id)
        {
            *value = Value::Inst(*phi);
        }
    }

    /// Adds to a loop's body the variables of what leaves it; the result is their phis.
    fn close(&mut self, body: &mut Vec<Statement>, condition: &Value) -> Vec<Id> {
        let mut inside = Uses::new();
        count_uses(self.function, body, &mut inside);
        if let Value::Inst(id) = condition {
            *inside.entry(*id).or_default() += 1;
        }
        let of = |uses: &Uses, id| uses.get(&id).copied().unwrap_or(0);
        let mut phis = Vec::new();
        for value in definitions(body) {
            let outside = of(&self.uses, value).saturating_sub(of(&inside, value));
            if outside > 0 {
                let phi = self.function.push(Op::Phi(Vec::new()), self.function[value].ty.clone());
                body.push(Statement::Set(vec![(phi, Value::Inst(value))]));
                self.uses.insert(phi, outside);
                self.uses.insert(value, of(&inside, value) + 1);
                self.leaves_as.insert(value, phi);
                phis.push(phi);
            }
        }
        phis
    }
}
