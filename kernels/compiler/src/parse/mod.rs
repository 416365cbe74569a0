//! Reads the text of LLVM's IR, as far as optimised kernels use it.
//!
//! Nothing is guessed: an instruction, type, constant or flag that is not known is a [`Reason`] that names it, and the function that
//! holds it is refused. Functions that no kernel is made of are not read at all.

mod attributes;
mod calls;
mod constants;
mod cursor;
mod debug;
mod function;
mod instructions;
mod lexer;
mod memory;
mod module;
mod types;

pub use calls::is_known;
pub use module::{Parsed, Problem, Unread, parse};

use crate::refusal::Reason;

/// What reading yields, or why not.
type Result<T> = std::result::Result<T, Reason>;
