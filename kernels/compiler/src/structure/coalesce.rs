//! Variables that are only handed on become one.
//!
//! A value that is needed far behind a join passes through a phi at each join on the way: a variable, a load and a store each, more
//! than half of a large kernel's. A phi `x` whose one use is to set a phi `y` needs no variable of its own if `y`'s is free from
//! where `x` is set up to there: then whoever sets `x` sets `y` at once. (Conservative coalescing of copies, as in Boissinot et al.,
//! "Revisiting Out-of-SSA Translation for Correctness, Code Quality, and Efficiency", 2009, on nested statements.)

use super::Statement;
use crate::ir::{Function, Id, Value};
use std::collections::BTreeMap;

/// Unites the variables of `body` where that changes nothing.
pub fn coalesce(function: &Function, body: &mut Vec<Statement>) {
    let mut uses = BTreeMap::new();
    super::loop_closed::count_uses(function, body, &mut uses);
    let mut copies = Vec::new();
    super::for_each_statement(body, &mut |statement| {
        if let Statement::Set(values) = statement {
            copies.extend(values.iter().filter_map(|(to, value)| Some((value.as_inst()?, *to))));
        }
    });
    let is_phi = |id: &Id| matches!(function[*id].op, crate::ir::Op::Phi(_));
    copies.retain(|(from, to)| from != to && is_phi(from) && uses.get(from) == Some(&1));
    let mut united: BTreeMap<Id, Id> = BTreeMap::new();
    for (from, mut to) in copies {
        while let Some(other) = united.get(&to) {
            to = *other;
        }
        if from != to && are_apart(body, from, to) {
            unite(body, from, to);
            united.insert(from, to);
        }
    }
}

/// Whether one variable can hold `from` and `to`, and `from` up to where it is handed on.
fn are_apart(body: &[Statement], from: Id, to: Id) -> bool {
    let copy = |target: Id, value: &Value| target == to && *value == Value::Inst(from);
    // While `to` is awaited, nobody may set `from`.
    let mut destination = Liveness {
        reads: |_: Id, _: &Value| false,
        loads: |phi| phi == to,
        writes: |target, _: &Value| target == to,
        ends: |_| false,
        clashes: |target, _: &Value| target == from,
        clash: false,
    };
    destination.before(body, false);
    // While `from` is on its way, nobody may set `to`.
    let mut source = Liveness {
        reads: copy,
        loads: |_| false,
        writes: |target, _: &Value| target == from,
        ends: |_| false,
        clashes: |target, value: &Value| target == to && !copy(target, value),
        clash: false,
    };
    source.before(body, false);
    // What is handed on must be what the phi was, not what it will be.
    let mut renewed = Liveness {
        reads: copy,
        loads: |_| false,
        writes: |_, _: &Value| false,
        ends: |phi| phi == from,
        clashes: |target, _: &Value| target == from,
        clash: false,
    };
    renewed.before(body, false);
    !(destination.clash || source.clash || renewed.clash)
}

/// Follows backwards where the content of a variable is awaited, and whether something clashes with that.
struct Liveness<Reads, Loads, Writes, Ends, Clashes> {
    /// Whether a pair of a `Set` awaits the content.
    reads: Reads,
    /// Whether a phi's load awaits it.
    loads: Loads,
    /// Whether a pair of a `Set` makes it.
    writes: Writes,
    /// Whether a phi begins what is followed.
    ends: Ends,
    /// Whether a pair of a `Set` must not stand where the content is awaited behind it.
    clashes: Clashes,
    /// Whether one does.
    clash: bool,
}

impl<R, L, W, E, C> Liveness<R, L, W, E, C>
where
    R: Fn(Id, &Value) -> bool,
    L: Fn(Id) -> bool,
    W: Fn(Id, &Value) -> bool,
    E: Fn(Id) -> bool,
    C: Fn(Id, &Value) -> bool,
{
    /// Whether the content is awaited before `statements`, if behind them it is `live` or not.
    fn before(&mut self, statements: &[Statement], mut live: bool) -> bool {
        for statement in statements.iter().rev() {
            live = match statement {
                Statement::Set(values) => self.before_set(values, live),
                Statement::Phi(phi) => (live || (self.loads)(*phi)) && !(self.ends)(*phi),
                Statement::If { then, otherwise, .. } => {
                    let then = self.before(then, live);
                    self.before(otherwise, live) || then
                }
                Statement::Loop { body, .. } => {
                    let again = self.before(body, live);
                    if again && !live { self.before(body, true) } else { again }
                }
                Statement::Return | Statement::Unreachable => false,
                Statement::Instruction(_) => live,
            };
        }
        live
    }

    /// All values are read before any variable is written.
    fn before_set(&mut self, values: &[(Id, Value)], live: bool) -> bool {
        let any = |holds: &dyn Fn(Id, &Value) -> bool| values.iter().any(|(to, value)| holds(*to, value));
        self.clash |= live && any(&self.clashes);
        (live && !any(&self.writes)) || any(&self.reads)
    }
}

/// Lets whoever sets `from` set `to`.
fn unite(statements: &mut Vec<Statement>, from: Id, to: Id) {
    for statement in statements.iter_mut() {
        match statement {
            Statement::Set(values) => {
                values.retain(|(target, value)| !(*target == to && *value == Value::Inst(from)));
                values.iter_mut().filter(|set| set.0 == from).for_each(|set| set.0 = to);
            }
            Statement::If { then, otherwise, .. } => {
                unite(then, from, to);
                unite(otherwise, from, to);
            }
            Statement::Loop { body, .. } => unite(body, from, to),
            _ => {}
        }
    }
    statements.retain(|statement| match statement {
        Statement::Set(values) => !values.is_empty(),
        Statement::Phi(phi) => *phi != from,
        Statement::If { then, otherwise, .. } => !(then.is_empty() && otherwise.is_empty()),
        _ => true,
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Op, Type};
    use crate::testing::word;

    /// A function of so many phis.
    fn phis(count: usize) -> (Function, Vec<Id>) {
        let mut function = Function::default();
        let ids = (0..count).map(|_| function.push(Op::Phi(vec![]), Type::I32)).collect();
        (function, ids)
    }

    fn set(to: Id, value: Value) -> Statement {
        Statement::Set(vec![(to, value)])
    }

    fn copy(to: Id, from: Id) -> Statement {
        set(to, Value::Inst(from))
    }

    fn either(then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
        Statement::If { condition: Value::bool(true), then, otherwise }
    }

    fn round(body: Vec<Statement>) -> Statement {
        Statement::Loop { body, condition: Value::bool(true), leaves_when: true }
    }

    fn coalesced(function: &Function, mut body: Vec<Statement>) -> Vec<Statement> {
        coalesce(function, &mut body);
        body
    }

    #[test]
    fn a_value_that_passes_joins_has_one_variable() {
        let (f, p) = phis(3);
        let inner = vec![either(vec![set(p[0], word(1))], vec![set(p[0], word(2))]), Statement::Phi(p[0])];
        let middle = vec![copy(p[1], p[0])];
        let body = vec![
            either([inner, middle].concat(), vec![set(p[1], word(3))]),
            Statement::Phi(p[1]),
            either(vec![copy(p[2], p[1])], vec![set(p[2], word(4))]),
            Statement::Phi(p[2]),
        ];
        let expected = vec![
            either(
                vec![either(vec![set(p[2], word(1))], vec![set(p[2], word(2))])],
                vec![set(p[2], word(3))],
            ),
            either(vec![], vec![set(p[2], word(4))]),
            Statement::Phi(p[2]),
        ];
        assert_eq!(coalesced(&f, body), expected);
    }

    /// Two values that are both known before it is decided which one is handed on.
    #[test]
    fn of_two_values_on_their_way_one_keeps_its_variable() {
        let (f, p) = phis(3);
        let body = vec![
            set(p[0], word(1)),
            Statement::Phi(p[0]),
            set(p[1], word(2)),
            Statement::Phi(p[1]),
            either(vec![copy(p[2], p[0])], vec![copy(p[2], p[1])]),
            Statement::Phi(p[2]),
        ];
        let expected = vec![
            set(p[2], word(1)),
            set(p[1], word(2)),
            Statement::Phi(p[1]),
            either(vec![], vec![copy(p[2], p[1])]),
            Statement::Phi(p[2]),
        ];
        assert_eq!(coalesced(&f, body), expected);
    }

    /// A loop's phi has got its next value when the last one is handed on.
    #[test]
    fn a_value_that_is_renewed_before_it_is_handed_on_keeps_its_variable() {
        let (f, p) = phis(2);
        let body = vec![
            set(p[0], word(0)),
            round(vec![Statement::Phi(p[0]), set(p[0], word(5)), copy(p[1], p[0])]),
            Statement::Phi(p[1]),
        ];
        assert_eq!(coalesced(&f, body.clone()), body);
    }

    /// What leaves a loop and what begins its next round are both set at its end.
    #[test]
    fn a_loops_phi_and_the_value_that_leaves_it_for_the_next_one_stay_apart() {
        let (f, p) = phis(2);
        let inner = round(vec![Statement::Phi(p[0]), set(p[0], word(5)), set(p[1], word(6))]);
        let body = vec![set(p[0], word(0)), round(vec![inner, Statement::Phi(p[1]), copy(p[0], p[1])])];
        assert_eq!(coalesced(&f, body.clone()), body);
    }
}
