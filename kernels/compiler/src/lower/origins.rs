//! Where pointers come from: the roots that each may point into, and what the pointers that meet in phis and selections have in common.

use super::linear::gcd;
use crate::ir::{BinaryOp, CastOp, Function, Id, Op, SourceOp, Type, Value};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

/// What a pointer starts from.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Origin {
    /// A call of `__k_root`, or an `alloca`.
    Made(Id),
    /// A global.
    Global(Arc<str>),
}

/// The pointers of a function.
pub struct Origins<'a> {
    source: &'a Function,
    origins: HashMap<Id, BTreeSet<Origin>>,
    /// Pointers that meet, by the smallest id among them (as in union-find).
    group: HashMap<Id, Id>,
    meetings: HashMap<Id, Meeting>,
}

/// What the pointers that meet have in common.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Meeting {
    /// A divisor of all their offsets in bytes: their common unit. 0 if all offsets are 0.
    pub unit: i64,
    /// Whether the null pointer is among them.
    pub nullable: bool,
}

impl<'a> Origins<'a> {
    /// Looks at `source`, a function as it was parsed.
    pub fn new(source: &'a Function) -> Self {
        let mut all =
            Self { source, origins: HashMap::new(), group: HashMap::new(), meetings: HashMap::new() };
        while all.spread() {}
        all.find_meetings();
        all
    }

    /// What the pointer may start from; nothing for a null pointer or one that does not start from memory of the kernel.
    pub fn of(&self, pointer: &Value) -> BTreeSet<Origin> {
        match pointer {
            Value::Global(name, _) => BTreeSet::from([Origin::Global(name.clone())]),
            Value::Inst(id) => self.origins.get(id).cloned().unwrap_or_default(),
            _ => BTreeSet::new(),
        }
    }

    /// What the pointers that meet `pointer` have in common.
    pub fn meeting(&self, pointer: Id) -> Meeting {
        self.meetings.get(&self.representative(pointer)).copied().unwrap_or_default()
    }

    /// Hands origins on from operands to results, once.
    fn spread(&mut self) -> bool {
        let mut changed = false;
        for id in self.source.placed().filter(|id| self.source[*id].ty == Type::Pointer) {
            let mut found = match &self.source[id].op {
                Op::Source(SourceOp::Alloca(_)) => BTreeSet::from([Origin::Made(id)]),
                Op::Source(SourceOp::Call(name, _)) if &**name == "__k_root" => {
                    BTreeSet::from([Origin::Made(id)])
                }
                _ => BTreeSet::new(),
            };
            for operand in bases(&self.source[id].op) {
                found.append(&mut self.of(operand));
            }
            let known = self.origins.entry(id).or_default();
            changed |= known.len() < found.len();
            *known = found;
        }
        changed
    }

    fn representative(&self, mut id: Id) -> Id {
        while let Some(parent) = self.group.get(&id).filter(|parent| **parent != id) {
            id = *parent;
        }
        id
    }

    fn unite(&mut self, a: Id, b: Id) {
        let (a, b) = (self.representative(a), self.representative(b));
        self.group.insert(a.max(b), a.min(b));
    }

    /// Pointers meet in phis and selections, and walk on by additions.
    fn find_meetings(&mut self) {
        let pointers: Vec<Id> =
            self.source.placed().filter(|id| self.source[*id].ty == Type::Pointer).collect();
        for &id in &pointers {
            for base in bases(&self.source[id].op).into_iter().filter_map(Value::as_inst) {
                self.unite(id, base);
            }
        }
        for &id in &pointers {
            let (unit, nullable) = (self.own_unit(id), self.joins_null(id));
            let meeting = self.meetings.entry(self.representative(id)).or_default();
            meeting.unit = gcd(meeting.unit, unit);
            meeting.nullable |= nullable;
        }
    }

    fn joins_null(&self, id: Id) -> bool {
        let joins = matches!(self.source[id].op, Op::Phi(_) | Op::Select(..));
        joins && bases(&self.source[id].op).into_iter().any(Value::is_null)
    }

    /// A divisor of what this instruction adds to its operands' offsets.
    fn own_unit(&self, id: Id) -> i64 {
        let constants = bases(&self.source[id].op).into_iter().fold(0, |unit, base| match base {
            Value::Global(_, offset) => gcd(unit, *offset),
            _ => unit,
        });
        match &self.source[id].op {
            Op::Source(SourceOp::Element(ty, _, indices)) => gcd(constants, self.step_unit(ty, indices)),
            _ => constants,
        }
    }

    fn step_unit(&self, ty: &Type, indices: &[Value]) -> i64 {
        let mut unit = 0;
        walk(ty, indices, |step| match step {
            Step::Field(offset) => unit = gcd(unit, offset),
            Step::Index(value, stride) => unit = gcd(unit, stride * self.factor(value, 4)),
        });
        unit
    }

    /// A known divisor of an index; 0 for 0.
    fn factor(&self, value: &Value, depth: u32) -> i64 {
        if let Some(constant) = value.as_int() {
            return constant as i64;
        }
        let (Some(id), true) = (value.as_inst(), depth > 0) else { return 1 };
        let factor = |value: &Value| self.factor(value, depth - 1);
        match &self.source[id].op {
            Op::Binary(BinaryOp::Mul, a, b) if self.source[id].exact && b.as_int().is_some() => {
                factor(a).saturating_mul(factor(b)).max(1)
            }
            Op::Binary(BinaryOp::Shl, a, b) if self.source[id].exact => {
                b.as_u32().filter(|k| *k < 16).map_or(1, |k| factor(a) << k)
            }
            Op::Binary(BinaryOp::Add, a, b) => gcd(factor(a), factor(b)),
            Op::Cast(CastOp::ZExt, a) | Op::Copy(a) => factor(a),
            _ => 1,
        }
    }
}

/// The pointers that a pointer is made from.
fn bases(op: &Op) -> Vec<&Value> {
    match op {
        Op::Phi(edges) => edges.iter().map(|edge| &edge.0).collect(),
        Op::Select(_, a, b) => vec![a, b],
        Op::Copy(base) | Op::Source(SourceOp::Element(_, base, _)) => vec![base],
        _ => vec![],
    }
}

/// A step of an address computation.
pub enum Step<'a> {
    /// A constant number of bytes.
    Field(i64),
    /// An index and the distance of elements in bytes.
    Index(&'a Value, i64),
}

/// Walks the indices of a `getelementptr` into a `ty`. Returns whether all could be followed.
pub fn walk<'a>(ty: &Type, indices: &'a [Value], mut visit: impl FnMut(Step<'a>)) -> bool {
    let mut ty = ty.clone();
    for (k, index) in indices.iter().enumerate() {
        if k == 0 {
            visit(Step::Index(index, ty.stride() as i64));
            continue;
        }
        ty = match ty {
            Type::Struct(_) | Type::Packed(_) => {
                let field = index.as_u32().map_or(usize::MAX, |k| k as usize);
                let Some(field_ty) = ty.fields().and_then(|fields| fields.get(field)) else { return false };
                visit(Step::Field(ty.field_offset(field) as i64));
                field_ty.clone()
            }
            Type::Array(_, element) | Type::Vector(_, element) => {
                visit(Step::Index(index, element.stride() as i64));
                *element
            }
            _ => return false,
        };
    }
    true
}
