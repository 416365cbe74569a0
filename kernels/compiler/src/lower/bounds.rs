//! How large 64-bit values can be, and which of them are `usize`.
//!
//! A device has 32 bits. LLVM's IR does not tell `usize` from `u64`, so each 64-bit value is looked at:
//!
//! * *Proven*: [`Bounds::upper`] finds a bound below 2³² (a word that was extended, a mask, a shift, a counter up to such a bound).
//! * *Assumed*: the value flows into an address without going through a mask, a right shift or a constant of more than 32 bits. A
//!   buffer is smaller than 4 GiB, so an index that is used fits into a word; that what it is compared with is a `usize` too is what
//!   the language would say on a target of 32 bits. The same holds for a difference of two words that is only compared or indexed
//!   with (LLVM drops `nuw` from lengths that it has guarded).
//!
//! What is neither stays 64 bits wide, and the kernel is refused unless wide values are allowed.

use crate::ir::{BinaryOp, CastOp, Function, Id, IntPredicate, Op, SourceOp, Type, Value, mask};
use std::collections::HashSet;

const WORD: u128 = u32::MAX as u128;
const WIDE: u128 = u64::MAX as u128;
/// How far the search for a bound goes.
const DEPTH: u32 = 8;

/// What is known of the 64-bit values of a function.
pub struct Bounds<'a> {
    source: &'a Function,
    /// Values that flow into addresses.
    indices: HashSet<Id>,
    /// The instructions that use each value.
    users: Vec<Vec<Id>>,
}

/// Whether a constant is a small negative number.
fn is_negative(value: u128) -> bool {
    value > WIDE - (1 << 31)
}

impl<'a> Bounds<'a> {
    /// Looks at `source`, a function as it was parsed.
    pub fn new(source: &'a Function) -> Self {
        let mut users = vec![vec![]; source.instructions.len()];
        for user in source.placed() {
            source[user].op.for_each_operand(|value| {
                if let Value::Inst(used) = value {
                    users[used.index()].push(user);
                }
            });
        }
        let mut bounds = Self { source, indices: HashSet::new(), users };
        bounds.find_indices();
        bounds
    }

    /// Whether 32 bits of a 64-bit value are all of it.
    pub fn is_usize(&self, value: &Value) -> bool {
        match value {
            Value::Inst(id) => self.indices.contains(id) || self.fits_word(value),
            Value::Undef(_) => true,
            constant => constant.as_int().is_some_and(|x| x <= WORD || is_negative(x)),
        }
    }

    /// Whether a value is proven to be below 2³².
    pub fn fits_word(&self, value: &Value) -> bool {
        self.upper(value) <= WORD
    }

    /// Whether the value flows into an address.
    pub fn is_index(&self, id: Id) -> bool {
        self.indices.contains(&id)
    }

    fn find_indices(&mut self) {
        let mut open: Vec<Value> = Vec::new();
        for id in self.source.placed() {
            if let Op::Source(SourceOp::Element(_, _, indices)) = &self.source[id].op {
                open.extend(indices.iter().cloned());
            }
        }
        while let Some(value) = open.pop() {
            let Value::Inst(id) = value else { continue };
            if self.source[id].ty == Type::I64 && !self.is_evidently_wide(id) && self.indices.insert(id) {
                self.push_parts(id, &mut open);
            }
        }
        while self.add_siblings() {}
    }

    /// A constant of more than 32 bits, or a masked value: what goes in need not be a `usize`.
    fn is_evidently_wide(&self, id: Id) -> bool {
        match &self.source[id].op {
            Op::Binary(BinaryOp::And, _, b) if b.as_int().is_some() => true,
            Op::Binary(_, a, b) => {
                [a, b].iter().any(|v| v.as_int().is_some_and(|x| x > WORD && !is_negative(x)))
            }
            _ => false,
        }
    }

    /// The operands that are `usize` because the result is.
    fn push_parts(&self, id: Id, open: &mut Vec<Value>) {
        use BinaryOp::*;
        match &self.source[id].op {
            Op::Binary(Add | Sub | Mul | And | Or | Xor, a, b) | Op::Select(_, a, b) => {
                open.extend([a.clone(), b.clone()])
            }
            Op::Binary(Shl, a, _) | Op::Copy(a) => open.push(a.clone()),
            Op::Phi(edges) => open.extend(edges.iter().map(|edge| edge.0.clone())),
            Op::Source(SourceOp::Call(name, arguments)) if is_selection(name) => {
                open.extend(arguments.iter().cloned())
            }
            _ => {}
        }
    }

    /// Neighbours through phis and constants: a counter that is compared while its sibling is the index.
    fn add_siblings(&mut self) -> bool {
        let before = self.indices.len();
        for id in self.source.placed() {
            let instruction = &self.source[id];
            if instruction.ty != Type::I64 || self.indices.contains(&id) || self.is_evidently_wide(id) {
                continue;
            }
            let index = |v: &Value| v.as_inst().is_some_and(|id| self.indices.contains(&id));
            let near = |v: &Value| index(v) || v.as_int().is_some();
            let found = match &instruction.op {
                Op::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                    (index(a) && near(b)) || (near(a) && index(b))
                }
                Op::Phi(edges) => edges.iter().any(|edge| index(&edge.0)),
                _ => false,
            };
            if found {
                self.indices.insert(id);
            }
        }
        self.indices.len() > before
    }

    /// An inclusive bound of an integer.
    pub fn upper(&self, value: &Value) -> u128 {
        self.bound(value, DEPTH)
    }

    fn bound(&self, value: &Value, depth: u32) -> u128 {
        if let Some(constant) = value.as_int() {
            return constant;
        }
        let Value::Inst(id) = value else { return 0 };
        let instruction = &self.source[*id];
        let own = match instruction.ty {
            Type::Int(bits) => mask(bits),
            _ => WIDE,
        };
        if depth == 0 {
            return own;
        }
        let bound = match &instruction.op {
            Op::Binary(op, a, b) => self.binary_bound(*id, *op, a, b, depth - 1),
            Op::Cast(CastOp::ZExt | CastOp::Trunc, a) => self.bound(a, depth - 1),
            Op::Cast(CastOp::PtrToInt, _) => WORD,
            Op::Select(_, a, b) => self.bound(a, depth - 1).max(self.bound(b, depth - 1)),
            Op::Copy(a) => self.bound(a, depth - 1),
            Op::Phi(edges) => self.phi_bound(*id, edges.iter().map(|edge| &edge.0), depth - 1),
            Op::Source(SourceOp::Call(name, arguments)) => self.call_bound(name, arguments, depth - 1),
            _ => own,
        };
        bound.min(own)
    }

    fn binary_bound(&self, id: Id, op: BinaryOp, a: &Value, b: &Value, depth: u32) -> u128 {
        let (x, y) = (self.bound(a, depth), self.bound(b, depth));
        let constant = b.as_int();
        match op {
            BinaryOp::And => x.min(y),
            BinaryOp::Or | BinaryOp::Xor => (x.max(y) + 1).next_power_of_two() - 1,
            // A constant is taken away: LLVM has seen to it that there is something to take it from, or it is a usize that wraps.
            BinaryOp::Add if constant.is_some_and(is_small_negative) && x <= WORD && self.is_length(id) => x,
            BinaryOp::Add => x + y,
            BinaryOp::Sub if self.source[id].exact => x,
            BinaryOp::Sub if x <= WORD && y <= WORD && self.is_length(id) => x,
            BinaryOp::Mul => x.saturating_mul(y),
            BinaryOp::Shl => constant.filter(|k| *k < 64).map_or(WIDE, |k| x << k),
            BinaryOp::LShr => constant.filter(|k| *k < 64).map_or(x, |k| x >> k),
            BinaryOp::UDiv => constant.filter(|k| *k > 0).map_or(x, |k| x / k),
            BinaryOp::URem => x.min(y.saturating_sub(1)),
            _ => u128::MAX,
        }
    }

    fn call_bound(&self, name: &str, arguments: &[Value], depth: u32) -> u128 {
        let bound = |k: usize| arguments.get(k).map_or(WIDE, |v| self.bound(v, depth));
        match name {
            _ if name.starts_with("llvm.umin.") => bound(0).min(bound(1)),
            _ if name.starts_with("llvm.umax.") => bound(0).max(bound(1)),
            _ if name.starts_with("llvm.usub.sat.") => bound(0),
            _ if name.starts_with("llvm.ct") => 64,
            _ => u128::MAX,
        }
    }

    fn phi_bound<'v>(&self, id: Id, values: impl Iterator<Item = &'v Value>, depth: u32) -> u128 {
        if let Some(bound) = self.counter_bound(id, depth.min(3)) {
            return bound;
        }
        values.map(|value| self.bound(value, depth.min(3))).max().unwrap_or(WIDE)
    }

    /// Whether a difference is only compared without a sign, indexed with, shortened or handed on to such uses: a length. (What is
    /// compared with a sign or made a float may be a negative `i64`.)
    fn is_length(&self, id: Id) -> bool {
        use IntPredicate::*;
        let (mut open, mut seen) = (vec![id], HashSet::from([id]));
        while let Some(id) = open.pop() {
            for &user in &self.users[id.index()] {
                match &self.source[user].op {
                    Op::IntCompare(Eq | Ne | Ult | Ule | Ugt | Uge, ..)
                    | Op::Source(SourceOp::Element(..))
                    | Op::Cast(CastOp::Trunc, _) => {}
                    Op::Phi(_) | Op::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => {
                        if seen.insert(user) {
                            open.push(user);
                        }
                    }
                    _ => return false,
                }
            }
        }
        true
    }

    /// A bound of `phi(start, phi + step)` that is compared with something bounded: such a loop is left before its counter wraps,
    /// at most one step behind the bound.
    fn counter_bound(&self, phi: Id, depth: u32) -> Option<u128> {
        let Op::Phi(edges) = &self.source[phi].op else { return None };
        let (mut start, mut next) = (0, None);
        for (value, _) in edges {
            match self.step(phi, value) {
                Some(step) => next = Some((value.as_inst()?, step)),
                None if value.is_undef() => {}
                None => start = self.bound(value, depth).max(start),
            }
        }
        let (next, step) = next?;
        let limit = self.compared_with([phi, next], depth)?;
        if start >= 1 << 31 {
            return None;
        }
        Some(if step > WORD { start } else { start.max(limit) + MAX_STEP })
    }

    /// The step, if `value` is `phi + step`, and the step is small or small and negative.
    fn step(&self, phi: Id, value: &Value) -> Option<u128> {
        match self.source.op_of(value)? {
            Op::Binary(BinaryOp::Add, Value::Inst(base), step) if *base == phi => {
                step.as_int().filter(|step| *step < MAX_STEP || *step > WIDE - MAX_STEP)
            }
            _ => None,
        }
    }

    /// A bound below 2³¹ of something that one of the two is compared with.
    fn compared_with(&self, counters: [Id; 2], depth: u32) -> Option<u128> {
        let counter = |v: &Value| v.as_inst().is_some_and(|id| counters.contains(&id));
        self.source.placed().find_map(|id| match &self.source[id].op {
            Op::IntCompare(predicate, a, b) if !predicate.is_signed() => {
                let other = match (counter(a), counter(b)) {
                    (true, false) => b,
                    (false, true) => a,
                    _ => return None,
                };
                Some(self.bound(other, depth)).filter(|bound| *bound < 1 << 31)
            }
            _ => None,
        })
    }
}

/// The largest step of a counter that is looked at.
const MAX_STEP: u128 = 1 << 20;

fn is_small_negative(value: u128) -> bool {
    value >= WIDE - 0xffff
}

/// Whether an intrinsic yields one of its arguments, or less.
fn is_selection(name: &str) -> bool {
    ["llvm.umin.", "llvm.umax.", "llvm.usub.sat."].iter().any(|prefix| name.starts_with(prefix))
}
