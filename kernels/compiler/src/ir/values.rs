//! Values and the numbers by which instructions, blocks and roots are named.

use super::Type;
use std::sync::Arc;

macro_rules! number {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// The number of the `index`th.
            pub fn new(index: usize) -> Self {
                Self(index as u32)
            }

            /// The number as an index.
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

number! {
    /// An instruction of a function, and the value that it makes.
    Id
}
number! {
    /// A block of a function.
    BlockId
}
number! {
    /// A root of a kernel: a buffer or other memory.
    RootId
}

/// An operand.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Value {
    /// What an instruction makes.
    Inst(Id),
    /// An integer of so many bits; the bits above are zero.
    Int(u32, u128),
    /// The bits of an `f32`.
    F32(u32),
    /// The bits of an `f64`.
    F64(u64),
    /// `undef` or `poison`: any value may stand for it, and zero does.
    Undef(Type),
    /// `zeroinitializer`, or the null pointer.
    Zero(Type),
    /// A constant struct, array or vector.
    Aggregate(Type, Arc<[Value]>),
    /// A constant array of bytes.
    Bytes(Arc<[u8]>),
    /// The address of a global, so many bytes into it.
    Global(Arc<str>, i64),
}

impl Value {
    /// A word.
    pub fn u32(value: u32) -> Value {
        Value::Int(32, value.into())
    }

    /// A truth value.
    pub fn bool(value: bool) -> Value {
        Value::Int(1, value.into())
    }

    /// The `f32` constant of this value.
    pub fn f32(value: f32) -> Value {
        Value::F32(value.to_bits())
    }

    /// The integer `value` modulo 2^bits.
    pub fn int(bits: u32, value: u128) -> Value {
        Value::Int(bits, value & mask(bits))
    }

    /// The value, if this is a constant integer.
    pub fn as_int(&self) -> Option<u128> {
        match self {
            Value::Int(_, value) => Some(*value),
            Value::Zero(Type::Int(_)) => Some(0),
            _ => None,
        }
    }

    /// The low word, if this is a constant integer.
    pub fn as_u32(&self) -> Option<u32> {
        self.as_int().map(|value| value as u32)
    }

    /// The instruction that makes this value, if one does.
    pub fn as_inst(&self) -> Option<Id> {
        match self {
            Value::Inst(id) => Some(*id),
            _ => None,
        }
    }

    /// Whether this is the null pointer.
    pub fn is_null(&self) -> bool {
        matches!(self, Value::Zero(Type::Pointer))
    }

    /// Whether this is `undef` or `poison`.
    pub fn is_undef(&self) -> bool {
        matches!(self, Value::Undef(_))
    }
}

/// The lowest `bits` bits.
pub fn mask(bits: u32) -> u128 {
    if bits >= 128 { u128::MAX } else { (1 << bits) - 1 }
}

/// The lowest `bits` bits of `value` as a two's complement number. `bits` is 1 to 128.
pub fn sign_extend(value: u128, bits: u32) -> i128 {
    let unused = 128 - bits;
    ((value << unused) as i128) >> unused
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_wrap_to_their_width() {
        assert_eq!(Value::int(8, 0x1ff), Value::Int(8, 0xff));
        assert_eq!(sign_extend(0xff, 8), -1);
        assert_eq!(sign_extend(0x7f, 8), 127);
        assert_eq!(mask(128), u128::MAX);
    }
}
