//! Constant folding and identities that hold for every operand.
//!
//! Floats are not touched: what a device computes must be what the CPU computes, signed zeros and NaNs included.

use crate::ir::{BinaryOp, CastOp, Function, Id, IntPredicate, Op, SourceOp, Type, Value, mask, sign_extend};

/// The value of `op`, if it is a constant or one of the values that went in.
pub fn fold(function: &Function, op: &Op, ty: &Type) -> Option<Value> {
    match op {
        Op::Copy(value) => Some(value.clone()),
        Op::Binary(op, a, b) if ty.is_int() => binary(function, *op, a, b, ty.bits()),
        Op::IntCompare(predicate, a, b) => compare(function, *predicate, a, b),
        Op::Select(condition, a, b) => select(condition, a, b),
        Op::Cast(op, value) => cast(function, *op, value, ty),
        Op::Source(SourceOp::ExtractValue(aggregate, path)) => extract_value(function, aggregate, path),
        Op::Source(SourceOp::ExtractElement(vector, index)) => {
            extract_element(function, vector, index.as_int()?)
        }
        _ => None,
    }
}

fn binary(function: &Function, op: BinaryOp, a: &Value, b: &Value, bits: u32) -> Option<Value> {
    if let (Some(a), Some(b)) = (a.as_int(), b.as_int()) {
        return constant_binary(op, a, b, bits);
    }
    use BinaryOp::*;
    match (op, a.as_int(), b.as_int()) {
        (Add | Or | Xor, Some(0), _) | (Mul, Some(1), _) => Some(b.clone()),
        (Add | Sub | Or | Xor | Shl | LShr | AShr, _, Some(0)) | (Mul | UDiv, _, Some(1)) => Some(a.clone()),
        (Mul | And, Some(0), _) | (Mul | And, _, Some(0)) => Some(Value::int(bits, 0)),
        (And, _, Some(m)) if m == mask(bits) => Some(a.clone()),
        (And, _, Some(m)) => {
            let zeros = trailing_zeros(function, a, 6);
            (zeros >= bits || m >> zeros == 0).then(|| Value::int(bits, 0))
        }
        _ => None,
    }
}

/// What has no defined result (a division by zero, a shift by the width) is left alone.
fn constant_binary(op: BinaryOp, a: u128, b: u128, bits: u32) -> Option<Value> {
    use BinaryOp::*;
    let in_width = b < u128::from(bits);
    Some(Value::int(
        bits,
        match op {
            Add => a.wrapping_add(b),
            Sub => a.wrapping_sub(b),
            Mul => a.wrapping_mul(b),
            And => a & b,
            Or => a | b,
            Xor => a ^ b,
            Shl if in_width => a << b,
            LShr if in_width => a >> b,
            AShr if in_width => (sign_extend(a, bits) >> b) as u128,
            UDiv if b != 0 => a / b,
            URem if b != 0 => a % b,
            _ => return None,
        },
    ))
}

fn compare(function: &Function, predicate: IntPredicate, a: &Value, b: &Value) -> Option<Value> {
    let bits = function.type_of(a).bits();
    let (a, b) = (a.as_int()?, b.as_int()?);
    Some(Value::bool(holds(predicate, a, b, bits)))
}

/// Whether the comparison of two integers of so many bits holds.
pub fn holds(predicate: IntPredicate, a: u128, b: u128, bits: u32) -> bool {
    use IntPredicate::*;
    let (signed_a, signed_b) = (sign_extend(a, bits), sign_extend(b, bits));
    match predicate {
        Eq => a == b,
        Ne => a != b,
        Ugt => a > b,
        Uge => a >= b,
        Ult => a < b,
        Ule => a <= b,
        Sgt => signed_a > signed_b,
        Sge => signed_a >= signed_b,
        Slt => signed_a < signed_b,
        Sle => signed_a <= signed_b,
    }
}

fn select(condition: &Value, a: &Value, b: &Value) -> Option<Value> {
    match condition.as_int() {
        Some(0) => Some(b.clone()),
        Some(_) => Some(a.clone()),
        None => (a == b).then(|| a.clone()),
    }
}

fn cast(function: &Function, op: CastOp, value: &Value, ty: &Type) -> Option<Value> {
    let bits = ty.bits();
    match (op, value, value.as_int()) {
        (CastOp::Bitcast, Value::F32(x), _) if *ty == Type::I32 => Some(Value::u32(*x)),
        (CastOp::Bitcast, _, Some(x)) if *ty == Type::F32 => Some(Value::F32(x as u32)),
        (CastOp::Trunc | CastOp::ZExt, _, Some(x)) => Some(Value::int(bits, x)),
        (CastOp::SExt, _, Some(x)) => {
            Some(Value::int(bits, sign_extend(x, function.type_of(value).bits()) as u128))
        }
        (CastOp::Bitcast, Value::Inst(id), _) => match &function[*id].op {
            Op::Cast(CastOp::Bitcast, original) if function.type_of(original) == *ty => {
                Some(original.clone())
            }
            _ => None,
        },
        (CastOp::Trunc, Value::Inst(id), _) => truncation(function, *id, ty),
        _ => None,
    }
}

/// The truncation of something that was extended, or put together from two words.
fn truncation(function: &Function, id: Id, ty: &Type) -> Option<Value> {
    match &function[id].op {
        Op::Cast(CastOp::ZExt | CastOp::SExt, original) if function.type_of(original) == *ty => {
            Some(original.clone())
        }
        Op::Binary(BinaryOp::Or, low, high) if *ty == Type::I32 && shifted_word(function, high).is_some() => {
            extended_word(function, low)
        }
        Op::Binary(BinaryOp::LShr, value, shift) if *ty == Type::I32 && shift.as_int() == Some(32) => {
            match function.op_of(value)? {
                Op::Binary(BinaryOp::Or, _, high) if function[id].ty == Type::I64 => {
                    shifted_word(function, high)
                }
                Op::Binary(BinaryOp::Shl, ..) if function[id].ty == Type::I64 => {
                    shifted_word(function, value)
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The word `w` of `zext w`.
fn extended_word(function: &Function, value: &Value) -> Option<Value> {
    match function.op_of(value)? {
        Op::Cast(CastOp::ZExt, word) if function.type_of(word) == Type::I32 => Some(word.clone()),
        _ => None,
    }
}

/// The word `w` of `(zext w) << 32`.
fn shifted_word(function: &Function, value: &Value) -> Option<Value> {
    match function.op_of(value)? {
        Op::Binary(BinaryOp::Shl, word, shift) if shift.as_int() == Some(32) => extended_word(function, word),
        _ => None,
    }
}

/// Looks for the field at `path` in the insertions that made the aggregate.
fn extract_value(function: &Function, aggregate: &Value, path: &[u32]) -> Option<Value> {
    let [field] = path else { return None };
    let mut aggregate = aggregate;
    loop {
        match aggregate {
            Value::Aggregate(_, fields) => return fields.get(*field as usize).cloned(),
            Value::Inst(id) => match &function[*id].op {
                Op::Source(SourceOp::InsertValue(_, value, at)) if at == path => return Some(value.clone()),
                Op::Source(SourceOp::InsertValue(rest, _, at)) if at.len() == 1 => aggregate = rest,
                Op::Copy(original) => aggregate = original,
                _ => return None,
            },
            _ => return None,
        }
    }
}

fn extract_element(function: &Function, vector: &Value, index: u128) -> Option<Value> {
    let mut vector = vector;
    loop {
        match vector {
            Value::Aggregate(_, elements) => return elements.get(index as usize).cloned(),
            Value::Inst(id) => match &function[*id].op {
                Op::Source(SourceOp::InsertElement(rest, value, at)) => {
                    if at.as_int()? == index {
                        return Some(value.clone());
                    }
                    vector = rest;
                }
                Op::Copy(original) => vector = original,
                _ => return None,
            },
            Value::Zero(Type::Vector(_, element)) => return Some(Value::Zero((**element).clone())),
            _ => return None,
        }
    }
}

/// How many low bits are known to be zero (more than any width for zero itself).
fn trailing_zeros(function: &Function, value: &Value, depth: u32) -> u32 {
    if let Some(constant) = value.as_int() {
        return constant.trailing_zeros();
    }
    let (Some(op), true) = (function.op_of(value), depth > 0) else { return 0 };
    let zeros = |value: &Value| trailing_zeros(function, value, depth - 1);
    use BinaryOp::*;
    match op {
        Op::Binary(Shl, a, shift) => zeros(a).saturating_add(shift.as_u32().unwrap_or(0)),
        Op::Binary(Mul, a, b) => zeros(a).saturating_add(zeros(b)),
        Op::Binary(Add | Sub | Or | Xor, a, b) => zeros(a).min(zeros(b)),
        Op::Binary(And, a, b) => zeros(a).max(zeros(b)),
        Op::Copy(a) => zeros(a),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cleanup::builder::Builder;

    fn unknown_word(builder: &mut Builder) -> Value {
        let id = builder.function.push(Op::SpecConstant { id: 0, default: 0 }, Type::I32);
        Value::Inst(id)
    }

    #[test]
    fn constants() {
        let f = Function::default();
        let byte = |op, a, b| binary(&f, op, &Value::int(8, a), &Value::int(8, b), 8);
        assert_eq!(byte(BinaryOp::Add, 250, 10), Some(Value::Int(8, 4)));
        assert_eq!(byte(BinaryOp::AShr, 0x80, 7), Some(Value::Int(8, 0xff)));
        assert_eq!(byte(BinaryOp::UDiv, 1, 0), None);
        assert_eq!(byte(BinaryOp::Shl, 1, 8), None);
        assert_eq!(
            compare(&f, IntPredicate::Slt, &Value::int(8, 0xff), &Value::int(8, 1)),
            Some(Value::bool(true))
        );
        let wide = fold(&f, &Op::Cast(CastOp::SExt, Value::int(8, 0x80)), &Type::I32);
        assert_eq!(wide, Some(Value::u32(0xffff_ff80)));
    }

    #[test]
    fn identities() {
        let mut b = Builder::default();
        let x = unknown_word(&mut b);
        assert_eq!(b.binary_const(BinaryOp::Add, &x, 0), x);
        assert_eq!(b.binary_const(BinaryOp::Mul, &x, 0), Value::u32(0));
        let shifted = b.binary_const(BinaryOp::Shl, &x, 2);
        assert_eq!(b.binary_const(BinaryOp::And, &shifted, 3), Value::u32(0));
        assert!(b.binary_const(BinaryOp::And, &shifted, 7).as_int().is_none());
        assert!(b.binary_const(BinaryOp::SDiv, &x, 3).as_int().is_none());
    }

    #[test]
    fn two_words_make_a_wide_value_and_come_back() {
        let mut b = Builder::default();
        let (low, high) = (unknown_word(&mut b), unknown_word(&mut b));
        let (wide_low, wide_high) =
            (b.cast(CastOp::ZExt, &low, Type::I64), b.cast(CastOp::ZExt, &high, Type::I64));
        let shifted = b.binary_const(BinaryOp::Shl, &wide_high, 32);
        let both = b.binary(BinaryOp::Or, &wide_low, &shifted);
        assert_eq!(b.cast(CastOp::Trunc, &both, Type::I32), low);
        let upper = b.binary_const(BinaryOp::LShr, &both, 32);
        assert_eq!(b.cast(CastOp::Trunc, &upper, Type::I32), high);
    }

    #[test]
    fn fields_are_found_behind_other_insertions() {
        let mut b = Builder::default();
        let (x, y) = (unknown_word(&mut b), unknown_word(&mut b));
        let pair = b.pair(x.clone(), y.clone());
        assert_eq!(b.emit(SourceOp::ExtractValue(pair.clone(), vec![0]), Type::I32), x);
        assert_eq!(b.emit(SourceOp::ExtractValue(pair, vec![1]), Type::I32), y);
    }
}
