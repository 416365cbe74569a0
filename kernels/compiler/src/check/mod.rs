//! What must hold of a structured kernel before it is emitted: barriers and subgroup operations are reached
//! by whole workgroups, and only types and operations are left that every target has.

mod types;
mod uniformity;

use crate::parse::Problem;
use crate::structure::Structured;

/// Everything that is wrong with `structured`; `wide` lets 64-bit integers through.
pub fn problems(structured: &Structured, wide: bool) -> Vec<Problem> {
    let mut problems = types::problems(&structured.kernel, wide);
    problems.extend(uniformity::problems(structured));
    problems
}
