//! A kernel of every arithmetic operation, comparison, conversion and function, with the results that they
//! must have.

use super::{KernelBuilder, word};
use crate::ir::{
    BinaryOp, CastOp, FloatPredicate, IntPredicate, Kernel, MathOp, Op, RootId, Terminator, Type, Value,
};

/// A kernel of one invocation that reads the words `inputs` at binding 1 and writes the words `expected` at
/// binding 0.
pub struct Operations {
    pub kernel: Kernel,
    pub inputs: Vec<u32>,
    pub expected: Vec<u32>,
}

/// All operations.
pub fn operations() -> Operations {
    let mut cases = Cases::new();
    cases.integers();
    cases.integer_comparisons();
    cases.floats();
    cases.float_comparisons();
    cases.casts();
    cases.functions();
    cases.truth_values();
    cases.finish()
}

struct Cases {
    k: KernelBuilder,
    output: RootId,
    input: RootId,
    inputs: Vec<u32>,
    expected: Vec<u32>,
}

/// −1 as a word, and so on.
fn signed(value: i32) -> u32 {
    value as u32
}

impl Cases {
    fn new() -> Self {
        let mut k = KernelBuilder::new(1);
        let output = k.buffer(0, true);
        let input = k.buffer(1, false);
        Self { k, output, input, inputs: Vec::new(), expected: Vec::new() }
    }

    fn finish(mut self) -> Operations {
        self.k.end(0, Terminator::Return);
        Operations { kernel: self.k.build(), inputs: self.inputs, expected: self.expected }
    }

    /// A word that no compiler can know.
    fn word(&mut self, value: u32) -> Value {
        self.inputs.push(value);
        let index = word(self.inputs.len() as u32 - 1);
        self.k.push(0, Op::LoadWord(self.input, index), Type::I32)
    }

    fn float(&mut self, value: f32) -> Value {
        let word = self.word(value.to_bits());
        self.k.push(0, Op::Cast(CastOp::Bitcast, word), Type::F32)
    }

    fn truth(&mut self, value: bool) -> Value {
        let loaded = self.word(value.into());
        self.k.push(0, Op::IntCompare(IntPredicate::Ne, loaded, word(0)), Type::BOOL)
    }

    fn expect(&mut self, op: Op, ty: Type, expected: u32) {
        let made = self.k.push(0, op, ty.clone());
        let made = match ty {
            Type::F32 => self.k.push(0, Op::Cast(CastOp::Bitcast, made), Type::I32),
            Type::Int(1) => self.k.push(0, Op::Cast(CastOp::ZExt, made), Type::I32),
            _ => made,
        };
        let index = word(self.expected.len() as u32);
        self.k.push(0, Op::StoreWord(self.output, index, made), Type::Void);
        self.expected.push(expected);
    }

    fn integers(&mut self) {
        let minimum = signed(i32::MIN);
        for (op, a, b, expected) in [
            (BinaryOp::Add, u32::MAX, 2, 1),
            (BinaryOp::Sub, 1, 2, u32::MAX),
            (BinaryOp::Mul, 0x1_0001, 0x1_0001, 0x2_0001),
            (BinaryOp::UDiv, signed(-7), 2, 0x7fff_fffc),
            (BinaryOp::SDiv, signed(-7), 2, signed(-3)),
            (BinaryOp::SDiv, 7, signed(-2), signed(-3)),
            (BinaryOp::URem, signed(-7), 16, 9),
            (BinaryOp::SRem, signed(-7), 2, signed(-1)),
            (BinaryOp::SRem, 7, signed(-2), 1),
            (BinaryOp::SRem, minimum, 3, signed(-2)),
            (BinaryOp::Shl, 0x8000_0001, 4, 0x10),
            (BinaryOp::LShr, 0x8000_0000, 31, 1),
            (BinaryOp::AShr, 0x8000_0000, 31, u32::MAX),
            (BinaryOp::And, 0xf0f0, 0xff00, 0xf000),
            (BinaryOp::Or, 0xf0f0, 0xff00, 0xfff0),
            (BinaryOp::Xor, 0xf0f0, 0xff00, 0x0ff0),
        ] {
            let (a, b) = (self.word(a), self.word(b));
            self.expect(Op::Binary(op, a, b), Type::I32, expected);
        }
        let (a, b) = (self.word(0xffff_fffe), self.word(0xffff_ffff));
        self.expect(Op::MulHigh(a, b), Type::I32, 0xffff_fffd);
    }

    fn integer_comparisons(&mut self) {
        use IntPredicate::*;
        // The predicates that hold of −1 and 1, of 1 and −1, and of 1 and 1.
        let all = [Eq, Ne, Ugt, Uge, Ult, Ule, Sgt, Sge, Slt, Sle];
        let cases = [
            (signed(-1), 1, vec![Ne, Ugt, Uge, Slt, Sle]),
            (1, signed(-1), vec![Ne, Ult, Ule, Sgt, Sge]),
            (1, 1, vec![Eq, Uge, Ule, Sge, Sle]),
        ];
        for (a, b, holding) in cases {
            let (a, b) = (self.word(a), self.word(b));
            for predicate in all {
                let compare = Op::IntCompare(predicate, a.clone(), b.clone());
                self.expect(compare, Type::BOOL, holding.contains(&predicate).into());
            }
        }
    }

    fn floats(&mut self) {
        for (op, a, b, expected) in [
            (BinaryOp::FAdd, 1.0, 2f32.powi(-24), 1.0),
            (BinaryOp::FSub, 1.5, 2.5, -1.0),
            (BinaryOp::FMul, 3.0, -0.5, -1.5),
            (BinaryOp::FDiv, 1.0, -4.0, -0.25),
            (BinaryOp::FDiv, 1.0, 0.0, f32::INFINITY),
            (BinaryOp::FRem, 7.5, 2.0, 1.5),
        ] {
            let (a, b) = (self.float(a), self.float(b));
            self.expect(Op::Binary(op, a, b), Type::F32, expected.to_bits());
        }
        let (zero, infinity) = (self.float(0.0), self.float(f32::INFINITY));
        self.expect(Op::FloatNegate(zero.clone()), Type::F32, 0x8000_0000);
        let constants = [-0.0, f32::NEG_INFINITY, f32::from_bits(1), 1e-38, 16_777_216.0];
        for constant in constants {
            let least = self.truth(true);
            let select = Op::Select(least, Value::f32(constant), infinity.clone());
            self.expect(select, Type::F32, constant.to_bits());
        }
    }

    fn float_comparisons(&mut self) {
        use FloatPredicate::*;
        let all = [False, Oeq, Ogt, Oge, Olt, Ole, One, Ord, Ueq, Ugt, Uge, Ult, Ule, Une, Uno, True];
        let cases = [
            (1.0, 2.0, vec![Olt, Ole, One, Ord, Ult, Ule, Une, True]),
            (2.0, 1.0, vec![Ogt, Oge, One, Ord, Ugt, Uge, Une, True]),
            (0.0, -0.0, vec![Oeq, Oge, Ole, Ord, Ueq, Uge, Ule, True]),
            (1.0, f32::NAN, vec![Ueq, Ugt, Uge, Ult, Ule, Une, Uno, True]),
        ];
        for (a, b, holding) in cases {
            let (a, b) = (self.float(a), self.float(b));
            for predicate in all {
                let compare = Op::FloatCompare(predicate, a.clone(), b.clone());
                self.expect(compare, Type::BOOL, holding.contains(&predicate).into());
            }
        }
    }

    fn casts(&mut self) {
        for (op, value, expected) in [
            (CastOp::FpToUi, 3.9, 3),
            (CastOp::FpToUi, 4_294_967_040.0, 0xffff_ff00),
            (CastOp::FpToSi, -3.9, signed(-3)),
        ] {
            let value = self.float(value);
            self.expect(Op::Cast(op, value), Type::I32, expected);
        }
        for (op, value, expected) in [
            (CastOp::UiToFp, u32::MAX, 4_294_967_296.0),
            (CastOp::SiToFp, u32::MAX, -1.0),
            (CastOp::UiToFp, 16_777_217, 16_777_216.0),
        ] {
            let value = self.word(value);
            self.expect(Op::Cast(op, value), Type::F32, f32::to_bits(expected));
        }
        for (op, ty, expected) in [
            (CastOp::ZExt, Type::I32, 1),
            (CastOp::SExt, Type::I32, u32::MAX),
            (CastOp::UiToFp, Type::F32, 1f32.to_bits()),
            (CastOp::SiToFp, Type::F32, (-1f32).to_bits()),
        ] {
            let value = self.truth(true);
            self.expect(Op::Cast(op, value), ty, expected);
        }
    }

    fn functions(&mut self) {
        use MathOp::*;
        for (function, value, expected) in [
            (Sqrt, 2.25, 1.5),
            (Abs, -0.0, 0.0),
            (Floor, -1.5, -2.0),
            (Ceil, -1.5, -1.0),
            (Trunc, -1.5, -1.0),
            (RoundEven, 2.5, 2.0),
        ] {
            let value = self.float(value);
            self.expect(Op::Math(function, vec![value]), Type::F32, f32::to_bits(expected));
        }
        for (function, a, b, expected) in [
            (UMin, 1, u32::MAX, 1),
            (UMax, 1, u32::MAX, u32::MAX),
            (SMin, 1, u32::MAX, u32::MAX),
            (SMax, 1, u32::MAX, 1),
        ] {
            let arguments = vec![self.word(a), self.word(b)];
            self.expect(Op::Math(function, arguments), Type::I32, expected);
        }
        for (function, value, expected) in [
            (CountOnes, 0xf0f0, 8),
            (LeadingZeros, 0, 32),
            (LeadingZeros, 0x10, 27),
            (TrailingZeros, 0, 32),
            (TrailingZeros, 0x10, 4),
            (ReverseBits, 0x8000_0002, 0x4000_0001),
        ] {
            let value = self.word(value);
            self.expect(Op::Math(function, vec![value]), Type::I32, expected);
        }
    }

    fn truth_values(&mut self) {
        for (op, expected) in [
            (BinaryOp::And, 0),
            (BinaryOp::Or, 1),
            (BinaryOp::Xor, 1),
            (BinaryOp::Add, 1),
            (BinaryOp::Mul, 0),
        ] {
            let (a, b) = (self.truth(true), self.truth(false));
            self.expect(Op::Binary(op, a, b), Type::BOOL, expected);
        }
        for (predicate, expected) in [(IntPredicate::Eq, 0), (IntPredicate::Ne, 1)] {
            let (a, b) = (self.truth(true), self.truth(false));
            self.expect(Op::IntCompare(predicate, a, b), Type::BOOL, expected);
        }
    }
}
