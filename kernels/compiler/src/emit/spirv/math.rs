//! Functions that devices have.

use super::{EmitError, Emitter};
use crate::ir::{MathOp, Value};
use rspirv::dr::Operand;
use rspirv::spirv::{Decoration, GlslStd450Op as GLOp, Op, Word};

/// How a function is written.
enum Form {
    /// An instruction of `GLSL.std.450`.
    Extended(GLOp),
    /// An instruction of one operand.
    Core(Op),
    /// 31 − the number of the highest one bit, which is −1 if there is none.
    LeadingZeros,
    /// The number of the lowest one bit, but 32 for the −1 that stands for none.
    TrailingZeros,
}

fn form(function: MathOp) -> Form {
    use Form::Extended;
    match function {
        MathOp::Sqrt => Extended(GLOp::Sqrt),
        MathOp::Abs => Extended(GLOp::FAbs),
        MathOp::Floor => Extended(GLOp::Floor),
        MathOp::Ceil => Extended(GLOp::Ceil),
        MathOp::Trunc => Extended(GLOp::Trunc),
        MathOp::RoundEven => Extended(GLOp::RoundEven),
        MathOp::Fma => Extended(GLOp::Fma),
        MathOp::Sin => Extended(GLOp::Sin),
        MathOp::Cos => Extended(GLOp::Cos),
        MathOp::Tan => Extended(GLOp::Tan),
        MathOp::Exp => Extended(GLOp::Exp),
        MathOp::Exp2 => Extended(GLOp::Exp2),
        MathOp::Log => Extended(GLOp::Log),
        MathOp::Log2 => Extended(GLOp::Log2),
        MathOp::Pow => Extended(GLOp::Pow),
        MathOp::Asin => Extended(GLOp::Asin),
        MathOp::Acos => Extended(GLOp::Acos),
        MathOp::Atan => Extended(GLOp::Atan),
        MathOp::Atan2 => Extended(GLOp::Atan2),
        MathOp::Sinh => Extended(GLOp::Sinh),
        MathOp::Cosh => Extended(GLOp::Cosh),
        MathOp::Tanh => Extended(GLOp::Tanh),
        MathOp::UMin => Extended(GLOp::UMin),
        MathOp::UMax => Extended(GLOp::UMax),
        MathOp::SMin => Extended(GLOp::SMin),
        MathOp::SMax => Extended(GLOp::SMax),
        MathOp::CountOnes => Form::Core(Op::BitCount),
        MathOp::ReverseBits => Form::Core(Op::BitReverse),
        MathOp::LeadingZeros => Form::LeadingZeros,
        MathOp::TrailingZeros => Form::TrailingZeros,
    }
}

impl Emitter<'_> {
    pub fn math(&mut self, function: MathOp, arguments: &[Value]) -> Result<Word, EmitError> {
        let arguments = self.values(arguments)?;
        let ty = if function.is_integer() { self.constants.u32 } else { self.constants.f32 };
        match form(function) {
            Form::Extended(op) => {
                let result = self.extended(op, ty, &arguments)?;
                if !function.is_integer() && !self.options.contract {
                    self.builder.decorate(result, Decoration::NoContraction, []);
                }
                Ok(result)
            }
            Form::Core(op) => self.make_of(op, ty, &arguments),
            Form::LeadingZeros => {
                let highest = self.extended(GLOp::FindUMsb, ty, &arguments)?;
                let last = self.word(31);
                self.make_of(Op::ISub, ty, &[last, highest])
            }
            Form::TrailingZeros => {
                let lowest = self.extended(GLOp::FindILsb, ty, &arguments)?;
                let bits = self.word(32);
                self.extended(GLOp::UMin, ty, &[lowest, bits])
            }
        }
    }

    fn extended(&mut self, op: GLOp, ty: Word, arguments: &[Word]) -> Result<Word, EmitError> {
        let head = [Operand::IdRef(self.glsl), Operand::LiteralExtInstInteger(op as u32)];
        let arguments = arguments.iter().map(|&argument| Operand::IdRef(argument));
        self.make(Op::ExtInst, ty, head.into_iter().chain(arguments).collect())
    }

    /// The high word of a product.
    pub fn mul_high(&mut self, a: &Value, b: &Value) -> Result<Word, EmitError> {
        let operands = [self.value(a)?, self.value(b)?];
        let word = self.constants.u32;
        let pair = self.builder.type_struct([word, word]);
        let product = self.make_of(Op::UMulExtended, pair, &operands)?;
        self.make(Op::CompositeExtract, word, vec![Operand::IdRef(product), Operand::LiteralBit32(1)])
    }
}
