//! Instructions.

use super::{
    AtomicOp, BinaryOp, BlockId, Builtin, CastOp, FloatPredicate, IntPredicate, MathOp, RootId, SubgroupOp,
    Type, Value,
};
use std::sync::Arc;

/// An instruction: what is done, and the type of the value that comes of it ([`Type::Void`] if none does).
#[derive(Clone, PartialEq, Debug)]
pub struct Instruction {
    /// What is done.
    pub op: Op,
    /// Type of the result.
    pub ty: Type,
    /// LLVM has proven that nothing is lost: `nuw` (no unsigned overflow), `disjoint` (an `or` that is a sum).
    pub exact: bool,
    /// The name in the IR, for messages.
    pub name: Arc<str>,
    /// Where it comes from, for [`Locations`](super::Locations).
    pub location: Option<u32>,
}

/// What an instruction does.
///
/// Indices into roots are in words, those of `LoadVec4`, `StoreVec4` and `StoreComponent` in elements of four words. An index out of
/// range is the driver's affair (robust buffer access).
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// Arithmetic.
    Binary(BinaryOp, Value, Value),
    /// Comparison of integers (or truth values); yields `i1`.
    IntCompare(IntPredicate, Value, Value),
    /// Comparison of floats; yields `i1`.
    FloatCompare(FloatPredicate, Value, Value),
    /// The second operand if the first holds, else the third.
    Select(Value, Value, Value),
    /// Conversion to the instruction's type.
    Cast(CastOp, Value),
    /// The float with its sign bit flipped.
    FloatNegate(Value),
    /// The operand itself. Gone after clean-up.
    Copy(Value),
    /// The value of the edge by which control came.
    Phi(Vec<(Value, BlockId)>),

    /// A word of a root (of a root that is not `vec4`).
    LoadWord(RootId, Value),
    /// `(root, index, word)`.
    StoreWord(RootId, Value, Value),
    /// A whole element of four words of a `vec4` root; yields `<4 x i32>`.
    LoadVec4(RootId, Value),
    /// `(root, element, words)`.
    StoreVec4(RootId, Value, [Value; 4]),
    /// `(root, element, component, word)`: one word of a `vec4` root.
    StoreComponent(RootId, Value, Value, Value),
    /// Component (a word) of a `<4 x i32>`.
    Component(Value, Value),
    /// `(root, index, operand)`; yields the old word.
    AtomicWord(AtomicOp, RootId, Value, Value),
    /// `(root, index, expected, new)`; yields the old word.
    CompareExchangeWord(RootId, Value, Value, Value),
    /// An atomic load of a word.
    AtomicLoadWord(RootId, Value),
    /// `(root, index, word)`: an atomic store.
    AtomicStoreWord(RootId, Value, Value),
    /// How many words a storage buffer has.
    WordCount(RootId),

    /// A function that every target has.
    Math(MathOp, Vec<Value>),
    /// The high word of a 32 × 32 bit product.
    MulHigh(Value, Value),
    /// Component 0, 1 or 2 of a builtin (0 of one that is not a vector).
    Builtin(Builtin, u32),
    /// The bits of a specialisation constant.
    SpecConstant {
        /// Its number.
        id: u32,
        /// Its bits when nobody sets it.
        default: u32,
    },
    /// Waits for the whole workgroup and makes workgroup memory visible to it.
    Barrier,
    /// An operation over the subgroup.
    Subgroup(SubgroupOp, Vec<Value>),

    /// Something that only LLVM's IR has: gone after lowering.
    Source(SourceOp),
}

/// What lowering and clean-up remove.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum SourceOp {
    /// A load of the instruction's type.
    Load {
        /// Where from.
        pointer: Value,
        /// Whether it is atomic.
        atomic: bool,
        /// What LLVM knows of the address's alignment, in bytes.
        align: u32,
    },
    /// A store.
    Store {
        /// What.
        value: Value,
        /// Where to.
        pointer: Value,
        /// Whether it is atomic.
        atomic: bool,
        /// What LLVM knows of the address's alignment, in bytes.
        align: u32,
    },
    /// `getelementptr`: the address of an element of a value of this type at the pointer.
    Element(Type, Value, Vec<Value>),
    /// Memory of the invocation for a value of this type.
    Alloca(Type),
    /// A call of a named function.
    Call(Arc<str>, Vec<Value>),
    /// `(pointer, operand)`; yields the old value.
    Atomic(AtomicOp, Value, Value),
    /// `(pointer, expected, new)`; yields `{ old, whether it was as expected }`.
    CompareExchange(Value, Value, Value),
    /// A field of an aggregate.
    ExtractValue(Value, Vec<u32>),
    /// `(aggregate, field, where)`.
    InsertValue(Value, Value, Vec<u32>),
    /// `(vector, index)`.
    ExtractElement(Value, Value),
    /// `(vector, element, index)`.
    InsertElement(Value, Value, Value),
    /// Elements of two vectors, numbered through; `None` is any value.
    Shuffle(Value, Value, Vec<Option<u32>>),
}

impl Op {
    /// Whether it does something besides making its value: such an instruction must stay where it is.
    pub fn has_effect(&self) -> bool {
        match self {
            Op::StoreWord(..)
            | Op::StoreVec4(..)
            | Op::StoreComponent(..)
            | Op::AtomicWord(..)
            | Op::CompareExchangeWord(..)
            | Op::AtomicLoadWord(..)
            | Op::AtomicStoreWord(..)
            | Op::Barrier
            | Op::Subgroup(..) => true,
            Op::Source(op) => op.has_effect(),
            _ => false,
        }
    }

    /// The root that is accessed, if one is.
    pub fn root(&self) -> Option<RootId> {
        match self {
            Op::LoadWord(root, ..)
            | Op::StoreWord(root, ..)
            | Op::LoadVec4(root, ..)
            | Op::StoreVec4(root, ..)
            | Op::StoreComponent(root, ..)
            | Op::AtomicWord(_, root, ..)
            | Op::CompareExchangeWord(root, ..)
            | Op::AtomicLoadWord(root, ..)
            | Op::AtomicStoreWord(root, ..)
            | Op::WordCount(root) => Some(*root),
            _ => None,
        }
    }
}

impl SourceOp {
    /// As [`Op::has_effect`].
    pub fn has_effect(&self) -> bool {
        match self {
            SourceOp::Store { .. } | SourceOp::Atomic(..) | SourceOp::CompareExchange(..) => true,
            SourceOp::Load { atomic, .. } => *atomic,
            SourceOp::Call(..) => true,
            _ => false,
        }
    }
}

impl From<SourceOp> for Op {
    fn from(op: SourceOp) -> Op {
        Op::Source(op)
    }
}
