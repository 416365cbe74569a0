//! Calls: those that an entry point is made of, LLVM's intrinsics, and the ones that no device can do.

use super::intrinsics::{self, base_name};
use super::roots::constants;
use super::{Lowering, Result, Translation};
use crate::demangle::demangle;
use crate::ir::{Builtin, CastOp, Function, Id, Module, Op, SourceOp, SubgroupOp, Type, Value};
use crate::parse::is_known;
use crate::refusal::{Reason, Refusal};
use std::sync::Arc;

/// Intrinsics that tell the optimiser something and compute nothing.
const HINTS: [&str; 8] = [
    "assume",
    "lifetime.start",
    "lifetime.end",
    "experimental.noalias.scope.decl",
    "prefetch",
    "donothing",
    "invariant.start",
    "invariant.end",
];

/// What the kernel calls that cannot be on a device: each function once.
pub(super) fn refusals(module: &Module, source: &Function, entry: &str) -> Vec<Refusal> {
    let mut refusals: Vec<Refusal> = Vec::new();
    for id in source.placed() {
        let Op::Source(SourceOp::Call(name, _)) = &source[id].op else { continue };
        let Some(reason) = refuse(module, name) else { continue };
        let function = Some(demangle(name));
        match refusals.iter_mut().find(|refusal| refusal.function == function) {
            Some(Refusal { reason: Reason::Panic { calls }, .. }) => *calls += 1,
            Some(_) => {}
            None => {
                let origin = source[id].location.and_then(|at| module.locations.origin(at));
                refusals.push(Refusal { function, ..Refusal::new(entry, reason, origin) })
            }
        }
    }
    refusals
}

/// Why a function cannot be called.
pub(super) fn refuse(module: &Module, name: &str) -> Option<Reason> {
    if is_panic(name) {
        return Some(Reason::Panic { calls: 1 });
    }
    if is_known(name) {
        return None;
    }
    Some(if is_allocation(name) {
        Reason::Allocation
    } else if module.defined.contains(name) {
        Reason::NotInlined
    } else {
        Reason::NoBody
    })
}

/// The functions of the standard library that a failing check ends in.
fn is_panic(name: &str) -> bool {
    const PARTS: [&str; 7] = [
        "panic",
        "unwrap_failed",
        "expect_failed",
        "slice_index",
        "slice5index",
        "copy_from_slice_impl",
        "len_mismatch_fail",
    ];
    matches!(name, "llvm.trap" | "llvm.ubsantrap" | "abort") || PARTS.iter().any(|part| name.contains(part))
}

fn is_allocation(name: &str) -> bool {
    ["__rust_alloc", "__rust_no_alloc", "__rust_dealloc", "__rust_realloc", "5alloc"]
        .iter()
        .any(|part| name.contains(part))
}

impl Lowering<'_> {
    /// Translates the call `id`, which yields no pointer.
    pub(super) fn call(&mut self, id: Id, name: &Arc<str>, arguments: &[Value]) -> Result<Translation> {
        if let Some(shim) = name.strip_prefix("__k_") {
            return self.shim(shim, arguments);
        }
        if let ("bcmp", [a, b, length]) = (&**name, arguments) {
            return self.difference(a, b, length).map(Translation::Value);
        }
        let Some(base) = base_name(name) else {
            return Ok(Translation::Nothing); // refused already
        };
        match base.as_str() {
            base if HINTS.contains(&base) || base.starts_with("dbg.") => Ok(Translation::Nothing),
            "trap" | "ubsantrap" => Ok(Translation::Nothing), // refused already
            "memcpy" | "memmove" | "memcpy.inline" => {
                let [to, from, length, ..] = arguments else { return Err(unknown(name)) };
                self.copy(to, from, length)?;
                Ok(Translation::Nothing)
            }
            "memset" | "memset.inline" => {
                let [to, byte, length, ..] = arguments else { return Err(unknown(name)) };
                self.fill(to, byte, length)?;
                Ok(Translation::Nothing)
            }
            base => self.intrinsic(id, name, base, arguments).map(Translation::Value),
        }
    }

    fn intrinsic(&mut self, id: Id, name: &str, base: &str, arguments: &[Value]) -> Result<Value> {
        let arguments: Vec<Value> = arguments.iter().map(|a| self.build.resolve(a)).collect();
        let ty = &self.source[id].ty;
        // A float that becomes an index becomes a word.
        if *ty == Type::I64 && base == "fptoui.sat" && self.bounds.is_index(id) {
            let word = intrinsics::expand(&mut self.build, base, &arguments, &Type::I32);
            let word = word.ok_or_else(|| unknown(name))?;
            return Ok(self.build.cast(CastOp::ZExt, &word, Type::I64));
        }
        intrinsics::expand(&mut self.build, base, &arguments, ty).ok_or_else(|| unknown(name))
    }

    /// What `kernel-api` declares.
    fn shim(&mut self, name: &str, arguments: &[Value]) -> Result<Translation> {
        let arguments: Vec<Value> = arguments.iter().map(|a| self.build.resolve(a)).collect();
        let (op, ty) = match (name, &arguments[..]) {
            ("threads" | "weight", _) => return Ok(Translation::Nothing),
            ("barrier", _) => {
                self.build.effect(Op::Barrier);
                return Ok(Translation::Nothing);
            }
            ("words", _) => {
                let [set, binding] = constants("__k_words", &arguments)?;
                (Op::WordCount(self.storage(set, binding)?), Type::I32)
            }
            ("builtin", _) => {
                let [kind, component] = constants("__k_builtin", &arguments)?;
                let builtin = builtin(kind).ok_or_else(|| Reason::Unknown(format!("the builtin {kind}")))?;
                (Op::Builtin(builtin, component), Type::I32)
            }
            ("spec", _) => {
                let [id, default] = constants("__k_spec", &arguments)?;
                (Op::SpecConstant { id, default }, Type::I32)
            }
            ("umulhi", [a, b]) => (Op::MulHigh(a.clone(), b.clone()), Type::I32),
            ("subgroup_size", _) => (Op::Builtin(Builtin::SubgroupSize, 0), Type::I32),
            ("subgroup_lane", _) => (Op::Builtin(Builtin::SubgroupLane, 0), Type::I32),
            _ => {
                let (op, ty) = subgroup(name).ok_or_else(|| unknown(&format!("__k_{name}")))?;
                (Op::Subgroup(op, arguments), ty)
            }
        };
        Ok(Translation::Value(self.build.emit(op, ty)))
    }
}

pub(super) fn unknown(name: &str) -> Reason {
    Reason::Unknown(format!("the function `{name}`"))
}

fn builtin(kind: u32) -> Option<Builtin> {
    use Builtin::*;
    [GlobalInvocationId, LocalInvocationId, WorkgroupId, NumWorkgroups, LocalInvocationIndex]
        .get(kind as usize)
        .copied()
}

fn subgroup(name: &str) -> Option<(SubgroupOp, Type)> {
    Some(match name {
        "subgroup_add" => (SubgroupOp::Add, Type::I32),
        "subgroup_umin" => (SubgroupOp::UMin, Type::I32),
        "subgroup_umax" => (SubgroupOp::UMax, Type::I32),
        "subgroup_any" => (SubgroupOp::Any, Type::BOOL),
        "subgroup_all" => (SubgroupOp::All, Type::BOOL),
        "subgroup_readlane" => (SubgroupOp::Read, Type::I32),
        "subgroup_count" => (SubgroupOp::Count, Type::I32),
        _ => return None,
    })
}
