//! Types, with the sizes and offsets that LLVM gives them on x86-64.

/// A type of LLVM's IR.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Type {
    /// No value.
    Void,
    /// An integer of so many bits; `i1` is a truth value.
    Int(u32),
    /// `float`.
    F32,
    /// `double`, which is parsed only to be refused.
    F64,
    /// An opaque pointer.
    Pointer,
    /// A vector of so many elements.
    Vector(u32, Box<Type>),
    /// An array of so many elements.
    Array(u64, Box<Type>),
    /// A struct whose fields are aligned.
    Struct(Vec<Type>),
    /// A struct without padding: rustc writes constants so.
    Packed(Vec<Type>),
    /// Anything else that IR has a word for (`metadata`, `half`, a function type): no kernel may use it.
    Other(String),
}

impl Type {
    /// A truth value.
    pub const BOOL: Type = Type::Int(1);
    /// The word of a device.
    pub const I32: Type = Type::Int(32);
    /// What `usize` is in the IR; lowering makes it 32 bits wide.
    pub const I64: Type = Type::Int(64);

    /// Four words: a whole element of a root of 128-bit records.
    pub fn vec4() -> Type {
        Type::Vector(4, Box::new(Type::I32))
    }

    /// Alignment in bytes.
    pub fn align(&self) -> u64 {
        match self {
            Type::Int(bits) => u64::from(*bits).div_ceil(8).next_power_of_two().min(16),
            Type::F32 => 4,
            Type::F64 | Type::Pointer => 8,
            Type::Vector(..) => self.size().next_power_of_two(),
            Type::Array(_, element) => element.align(),
            Type::Struct(fields) => fields.iter().map(Type::align).max().unwrap_or(1),
            Type::Void | Type::Packed(_) | Type::Other(_) => 1,
        }
    }

    /// Size in bytes.
    pub fn size(&self) -> u64 {
        match self {
            Type::Int(bits) => u64::from(*bits).div_ceil(8),
            Type::F32 => 4,
            Type::F64 | Type::Pointer => 8,
            Type::Vector(n, element) => u64::from(*n) * element.size(),
            Type::Array(n, element) => n * element.stride(),
            Type::Struct(fields) => self.field_offset(fields.len()).next_multiple_of(self.align()),
            Type::Packed(fields) => self.field_offset(fields.len()),
            Type::Void | Type::Other(_) => 0,
        }
    }

    /// Distance of the elements of an array of this type, in bytes.
    pub fn stride(&self) -> u64 {
        self.size().next_multiple_of(self.align())
    }

    /// Where field `index` of a struct begins, in bytes; the end of the last field for one past it. 0 for other types.
    pub fn field_offset(&self, index: usize) -> u64 {
        match self {
            Type::Struct(fields) => {
                let end =
                    fields[..index].iter().fold(0, |at: u64, f| at.next_multiple_of(f.align()) + f.size());
                fields.get(index).map_or(end, |f| end.next_multiple_of(f.align()))
            }
            Type::Packed(fields) => fields[..index].iter().map(Type::size).sum(),
            _ => 0,
        }
    }

    /// The fields, if this is a struct.
    pub fn fields(&self) -> Option<&[Type]> {
        match self {
            Type::Struct(fields) | Type::Packed(fields) => Some(fields),
            _ => None,
        }
    }

    /// Whether this is an integer of any width.
    pub fn is_int(&self) -> bool {
        matches!(self, Type::Int(_))
    }

    /// Width of a scalar in bits; 0 for other types.
    pub fn bits(&self) -> u32 {
        match self {
            Type::Int(bits) => *bits,
            Type::F32 => 32,
            Type::F64 | Type::Pointer => 64,
            _ => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_llvms() {
        let fields = vec![Type::Int(8), Type::I32, Type::Int(16), Type::I64];
        let (aligned, packed) = (Type::Struct(fields.clone()), Type::Packed(fields));
        assert_eq!([0, 1, 2, 3].map(|i| aligned.field_offset(i)), [0, 4, 8, 16]);
        assert_eq!((aligned.size(), aligned.align()), (24, 8));
        assert_eq!([0, 1, 2, 3].map(|i| packed.field_offset(i)), [0, 1, 5, 7]);
        assert_eq!((packed.size(), packed.align()), (15, 1));
        assert_eq!(Type::Array(3, Box::new(Type::Struct(vec![Type::I32, Type::Int(8)]))).size(), 24);
        assert_eq!(Type::vec4().align(), 16);
    }
}
