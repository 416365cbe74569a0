//! Rewrites a kernel so that its memory is words of known roots and `usize` has 32 bits.
//!
//! The blocks are visited in an order in which definitions come before uses (but over the edges of loops). Each instruction is
//! translated once, where it stands: a pointer becomes a `Place`, a load or store becomes accesses of words, a call becomes an
//! operation that every target has, and each integer of more than 32 bits gets a companion that is its low word. What nobody uses
//! afterwards is removed by the [clean-up](crate::cleanup).
//!
//! * `bounds`: which 64-bit values are `usize`; `narrow`, `halves`: their low and high words.
//! * `origins`, `places`, `joins`, `linear`: pointers.
//! * `access`, `copies`, `atomics`: loads, stores and what is made of them.
//! * `roots`, `tables`: the memory; `calls`, `intrinsics`: what is called.

mod access;
mod atomics;
mod bounds;
mod calls;
mod compare;
mod copies;
mod halves;
mod intrinsics;
mod joins;
mod linear;
mod narrow;
mod origins;
mod places;
mod roots;
mod tables;

use crate::cleanup::builder::Builder;
use crate::ir::{
    BlockId, CastOp, Function, Id, Kernel, Module, Op, Root, RootId, SourceOp, Terminator, Type, Value,
};
use crate::refusal::{Reason, Refusal};
use crate::structure::dominators::Dominators;
use bounds::Bounds;
use origins::Origins;
use places::Place;
use std::collections::HashMap;
use std::sync::Arc;

/// What lowering yields, or why not.
type Result<T> = std::result::Result<T, Reason>;

/// How kernels are lowered.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whether records of 16-byte alignment are accessed 128 bits at a time.
    pub vec4: bool,
}

/// The prefix of the symbols of entry points.
pub const ENTRY: &str = "__kernel_";

/// Lowers the kernel `source` of `module`. The result still needs clean-up.
///
/// # Errors
/// All problems of the kernel.
pub fn lower(
    module: &Module,
    source: &Function,
    options: Options,
) -> std::result::Result<Kernel, Vec<Refusal>> {
    let entry = source.name.trim_start_matches(ENTRY);
    let mut refusals = calls::refusals(module, source, entry);
    let mut lowering = Lowering::new(module, source, options);
    let mut note = |reason, location: Option<u32>| {
        let refusal = Refusal::new(entry, reason, location.and_then(|at| module.locations.origin(at)));
        let same = |other: &Refusal| other.reason == refusal.reason && other.function == refusal.function;
        if !refusals.iter().any(same) && !refusal.reason.is_about_a_call() {
            refusals.push(refusal);
        }
    };
    if let Err(reason) = lowering.find_roots() {
        note(reason, None);
    }
    lowering.blocks(&mut note);
    if refusals.is_empty() { Ok(lowering.kernel(entry)) } else { Err(refusals) }
}

struct Lowering<'a> {
    module: &'a Module,
    /// The kernel as it was parsed.
    source: &'a Function,
    bounds: Bounds<'a>,
    origins: Origins<'a>,
    options: Options,
    /// The kernel as it becomes; instructions of `source` keep their numbers.
    build: Builder,
    /// What goes to the end of each block.
    tails: Vec<Vec<Id>>,
    threads: [u32; 3],
    roots: Vec<Root>,
    /// Roots by the instruction that makes a pointer to their begin.
    made: HashMap<Id, RootId>,
    /// Roots that are tables of constants, by global.
    tables: HashMap<Arc<str>, RootId>,
    /// What each pointer points to.
    places: HashMap<Id, Result<Place>>,
    /// The low words of integers of more than 32 bits.
    low: HashMap<Id, Value>,
    /// The high words of 64-bit integers.
    high: HashMap<Id, Value>,
}

impl<'a> Lowering<'a> {
    fn new(module: &'a Module, source: &'a Function, options: Options) -> Self {
        Self {
            module,
            source,
            bounds: Bounds::new(source),
            origins: Origins::new(source),
            options,
            build: Builder { function: source.clone(), ..Builder::default() },
            tails: vec![vec![]; source.blocks.len()],
            threads: [1; 3],
            roots: vec![],
            made: HashMap::new(),
            tables: HashMap::new(),
            places: HashMap::new(),
            low: HashMap::new(),
            high: HashMap::new(),
        }
    }

    /// Translates all blocks; `note` hears of all problems.
    fn blocks(&mut self, note: &mut dyn FnMut(Reason, Option<u32>)) {
        let successors: Vec<Vec<usize>> = self.source.blocks.iter().map(|b| indices(&b.terminator)).collect();
        let order = Dominators::new(&successors, 0).reverse_postorder;
        for block in self.build.function.block_ids() {
            self.build.function[block].instructions.clear();
        }
        for &block in &order {
            for &id in &self.source.blocks[block].instructions {
                self.build.location = self.source[id].location;
                if let Err(reason) = self.instruction(id) {
                    note(reason, self.build.location);
                }
            }
            self.build.function.blocks[block].instructions = std::mem::take(&mut self.build.out);
        }
        if let Err(reason) = self.close_phis() {
            note(reason, None);
        }
        for block in 0..self.tails.len() {
            let tail = std::mem::take(&mut self.tails[block]);
            self.build.function.blocks[block].instructions.extend(tail);
        }
        for block in (0..self.source.blocks.len()).filter(|block| !order.contains(block)) {
            self.build.function.blocks[block].terminator = Terminator::Unreachable;
        }
    }

    /// Fills in the companions of phis, whose operands may come later than they.
    fn close_phis(&mut self) -> Result<()> {
        for id in self.source.placed().collect::<Vec<_>>() {
            let Op::Phi(edges) = &self.source[id].op else { continue };
            match &self.source[id].ty {
                Type::Pointer => self.close_pointer_phi(id, edges)?,
                Type::Int(bits @ 33..) => {
                    self.close_low_phi(id, edges);
                    if *bits == 64 {
                        self.close_high_phi(id, edges);
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn kernel(self, entry: &str) -> Kernel {
        Kernel { name: entry.into(), threads: self.threads, function: self.build.function, roots: self.roots }
    }

    /// Translates one instruction.
    fn instruction(&mut self, id: Id) -> Result<()> {
        let instruction = &self.source[id];
        self.refuse_types(&instruction.op, &instruction.ty)?;
        if instruction.ty == Type::Pointer {
            return self.pointer(id);
        }
        match self.translate(id)? {
            Translation::Keep => {
                let mut op = instruction.op.clone();
                op.for_each_operand_mut(|v| *v = self.build.resolve(v));
                self.build.function[id].op = op;
                self.build.out.push(id);
            }
            Translation::Value(value) => self.build.function[id].op = Op::Copy(value),
            Translation::Nothing => {}
        }
        if matches!(instruction.ty, Type::Int(33..)) {
            self.make_low(id);
        }
        if instruction.ty == Type::I64 {
            self.make_high(id);
        }
        Ok(())
    }

    fn translate(&mut self, id: Id) -> Result<Translation> {
        let instruction = &self.source[id];
        match &instruction.op {
            Op::Source(SourceOp::Load { pointer, atomic, align }) => {
                self.translate_load(pointer, *atomic, *align, &instruction.ty).map(Translation::Value)
            }
            Op::Source(SourceOp::Store { value, pointer, atomic, align }) => {
                self.translate_store(value, pointer, *atomic, *align)?;
                Ok(Translation::Nothing)
            }
            Op::Source(SourceOp::Atomic(op, pointer, value)) => {
                self.atomic(*op, pointer, value).map(Translation::Value)
            }
            Op::Source(SourceOp::CompareExchange(pointer, expected, new)) => {
                self.compare_exchange(pointer, expected, new).map(Translation::Value)
            }
            Op::Source(SourceOp::Call(name, arguments)) => self.call(id, name, arguments),
            Op::Source(SourceOp::Shuffle(a, b, mask)) => {
                let value = self.shuffle(a, b, mask, &instruction.ty);
                Ok(Translation::Value(value))
            }
            Op::IntCompare(predicate, a, b) => self.compare(*predicate, a, b),
            Op::Cast(CastOp::PtrToInt, pointer) => {
                let value = self.address(pointer, &instruction.ty)?;
                Ok(Translation::Value(value))
            }
            Op::Cast(op, value) if self.source.type_of(value) == Type::I64 => {
                Ok(self.narrow_cast(*op, value, &instruction.ty))
            }
            op => Ok(self.fold(op, &instruction.ty)),
        }
    }

    /// The value of an operation that stays as it is, if it is known.
    fn fold(&self, op: &Op, ty: &Type) -> Translation {
        if matches!(op, Op::Phi(_)) {
            return Translation::Keep;
        }
        let mut op = op.clone();
        op.for_each_operand_mut(|v| *v = self.build.resolve(v));
        crate::cleanup::fold::fold(&self.build.function, &op, ty)
            .map_or(Translation::Keep, Translation::Value)
    }

    /// Elements one by one.
    fn shuffle(&mut self, a: &Value, b: &Value, mask: &[Option<u32>], ty: &Type) -> Value {
        let (a, b) = (self.build.resolve(a), self.build.resolve(b));
        let Type::Vector(n, element) = self.build.type_of(&a) else { return Value::Undef(ty.clone()) };
        let mut vector = Value::Undef(ty.clone());
        for (at, from) in mask.iter().enumerate() {
            let Some(from) = *from else { continue };
            let (source, index) = if from < n { (&a, from) } else { (&b, from - n) };
            let extract = SourceOp::ExtractElement(source.clone(), Value::u32(index));
            let value = self.build.emit(extract, (*element).clone());
            vector =
                self.build.emit(SourceOp::InsertElement(vector, value, Value::u32(at as u32)), ty.clone());
        }
        vector
    }

    /// Types that no device has.
    fn refuse_types(&self, op: &Op, ty: &Type) -> Result<()> {
        let mut result = refuse_type(ty);
        op.for_each_operand(|value| {
            if result.is_ok() {
                result = refuse_type(&self.source.type_of(value));
            }
        });
        result
    }
}

/// What comes of an instruction.
enum Translation {
    /// It stays as it is.
    Keep,
    /// It stands for this value.
    Value(Value),
    /// It makes no value and is gone.
    Nothing,
}

fn refuse_type(ty: &Type) -> Result<()> {
    match ty {
        Type::F64 => Err(Reason::Double),
        Type::Other(name) => Err(Reason::Unknown(format!("the type `{name}`"))),
        Type::Vector(_, element) | Type::Array(_, element) => refuse_type(element),
        _ => Ok(()),
    }
}

fn indices(terminator: &Terminator) -> Vec<usize> {
    terminator.successors().into_iter().map(BlockId::index).collect()
}

#[cfg(test)]
pub(crate) mod tests;
