//! Instructions, and those of them that are arithmetic, comparison and conversion.

use super::{EmitError, Emitter};
use crate::ir::{BinaryOp, CastOp, FloatPredicate, Id, IntPredicate, Op as Ir, Type, Value};
use rspirv::spirv::{Decoration, Op, Word};

impl Emitter<'_> {
    /// Writes one instruction and notes its value.
    pub fn instruction(&mut self, id: Id) -> Result<(), EmitError> {
        let kernel = self.kernel;
        let instruction = &kernel.function[id];
        let made = match &instruction.op {
            Ir::StoreWord(root, index, word) => return self.store_word(*root, index, word),
            Ir::StoreVec4(root, element, words) => return self.store_vec4(*root, element, words),
            Ir::StoreComponent(root, element, component, word) => {
                return self.store_component(*root, element, component, word);
            }
            Ir::AtomicStoreWord(root, index, word) => return self.atomic_store(*root, index, word),
            Ir::Barrier => return self.barrier(),
            op => self.made(op, &instruction.ty)?,
        };
        self.values.insert(id, made);
        Ok(())
    }

    /// Writes an instruction that makes a value.
    fn made(&mut self, op: &Ir, ty: &Type) -> Result<Word, EmitError> {
        match op {
            Ir::Binary(op, a, b) => self.binary(*op, ty, a, b),
            Ir::IntCompare(predicate, a, b) => self.compare_integers(*predicate, a, b),
            Ir::FloatCompare(predicate, a, b) => self.compare_floats(*predicate, a, b),
            Ir::Select(condition, a, b) => {
                let operands = [self.value(condition)?, self.value(a)?, self.value(b)?];
                let ty = self.type_id(ty)?;
                self.make_of(Op::Select, ty, &operands)
            }
            Ir::Cast(cast, value) => self.cast(*cast, value, ty),
            Ir::FloatNegate(value) => {
                let value = self.value(value)?;
                self.float(Op::FNegate, &[value])
            }
            Ir::Copy(value) => self.value(value),
            Ir::LoadWord(root, index) => self.load_word(*root, index),
            Ir::LoadVec4(root, element) => self.load_vec4(*root, element),
            Ir::Component(vector, component) => self.component(vector, component),
            Ir::AtomicWord(op, root, index, operand) => self.atomic(*op, *root, index, operand),
            Ir::CompareExchangeWord(root, index, expected, new) => {
                self.compare_exchange(*root, index, expected, new)
            }
            Ir::AtomicLoadWord(root, index) => self.atomic_load(*root, index),
            Ir::WordCount(root) => self.word_count(*root),
            Ir::Math(function, arguments) => self.math(*function, arguments),
            Ir::MulHigh(a, b) => self.mul_high(a, b),
            Ir::Builtin(builtin, component) => self.builtin(*builtin, *component),
            Ir::SpecConstant { id, default } => self.spec_constant(*id, *default),
            Ir::Subgroup(op, arguments) => self.subgroup(*op, arguments),
            other => Err(EmitError::unsupported(other, "SPIR-V")),
        }
    }

    /// A float operation, with the decoration that keeps it from being contracted.
    pub fn float(&mut self, op: Op, operands: &[Word]) -> Result<Word, EmitError> {
        let result = self.make_of(op, self.constants.f32, operands)?;
        if !self.options.contract {
            self.builder.decorate(result, Decoration::NoContraction, []);
        }
        Ok(result)
    }

    fn binary(&mut self, op: BinaryOp, ty: &Type, a: &Value, b: &Value) -> Result<Word, EmitError> {
        let operands = [self.value(a)?, self.value(b)?];
        let type_id = self.type_id(ty)?;
        match op {
            BinaryOp::SRem => self.signed_remainder(type_id, operands),
            op if is_float(op) => self.float(binary_opcode(op, false), &operands),
            op => self.make_of(binary_opcode(op, *ty == Type::BOOL), type_id, &operands),
        }
    }

    /// `a − a / b · b`: Vulkan leaves OpSRem of negative numbers undefined, but not OpSDiv.
    fn signed_remainder(&mut self, ty: Word, [a, b]: [Word; 2]) -> Result<Word, EmitError> {
        let quotient = self.make_of(Op::SDiv, ty, &[a, b])?;
        let product = self.make_of(Op::IMul, ty, &[quotient, b])?;
        self.make_of(Op::ISub, ty, &[a, product])
    }

    fn compare_integers(&mut self, predicate: IntPredicate, a: &Value, b: &Value) -> Result<Word, EmitError> {
        let truth_values = self.kernel.function.type_of(a) == Type::BOOL;
        let opcode = match predicate {
            IntPredicate::Eq if truth_values => Op::LogicalEqual,
            IntPredicate::Ne if truth_values => Op::LogicalNotEqual,
            IntPredicate::Eq => Op::IEqual,
            IntPredicate::Ne => Op::INotEqual,
            other if truth_values => {
                return Err(EmitError::unsupported((other, "of truth values"), "SPIR-V"));
            }
            IntPredicate::Ugt => Op::UGreaterThan,
            IntPredicate::Uge => Op::UGreaterThanEqual,
            IntPredicate::Ult => Op::ULessThan,
            IntPredicate::Ule => Op::ULessThanEqual,
            IntPredicate::Sgt => Op::SGreaterThan,
            IntPredicate::Sge => Op::SGreaterThanEqual,
            IntPredicate::Slt => Op::SLessThan,
            IntPredicate::Sle => Op::SLessThanEqual,
        };
        let operands = [self.value(a)?, self.value(b)?];
        self.make_of(opcode, self.constants.bool, &operands)
    }

    fn compare_floats(&mut self, predicate: FloatPredicate, a: &Value, b: &Value) -> Result<Word, EmitError> {
        let opcode = match predicate {
            FloatPredicate::Oeq => Op::FOrdEqual,
            FloatPredicate::Ogt => Op::FOrdGreaterThan,
            FloatPredicate::Oge => Op::FOrdGreaterThanEqual,
            FloatPredicate::Olt => Op::FOrdLessThan,
            FloatPredicate::Ole => Op::FOrdLessThanEqual,
            FloatPredicate::One => Op::FOrdNotEqual,
            FloatPredicate::Ueq => Op::FUnordEqual,
            FloatPredicate::Ugt => Op::FUnordGreaterThan,
            FloatPredicate::Uge => Op::FUnordGreaterThanEqual,
            FloatPredicate::Ult => Op::FUnordLessThan,
            FloatPredicate::Ule => Op::FUnordLessThanEqual,
            FloatPredicate::Une => Op::FUnordNotEqual,
            FloatPredicate::Uno => return self.either_is_nan(a, b),
            FloatPredicate::Ord => {
                let unordered = self.either_is_nan(a, b)?;
                return self.make_of(Op::LogicalNot, self.constants.bool, &[unordered]);
            }
            FloatPredicate::False => return self.constant(&Value::bool(false)),
            FloatPredicate::True => return self.constant(&Value::bool(true)),
        };
        let operands = [self.value(a)?, self.value(b)?];
        self.make_of(opcode, self.constants.bool, &operands)
    }

    fn either_is_nan(&mut self, a: &Value, b: &Value) -> Result<Word, EmitError> {
        let first = self.is_nan(a)?;
        if a == b {
            return Ok(first);
        }
        let second = self.is_nan(b)?;
        self.make_of(Op::LogicalOr, self.constants.bool, &[first, second])
    }

    /// On the bits: a driver may assume that a float is no NaN.
    fn is_nan(&mut self, value: &Value) -> Result<Word, EmitError> {
        let value = self.value(value)?;
        let ty = self.constants.u32;
        let (magnitude, infinity) = (self.word(0x7fff_ffff), self.word(f32::INFINITY.to_bits()));
        let bits = self.make_of(Op::Bitcast, ty, &[value])?;
        let bits = self.make_of(Op::BitwiseAnd, ty, &[bits, magnitude])?;
        self.make_of(Op::UGreaterThan, self.constants.bool, &[bits, infinity])
    }

    fn cast(&mut self, cast: CastOp, value: &Value, to: &Type) -> Result<Word, EmitError> {
        let from = self.kernel.function.type_of(value);
        let (value, type_id) = (self.value(value)?, self.type_id(to)?);
        match cast {
            CastOp::Bitcast if from == *to => Ok(value),
            _ if from == Type::BOOL => self.cast_truth(cast, value, to),
            CastOp::Bitcast => self.make_of(Op::Bitcast, type_id, &[value]),
            CastOp::Trunc | CastOp::ZExt => self.make_of(Op::UConvert, type_id, &[value]),
            CastOp::SExt => self.sign_extend(value, type_id),
            CastOp::FpToUi => self.make_of(Op::ConvertFToU, type_id, &[value]),
            CastOp::FpToSi => {
                let signed = self.signed(to)?;
                let signed = self.make_of(Op::ConvertFToS, signed, &[value])?;
                self.make_of(Op::Bitcast, type_id, &[signed])
            }
            CastOp::UiToFp => self.make_of(Op::ConvertUToF, type_id, &[value]),
            CastOp::SiToFp => {
                let signed = self.signed(&from)?;
                let signed = self.make_of(Op::Bitcast, signed, &[value])?;
                self.make_of(Op::ConvertSToF, type_id, &[signed])
            }
            other => Err(EmitError::unsupported(other, "SPIR-V")),
        }
    }

    fn sign_extend(&mut self, value: Word, to: Word) -> Result<Word, EmitError> {
        let signed = self.make_of(Op::Bitcast, self.constants.i32, &[value])?;
        let long = self.long_type(1);
        let extended = self.make_of(Op::SConvert, long, &[signed])?;
        self.make_of(Op::Bitcast, to, &[extended])
    }

    /// The signed type of the width of `ty`.
    fn signed(&mut self, ty: &Type) -> Result<Word, EmitError> {
        match ty {
            Type::Int(32) => Ok(self.constants.i32),
            Type::Int(64) => Ok(self.long_type(1)),
            other => Err(EmitError::unsupported(other, "SPIR-V")),
        }
    }

    /// A truth value becomes one of two constants.
    fn cast_truth(&mut self, cast: CastOp, value: Word, to: &Type) -> Result<Word, EmitError> {
        let (yes, no) = match cast {
            CastOp::ZExt => (Value::int(to.bits(), 1), Value::int(to.bits(), 0)),
            CastOp::SExt => (Value::int(to.bits(), u128::MAX), Value::int(to.bits(), 0)),
            CastOp::UiToFp => (Value::f32(1.0), Value::f32(0.0)),
            CastOp::SiToFp => (Value::f32(-1.0), Value::f32(0.0)),
            other => return Err(EmitError::unsupported((other, "of a truth value"), "SPIR-V")),
        };
        let operands = [value, self.constant(&yes)?, self.constant(&no)?];
        let to = self.type_id(to)?;
        self.make_of(Op::Select, to, &operands)
    }
}

fn is_float(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::FAdd | BinaryOp::FSub | BinaryOp::FMul | BinaryOp::FDiv | BinaryOp::FRem)
}

fn binary_opcode(op: BinaryOp, truth_values: bool) -> Op {
    match op {
        BinaryOp::And if truth_values => Op::LogicalAnd,
        BinaryOp::Or if truth_values => Op::LogicalOr,
        BinaryOp::Xor | BinaryOp::Add | BinaryOp::Sub if truth_values => Op::LogicalNotEqual,
        BinaryOp::Mul if truth_values => Op::LogicalAnd,
        BinaryOp::Add => Op::IAdd,
        BinaryOp::Sub => Op::ISub,
        BinaryOp::Mul => Op::IMul,
        BinaryOp::UDiv => Op::UDiv,
        BinaryOp::SDiv => Op::SDiv,
        BinaryOp::URem => Op::UMod,
        BinaryOp::SRem => Op::SRem,
        BinaryOp::Shl => Op::ShiftLeftLogical,
        BinaryOp::LShr => Op::ShiftRightLogical,
        BinaryOp::AShr => Op::ShiftRightArithmetic,
        BinaryOp::And => Op::BitwiseAnd,
        BinaryOp::Or => Op::BitwiseOr,
        BinaryOp::Xor => Op::BitwiseXor,
        BinaryOp::FAdd => Op::FAdd,
        BinaryOp::FSub => Op::FSub,
        BinaryOp::FMul => Op::FMul,
        BinaryOp::FDiv => Op::FDiv,
        BinaryOp::FRem => Op::FRem,
    }
}
