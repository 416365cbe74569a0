//! Types and constants.

use super::{EmitError, Emitter};
use crate::ir::{Type, Value};
use rspirv::dr::Builder;
use rspirv::spirv::{Capability, Word};
use std::collections::BTreeMap;

/// The types that every module declares, and the constants so far.
pub struct Constants {
    pub bool: Word,
    pub u32: Word,
    pub i32: Word,
    pub f32: Word,
    /// Four words.
    pub vec4: Word,
    /// By type and bits.
    known: BTreeMap<(Word, u64), Word>,
    /// Zeros by type.
    zeros: BTreeMap<Word, Word>,
}

impl Constants {
    pub fn new(builder: &mut Builder) -> Self {
        let u32 = builder.type_int(32, 0);
        Self {
            bool: builder.type_bool(),
            u32,
            i32: builder.type_int(32, 1),
            f32: builder.type_float(32, None),
            vec4: builder.type_vector(u32, 4),
            known: BTreeMap::new(),
            zeros: BTreeMap::new(),
        }
    }

    /// A constant word.
    pub fn word(&mut self, builder: &mut Builder, value: u32) -> Word {
        let ty = self.u32;
        *self.known.entry((ty, value.into())).or_insert_with(|| builder.constant_bit32(ty, value))
    }

    /// A constant float of these bits.
    fn float(&mut self, builder: &mut Builder, bits: u32) -> Word {
        let ty = self.f32;
        *self.known.entry((ty, bits.into())).or_insert_with(|| builder.constant_bit32(ty, bits))
    }

    /// A constant truth value.
    pub fn truth(&mut self, builder: &mut Builder, value: bool) -> Word {
        let ty = self.bool;
        *self.known.entry((ty, value.into())).or_insert_with(|| match value {
            true => builder.constant_true(ty),
            false => builder.constant_false(ty),
        })
    }

    /// The zero of any type of values.
    pub fn zero(&mut self, builder: &mut Builder, ty: Word) -> Word {
        *self.zeros.entry(ty).or_insert_with(|| builder.constant_null(ty))
    }

    fn long(&mut self, builder: &mut Builder, ty: Word, value: u64) -> Word {
        *self.known.entry((ty, value)).or_insert_with(|| builder.constant_bit64(ty, value))
    }
}

impl Emitter<'_> {
    /// The id of a type of values.
    pub fn type_id(&mut self, ty: &Type) -> Result<Word, EmitError> {
        match ty {
            Type::Int(1) => Ok(self.constants.bool),
            Type::Int(32) => Ok(self.constants.u32),
            Type::Int(64) => Ok(self.long_type(0)),
            Type::F32 => Ok(self.constants.f32),
            Type::Vector(4, element) if **element == Type::I32 => Ok(self.constants.vec4),
            other => Err(EmitError::unsupported(other, "SPIR-V")),
        }
    }

    /// The type of 64-bit integers, signed or not.
    pub fn long_type(&mut self, signedness: u32) -> Word {
        self.capabilities.insert(Capability::Int64);
        self.builder.type_int(64, signedness)
    }

    /// The id of a constant. An undefined one is zero.
    pub fn constant(&mut self, value: &Value) -> Result<Word, EmitError> {
        let builder = &mut self.builder;
        match value {
            Value::Int(1, bits) => Ok(self.constants.truth(builder, *bits != 0)),
            Value::Int(32, bits) => Ok(self.constants.word(builder, *bits as u32)),
            Value::Int(64, bits) => {
                let ty = self.long_type(0);
                Ok(self.constants.long(&mut self.builder, ty, *bits as u64))
            }
            Value::F32(bits) => Ok(self.constants.float(builder, *bits)),
            Value::Zero(Type::F32) | Value::Undef(Type::F32) => Ok(self.constants.float(builder, 0)),
            Value::Zero(Type::Int(bits)) | Value::Undef(Type::Int(bits)) => {
                self.constant(&Value::Int(*bits, 0))
            }
            other => Err(EmitError::unsupported(other, "SPIR-V")),
        }
    }
}
