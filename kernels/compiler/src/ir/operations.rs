//! The small vocabularies: arithmetic, predicates, casts, atomics, mathematics, builtins.

/// Arithmetic of two operands of one type.
#[allow(missing_docs)] // as LLVM's instructions of the same names
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    UDiv,
    SDiv,
    URem,
    SRem,
    Shl,
    LShr,
    AShr,
    And,
    Or,
    Xor,
    FAdd,
    FSub,
    FMul,
    FDiv,
    FRem,
}

impl BinaryOp {
    /// Whether the operands may be exchanged. (Floats too, up to which of two NaNs is handed on; they are left as they are.)
    pub fn commutes(self) -> bool {
        use BinaryOp::*;
        matches!(self, Add | Mul | And | Or | Xor)
    }
}

/// Conversions.
#[allow(missing_docs)] // as LLVM's instructions of the same names
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum CastOp {
    Trunc,
    ZExt,
    SExt,
    FpToUi,
    FpToSi,
    UiToFp,
    SiToFp,
    FpTrunc,
    FpExt,
    Bitcast,
    PtrToInt,
    IntToPtr,
}

/// Comparison of integers: `U` unsigned, `S` signed.
#[allow(missing_docs)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum IntPredicate {
    Eq,
    Ne,
    Ugt,
    Uge,
    Ult,
    Ule,
    Sgt,
    Sge,
    Slt,
    Sle,
}

impl IntPredicate {
    /// Whether the operands are taken as two's complement numbers.
    pub fn is_signed(self) -> bool {
        use IntPredicate::*;
        matches!(self, Sgt | Sge | Slt | Sle)
    }
}

/// Comparison of floats: `O` false and `U` true when an operand is a NaN.
#[allow(missing_docs)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum FloatPredicate {
    False,
    Oeq,
    Ogt,
    Oge,
    Olt,
    Ole,
    One,
    Ord,
    Ueq,
    Ugt,
    Uge,
    Ult,
    Ule,
    Une,
    Uno,
    True,
}

/// What an atomic instruction makes of the old word and its operand; it yields the old word.
#[allow(missing_docs)]
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum AtomicOp {
    Add,
    Sub,
    And,
    Or,
    Xor,
    UMin,
    UMax,
    SMin,
    SMax,
    Exchange,
}

/// Functions that both SPIR-V and WGSL have. The float functions take and yield `f32`, the integer functions `i32`.
///
/// There is no float min or max: drivers differ in the sign of zero, so lowering makes them comparisons and selections.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum MathOp {
    /// Square root (of one argument, as all up to `Tanh` unless said otherwise).
    Sqrt,
    /// Magnitude.
    Abs,
    /// Towards −∞.
    Floor,
    /// Towards +∞.
    Ceil,
    /// Towards zero.
    Trunc,
    /// To the nearest integer, ties to even.
    RoundEven,
    /// `a · b + c` of three arguments; not fused on every driver.
    Fma,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// e^x.
    Exp,
    /// 2^x.
    Exp2,
    /// Natural logarithm.
    Log,
    /// Binary logarithm.
    Log2,
    /// x^y of two arguments.
    Pow,
    /// Arc sine.
    Asin,
    /// Arc cosine.
    Acos,
    /// Arc tangent.
    Atan,
    /// Arc tangent of y / x, of the two arguments y and x.
    Atan2,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// The smaller of two unsigned words.
    UMin,
    /// The larger of two unsigned words.
    UMax,
    /// The smaller of two signed words.
    SMin,
    /// The larger of two signed words.
    SMax,
    /// Number of one bits.
    CountOnes,
    /// Number of zero bits above the highest one bit; 32 for 0.
    LeadingZeros,
    /// Number of zero bits below the lowest one bit; 32 for 0.
    TrailingZeros,
    /// Bit `i` becomes bit `31 − i`.
    ReverseBits,
}

impl MathOp {
    /// Whether this is a function of words (the others are of floats).
    pub fn is_integer(self) -> bool {
        use MathOp::*;
        matches!(self, UMin | UMax | SMin | SMax | CountOnes | LeadingZeros | TrailingZeros | ReverseBits)
    }
}

/// What a device tells an invocation about itself. The first four have three components.
#[allow(missing_docs)] // as SPIR-V's builtins of the same names
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Builtin {
    GlobalInvocationId,
    LocalInvocationId,
    WorkgroupId,
    NumWorkgroups,
    LocalInvocationIndex,
    SubgroupSize,
    SubgroupLane,
}

impl Builtin {
    /// Whether it has three components.
    pub fn is_vector(self) -> bool {
        self <= Builtin::NumWorkgroups
    }
}

/// Operations over the invocations of a subgroup.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum SubgroupOp {
    /// Sum of all words.
    Add,
    /// Smallest unsigned word.
    UMin,
    /// Largest unsigned word.
    UMax,
    /// Whether the truth value holds in any invocation.
    Any,
    /// Whether it holds in all invocations.
    All,
    /// The word of another invocation: of two arguments, word and lane.
    Read,
    /// In how many invocations the truth value holds.
    Count,
}
