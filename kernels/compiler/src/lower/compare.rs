//! Comparisons of pointers and of 64-bit integers.

use super::linear::gcd;
use super::places::{NULL, Target};
use super::{Lowering, Result, Translation};
use crate::cleanup::fold::holds;
use crate::ir::{IntPredicate, Op, Type, Value};
use crate::refusal::Reason;

impl Lowering<'_> {
    pub(super) fn compare(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Result<Translation> {
        match self.source.type_of(a) {
            Type::Pointer if a.is_null() || b.is_null() => {
                let pointer = if a.is_null() { b } else { a };
                self.compare_with_null(predicate, pointer).map(Translation::Value)
            }
            Type::Pointer => self.compare_pointers(predicate, a, b).map(Translation::Value),
            Type::I64 => Ok(self.compare_wide(predicate, a, b)),
            _ => Ok(self.fold(&Op::IntCompare(predicate, a.clone(), b.clone()), &Type::BOOL)),
        }
    }

    /// Only a pointer that was joined with null can be null.
    fn compare_with_null(&mut self, predicate: IntPredicate, pointer: &Value) -> Result<Value> {
        match self.place(pointer)?.null {
            Some(offset) => Ok(self.build.compare_const(predicate, &offset, NULL.into())),
            None => Ok(Value::bool(predicate == IntPredicate::Ne)),
        }
    }

    /// Pointers into one root are compared by their offsets, in the largest unit that both have.
    fn compare_pointers(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Result<Value> {
        let (a, b) = (self.place(a)?, self.place(b)?);
        match (a.target, b.target) {
            (Target::Root(x), Target::Root(y)) if x == y => {}
            _ => {
                return Err(Reason::Pointer("pointers into different buffers or arrays are compared".into()));
            }
        }
        let unit = gcd(a.offset.divisor(), b.offset.divisor()).max(1);
        let (a, b) = (self.scaled(&a.offset, unit), self.scaled(&b.offset, unit));
        Ok(self.build.compare(predicate, &a, &b))
    }

    fn compare_wide(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Translation {
        if let Some(known) = self.beyond_words(predicate, a, b) {
            return Translation::Value(Value::bool(known));
        }
        if !self.bounds.is_usize(a) || !self.bounds.is_usize(b) {
            return Translation::Value(self.compare_halves(predicate, a, b));
        }
        // What is proven to fit is not negative, whatever its highest bit is.
        let proven = self.bounds.fits_word(a) && self.bounds.fits_word(b);
        let predicate = if proven { unsigned(predicate) } else { predicate };
        let (a, b) = (self.low_word(a), self.low_word(b));
        Translation::Value(self.build.compare(predicate, &a, &b))
    }

    /// A comparison of something below 2³² with a constant that is not.
    fn beyond_words(&self, predicate: IntPredicate, a: &Value, b: &Value) -> Option<bool> {
        let beyond = |v: &Value| v.as_int().filter(|x| *x > u128::from(u32::MAX));
        match (beyond(a), beyond(b)) {
            (None, Some(constant)) if self.bounds.fits_word(a) => Some(holds(predicate, 0, constant, 64)),
            (Some(constant), None) if self.bounds.fits_word(b) => Some(holds(predicate, constant, 0, 64)),
            _ => None,
        }
    }
}

/// The same comparison of numbers that are not negative.
fn unsigned(predicate: IntPredicate) -> IntPredicate {
    match predicate {
        IntPredicate::Sgt => IntPredicate::Ugt,
        IntPredicate::Sge => IntPredicate::Uge,
        IntPredicate::Slt => IntPredicate::Ult,
        IntPredicate::Sle => IntPredicate::Ule,
        other => other,
    }
}
