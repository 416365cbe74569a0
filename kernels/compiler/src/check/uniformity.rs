//! Divergence: which values and which control flow may differ between the invocations of a workgroup.
//!
//! A value diverges if it is made from one that does, comes from the invocation's own builtins or memory or
//! from what another invocation may write, or is a phi that is set under divergent control flow. (The
//! loop-closed form makes that last rule cover values that invocations carry out of a loop after different
//! numbers of rounds.) Barriers and subgroup operations must not stand under divergent control flow.

use crate::ir::{Builtin, Id, Kernel, Op, Space, Value};
use crate::parse::Problem;
use crate::refusal::Reason;
use crate::structure::{Statement, Structured};
use std::collections::BTreeSet;

/// Says so if a barrier or a subgroup operation stands where not all invocations may come by together.
pub fn problems(structured: &Structured) -> Vec<Problem> {
    let mut divergence = Divergence { kernel: &structured.kernel, divergent: BTreeSet::new() };
    let mut known = usize::MAX;
    while known != divergence.divergent.len() {
        known = divergence.divergent.len();
        divergence.spread(&structured.body, false);
    }
    let mut problems = Vec::new();
    divergence.find(&structured.body, false, &mut problems);
    problems.dedup();
    problems
}

struct Divergence<'a> {
    kernel: &'a Kernel,
    divergent: BTreeSet<Id>,
}

impl Divergence<'_> {
    fn holds(&self, value: &Value) -> bool {
        matches!(value, Value::Inst(id) if self.divergent.contains(id))
    }

    /// Adds what diverges by the operands known so far; `under` tells whether the statements stand under
    /// divergent control flow.
    fn spread(&mut self, statements: &[Statement], under: bool) {
        for statement in statements {
            match statement {
                Statement::Instruction(id) if self.makes(&self.kernel.function[*id].op) => {
                    self.divergent.insert(*id);
                }
                Statement::Set(values) => {
                    let divergent = values.iter().filter(|(_, value)| under || self.holds(value));
                    let phis: Vec<Id> = divergent.map(|(phi, _)| *phi).collect();
                    self.divergent.extend(phis);
                }
                Statement::If { condition, .. } | Statement::Loop { condition, .. } => {
                    let under = under || self.holds(condition);
                    statement.nested().for_each(|inner| self.spread(inner, under));
                }
                _ => {}
            }
        }
    }

    /// Whether the operation makes a divergent value.
    fn makes(&self, op: &Op) -> bool {
        let mut from_operands = false;
        op.for_each_operand(|value| from_operands |= self.holds(value));
        match op {
            Op::Builtin(builtin, _) => {
                use Builtin::{NumWorkgroups, SubgroupSize, WorkgroupId};
                !matches!(builtin, WorkgroupId | NumWorkgroups | SubgroupSize)
            }
            Op::Subgroup(..) | Op::AtomicWord(..) | Op::CompareExchangeWord(..) | Op::AtomicLoadWord(..) => {
                true
            }
            Op::LoadWord(root, _) | Op::LoadVec4(root, _) => {
                let root = self.kernel.root(*root);
                let others_write = root.written && !matches!(root.space, Space::Workgroup(_));
                from_operands || others_write || root.space == Space::Local
            }
            _ => from_operands,
        }
    }

    fn find(&self, statements: &[Statement], under: bool, problems: &mut Vec<Problem>) {
        for statement in statements {
            match statement {
                Statement::Instruction(id) if under => {
                    let instruction = &self.kernel.function[*id];
                    let reason = match &instruction.op {
                        Op::Barrier => Some(Reason::DivergentBarrier),
                        Op::Subgroup(..) => Some(Reason::DivergentSubgroup),
                        _ => None,
                    };
                    let location = instruction.location;
                    problems.extend(reason.map(|reason| Problem { reason, location }));
                }
                Statement::If { condition, .. } | Statement::Loop { condition, .. } => {
                    let under = under || self.holds(condition);
                    statement.nested().for_each(|inner| self.find(inner, under, problems));
                }
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{BlockId, SubgroupOp, Terminator, Type};
    use crate::structure::structure;
    use crate::testing::{KernelBuilder, less, word};

    fn reasons(kernel: &Kernel) -> Vec<Reason> {
        let structured = structure(kernel).unwrap();
        problems(&structured).into_iter().map(|problem| problem.reason).collect()
    }

    /// `if source < 5 { operation }`.
    fn under_a_condition(source: Op, operation: Op) -> Vec<Reason> {
        let mut k = KernelBuilder::new(3);
        let value = k.push(0, source, Type::I32);
        let condition = k.push(0, less(value, word(5)), Type::BOOL);
        let ty = if operation == Op::Barrier { Type::Void } else { Type::I32 };
        k.push(1, operation, ty);
        k.end(0, Terminator::Condition(condition, BlockId(1), BlockId(2)));
        k.end(1, Terminator::Branch(BlockId(2))).end(2, Terminator::Return);
        reasons(&k.build())
    }

    #[test]
    fn a_barrier_under_the_invocation_id_is_refused() {
        let own = Op::Builtin(Builtin::LocalInvocationIndex, 0);
        assert_eq!(under_a_condition(own, Op::Barrier), [Reason::DivergentBarrier]);
    }

    #[test]
    fn a_barrier_under_what_is_the_same_for_the_workgroup_passes() {
        assert_eq!(under_a_condition(Op::Builtin(Builtin::WorkgroupId, 0), Op::Barrier), []);
        assert_eq!(under_a_condition(Op::SpecConstant { id: 0, default: 3 }, Op::Barrier), []);
    }

    #[test]
    fn a_subgroup_operation_under_the_invocation_id_is_refused() {
        let own = Op::Builtin(Builtin::GlobalInvocationId, 0);
        let add = Op::Subgroup(SubgroupOp::Add, vec![word(1)]);
        assert_eq!(under_a_condition(own, add), [Reason::DivergentSubgroup]);
    }

    /// `do { barrier; i += 1 } while i < bound`, where each invocation has its own bound.
    fn in_a_loop(bound: Op) -> Vec<Reason> {
        let mut k = KernelBuilder::new(3);
        let bound = k.push(0, bound, Type::I32);
        let (_, next) = k.counter(1, 0);
        k.push(1, Op::Barrier, Type::Void);
        let again = k.push(1, less(next, bound), Type::BOOL);
        k.end(0, Terminator::Branch(BlockId(1)));
        k.end(1, Terminator::Condition(again, BlockId(1), BlockId(2))).end(2, Terminator::Return);
        reasons(&k.build())
    }

    #[test]
    fn a_barrier_in_a_loop_needs_a_uniform_number_of_rounds() {
        let own = Op::Builtin(Builtin::LocalInvocationId, 0);
        assert_eq!(in_a_loop(own), [Reason::DivergentBarrier]);
        assert_eq!(in_a_loop(Op::SpecConstant { id: 0, default: 3 }), []);
    }

    /// A counter that leaves a loop after as many rounds as each invocation likes diverges, though each of
    /// its values is uniform.
    #[test]
    fn what_leaves_a_divergent_loop_diverges() {
        let mut k = KernelBuilder::new(5);
        let own = k.push(0, Op::Builtin(Builtin::LocalInvocationId, 0), Type::I32);
        let (_, next) = k.counter(1, 0);
        let again = k.push(1, less(next.clone(), own), Type::BOOL);
        let few = k.push(2, less(next, word(3)), Type::BOOL);
        k.push(3, Op::Barrier, Type::Void);
        k.end(0, Terminator::Branch(BlockId(1)));
        k.end(1, Terminator::Condition(again, BlockId(1), BlockId(2)));
        k.end(2, Terminator::Condition(few, BlockId(3), BlockId(4)));
        k.end(3, Terminator::Branch(BlockId(4))).end(4, Terminator::Return);
        assert_eq!(reasons(&k.build()), [Reason::DivergentBarrier]);
    }
}
