//! Loads and stores of any type, as accesses of words.
//!
//! A value is taken apart into pieces that lie within a word each. Pieces of less than a word are shifted out of the word that holds
//! them; putting one in is possible only in memory that belongs to the invocation alone.

use super::linear::Linear;
use super::places::{Place, Target};
use super::{Lowering, Result};
use crate::ir::{BinaryOp, CastOp, IntPredicate, Op, RootId, SourceOp, Space, Type, Value, mask};
use crate::refusal::Reason;

impl Lowering<'_> {
    pub(super) fn translate_load(
        &mut self,
        pointer: &Value,
        atomic: bool,
        align: u32,
        ty: &Type,
    ) -> Result<Value> {
        if atomic {
            return self.atomic_load(pointer, ty);
        }
        let place = self.place(pointer)?;
        match place.target {
            Target::Root(root) => self.load(root, &place.offset, align, ty),
            Target::OneOf(..) => self.load_from_one(&place, align, ty),
        }
    }

    pub(super) fn translate_store(
        &mut self,
        value: &Value,
        pointer: &Value,
        atomic: bool,
        align: u32,
    ) -> Result<()> {
        if atomic {
            return self.atomic_store(pointer, value);
        }
        let (root, offset) = self.single(pointer)?;
        if self.source.type_of(value) == Type::Pointer {
            return Err(Reason::Pointer(
                "a pointer is stored to memory: a reference in an array or a struct".into(),
            ));
        }
        if self.source.type_of(value) == Type::I64 {
            let (low, high) = (self.low_word(value), self.high_word(value));
            self.store(root, &offset, align, &low)?;
            return self.store(root, &offset.plus(4), part_align(align, 4), &high);
        }
        let value = self.build.resolve(value);
        self.store(root, &offset, align, &value)
    }

    /// A load from one of several roots: from each, at its begin unless it is the right one, and then the right word.
    fn load_from_one(&mut self, place: &Place, align: u32, ty: &Type) -> Result<Value> {
        let (Target::OneOf(tag, roots), Type::Int(_) | Type::F32) = (&place.target, ty) else {
            return Err(Reason::Pointer(format!("a {ty:?} is loaded from one of several buffers")));
        };
        let bytes = self.scaled(&place.offset, 1);
        let mut loaded: Option<Value> = None;
        for root in roots {
            let right = self.build.compare_const(IntPredicate::Eq, tag, root.0.into());
            let offset = self.build.select(&right, &bytes, &Value::u32(0));
            let value = self.load(*root, &Linear::term(offset, 1), align, ty)?;
            loaded = Some(match loaded {
                Some(other) => self.build.select(&right, &value, &other),
                None => value,
            });
        }
        loaded.ok_or_else(|| Reason::Unknown("a pointer into no root".into()))
    }

    /// Loads a `ty`. LLVM knows the address to be a multiple of `align`.
    pub(super) fn load(&mut self, root: RootId, offset: &Linear, align: u32, ty: &Type) -> Result<Value> {
        match ty {
            Type::F32 => {
                let word = self.load(root, offset, align, &Type::I32)?;
                Ok(self.build.cast(CastOp::Bitcast, &word, Type::F32))
            }
            Type::Int(bits) => self.load_int(root, offset, align, *bits),
            Type::Pointer => Err(Reason::Pointer(
                "a pointer is loaded from memory: a reference in an array or a struct".into(),
            )),
            _ => {
                let mut aggregate = Value::Undef(ty.clone());
                for (k, (at, part)) in parts(ty)?.into_iter().enumerate() {
                    let value = self.load(root, &offset.plus(at as i64), part_align(align, at), &part)?;
                    aggregate = self.insert(aggregate, value, k as u32, ty);
                }
                Ok(aggregate)
            }
        }
    }

    fn load_int(&mut self, root: RootId, offset: &Linear, align: u32, bits: u32) -> Result<Value> {
        let ty = Type::Int(bits);
        let mut whole: Option<Value> = None;
        for (at, bytes) in pieces(offset, align, bits) {
            let piece = self.load_piece(root, &offset.plus(at), bytes);
            let piece = match bits {
                0..32 => self.build.cast(CastOp::Trunc, &piece, ty.clone()),
                _ => self.build.cast(CastOp::ZExt, &piece, ty.clone()),
            };
            let piece = self.build.binary_const(BinaryOp::Shl, &piece, at as u128 * 8);
            whole = Some(match whole {
                Some(whole) => self.build.binary(BinaryOp::Or, &whole, &piece),
                None => piece,
            });
        }
        whole.ok_or_else(|| Reason::Unknown(format!("a load of {bits} bits")))
    }

    /// One, two or four bytes, zero-extended to a word.
    fn load_piece(&mut self, root: RootId, offset: &Linear, bytes: u32) -> Value {
        let word = self.load_word(root, offset);
        if bytes == 4 {
            return word;
        }
        let shift = self.bit_in_word(offset);
        let shifted = self.build.binary(BinaryOp::LShr, &word, &shift);
        self.build.binary_const(BinaryOp::And, &shifted, mask(bytes * 8))
    }

    fn load_word(&mut self, root: RootId, offset: &Linear) -> Value {
        if self.roots[root.index()].vec4 {
            let (element, component) = self.element_index(offset);
            let vector = self.build.emit(Op::LoadVec4(root, element), Type::vec4());
            return self.build.emit(Op::Component(vector, component), Type::I32);
        }
        let index = self.scaled(offset, 4);
        if let (Space::Constant(words), Some(index)) = (&self.roots[root.index()].space, index.as_u32()) {
            return Value::u32(words.get(index as usize).copied().unwrap_or(0));
        }
        self.build.emit(Op::LoadWord(root, index), Type::I32)
    }

    /// Stores `value`. LLVM knows the address to be a multiple of `align`.
    pub(super) fn store(&mut self, root: RootId, offset: &Linear, align: u32, value: &Value) -> Result<()> {
        self.roots[root.index()].written = true;
        match self.build.type_of(value) {
            Type::F32 => {
                let word = self.build.cast(CastOp::Bitcast, value, Type::I32);
                self.store(root, offset, align, &word)
            }
            Type::Int(bits) => self.store_int(root, offset, align, value, bits),
            ty => {
                for (k, (at, part)) in parts(&ty)?.into_iter().enumerate() {
                    let value = self.extract(value, k as u32, &ty, part);
                    self.store(root, &offset.plus(at as i64), part_align(align, at), &value)?;
                }
                Ok(())
            }
        }
    }

    fn store_int(
        &mut self,
        root: RootId,
        offset: &Linear,
        align: u32,
        value: &Value,
        bits: u32,
    ) -> Result<()> {
        for (at, bytes) in pieces(offset, align, bits) {
            let piece = self.build.binary_const(BinaryOp::LShr, value, at as u128 * 8);
            let piece = self.low_word(&piece);
            self.store_piece(root, &offset.plus(at), bytes, &piece, bits)?;
        }
        Ok(())
    }

    fn store_piece(
        &mut self,
        root: RootId,
        offset: &Linear,
        bytes: u32,
        piece: &Value,
        bits: u32,
    ) -> Result<()> {
        if bytes == 4 {
            self.store_word(root, offset, piece);
            return Ok(());
        }
        if self.roots[root.index()].space != Space::Local {
            return Err(if bits < 32 { Reason::NarrowStore { bits } } else { Reason::Unaligned });
        }
        let ones = mask(bytes * 8);
        let shift = self.bit_in_word(offset);
        let word = self.load_word(root, offset);
        let hole = self.build.binary(BinaryOp::Shl, &Value::u32(ones as u32), &shift);
        let hole = self.build.binary_const(BinaryOp::Xor, &hole, mask(32));
        let kept = self.build.binary(BinaryOp::And, &word, &hole);
        let piece = self.build.binary_const(BinaryOp::And, piece, ones);
        let piece = self.build.binary(BinaryOp::Shl, &piece, &shift);
        let word = self.build.binary(BinaryOp::Or, &kept, &piece);
        self.store_word(root, offset, &word);
        Ok(())
    }

    fn store_word(&mut self, root: RootId, offset: &Linear, word: &Value) {
        if self.roots[root.index()].vec4 {
            let (element, component) = self.element_index(offset);
            return self.build.effect(Op::StoreComponent(root, element, component, word.clone()));
        }
        let index = self.scaled(offset, 4);
        self.build.effect(Op::StoreWord(root, index, word.clone()))
    }

    /// The element of four words and the component in it.
    fn element_index(&mut self, offset: &Linear) -> (Value, Value) {
        if offset.steps_are_multiples_of(16) {
            let within = offset.constant.rem_euclid(16);
            let element = self.scaled(&offset.plus(-within), 16);
            return (element, Value::u32(within as u32 / 4));
        }
        let word = self.scaled(offset, 4);
        let element = self.build.binary_const(BinaryOp::LShr, &word, 2);
        (element, self.build.binary_const(BinaryOp::And, &word, 3))
    }

    /// Which bit of its word a byte begins at.
    fn bit_in_word(&mut self, offset: &Linear) -> Value {
        if offset.steps_are_multiples_of(4) {
            return Value::u32(offset.constant.rem_euclid(4) as u32 * 8);
        }
        let bytes = self.scaled(offset, 1);
        let byte = self.build.binary_const(BinaryOp::And, &bytes, 3);
        self.build.binary_const(BinaryOp::Shl, &byte, 3)
    }

    fn insert(&mut self, aggregate: Value, part: Value, index: u32, ty: &Type) -> Value {
        let op = match ty {
            Type::Vector(..) => SourceOp::InsertElement(aggregate, part, Value::u32(index)),
            _ => SourceOp::InsertValue(aggregate, part, vec![index]),
        };
        self.build.emit(op, ty.clone())
    }

    fn extract(&mut self, aggregate: &Value, index: u32, ty: &Type, part: Type) -> Value {
        let op = match ty {
            Type::Vector(..) => SourceOp::ExtractElement(aggregate.clone(), Value::u32(index)),
            _ => SourceOp::ExtractValue(aggregate.clone(), vec![index]),
        };
        self.build.emit(op, part)
    }
}

/// The pieces of an integer of so many bits: where each begins, in bytes, and how many bytes it has. None crosses a word.
fn pieces(offset: &Linear, align: u32, bits: u32) -> Vec<(i64, u32)> {
    cut(bits.div_ceil(8), |at, n| {
        align.is_multiple_of(n) && at.is_multiple_of(n) || offset.plus(at.into()).is_multiple_of(n.into())
    })
}

/// Cuts `size` bytes into pieces of four, two or one. `aligned(at, n)` says whether byte `at` is known to lie at a multiple of `n`.
pub(super) fn cut(size: u32, aligned: impl Fn(u32, u32) -> bool) -> Vec<(i64, u32)> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < size {
        let bytes = [4, 2].into_iter().find(|n| size - at >= *n && aligned(at, *n)).unwrap_or(1);
        pieces.push((at.into(), bytes));
        at += bytes;
    }
    pieces
}

/// What is known of the address of a part when the whole is aligned.
fn part_align(align: u32, at: u64) -> u32 {
    match at {
        0 => align,
        at => align.min(1 << at.trailing_zeros().min(31)),
    }
}

/// Offsets and types of the parts of an aggregate.
fn parts(ty: &Type) -> Result<Vec<(u64, Type)>> {
    match ty {
        Type::Struct(fields) | Type::Packed(fields) => {
            Ok(fields.iter().enumerate().map(|(k, field)| (ty.field_offset(k), field.clone())).collect())
        }
        Type::Array(n, element) if *n <= 64 => {
            Ok((0..*n).map(|k| (k * element.stride(), (**element).clone())).collect())
        }
        Type::Vector(n, element) => {
            Ok((0..u64::from(*n)).map(|k| (k * element.size(), (**element).clone())).collect())
        }
        ty => Err(Reason::Unknown(format!("an access of the type {ty:?}"))),
    }
}
