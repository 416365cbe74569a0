//! Instructions and terminators.

use super::Result;
use super::cursor::Cursor;
use super::lexer::Token;
use crate::ir::{BinaryOp, CastOp, FloatPredicate, IntPredicate, Op, SourceOp, Terminator, Type, Value};

/// What a line says.
#[derive(Debug, PartialEq)]
#[allow(clippy::large_enum_variant)] // there is one at a time
pub enum Line {
    /// An instruction.
    Instruction {
        /// What is done.
        op: Op,
        /// Type of the result.
        ty: Type,
        /// As [`Instruction::exact`](crate::ir::Instruction::exact).
        exact: bool,
    },
    /// The end of a block.
    Terminator(Terminator),
}

/// An instruction without a promise.
pub(super) fn plain(op: impl Into<Op>, ty: Type) -> Line {
    Line::Instruction { op: op.into(), ty, exact: false }
}

impl Cursor<'_> {
    /// What the line says, from the instruction's word on.
    pub fn line(&mut self) -> Result<Line> {
        while matches!(self.word(), "tail" | "musttail" | "notail") {
            self.take();
        }
        let keyword = self.word();
        self.take();
        if let Some(op) = binary_op(keyword) {
            return self.binary(op);
        }
        if let Some(op) = cast_op(keyword) {
            return self.cast(op);
        }
        match keyword {
            "br" | "switch" | "ret" | "unreachable" => Ok(Line::Terminator(self.terminator(keyword)?)),
            "call" => self.call(),
            "load" | "store" | "alloca" | "getelementptr" | "atomicrmw" | "cmpxchg" | "fence" => {
                self.memory(keyword)
            }
            "extractvalue" | "insertvalue" | "extractelement" | "insertelement" | "shufflevector" => {
                self.aggregate(keyword)
            }
            _ => self.scalar(keyword),
        }
    }

    fn binary(&mut self, op: BinaryOp) -> Result<Line> {
        let exact = self.flags()?.exact;
        let (ty, a, b) = self.pair()?;
        Ok(Line::Instruction { op: Op::Binary(op, a, b), ty, exact })
    }

    fn cast(&mut self, op: CastOp) -> Result<Line> {
        let exact = self.flags()?.exact;
        let (_, value) = self.typed_value()?;
        self.expect("to")?;
        Ok(Line::Instruction { op: Op::Cast(op, value), ty: self.ty()?, exact })
    }

    /// `type a, b`.
    fn pair(&mut self) -> Result<(Type, Value, Value)> {
        let (ty, a) = self.typed_value()?;
        self.expect_mark(',')?;
        let b = self.value(&ty)?;
        Ok((ty, a, b))
    }

    fn scalar(&mut self, keyword: &str) -> Result<Line> {
        match keyword {
            "icmp" => {
                self.flags()?;
                let word = self.word();
                let predicate = int_predicate(word).ok_or_else(|| self.unknown(&format!("`icmp {word}`")))?;
                self.take();
                let (ty, a, b) = self.pair()?;
                Ok(plain(Op::IntCompare(predicate, a, b), truth(&ty)))
            }
            "fcmp" => {
                self.flags()?;
                let word = self.word();
                let predicate =
                    float_predicate(word).ok_or_else(|| self.unknown(&format!("`fcmp {word}`")))?;
                self.take();
                let (ty, a, b) = self.pair()?;
                Ok(plain(Op::FloatCompare(predicate, a, b), truth(&ty)))
            }
            "select" => {
                self.flags()?;
                let (_, condition) = self.typed_value()?;
                self.expect_mark(',')?;
                let (ty, a) = self.typed_value()?;
                self.expect_mark(',')?;
                let (_, b) = self.typed_value()?;
                Ok(plain(Op::Select(condition, a, b), ty))
            }
            "fneg" => {
                self.flags()?;
                let (ty, value) = self.typed_value()?;
                Ok(plain(Op::FloatNegate(value), ty))
            }
            "freeze" => {
                let (ty, value) = self.typed_value()?;
                Ok(plain(Op::Copy(value), ty))
            }
            "phi" => self.phi(),
            _ => Err(self.unknown(&format!("the instruction `{keyword}`"))),
        }
    }

    fn phi(&mut self) -> Result<Line> {
        self.flags()?;
        let ty = self.ty()?;
        let mut edges = Vec::new();
        loop {
            self.expect_mark('[')?;
            let value = self.value(&ty)?;
            self.expect_mark(',')?;
            edges.push((value, self.block()?));
            self.expect_mark(']')?;
            if !self.eat_comma_before_operand() {
                return Ok(plain(Op::Phi(edges), ty));
            }
        }
    }

    fn aggregate(&mut self, keyword: &str) -> Result<Line> {
        let (ty, aggregate) = self.typed_value()?;
        if keyword == "extractvalue" {
            let path = self.path()?;
            let field = path.iter().try_fold(ty, |ty, k| element_of(&ty, *k));
            let field = field.ok_or_else(|| self.unknown("a field"))?;
            return Ok(plain(SourceOp::ExtractValue(aggregate, path), field));
        }
        self.expect_mark(',')?;
        let (_, second) = self.typed_value()?;
        match keyword {
            "insertvalue" => Ok(plain(SourceOp::InsertValue(aggregate, second, self.path()?), ty)),
            "extractelement" => {
                let element = element_of(&ty, 0).ok_or_else(|| self.unknown("an element"))?;
                Ok(plain(SourceOp::ExtractElement(aggregate, second), element))
            }
            "insertelement" => {
                self.expect_mark(',')?;
                let (_, index) = self.typed_value()?;
                Ok(plain(SourceOp::InsertElement(aggregate, second, index), ty))
            }
            _ => self.shuffle(ty, aggregate, second),
        }
    }

    /// The mask of a `shufflevector` of `a` and `b`, and the instruction.
    fn shuffle(&mut self, ty: Type, a: Value, b: Value) -> Result<Line> {
        self.expect_mark(',')?;
        let (mask_ty, mask) = self.typed_value()?;
        let (Type::Vector(n, _), Some(element)) = (mask_ty, element_of(&ty, 0)) else {
            return Err(self.unknown("a shuffle"));
        };
        let mask = match mask {
            Value::Zero(_) => vec![Some(0); n as usize],
            Value::Undef(_) => vec![None; n as usize],
            Value::Aggregate(_, elements) => elements.iter().map(Value::as_u32).collect(),
            _ => return Err(self.unknown("a shuffle's mask")),
        };
        Ok(plain(SourceOp::Shuffle(a, b, mask), Type::Vector(n, Box::new(element))))
    }

    /// `, i, j …`.
    fn path(&mut self) -> Result<Vec<u32>> {
        let mut path = Vec::new();
        while self.eat_comma_before_operand() {
            path.push(self.number()?);
        }
        Ok(path)
    }

    fn terminator(&mut self, keyword: &str) -> Result<Terminator> {
        match keyword {
            "br" if self.word() == "label" => Ok(Terminator::Branch(self.label()?)),
            "br" => {
                let (_, condition) = self.typed_value()?;
                self.expect_mark(',')?;
                let then = self.label()?;
                self.expect_mark(',')?;
                Ok(Terminator::Condition(condition, then, self.label()?))
            }
            "switch" => self.switch(),
            "ret" if self.word() != "void" => Err(self.unknown("a kernel that returns a value")),
            "ret" => Ok(Terminator::Return),
            _ => Ok(Terminator::Unreachable),
        }
    }

    fn switch(&mut self) -> Result<Terminator> {
        let (_, value) = self.typed_value()?;
        self.expect_mark(',')?;
        let default = self.label()?;
        self.expect_mark('[')?;
        let mut cases = Vec::new();
        while !self.eat_mark(']') {
            let (_, case) = self.typed_value()?;
            let case = case.as_int().ok_or_else(|| self.unknown("a case"))?;
            self.expect_mark(',')?;
            cases.push((case, self.label()?));
        }
        Ok(Terminator::Switch(value, default, cases))
    }

    /// What is left of the line, if it is the alignment; 1 if it is not there.
    pub(super) fn alignment(&mut self) -> Result<u32> {
        while let Some(token) = self.take() {
            if *token == Token::Word("align".into()) {
                return self.number();
            }
        }
        Ok(1)
    }
}

/// The type of element `index` of a struct, array or vector.
fn element_of(ty: &Type, index: u32) -> Option<Type> {
    match ty {
        Type::Struct(fields) | Type::Packed(fields) => fields.get(index as usize).cloned(),
        Type::Array(_, element) | Type::Vector(_, element) => Some((**element).clone()),
        _ => None,
    }
}

/// The type of a comparison of values of type `ty`.
fn truth(ty: &Type) -> Type {
    match ty {
        Type::Vector(n, _) => Type::Vector(*n, Box::new(Type::BOOL)),
        _ => Type::BOOL,
    }
}

fn binary_op(word: &str) -> Option<BinaryOp> {
    use BinaryOp::*;
    Some(match word {
        "add" => Add,
        "sub" => Sub,
        "mul" => Mul,
        "udiv" => UDiv,
        "sdiv" => SDiv,
        "urem" => URem,
        "srem" => SRem,
        "shl" => Shl,
        "lshr" => LShr,
        "ashr" => AShr,
        "and" => And,
        "or" => Or,
        "xor" => Xor,
        "fadd" => FAdd,
        "fsub" => FSub,
        "fmul" => FMul,
        "fdiv" => FDiv,
        "frem" => FRem,
        _ => return None,
    })
}

fn cast_op(word: &str) -> Option<CastOp> {
    use CastOp::*;
    Some(match word {
        "trunc" => Trunc,
        "zext" => ZExt,
        "sext" => SExt,
        "fptoui" => FpToUi,
        "fptosi" => FpToSi,
        "uitofp" => UiToFp,
        "sitofp" => SiToFp,
        "fptrunc" => FpTrunc,
        "fpext" => FpExt,
        "bitcast" => Bitcast,
        "ptrtoint" | "ptrtoaddr" => PtrToInt,
        "inttoptr" => IntToPtr,
        _ => return None,
    })
}

fn int_predicate(word: &str) -> Option<IntPredicate> {
    use IntPredicate::*;
    Some(match word {
        "eq" => Eq,
        "ne" => Ne,
        "ugt" => Ugt,
        "uge" => Uge,
        "ult" => Ult,
        "ule" => Ule,
        "sgt" => Sgt,
        "sge" => Sge,
        "slt" => Slt,
        "sle" => Sle,
        _ => return None,
    })
}

fn float_predicate(word: &str) -> Option<FloatPredicate> {
    use FloatPredicate::*;
    Some(match word {
        "false" => False,
        "oeq" => Oeq,
        "ogt" => Ogt,
        "oge" => Oge,
        "olt" => Olt,
        "ole" => Ole,
        "one" => One,
        "ord" => Ord,
        "ueq" => Ueq,
        "ugt" => Ugt,
        "uge" => Uge,
        "ult" => Ult,
        "ule" => Ule,
        "une" => Une,
        "uno" => Uno,
        "true" => True,
        _ => return None,
    })
}
