//! What stands before and around the body.

use super::{EmitError, Writer, type_name};
use crate::ir::{Builtin, Id, Root, RootId, Space};
use crate::structure::{Statement, for_each_statement};
use std::fmt::Write;

/// The high word of a product, from products of half words.
const MUL_HIGH: &str = "\
fn mul_high(a: u32, b: u32) -> u32 {
  let low = (a & 65535u) * (b & 65535u);
  let middle = (a >> 16u) * (b & 65535u) + (low >> 16u);
  let other = (a & 65535u) * (b >> 16u) + (middle & 65535u);
  return (a >> 16u) * (b >> 16u) + (middle >> 16u) + (other >> 16u);
}
";

impl Writer<'_> {
    /// The whole text.
    pub fn text(&self, body: &[Statement]) -> Result<String, EmitError> {
        let mut text = String::new();
        for (number, root) in self.kernel.roots.iter().enumerate() {
            let signed = self.signed.contains(&RootId::new(number));
            text.push_str(&module_scope(number, root, signed));
        }
        for (id, default) in &self.specialisation {
            line(&mut text, format_args!("@id({id}) override spec{id}: u32 = {default}u;"));
        }
        for bits in &self.odd_floats {
            line(&mut text, format_args!("var<private> bits_{bits:08x}: u32 = {bits}u;"));
        }
        if self.mul_high {
            text.push_str(MUL_HIGH);
        }
        let [x, y, z] = self.kernel.threads;
        line(&mut text, format_args!("@compute @workgroup_size({x}, {y}, {z})"));
        line(&mut text, format_args!("fn {}({}) {{", self.kernel.name, self.parameters()));
        text.push_str(&self.variables(body)?);
        text.push_str(&self.body);
        text.push_str("}\n");
        Ok(text)
    }

    fn parameters(&self) -> String {
        let parameter = |builtin: &Builtin| {
            let ty = if builtin.is_vector() { "vec3<u32>" } else { "u32" };
            let name = builtin_name(*builtin);
            format!("@builtin({name}) {name}: {ty}")
        };
        self.builtins.iter().map(parameter).collect::<Vec<_>>().join(", ")
    }

    /// The arrays of the invocation's own, and the variables of phis.
    fn variables(&self, body: &[Statement]) -> Result<String, EmitError> {
        let mut text = String::new();
        for (number, root) in self.kernel.roots.iter().enumerate() {
            if root.space == Space::Local {
                line(&mut text, format_args!("  var r{number}: array<u32, {}>;", root.words.max(1)));
            }
        }
        for phi in phis(body) {
            let ty = type_name(&self.kernel.function[phi].ty)?;
            line(&mut text, format_args!("  var p{}: {ty};", phi.0));
        }
        Ok(text)
    }
}

fn line(text: &mut String, what: std::fmt::Arguments) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{what}");
}

/// The declaration of a root at module scope; nothing for an array of the invocation's own.
fn module_scope(number: usize, root: &Root, signed: bool) -> String {
    let element = match root {
        Root { vec4: true, .. } => "vec4<u32>",
        Root { atomic: true, .. } if signed => "atomic<i32>",
        Root { atomic: true, .. } => "atomic<u32>",
        _ => "u32",
    };
    match &root.space {
        Space::Storage { set, binding } => {
            let access = if root.written || root.atomic { "read_write" } else { "read" };
            format!("@group({set}) @binding({binding}) var<storage, {access}> r{number}: array<{element}>;\n")
        }
        Space::Uniform { set, binding } => {
            let length = root.words.div_ceil(4);
            format!("@group({set}) @binding({binding}) var<uniform> r{number}: array<vec4<u32>, {length}>;\n")
        }
        Space::Push => {
            let fields: Vec<_> = (0..root.words).map(|word| format!("w{word}: u32")).collect();
            let fields = fields.join(", ");
            format!("struct Push {{ {fields} }}\nvar<immediate> r{number}: Push;\n")
        }
        Space::Workgroup(_) => format!("var<workgroup> r{number}: array<{element}, {}>;\n", root.words),
        Space::Constant(words) => {
            let (length, words) = (words.len(), words.iter().map(|w| format!("{w}u")).collect::<Vec<_>>());
            let words = words.join(", ");
            format!("var<private> r{number}: array<u32, {length}> = array<u32, {length}>({words});\n")
        }
        Space::Local => String::new(),
    }
}

/// The name of a builtin, which its parameter has too.
pub fn builtin_name(builtin: Builtin) -> &'static str {
    match builtin {
        Builtin::GlobalInvocationId => "global_invocation_id",
        Builtin::LocalInvocationId => "local_invocation_id",
        Builtin::WorkgroupId => "workgroup_id",
        Builtin::NumWorkgroups => "num_workgroups",
        Builtin::LocalInvocationIndex => "local_invocation_index",
        Builtin::SubgroupSize => "subgroup_size",
        Builtin::SubgroupLane => "subgroup_invocation_id",
    }
}

fn phis(body: &[Statement]) -> Vec<Id> {
    let mut phis = Vec::new();
    for_each_statement(body, &mut |statement| {
        if let Statement::Phi(id) = statement {
            phis.push(*id);
        }
    });
    phis
}
