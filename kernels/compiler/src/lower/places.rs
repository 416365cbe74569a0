//! Pointers: each is a place in one root, or in one of several.

use super::linear::Linear;
use super::origins::{Step, walk};
use super::{Lowering, Result, calls};
use crate::ir::{BinaryOp, CastOp, Id, Op, RootId, SourceOp, Type, Value};
use crate::refusal::Reason;

/// What a pointer points to.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The root, or the roots.
    pub target: Target,
    /// Bytes from the root's begin.
    pub offset: Linear,
    /// For a pointer that may be null: the value that is [`NULL`] if it is.
    pub null: Option<Value>,
}

/// Where a pointer points into.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// One root.
    Root(RootId),
    /// One of several roots: the value is its number.
    OneOf(Value, Vec<RootId>),
}

/// The offset, in units, of the null pointer: no access reaches so far.
pub const NULL: u32 = u32::MAX;

impl Place {
    pub(super) fn start(root: RootId, offset: i64) -> Self {
        Self { target: Target::Root(root), offset: Linear::constant(offset), null: None }
    }
}

impl Lowering<'_> {
    /// Makes the place of an instruction that yields a pointer. Problems are told when the pointer is used.
    pub(super) fn pointer(&mut self, id: Id) -> Result<()> {
        let place = match &self.source[id].op {
            Op::Phi(_) => self.open_pointer_phi(id),
            Op::Select(condition, a, b) => self.pointer_select(id, condition, a, b),
            Op::Copy(pointer) => self.place(pointer),
            Op::Source(SourceOp::Element(ty, base, indices)) => self.element(ty, base, indices),
            Op::Source(SourceOp::Load { .. }) => Err(Reason::Pointer(
                "a pointer is loaded from memory: a reference in an array or a struct".into(),
            )),
            Op::Source(SourceOp::Call(name, _)) if !self.made.contains_key(&id) => {
                Err(calls::refuse(self.module, name).unwrap_or_else(|| calls::unknown(name)))
            }
            Op::Cast(CastOp::IntToPtr, _) => Err(Reason::Pointer("an integer is made a pointer".into())),
            _ => match self.made.get(&id) {
                Some(root) => Ok(Place::start(*root, 0)),
                None => Err(Reason::Pointer(
                    "a pointer does not come from the kernel's arguments or arrays".into(),
                )),
            },
        };
        self.places.insert(id, place);
        Ok(())
    }

    /// What `pointer` points to.
    pub(super) fn place(&mut self, pointer: &Value) -> Result<Place> {
        match pointer {
            Value::Inst(id) => self
                .places
                .get(id)
                .cloned()
                .unwrap_or_else(|| Err(Reason::Pointer("a pointer is used before it is known".into()))),
            Value::Global(name, offset) => Ok(Place::start(self.table(name)?, *offset)),
            _ => Err(Reason::Pointer("a null or dangling pointer is followed".into())),
        }
    }

    /// What `pointer` points to, if that is in one root only.
    pub(super) fn single(&mut self, pointer: &Value) -> Result<(RootId, Linear)> {
        let place = self.place(pointer)?;
        match place.target {
            Target::Root(root) => Ok((root, place.offset)),
            Target::OneOf(_, roots) => Err(self.several(&roots)),
        }
    }

    fn several(&self, roots: &[RootId]) -> Reason {
        let names: Vec<&str> = roots.iter().map(|root| self.roots[root.index()].name.as_str()).collect();
        Reason::Pointer(format!(
            "a pointer may point into {}: only loads can go through it",
            names.join(" or into ")
        ))
    }

    fn element(&mut self, ty: &Type, base: &Value, indices: &[Value]) -> Result<Place> {
        let mut place = self.place(base)?;
        place.null = None;
        let mut steps = Vec::new();
        let known = walk(ty, indices, |step| {
            steps.push(match step {
                Step::Field(offset) => (None, offset),
                Step::Index(index, stride) => (Some(index.clone()), stride),
            });
        });
        if !known {
            return Err(Reason::Unknown(format!("an address computation into {ty:?}")));
        }
        for (index, scale) in steps {
            match index {
                None => place.offset.constant += scale,
                Some(index) => match index.as_int() {
                    Some(constant) => place.offset.constant += constant as i64 * scale,
                    None => {
                        let index = self.low_word(&index);
                        place.offset.add(&self.build.function, &index, scale);
                    }
                },
            }
        }
        Ok(place)
    }

    /// A pointer as an integer: bytes from its root's begin. Only differences and low bits of it mean anything.
    pub(super) fn address(&mut self, pointer: &Value, ty: &Type) -> Result<Value> {
        let (_, offset) = self.single(pointer)?;
        let bytes = self.scaled(&offset, 1);
        Ok(self.build.cast(CastOp::ZExt, &bytes, ty.clone()))
    }

    /// The offset divided by `unit`. Where the form does not show that it is a multiple, the bytes are divided.
    pub(super) fn scaled(&mut self, offset: &Linear, unit: i64) -> Value {
        if !offset.is_multiple_of(unit) {
            let bytes = self.sum(offset, 1);
            let op = if unit.count_ones() == 1 { BinaryOp::LShr } else { BinaryOp::UDiv };
            let by = if op == BinaryOp::LShr { unit.trailing_zeros() as u128 } else { unit as u128 };
            return self.build.binary_const(op, &bytes, by);
        }
        self.sum(offset, unit)
    }

    /// The sum of all parts, each divided by `unit`.
    fn sum(&mut self, offset: &Linear, unit: i64) -> Value {
        let constant = Value::u32((offset.constant / unit) as u32);
        let mut sum: Option<Value> = None;
        for (value, scale) in &offset.terms {
            let term = self.build.binary_const(BinaryOp::Mul, value, (scale / unit) as u32 as u128);
            sum = Some(match sum {
                Some(sum) => self.build.binary(BinaryOp::Add, &sum, &term),
                None => term,
            });
        }
        match sum {
            Some(sum) => self.build.binary(BinaryOp::Add, &sum, &constant),
            None => constant,
        }
    }
}
