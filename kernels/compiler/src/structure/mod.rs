//! From blocks and branches to nested statements.
//!
//! LLVM has already made the control flow reducible and its regions nested (`structurizecfg`): what is left
//! are conditions whose two sides meet again, and loops with one latch, at which alone they are left.
//! [`structure`] writes that down as statements, in loop-closed form and with few
//! variables, and refuses anything else.

mod coalesce;
pub mod dominators;
mod loop_closed;
mod regions;

use crate::ir::{Id, Kernel, Value};
use crate::refusal::Reason;

/// A kernel as nested statements.
#[derive(Clone, Debug)]
pub struct Structured {
    /// The kernel. Its instructions are those of the statements: they are not in the form of its blocks any
    /// more.
    pub kernel: Kernel,
    /// What it does.
    pub body: Vec<Statement>,
}

/// A step of a structured kernel.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// Executes the instruction (never a phi).
    Instruction(Id),
    /// Gives the phis' variables their values for one edge; every value is read before any variable is
    /// written.
    Set(Vec<(Id, Value)>),
    /// One of two sides.
    If {
        /// Which one: the first if it holds.
        condition: Value,
        /// The first side.
        then: Vec<Statement>,
        /// The second side.
        otherwise: Vec<Statement>,
    },
    /// Does the body, at least once, until the condition at its end says that it is the last time.
    Loop {
        /// What is done each time.
        body: Vec<Statement>,
        /// Looked at after the body.
        condition: Value,
        /// The loop is left when the condition has this value.
        leaves_when: bool,
    },
    /// Reads a phi's variable: from here on its value stands for the phi.
    Phi(Id),
    /// Ends the invocation.
    Return,
    /// Is never reached.
    Unreachable,
}

impl Statement {
    /// The lists of statements inside this one.
    pub fn nested(&self) -> impl Iterator<Item = &[Statement]> {
        let (first, second): (&[Statement], &[Statement]) = match self {
            Statement::If { then, otherwise, .. } => (then, otherwise),
            Statement::Loop { body, .. } => (body, &[]),
            _ => (&[], &[]),
        };
        [first, second].into_iter()
    }
}

/// Calls `visit` for each statement, outer ones before those inside.
pub fn for_each_statement(statements: &[Statement], visit: &mut dyn FnMut(&Statement)) {
    for statement in statements {
        visit(statement);
        statement.nested().for_each(|inner| for_each_statement(inner, visit));
    }
}

/// The structured form of `kernel`, closed under loops: a value that leaves a loop does so through a phi
/// behind it.
///
/// # Errors
/// [`Reason::ControlFlow`], which names the block, when its control flow is not nested as described above.
pub fn structure(kernel: &Kernel) -> Result<Structured, Reason> {
    let mut kernel = kernel.clone();
    let mut body = regions::statements(&kernel.function)?;
    loop_closed::close_loops(&mut kernel.function, &mut body);
    coalesce::coalesce(&kernel.function, &mut body);
    Ok(Structured { kernel, body })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{BlockId, Op, Terminator, Type};
    use crate::testing::{KernelBuilder, add, less, word};

    fn condition(value: Value, then: usize, otherwise: usize) -> Terminator {
        Terminator::Condition(value, BlockId::new(then), BlockId::new(otherwise))
    }

    fn branch(to: usize) -> Terminator {
        Terminator::Branch(BlockId::new(to))
    }

    #[test]
    fn a_condition_whose_sides_meet() {
        let mut k = KernelBuilder::new(4);
        let c = k.push(0, Op::SpecConstant { id: 0, default: 1 }, Type::I32);
        let c = k.push(0, less(c, word(5)), Type::BOOL);
        let x = k.push(1, add(word(1), word(2)), Type::I32);
        let y = k.push(3, Op::Phi(vec![(x.clone(), BlockId(1)), (word(7), BlockId(2))]), Type::I32);
        k.end(0, condition(c.clone(), 1, 2)).end(1, branch(3)).end(2, branch(3)).end(3, Terminator::Return);
        let body = structure(&k.build()).unwrap().body;
        let id = |v: &Value| v.as_inst().unwrap();
        let then = vec![Statement::Instruction(id(&x)), Statement::Set(vec![(id(&y), x.clone())])];
        let otherwise = vec![Statement::Set(vec![(id(&y), word(7))])];
        assert_eq!(body[2], Statement::If { condition: c, then, otherwise });
        assert_eq!(body[3..], [Statement::Phi(id(&y)), Statement::Return]);
    }

    /// `i = 0; do { i += 1 } while i < 5; use(i)`: `i` leaves the loop through a phi.
    #[test]
    fn a_value_leaves_a_loop_through_a_phi() {
        let mut k = KernelBuilder::new(3);
        let (i, next) = k.counter(1, 0);
        let c = k.push(1, less(next.clone(), word(5)), Type::BOOL);
        let used = k.push(2, add(next.clone(), word(1)), Type::I32);
        k.end(0, branch(1)).end(1, condition(c.clone(), 1, 2)).end(2, Terminator::Return);
        let structured = structure(&k.build()).unwrap();
        let Statement::Loop { body, condition, leaves_when } = &structured.body[1] else {
            panic!("{:?}", structured.body)
        };
        assert_eq!((condition, *leaves_when), (&c, false));
        assert_eq!(body[0], Statement::Phi(i.as_inst().unwrap()));
        let Some(Statement::Set(leaving)) = body.last() else { panic!("{body:?}") };
        let [(phi, value)] = &leaving[..] else { panic!("{leaving:?}") };
        assert_eq!(*value, next);
        assert_eq!(structured.body[2], Statement::Phi(*phi));
        let user = &structured.kernel.function[used.as_inst().unwrap()].op;
        assert_eq!(*user, add(Value::Inst(*phi), word(1)));
    }

    #[test]
    fn flow_that_is_not_nested_is_refused_by_name() {
        // 0 → 1 | 2, 1 → 2 | 3, 2 → 3: block 2 lies on both sides of block 0.
        let mut k = KernelBuilder::new(4);
        let c = k.push(0, Op::SpecConstant { id: 0, default: 1 }, Type::I32);
        let c = k.push(0, less(c, word(5)), Type::BOOL);
        k.end(0, condition(c.clone(), 1, 2)).end(1, condition(c, 2, 3)).end(2, branch(3));
        k.end(3, Terminator::Return);
        let reason = structure(&k.build()).unwrap_err();
        assert!(matches!(&reason, Reason::ControlFlow(what) if what.contains("block2")), "{reason}");
    }

    #[test]
    fn a_loop_without_an_end_is_refused() {
        let mut k = KernelBuilder::new(2);
        k.end(0, branch(1)).end(1, branch(1));
        let reason = structure(&k.build()).unwrap_err();
        assert!(matches!(&reason, Reason::ControlFlow(what) if what.contains("never left")), "{reason}");
    }

    #[test]
    fn a_loop_that_is_left_in_its_middle_is_refused() {
        let mut k = KernelBuilder::new(4);
        let (_, next) = k.counter(1, 0);
        let c = k.push(1, less(next, word(5)), Type::BOOL);
        k.end(0, branch(1)).end(1, condition(c.clone(), 2, 3)).end(2, condition(c, 1, 3));
        k.end(3, Terminator::Return);
        assert!(matches!(structure(&k.build()), Err(Reason::ControlFlow(_))));
    }
}
