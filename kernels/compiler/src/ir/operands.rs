//! The operands of instructions, for reading and for rewriting.

use super::{Op, SourceOp, Terminator, Value};

/// Writes the same visit once for shared and once for exclusive references.
macro_rules! visit {
    ($op:ident, $source:ident, $value:ty, $op_ty:ty, $source_ty:ty, $iter:ident) => {
        fn $op<'a>(op: $op_ty, visit: &mut dyn FnMut($value)) {
            match op {
                Op::Cast(_, a)
                | Op::FloatNegate(a)
                | Op::Copy(a)
                | Op::LoadWord(_, a)
                | Op::LoadVec4(_, a)
                | Op::AtomicLoadWord(_, a) => visit(a),
                Op::Binary(_, a, b)
                | Op::IntCompare(_, a, b)
                | Op::FloatCompare(_, a, b)
                | Op::StoreWord(_, a, b)
                | Op::Component(a, b)
                | Op::AtomicWord(_, _, a, b)
                | Op::AtomicStoreWord(_, a, b)
                | Op::MulHigh(a, b) => [a, b].into_iter().for_each(visit),
                Op::Select(a, b, c)
                | Op::StoreComponent(_, a, b, c)
                | Op::CompareExchangeWord(_, a, b, c) => [a, b, c].into_iter().for_each(visit),
                Op::Phi(edges) => edges.$iter().for_each(|(value, _)| visit(value)),
                Op::StoreVec4(_, a, words) => {
                    visit(a);
                    words.$iter().for_each(visit)
                }
                Op::Math(_, arguments) | Op::Subgroup(_, arguments) => arguments.$iter().for_each(visit),
                Op::WordCount(_) | Op::Builtin(..) | Op::SpecConstant { .. } | Op::Barrier => {}
                Op::Source(op) => $source(op, visit),
            }
        }

        fn $source<'a>(op: $source_ty, visit: &mut dyn FnMut($value)) {
            match op {
                SourceOp::Load { pointer, .. } => visit(pointer),
                SourceOp::Store { value, pointer, .. } => [value, pointer].into_iter().for_each(visit),
                SourceOp::Element(_, base, indices) => {
                    visit(base);
                    indices.$iter().for_each(visit)
                }
                SourceOp::Call(_, arguments) => arguments.$iter().for_each(visit),
                SourceOp::ExtractValue(a, _) => visit(a),
                SourceOp::Atomic(_, a, b)
                | SourceOp::InsertValue(a, b, _)
                | SourceOp::ExtractElement(a, b)
                | SourceOp::Shuffle(a, b, _) => [a, b].into_iter().for_each(visit),
                SourceOp::CompareExchange(a, b, c) | SourceOp::InsertElement(a, b, c) => {
                    [a, b, c].into_iter().for_each(visit)
                }
                SourceOp::Alloca(_) => {}
            }
        }
    };
}

visit!(visit_op, visit_source, &'a Value, &'a Op, &'a SourceOp, iter);
visit!(visit_op_mut, visit_source_mut, &'a mut Value, &'a mut Op, &'a mut SourceOp, iter_mut);

impl Op {
    /// Calls `visit` with every operand, in order.
    pub fn for_each_operand(&self, mut visit: impl FnMut(&Value)) {
        visit_op(self, &mut visit)
    }

    /// Calls `rewrite` with every operand, in order.
    pub fn for_each_operand_mut(&mut self, mut rewrite: impl FnMut(&mut Value)) {
        visit_op_mut(self, &mut rewrite)
    }

    /// Whether `value` is an operand.
    pub fn uses(&self, value: &Value) -> bool {
        let mut found = false;
        self.for_each_operand(|operand| found |= operand == value);
        found
    }
}

impl Terminator {
    /// The value that decides where control goes, if one does.
    pub fn operand(&self) -> Option<&Value> {
        match self {
            Terminator::Condition(value, ..) | Terminator::Switch(value, ..) => Some(value),
            Terminator::Branch(_) | Terminator::Return | Terminator::Unreachable => None,
        }
    }

    /// The same for rewriting.
    pub fn operand_mut(&mut self) -> Option<&mut Value> {
        match self {
            Terminator::Condition(value, ..) | Terminator::Switch(value, ..) => Some(value),
            Terminator::Branch(_) | Terminator::Return | Terminator::Unreachable => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{BlockId, RootId};

    #[test]
    fn every_operand_is_visited_in_order() {
        let word = |k| Value::u32(k);
        let mut op = Op::StoreVec4(RootId(0), word(0), [1, 2, 3, 4].map(word));
        let mut seen = vec![];
        op.for_each_operand(|v| seen.push(v.clone()));
        assert_eq!(seen, [0, 1, 2, 3, 4].map(word));
        op.for_each_operand_mut(|v| *v = word(9));
        assert_eq!(op, Op::StoreVec4(RootId(0), word(9), [9; 4].map(word)));
        assert!(Op::Phi(vec![(word(7), BlockId(0))]).uses(&word(7)));
    }
}
