//! The types and operations that reach the emitters.

use crate::ir::{Id, Instruction, Kernel, Op, Type, Value};
use crate::parse::Problem;
use crate::refusal::Reason;

/// What no emitter has a form for, each named once by its first value.
pub fn problems(kernel: &Kernel, wide: bool) -> Vec<Problem> {
    let mut problems: Vec<Problem> = Vec::new();
    for id in kernel.function.placed() {
        let found = problem(kernel, id, wide);
        let kind = |reason: &Reason| std::mem::discriminant(reason);
        let is_new = |new: &Reason| match new {
            Reason::Unknown(_) => problems.iter().all(|old| old.reason != *new),
            _ => problems.iter().all(|old| kind(&old.reason) != kind(new)),
        };
        let found = found.filter(is_new);
        problems.extend(found.map(|reason| Problem { reason, location: kernel.function[id].location }));
    }
    problems
}

fn problem(kernel: &Kernel, id: Id, wide: bool) -> Option<Reason> {
    let Instruction { op, ty, name, .. } = &kernel.function[id];
    if let Op::Source(op) = op {
        return Some(Reason::Unknown(format!("the instruction {op:?} (value %{name})")));
    }
    let mut found = of_type(ty, name, wide);
    op.for_each_operand(|value| {
        if !matches!(value, Value::Inst(_)) && found.is_none() {
            found = of_type(&kernel.function.type_of(value), name, wide);
        }
    });
    found
}

fn of_type(ty: &Type, name: &str, wide: bool) -> Option<Reason> {
    match ty {
        Type::Void | Type::Int(1 | 32) | Type::F32 => None,
        Type::Int(64) if wide => None,
        Type::Vector(4, element) if **element == Type::I32 => None,
        Type::Int(64) => Some(Reason::Wide(name.to_owned())),
        Type::F64 => Some(Reason::Double),
        other => Some(Reason::Unknown(format!("the type {other:?} of the value %{name}"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{BinaryOp, Terminator};
    use crate::testing::KernelBuilder;

    fn reasons(kernel: &Kernel, wide: bool) -> Vec<Reason> {
        problems(kernel, wide).into_iter().map(|problem| problem.reason).collect()
    }

    fn kernel(ty: Type, constant: Value) -> Kernel {
        let mut k = KernelBuilder::new(1);
        k.push(0, Op::Binary(BinaryOp::Add, constant.clone(), constant), ty);
        k.end(0, Terminator::Return);
        k.build()
    }

    #[test]
    fn sixty_four_bits_are_refused_unless_asked_for() {
        let wide = kernel(Type::I64, Value::int(64, 1 << 40));
        assert!(matches!(reasons(&wide, false)[..], [Reason::Wide(_)]));
        assert_eq!(reasons(&wide, true), []);
        assert_eq!(reasons(&kernel(Type::I32, Value::u32(1)), false), []);
    }

    #[test]
    fn a_double_and_an_odd_width_are_refused() {
        assert_eq!(reasons(&kernel(Type::F64, Value::F64(0)), true), [Reason::Double]);
        let odd = &reasons(&kernel(Type::Int(17), Value::int(17, 3)), true)[0];
        assert!(odd.to_string().contains("Int(17)"), "{odd}");
    }
}
