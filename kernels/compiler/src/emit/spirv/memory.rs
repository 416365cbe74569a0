//! Memory: the variables of the roots, and plain loads and stores.

use super::{EmitError, Emitter};
use crate::ir::{Root, RootId, Space, Value};
use rspirv::dr::Operand;
use rspirv::spirv::{Decoration, Op, StorageClass, Word};
use std::collections::BTreeMap;

/// The variable that holds a root.
#[derive(Clone, Copy)]
pub struct RootVariable {
    id: Word,
    class: StorageClass,
}

/// A block (a struct of one array) is declared once per class, element type and length.
type BlockKey = (Decorated, bool, u32);

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Decorated {
    Storage,
    Uniform,
    Push,
}

impl Emitter<'_> {
    /// Declares the variables of all roots.
    pub fn declare_roots(&mut self) {
        let mut blocks = BTreeMap::new();
        for root in &self.kernel.roots {
            let variable = match &root.space {
                Space::Storage { set, binding } | Space::Uniform { set, binding } => {
                    self.resource(root, *set, *binding, &mut blocks)
                }
                Space::Push => self.block_variable(root, &mut blocks),
                Space::Workgroup(_) => {
                    let array = self.array(root.words);
                    self.global(array, StorageClass::Workgroup)
                }
                Space::Local => {
                    let array = self.array(root.words);
                    RootVariable { id: self.local(array, None), class: StorageClass::Function }
                }
                Space::Constant(words) => self.table(words),
            };
            self.roots.push(variable);
        }
    }

    fn resource(
        &mut self,
        root: &Root,
        set: u32,
        binding: u32,
        blocks: &mut BTreeMap<BlockKey, Word>,
    ) -> RootVariable {
        let variable = self.block_variable(root, blocks);
        for (decoration, number) in [(Decoration::DescriptorSet, set), (Decoration::Binding, binding)] {
            self.builder.decorate(variable.id, decoration, [Operand::LiteralBit32(number)]);
        }
        if variable.class == StorageClass::StorageBuffer && !root.written {
            self.builder.decorate(variable.id, Decoration::NonWritable, []);
        }
        variable
    }

    fn block_variable(&mut self, root: &Root, blocks: &mut BTreeMap<BlockKey, Word>) -> RootVariable {
        // A uniform's array has a stride of 16 bytes by rule; a storage buffer's length is the binding's.
        let (kind, class, vec4, length) = match root.space {
            Space::Uniform { .. } => {
                (Decorated::Uniform, StorageClass::Uniform, true, root.words.div_ceil(4))
            }
            Space::Push => (Decorated::Push, StorageClass::PushConstant, false, root.words),
            _ => (Decorated::Storage, StorageClass::StorageBuffer, root.vec4, 0),
        };
        let block = match blocks.get(&(kind, vec4, length)) {
            Some(&block) => block,
            None => self.block(vec4, length),
        };
        blocks.insert((kind, vec4, length), block);
        self.global(block, class)
    }

    /// `struct { array of words or of four words each }`; the array has no fixed length if that is 0.
    fn block(&mut self, vec4: bool, length: u32) -> Word {
        let (element, stride) = if vec4 { (self.constants.vec4, 16) } else { (self.constants.u32, 4) };
        // An id of its own: the array without a layout, in workgroup memory, is another type.
        let array = self.builder.id();
        match length {
            0 => self.builder.type_runtime_array_id(Some(array), element),
            length => {
                let length = self.word(length);
                self.builder.type_array_id(Some(array), element, length)
            }
        };
        self.builder.decorate(array, Decoration::ArrayStride, [Operand::LiteralBit32(stride)]);
        let block = self.builder.id();
        self.builder.type_struct_id(Some(block), [array]);
        self.builder.member_decorate(block, 0, Decoration::Offset, [Operand::LiteralBit32(0)]);
        self.builder.decorate(block, Decoration::Block, []);
        block
    }

    /// An array of words without a layout.
    fn array(&mut self, words: u32) -> Word {
        let length = self.word(words.max(1));
        let id = self.plain_arrays.get(&length).copied();
        id.unwrap_or_else(|| {
            let array = self.builder.id();
            self.builder.type_array_id(Some(array), self.constants.u32, length);
            self.plain_arrays.insert(length, array);
            array
        })
    }

    fn global(&mut self, ty: Word, class: StorageClass) -> RootVariable {
        let pointer = self.builder.type_pointer(None, class, ty);
        RootVariable { id: self.builder.variable(pointer, None, class, None), class }
    }

    /// A table of constants is a variable of the function that begins with its value: a constant cannot be
    /// indexed with a variable.
    fn table(&mut self, words: &[u32]) -> RootVariable {
        let array = self.array(words.len() as u32);
        let words: Vec<Word> = words.iter().map(|&word| self.word(word)).collect();
        let value = self.builder.constant_composite(array, words);
        RootVariable { id: self.local(array, Some(value)), class: StorageClass::Function }
    }

    fn chain(&mut self, root: RootId, element: Word, indices: &[Word]) -> Result<Word, EmitError> {
        let variable = self.roots[root.index()];
        let pointer = self.builder.type_pointer(None, variable.class, element);
        let block = matches!(
            self.kernel.root(root).space,
            Space::Storage { .. } | Space::Uniform { .. } | Space::Push
        );
        let member = block.then(|| self.word(0));
        let operands: Vec<Word> =
            [variable.id].into_iter().chain(member).chain(indices.iter().copied()).collect();
        self.make_of(Op::AccessChain, pointer, &operands)
    }

    /// A pointer to a word of a root that is not `vec4`.
    pub fn word_pointer(&mut self, root: RootId, index: &Value) -> Result<Word, EmitError> {
        let indices = match (&self.kernel.root(root).space, index.as_u32()) {
            (Space::Uniform { .. }, Some(index)) => vec![self.word(index / 4), self.word(index % 4)],
            (Space::Uniform { .. }, None) => {
                let (index, two, three) = (self.value(index)?, self.word(2), self.word(3));
                let ty = self.constants.u32;
                let element = self.make_of(Op::ShiftRightLogical, ty, &[index, two])?;
                vec![element, self.make_of(Op::BitwiseAnd, ty, &[index, three])?]
            }
            _ => vec![self.value(index)?],
        };
        self.chain(root, self.constants.u32, &indices)
    }

    pub fn load_word(&mut self, root: RootId, index: &Value) -> Result<Word, EmitError> {
        let pointer = self.word_pointer(root, index)?;
        self.make_of(Op::Load, self.constants.u32, &[pointer])
    }

    pub fn store_word(&mut self, root: RootId, index: &Value, word: &Value) -> Result<(), EmitError> {
        let (pointer, word) = (self.word_pointer(root, index)?, self.value(word)?);
        self.store(pointer, word)
    }

    pub fn load_vec4(&mut self, root: RootId, element: &Value) -> Result<Word, EmitError> {
        let element = self.value(element)?;
        let pointer = self.chain(root, self.constants.vec4, &[element])?;
        self.make_of(Op::Load, self.constants.vec4, &[pointer])
    }

    pub fn store_vec4(&mut self, root: RootId, element: &Value, words: &[Value; 4]) -> Result<(), EmitError> {
        let element = self.value(element)?;
        let pointer = self.chain(root, self.constants.vec4, &[element])?;
        let words = self.values(words)?;
        let vector = self.make_of(Op::CompositeConstruct, self.constants.vec4, &words)?;
        self.store(pointer, vector)
    }

    pub fn store_component(
        &mut self,
        root: RootId,
        element: &Value,
        component: &Value,
        word: &Value,
    ) -> Result<(), EmitError> {
        let indices = [self.value(element)?, self.value(component)?];
        let pointer = self.chain(root, self.constants.u32, &indices)?;
        let word = self.value(word)?;
        self.store(pointer, word)
    }

    /// A word of four, by a number or by a variable.
    pub fn component(&mut self, vector: &Value, component: &Value) -> Result<Word, EmitError> {
        let (vector, ty) = (self.value(vector)?, self.constants.u32);
        match component.as_u32() {
            Some(number) => {
                let operands = vec![Operand::IdRef(vector), Operand::LiteralBit32(number)];
                self.make(Op::CompositeExtract, ty, operands)
            }
            None => {
                let component = self.value(component)?;
                self.make_of(Op::VectorExtractDynamic, ty, &[vector, component])
            }
        }
    }

    /// How many words a storage buffer has.
    pub fn word_count(&mut self, root: RootId) -> Result<Word, EmitError> {
        let ty = self.constants.u32;
        let buffer = Operand::IdRef(self.roots[root.index()].id);
        let elements = self.make(Op::ArrayLength, ty, vec![buffer, Operand::LiteralBit32(0)])?;
        if !self.kernel.root(root).vec4 {
            return Ok(elements);
        }
        let two = self.word(2);
        self.make_of(Op::ShiftLeftLogical, ty, &[elements, two])
    }

    /// Whether a root is shared by a workgroup only.
    pub fn is_workgroup(&self, root: RootId) -> bool {
        matches!(self.kernel.root(root).space, Space::Workgroup(_))
    }
}
