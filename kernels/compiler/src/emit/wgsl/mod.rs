//! WGSL from the same structured form, for the fast profile: it goes through wgpu's ordinary path to Metal,
//! DX12 and WebGPU, where naga ignores `NoContraction`.
//!
//! Words are `u32` and are taken as `i32` where an operation is signed. Values are `let`s named after their
//! instruction (`v7`), the variables of phis are `p7`, roots are `r0`, `r1`, … The loop-closed form
//! guarantees that each use is in scope.

mod declarations;
mod device;
mod expressions;
mod memory;
mod names;
mod statements;

use super::EmitError;
use crate::ir::{Builtin, Kernel, RootId, Type, Value};
use crate::structure::Structured;
use std::collections::{BTreeMap, BTreeSet};

/// The text of one kernel, whose entry point has the kernel's name.
///
/// # Errors
/// [`EmitError::Unsupported`] when something has no form in WGSL (64-bit integers, signed and unsigned atomic
/// minima or maxima of one buffer, push constants that are indexed with a variable), or when the kernel's
/// name means something else in WGSL.
pub fn emit(structured: &Structured) -> Result<String, EmitError> {
    let mut writer = Writer::new(&structured.kernel);
    writer.statements(&structured.body)?;
    let name = &structured.kernel.name;
    match names::objection(name, &writer.body) {
        Some(objection) => {
            Err(EmitError::Unsupported(format!("the name `{name}`, which {objection}, in WGSL")))
        }
        None => writer.text(&structured.body),
    }
}

/// A text in the making: the body so far, and what it needs to be declared.
struct Writer<'a> {
    kernel: &'a Kernel,
    body: String,
    depth: usize,
    builtins: BTreeSet<Builtin>,
    /// Specialisation constants with their defaults.
    specialisation: BTreeMap<u32, u32>,
    /// Floats that have no literal (infinities, NaNs, −0, denormals), by their bits.
    odd_floats: BTreeSet<u32>,
    /// Atomic roots whose words are `i32`, for their minima and maxima.
    signed: BTreeSet<RootId>,
    /// How many loops there are so far.
    loops: usize,
    mul_high: bool,
}

impl<'a> Writer<'a> {
    fn new(kernel: &'a Kernel) -> Self {
        Self {
            kernel,
            body: String::new(),
            depth: 1,
            builtins: BTreeSet::new(),
            specialisation: BTreeMap::new(),
            odd_floats: BTreeSet::new(),
            signed: memory::signed_roots(kernel),
            loops: 0,
            mul_high: false,
        }
    }

    /// Appends a line to the body.
    fn line(&mut self, text: &str) {
        self.body.extend(std::iter::repeat_n("  ", self.depth));
        self.body.push_str(text);
        self.body.push('\n');
    }

    /// An operand.
    fn value(&mut self, value: &Value) -> Result<String, EmitError> {
        match value {
            Value::Inst(id) => Ok(format!("v{}", id.0)),
            Value::Int(1, bits) => Ok((*bits != 0).to_string()),
            Value::Int(32, bits) => Ok(format!("{bits}u")),
            Value::F32(bits) => Ok(self.float(*bits)),
            Value::Zero(Type::F32) | Value::Undef(Type::F32) => Ok("0f".into()),
            Value::Zero(Type::Int(bits)) | Value::Undef(Type::Int(bits)) => self.value(&Value::Int(*bits, 0)),
            other => Err(EmitError::unsupported(other, "WGSL")),
        }
    }

    fn values(&mut self, values: &[Value]) -> Result<Vec<String>, EmitError> {
        values.iter().map(|value| self.value(value)).collect()
    }

    /// A float constant. One without a literal is cast from a variable, since a constant expression must not
    /// be a NaN or infinite.
    fn float(&mut self, bits: u32) -> String {
        let value = f32::from_bits(bits);
        if bits == 0 || value.is_normal() {
            return format!("{value:?}f");
        }
        self.odd_floats.insert(bits);
        format!("bitcast<f32>(bits_{bits:08x})")
    }
}

/// The name of a type of values.
fn type_name(ty: &Type) -> Result<&'static str, EmitError> {
    match ty {
        Type::Int(1) => Ok("bool"),
        Type::Int(32) => Ok("u32"),
        Type::F32 => Ok("f32"),
        Type::Vector(4, element) if **element == Type::I32 => Ok("vec4<u32>"),
        other => Err(EmitError::unsupported(other, "WGSL")),
    }
}

#[cfg(test)]
mod tests;
