//! Phis and selections of pointers.
//!
//! Pointers that meet have a common unit, in which their offsets are whole numbers: the offset becomes a phi or selection of words. If
//! they may point into several roots, a second one says into which.

use super::linear::Linear;
use super::places::{NULL, Place, Target};
use super::{Lowering, Result};
use crate::ir::{BlockId, Id, Op, RootId, Type, Value};
use crate::refusal::Reason;

impl Lowering<'_> {
    /// The place of a phi, whose operands are filled in by [`close_pointer_phi`](Self::close_pointer_phi).
    pub(super) fn open_pointer_phi(&mut self, id: Id) -> Result<Place> {
        let roots = self.roots_of(id)?;
        let offset = self.build.emit(Op::Phi(vec![]), Type::I32);
        let tag = (roots.len() > 1).then(|| self.build.emit(Op::Phi(vec![]), Type::I32));
        Ok(self.joined(id, roots, offset, tag))
    }

    /// The operands of a phi's companions. Those of the offset are computed at the ends of the blocks that they come from.
    pub(super) fn close_pointer_phi(&mut self, id: Id, edges: &[(Value, BlockId)]) -> Result<()> {
        let Some(Ok(place)) = self.places.get(&id).cloned() else { return Ok(()) };
        let unit = self.unit(id);
        let (mut offsets, mut tags) = (Vec::new(), Vec::new());
        for (pointer, from) in edges {
            std::mem::swap(&mut self.build.out, &mut self.tails[from.index()]);
            let offset = self.in_units(pointer, unit);
            std::mem::swap(&mut self.build.out, &mut self.tails[from.index()]);
            offsets.push((offset?, *from));
            tags.push((self.tag(pointer)?, *from));
        }
        if let [(Value::Inst(phi), _)] = place.offset.terms[..] {
            self.build.function[phi].op = Op::Phi(offsets);
        }
        if let Target::OneOf(Value::Inst(phi), _) = place.target {
            self.build.function[phi].op = Op::Phi(tags);
        }
        Ok(())
    }

    /// The place of `condition ? a : b`.
    pub(super) fn pointer_select(
        &mut self,
        id: Id,
        condition: &Value,
        a: &Value,
        b: &Value,
    ) -> Result<Place> {
        let roots = self.roots_of(id)?;
        let condition = self.build.resolve(condition);
        let unit = self.unit(id);
        let (x, y) = (self.in_units(a, unit)?, self.in_units(b, unit)?);
        let offset = self.build.select(&condition, &x, &y);
        let tag = match roots.len() {
            1 => None,
            _ => {
                let (x, y) = (self.tag(a)?, self.tag(b)?);
                Some(self.build.select(&condition, &x, &y))
            }
        };
        Ok(self.joined(id, roots, offset, tag))
    }

    fn joined(&self, id: Id, roots: Vec<RootId>, offset: Value, tag: Option<Value>) -> Place {
        let null = self.origins.meeting(id).nullable.then(|| offset.clone());
        let target = match tag {
            Some(tag) => Target::OneOf(tag, roots),
            None => Target::Root(roots[0]),
        };
        Place { target, offset: Linear::term(offset, self.unit(id)), null }
    }

    /// The common unit of the pointers that meet here, in bytes.
    fn unit(&self, id: Id) -> i64 {
        match self.origins.meeting(id).unit {
            0 => 4,
            unit => unit,
        }
    }

    /// The roots that a pointer may point into; at least one.
    fn roots_of(&mut self, id: Id) -> Result<Vec<RootId>> {
        let mut roots = Vec::new();
        for origin in self.origins.of(&Value::Inst(id)) {
            let root = self.root_of(&origin)?;
            if !roots.contains(&root) {
                roots.push(root);
            }
        }
        match roots.is_empty() {
            true => {
                Err(Reason::Pointer("a pointer does not come from the kernel's arguments or arrays".into()))
            }
            false => Ok(roots),
        }
    }

    fn in_units(&mut self, pointer: &Value, unit: i64) -> Result<Value> {
        if pointer.is_null() {
            return Ok(Value::u32(NULL));
        }
        if pointer.is_undef() {
            return Ok(Value::u32(0));
        }
        let place = self.place(pointer)?;
        Ok(self.scaled(&place.offset, unit))
    }

    /// The number of the root that a pointer points into.
    fn tag(&mut self, pointer: &Value) -> Result<Value> {
        if pointer.is_null() || pointer.is_undef() {
            return Ok(Value::u32(0));
        }
        Ok(match self.place(pointer)?.target {
            Target::Root(root) => Value::u32(root.0),
            Target::OneOf(tag, _) => tag,
        })
    }
}
