//! Functions, builtins, specialisation constants and subgroups.

use super::declarations::builtin_name;
use super::{EmitError, Writer};
use crate::ir::{Builtin, MathOp, SubgroupOp, Value};

impl Writer<'_> {
    pub fn builtin(&mut self, builtin: Builtin, component: u32) -> String {
        self.builtins.insert(builtin);
        let name = builtin_name(builtin);
        if builtin.is_vector() { format!("{name}[{component}u]") } else { name.to_owned() }
    }

    pub fn spec_constant(&mut self, id: u32, default: u32) -> String {
        self.specialisation.insert(id, default);
        format!("spec{id}")
    }

    pub fn subgroup(&mut self, op: SubgroupOp, arguments: &[Value]) -> Result<String, EmitError> {
        let arguments = self.values(arguments)?.join(", ");
        Ok(match op {
            SubgroupOp::Add => format!("subgroupAdd({arguments})"),
            SubgroupOp::UMin => format!("subgroupMin({arguments})"),
            SubgroupOp::UMax => format!("subgroupMax({arguments})"),
            SubgroupOp::Any => format!("subgroupAny({arguments})"),
            SubgroupOp::All => format!("subgroupAll({arguments})"),
            SubgroupOp::Read => format!("subgroupShuffle({arguments})"),
            SubgroupOp::Count => {
                format!("dot(countOneBits(subgroupBallot({arguments})), vec4<u32>(1u))")
            }
        })
    }

    pub fn math(&mut self, function: MathOp, arguments: &[Value]) -> Result<String, EmitError> {
        let arguments = self.values(arguments)?;
        Ok(match function {
            MathOp::SMin | MathOp::SMax => {
                let signed: Vec<_> = arguments.iter().map(|a| format!("bitcast<i32>({a})")).collect();
                format!("bitcast<u32>({}({}))", name(function), signed.join(", "))
            }
            function => format!("{}({})", name(function), arguments.join(", ")),
        })
    }
}

fn name(function: MathOp) -> &'static str {
    match function {
        MathOp::Sqrt => "sqrt",
        MathOp::Abs => "abs",
        MathOp::Floor => "floor",
        MathOp::Ceil => "ceil",
        MathOp::Trunc => "trunc",
        MathOp::RoundEven => "round",
        MathOp::Fma => "fma",
        MathOp::Sin => "sin",
        MathOp::Cos => "cos",
        MathOp::Tan => "tan",
        MathOp::Exp => "exp",
        MathOp::Exp2 => "exp2",
        MathOp::Log => "log",
        MathOp::Log2 => "log2",
        MathOp::Pow => "pow",
        MathOp::Asin => "asin",
        MathOp::Acos => "acos",
        MathOp::Atan => "atan",
        MathOp::Atan2 => "atan2",
        MathOp::Sinh => "sinh",
        MathOp::Cosh => "cosh",
        MathOp::Tanh => "tanh",
        MathOp::UMin | MathOp::SMin => "min",
        MathOp::UMax | MathOp::SMax => "max",
        MathOp::CountOnes => "countOneBits",
        MathOp::LeadingZeros => "countLeadingZeros",
        MathOp::TrailingZeros => "countTrailingZeros",
        MathOp::ReverseBits => "reverseBits",
    }
}
