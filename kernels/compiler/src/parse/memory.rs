//! Instructions that touch memory or make addresses.

use super::Result;
use super::cursor::Cursor;
use super::instructions::{Line, plain};
use crate::ir::{AtomicOp, SourceOp, Type};
use crate::refusal::Reason;

impl Cursor<'_> {
    pub(super) fn memory(&mut self, keyword: &str) -> Result<Line> {
        match keyword {
            "load" => self.load(),
            "store" => self.store(),
            "alloca" => self.alloca(),
            "getelementptr" => self.element_address(),
            "atomicrmw" => self.atomic_update(),
            "cmpxchg" => self.compare_exchange(),
            _ => Err(Reason::Ordering("a fence".into())),
        }
    }

    fn load(&mut self) -> Result<Line> {
        let atomic = self.flags()?.atomic;
        let ty = self.ty()?;
        self.expect_mark(',')?;
        let (_, pointer) = self.typed_value()?;
        if atomic {
            self.ordering()?;
        }
        Ok(plain(SourceOp::Load { pointer, atomic, align: self.alignment()? }, ty))
    }

    fn store(&mut self) -> Result<Line> {
        let atomic = self.flags()?.atomic;
        let (_, value) = self.typed_value()?;
        self.expect_mark(',')?;
        let (_, pointer) = self.typed_value()?;
        if atomic {
            self.ordering()?;
        }
        Ok(plain(SourceOp::Store { value, pointer, atomic, align: self.alignment()? }, Type::Void))
    }

    /// An array of one value: rustc makes no others.
    fn alloca(&mut self) -> Result<Line> {
        let ty = self.ty()?;
        if self.eat_comma_before_operand() && self.word() != "align" {
            return Err(self.unknown("an `alloca` of variable length"));
        }
        Ok(plain(SourceOp::Alloca(ty), Type::Pointer))
    }

    fn element_address(&mut self) -> Result<Line> {
        self.flags()?;
        let ty = self.ty()?;
        self.expect_mark(',')?;
        let (base_ty, base) = self.typed_value()?;
        if base_ty != Type::Pointer {
            return Err(self.unknown("a vector of addresses"));
        }
        let mut indices = Vec::new();
        while self.eat_comma_before_operand() {
            indices.push(self.typed_value()?.1);
        }
        Ok(plain(SourceOp::Element(ty, base, indices), Type::Pointer))
    }

    fn atomic_update(&mut self) -> Result<Line> {
        self.flags()?;
        let word = self.word();
        let op = atomic_op(word).ok_or_else(|| self.unknown(&format!("`atomicrmw {word}`")))?;
        self.take();
        let (_, pointer) = self.typed_value()?;
        self.expect_mark(',')?;
        let (ty, value) = self.typed_value()?;
        self.ordering()?;
        Ok(plain(SourceOp::Atomic(op, pointer, value), ty))
    }

    fn compare_exchange(&mut self) -> Result<Line> {
        self.eat("weak");
        self.flags()?;
        let (_, pointer) = self.typed_value()?;
        self.expect_mark(',')?;
        let (ty, expected) = self.typed_value()?;
        self.expect_mark(',')?;
        let (_, new) = self.typed_value()?;
        self.ordering()?;
        self.ordering()?;
        let pair = Type::Struct(vec![ty, Type::BOOL]);
        Ok(plain(SourceOp::CompareExchange(pointer, expected, new), pair))
    }

    /// Only relaxed atomics are the same everywhere: the drivers' memory models differ in what the others mean.
    fn ordering(&mut self) -> Result<()> {
        match self.word() {
            "monotonic" | "unordered" => {
                self.take();
                Ok(())
            }
            word => Err(Reason::Ordering(format!("an atomic access with the ordering `{word}`"))),
        }
    }
}

fn atomic_op(word: &str) -> Option<AtomicOp> {
    use AtomicOp::*;
    Some(match word {
        "add" => Add,
        "sub" => Sub,
        "and" => And,
        "or" => Or,
        "xor" => Xor,
        "umin" => UMin,
        "umax" => UMax,
        "min" => SMin,
        "max" => SMax,
        "xchg" => Exchange,
        _ => return None,
    })
}
