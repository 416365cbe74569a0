//! LLVM's intrinsics, in terms of what SPIR-V and WGSL have. What is not here is refused by name.

mod bits;
mod conversion;
mod float;
mod overflow;
#[cfg(test)]
mod tests;

use crate::cleanup::builder::Builder;
use crate::ir::{IntPredicate, MathOp, Type, Value};

/// The name of an intrinsic without `llvm.` and the types at its end.
pub fn base_name(name: &str) -> Option<String> {
    let is_type = |part: &&str| {
        part.starts_with(['i', 'f', 'p', 'v']) && part[1..].starts_with(|c: char| c.is_ascii_digit())
    };
    let parts = name.strip_prefix("llvm.")?.split('.').take_while(|part| !is_type(part));
    Some(parts.collect::<Vec<_>>().join("."))
}

/// The value of the intrinsic `base` of scalar arguments, as a `ty`; `None` if it is not known.
pub fn expand(build: &mut Builder, base: &str, arguments: &[Value], ty: &Type) -> Option<Value> {
    let scalar = |v: &Value| matches!(build.type_of(v), Type::Int(_) | Type::F32);
    if !arguments.iter().all(scalar) {
        return None;
    }
    match build.type_of(arguments.first()?) {
        Type::F32 => {
            conversion::expand(build, base, arguments, ty).or_else(|| float::expand(build, base, arguments))
        }
        Type::Int(bits) => integer(build, base, arguments, ty, bits),
        _ => None,
    }
}

fn integer(build: &mut Builder, base: &str, arguments: &[Value], ty: &Type, bits: u32) -> Option<Value> {
    match (base, arguments) {
        ("umin", [a, b]) => Some(choose(build, IntPredicate::Ult, MathOp::UMin, a, b)),
        ("umax", [a, b]) => Some(choose(build, IntPredicate::Ugt, MathOp::UMax, a, b)),
        ("smin", [a, b]) => Some(choose(build, IntPredicate::Slt, MathOp::SMin, a, b)),
        ("smax", [a, b]) => Some(choose(build, IntPredicate::Sgt, MathOp::SMax, a, b)),
        ("abs", [a, ..]) => {
            let zero = Value::int(bits, 0);
            let negative = build.compare(IntPredicate::Slt, a, &zero);
            let negated = build.binary(crate::ir::BinaryOp::Sub, &zero, a);
            Some(build.select(&negative, &negated, a))
        }
        ("scmp", [a, b]) => Some(order(build, IntPredicate::Slt, IntPredicate::Sgt, a, b, ty)),
        ("ucmp", [a, b]) => Some(order(build, IntPredicate::Ult, IntPredicate::Ugt, a, b, ty)),
        _ => bits::expand(build, base, arguments, bits)
            .or_else(|| overflow::expand(build, base, arguments, bits)),
    }
}

/// The operand for which `predicate` holds: by `op` if they are words.
fn choose(build: &mut Builder, predicate: IntPredicate, op: MathOp, a: &Value, b: &Value) -> Value {
    if build.type_of(a) == Type::I32 {
        return build.math(op, vec![a.clone(), b.clone()]);
    }
    let first = build.compare(predicate, a, b);
    build.select(&first, a, b)
}

/// −1, 0 or 1.
fn order(
    build: &mut Builder,
    less: IntPredicate,
    greater: IntPredicate,
    a: &Value,
    b: &Value,
    ty: &Type,
) -> Value {
    let (is_less, is_greater) = (build.compare(less, a, b), build.compare(greater, a, b));
    let number = |value| Value::int(ty.bits(), value);
    let rest = build.select(&is_less, &number(u128::MAX), &number(0));
    build.select(&is_greater, &number(1), &rest)
}
