//! Constant globals as tables of words.

use super::roots::root;
use super::{Lowering, Result};
use crate::demangle::demangle;
use crate::ir::{RootId, Space, Type, Value};
use crate::refusal::Reason;
use std::sync::Arc;

impl Lowering<'_> {
    /// The root that holds a constant global.
    pub(super) fn table(&mut self, name: &Arc<str>) -> Result<RootId> {
        if let Some(root) = self.tables.get(name) {
            return Ok(*root);
        }
        let pretty = demangle(name);
        let global = self.module.globals.get(name);
        let global = global.ok_or_else(|| Reason::Unknown(format!("the global `{pretty}`")))?;
        if !global.constant {
            return Err(Reason::MutableStatic(pretty));
        }
        let value = global.initializer.as_ref();
        let value = value
            .ok_or_else(|| Reason::Pointer(format!("the constant `{pretty}` holds more than numbers")))?;
        let mut bytes = vec![0; global.ty.size().next_multiple_of(4) as usize];
        write(value, &global.ty, &mut bytes)
            .ok_or_else(|| Reason::Pointer(format!("the constant `{pretty}` holds more than numbers")))?;
        let words: Arc<[u32]> =
            bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let id = RootId::new(self.roots.len());
        let count = words.len() as u32;
        self.roots.push(root(Space::Constant(words), format!("the constant `{pretty}`"), count, 4));
        self.tables.insert(name.clone(), id);
        Ok(id)
    }
}

/// Writes a constant of type `ty` to the begin of `bytes`. `None` if it holds something else than numbers.
fn write(value: &Value, ty: &Type, bytes: &mut [u8]) -> Option<()> {
    let mut put = |source: &[u8]| {
        bytes.get_mut(..source.len())?.copy_from_slice(source);
        Some(())
    };
    match value {
        Value::Int(_, number) => put(number.to_le_bytes().get(..ty.size() as usize)?),
        Value::F32(bits) => put(&bits.to_le_bytes()),
        Value::F64(bits) => put(&bits.to_le_bytes()),
        Value::Bytes(text) => put(text),
        Value::Zero(Type::Pointer) => None,
        Value::Zero(_) | Value::Undef(_) => Some(()),
        Value::Aggregate(ty, parts) => parts.iter().enumerate().try_for_each(|(k, part)| {
            let (offset, ty) = part_of(ty, k)?;
            write(part, &ty, bytes.get_mut(offset as usize..)?)
        }),
        Value::Inst(_) | Value::Global(..) => None,
    }
}

/// Offset and type of part `index` of a struct, array or vector.
fn part_of(ty: &Type, index: usize) -> Option<(u64, Type)> {
    match ty {
        Type::Struct(fields) | Type::Packed(fields) => {
            Some((ty.field_offset(index), fields.get(index)?.clone()))
        }
        Type::Array(_, element) | Type::Vector(_, element) => {
            Some((index as u64 * element.stride(), (**element).clone()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_packed_struct_of_bytes_and_numbers() {
        let ty = Type::Packed(vec![Type::Array(2, Box::new(Type::Int(8))), Type::Int(16), Type::F32]);
        let parts = vec![Value::Bytes([1, 2][..].into()), Value::Int(16, 0x0403), Value::f32(1.0)];
        let mut bytes = [0xee; 8];
        assert_eq!(write(&Value::Aggregate(ty.clone(), parts.into()), &ty, &mut bytes), Some(()));
        assert_eq!(bytes, [1, 2, 3, 4, 0, 0, 0x80, 0x3f]);
    }

    #[test]
    fn pointers_are_no_numbers() {
        let ty = Type::Packed(vec![Type::Pointer]);
        let value = Value::Aggregate(ty.clone(), vec![Value::Global("f".into(), 0)].into());
        assert_eq!(write(&value, &ty, &mut [0; 8]), None);
    }
}
