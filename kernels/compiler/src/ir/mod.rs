//! The program in memory: first as LLVM's IR says it, after [lowering](crate::lower) as a GPU can run it.
//!
//! Both stages share these types. What only LLVM's IR has (pointers, calls, aggregates) is an [`Op::Source`]; a lowered kernel has
//! none of those left, its memory is words of [`Root`]s, and its values are `i1`, `i32`, `f32`, `<4 x i32>` (and `i64` if allowed).

mod function;
mod instructions;
mod kernel;
mod locations;
mod operands;
mod operations;
mod types;
mod values;

pub use function::{Block, Function, Global, Module, Terminator};
pub use instructions::{Instruction, Op, SourceOp};
pub use kernel::{Kernel, Root, Space};
pub use locations::{Locations, Origin, Record};
pub use operations::{AtomicOp, BinaryOp, Builtin, CastOp, FloatPredicate, IntPredicate, MathOp, SubgroupOp};
pub use types::Type;
pub use values::{BlockId, Id, RootId, Value, mask, sign_extend};
