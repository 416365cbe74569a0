//! What an invocation knows of itself and does with the others: builtins, specialisation constants, barriers,
//! subgroups.

use super::{EmitError, Emitter};
use crate::ir::{Builtin, Op as Ir, SubgroupOp, Value};
use rspirv::dr::Operand;
use rspirv::spirv::{
    BuiltIn, Capability, Decoration, GroupOperation, MemorySemantics, Op, Scope, StorageClass, Word,
};

/// The builtin that an operation reads.
pub fn builtin_of(op: &Ir) -> Option<Builtin> {
    match op {
        Ir::Builtin(builtin, _) => Some(*builtin),
        _ => None,
    }
}

fn spirv_builtin(builtin: Builtin) -> BuiltIn {
    match builtin {
        Builtin::GlobalInvocationId => BuiltIn::GlobalInvocationId,
        Builtin::LocalInvocationId => BuiltIn::LocalInvocationId,
        Builtin::WorkgroupId => BuiltIn::WorkgroupId,
        Builtin::NumWorkgroups => BuiltIn::NumWorkgroups,
        Builtin::LocalInvocationIndex => BuiltIn::LocalInvocationIndex,
        Builtin::SubgroupSize => BuiltIn::SubgroupSize,
        Builtin::SubgroupLane => BuiltIn::SubgroupLocalInvocationId,
    }
}

impl Emitter<'_> {
    fn builtin_type(&mut self, builtin: Builtin) -> Word {
        match builtin.is_vector() {
            true => self.builder.type_vector(self.constants.u32, 3),
            false => self.constants.u32,
        }
    }

    /// Declares the input variable of a builtin, once.
    pub fn declare_builtin(&mut self, builtin: Builtin) {
        if self.builtins.contains_key(&builtin) {
            return;
        }
        if matches!(builtin, Builtin::SubgroupSize | Builtin::SubgroupLane) {
            self.capabilities.insert(Capability::GroupNonUniform);
        }
        let ty = self.builtin_type(builtin);
        let pointer = self.builder.type_pointer(None, StorageClass::Input, ty);
        let variable = self.builder.variable(pointer, None, StorageClass::Input, None);
        let kind = Operand::BuiltIn(spirv_builtin(builtin));
        self.builder.decorate(variable, Decoration::BuiltIn, [kind]);
        self.builtins.insert(builtin, variable);
    }

    /// A component of a builtin.
    pub fn builtin(&mut self, builtin: Builtin, component: u32) -> Result<Word, EmitError> {
        let ty = self.builtin_type(builtin);
        let variable = self.builtins.get(&builtin).copied();
        let variable = variable.ok_or_else(|| EmitError::unsupported(builtin, "SPIR-V"))?;
        let value = self.make_of(Op::Load, ty, &[variable])?;
        if !builtin.is_vector() {
            return Ok(value);
        }
        let operands = vec![Operand::IdRef(value), Operand::LiteralBit32(component)];
        self.make(Op::CompositeExtract, self.constants.u32, operands)
    }

    /// The bits of a specialisation constant.
    pub fn spec_constant(&mut self, id: u32, default: u32) -> Result<Word, EmitError> {
        if let Some(&(known, constant)) = self.specialisation.get(&id) {
            return match known == default {
                true => Ok(constant),
                false => {
                    let what =
                        format!("specialisation constant {id} with the two defaults {known} and {default}");
                    Err(EmitError::Unsupported(what))
                }
            };
        }
        let constant = self.builder.spec_constant_bit32(self.constants.u32, default);
        self.builder.decorate(constant, Decoration::SpecId, [Operand::LiteralBit32(id)]);
        self.specialisation.insert(id, (default, constant));
        Ok(constant)
    }

    /// Waits for the workgroup and makes workgroup memory visible to it.
    pub fn barrier(&mut self) -> Result<(), EmitError> {
        let semantics = MemorySemantics::ACQUIRE_RELEASE | MemorySemantics::WORKGROUP_MEMORY;
        let (workgroup, semantics) = (self.word(Scope::Workgroup as u32), self.word(semantics.bits()));
        let scopes = [Operand::IdScope(workgroup), Operand::IdScope(workgroup)];
        let operands = scopes.into_iter().chain([Operand::IdMemorySemantics(semantics)]).collect();
        self.perform(Op::ControlBarrier, operands)
    }

    /// An operation over the subgroup.
    pub fn subgroup(&mut self, op: SubgroupOp, arguments: &[Value]) -> Result<Word, EmitError> {
        let arguments = self.values(arguments)?;
        let (word, boolean) = (self.constants.u32, self.constants.bool);
        match op {
            SubgroupOp::Add => self.reduce(Op::GroupNonUniformIAdd, arguments[0]),
            SubgroupOp::UMin => self.reduce(Op::GroupNonUniformUMin, arguments[0]),
            SubgroupOp::UMax => self.reduce(Op::GroupNonUniformUMax, arguments[0]),
            SubgroupOp::Any => self.over_subgroup(
                Op::GroupNonUniformAny,
                Capability::GroupNonUniformVote,
                boolean,
                &arguments,
            ),
            SubgroupOp::All => self.over_subgroup(
                Op::GroupNonUniformAll,
                Capability::GroupNonUniformVote,
                boolean,
                &arguments,
            ),
            SubgroupOp::Read => {
                let shuffle = Capability::GroupNonUniformShuffle;
                self.over_subgroup(Op::GroupNonUniformShuffle, shuffle, word, &arguments)
            }
            SubgroupOp::Count => self.count(&arguments),
        }
    }

    fn over_subgroup(
        &mut self,
        op: Op,
        capability: Capability,
        ty: Word,
        arguments: &[Word],
    ) -> Result<Word, EmitError> {
        self.capabilities.extend([Capability::GroupNonUniform, capability]);
        let scope = Operand::IdScope(self.word(Scope::Subgroup as u32));
        let arguments = arguments.iter().map(|&argument| Operand::IdRef(argument));
        self.make(op, ty, std::iter::once(scope).chain(arguments).collect())
    }

    fn reduce(&mut self, op: Op, argument: Word) -> Result<Word, EmitError> {
        self.capabilities.extend([Capability::GroupNonUniform, Capability::GroupNonUniformArithmetic]);
        let scope = Operand::IdScope(self.word(Scope::Subgroup as u32));
        let reduce = Operand::GroupOperation(GroupOperation::Reduce);
        self.make(op, self.constants.u32, vec![scope, reduce, Operand::IdRef(argument)])
    }

    /// In how many invocations a truth value holds: the number of bits of its ballot.
    fn count(&mut self, arguments: &[Word]) -> Result<Word, EmitError> {
        let ballot = Capability::GroupNonUniformBallot;
        let ballot = self.over_subgroup(Op::GroupNonUniformBallot, ballot, self.constants.vec4, arguments)?;
        let scope = Operand::IdScope(self.word(Scope::Subgroup as u32));
        let reduce = Operand::GroupOperation(GroupOperation::Reduce);
        let operands = vec![scope, reduce, Operand::IdRef(ballot)];
        self.make(Op::GroupNonUniformBallotBitCount, self.constants.u32, operands)
    }
}
