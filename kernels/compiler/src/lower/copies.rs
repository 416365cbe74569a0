//! Copies, fills and comparisons of memory, unrolled.

use super::access::cut;
use super::linear::Linear;
use super::{Lowering, Result};
use crate::ir::{BinaryOp, CastOp, Type, Value};
use crate::refusal::Reason;

/// The longest copy that is unrolled, in bytes.
const LONGEST: u32 = 4096;

impl Lowering<'_> {
    /// `memcpy` or `memmove`: all is loaded before anything is stored.
    pub(super) fn copy(&mut self, to: &Value, from: &Value, length: &Value) -> Result<()> {
        let bytes = constant_length(length)?;
        let ((to, to_offset), (from, from_offset)) = (self.single(to)?, self.single(from)?);
        let mut loaded = Vec::new();
        for (at, size) in cut(bytes, |at, n| aligned(&to_offset, at, n) && aligned(&from_offset, at, n)) {
            let ty = Type::Int(size * 8);
            loaded.push((at, self.load(from, &from_offset.plus(at), 1, &ty)?));
        }
        for (at, value) in loaded {
            self.store(to, &to_offset.plus(at), 1, &value)?;
        }
        Ok(())
    }

    /// `memset`.
    pub(super) fn fill(&mut self, to: &Value, byte: &Value, length: &Value) -> Result<()> {
        let bytes = constant_length(length)?;
        let byte =
            byte.as_u32().ok_or_else(|| Reason::Copy("memory is filled with a byte that varies".into()))?;
        let (to, offset) = self.single(to)?;
        for (at, size) in cut(bytes, |at, n| aligned(&offset, at, n)) {
            let value = Value::int(size * 8, u128::from(byte & 0xff) * 0x0101_0101);
            self.store(to, &offset.plus(at), 1, &value)?;
        }
        Ok(())
    }

    /// `bcmp`: zero if the bytes are the same.
    pub(super) fn difference(&mut self, a: &Value, b: &Value, length: &Value) -> Result<Value> {
        let bytes = constant_length(length)?;
        let ((a, a_offset), (b, b_offset)) = (self.single(a)?, self.single(b)?);
        let mut difference = Value::u32(0);
        for (at, size) in cut(bytes, |at, n| aligned(&a_offset, at, n) && aligned(&b_offset, at, n)) {
            let ty = Type::Int(size * 8);
            let x = self.load(a, &a_offset.plus(at), 1, &ty)?;
            let y = self.load(b, &b_offset.plus(at), 1, &ty)?;
            let piece = self.build.binary(BinaryOp::Xor, &x, &y);
            let piece = self.build.cast(CastOp::ZExt, &piece, Type::I32);
            difference = self.build.binary(BinaryOp::Or, &difference, &piece);
        }
        Ok(difference)
    }
}

fn aligned(offset: &Linear, at: u32, bytes: u32) -> bool {
    offset.plus(at.into()).is_multiple_of(bytes.into())
}

fn constant_length(length: &Value) -> Result<u32> {
    match length.as_int() {
        None => Err(Reason::Copy("memory of variable length is copied, filled or compared".into())),
        Some(bytes) if bytes > LONGEST.into() => Err(Reason::Copy(format!(
            "{bytes} bytes are copied, filled or compared, more than the {LONGEST} that are unrolled"
        ))),
        Some(bytes) => Ok(bytes as u32),
    }
}
