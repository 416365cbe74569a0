//! Why a kernel cannot be compiled, and what to write instead.

use crate::ir::Origin;
use std::fmt;

/// A kernel that is not compiled, and why. A kernel may have several.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub struct Refusal {
    /// The entry point.
    pub entry: String,
    /// The function that must not be called, or else the one that holds the trouble, where the IR still tells.
    pub function: Option<String>,
    /// `file:line` of the kernel's source, where the IR still tells.
    pub place: Option<String>,
    /// Why.
    pub reason: Reason,
}

impl Refusal {
    /// A refusal of the kernel `entry` for something that comes from `origin`.
    pub fn new(entry: &str, reason: Reason, origin: Option<Origin>) -> Self {
        let (function, place) = origin.map(|origin| (origin.function, origin.place)).unzip();
        Self { entry: entry.into(), function, place, reason }
    }
}

/// Why a kernel is refused.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Reason {
    /// It can panic, in so many places.
    Panic {
        /// Number of calls.
        calls: usize,
    },
    /// A function was not inlined.
    NotInlined,
    /// A function has no body in this crate.
    NoBody,
    /// Memory is allocated.
    Allocation,
    /// A call through a function pointer or trait object.
    IndirectCall,
    /// `f64` is used.
    Double,
    /// A value wider than 32 bits that could not be avoided; its name in the IR.
    Wide(String),
    /// A store of fewer than 32 bits into shared memory.
    NarrowStore {
        /// The bits.
        bits: u32,
    },
    /// A static that is written.
    MutableStatic(String),
    /// An atomic access of something else than 32 bits.
    WideAtomic,
    /// A fence, or an atomic access that is not relaxed.
    Ordering(String),
    /// A pointer in memory, from an integer, or into several places.
    Pointer(String),
    /// A copy or fill that cannot be unrolled.
    Copy(String),
    /// An access of a word at an address that is not a multiple of four.
    Unaligned,
    /// A barrier that not all invocations of a workgroup reach together.
    DivergentBarrier,
    /// A subgroup operation that not all invocations of a workgroup reach together.
    DivergentSubgroup,
    /// Control flow that is not structured.
    ControlFlow(String),
    /// Something for which SPIR-V or WGSL has no form.
    NoForm(String),
    /// Something that this compiler does not know, by name.
    Unknown(String),
}

impl Reason {
    /// Whether the function that must not be called says it all.
    pub(crate) fn is_about_a_call(&self) -> bool {
        matches!(self, Reason::Panic { .. } | Reason::NotInlined | Reason::NoBody | Reason::Allocation)
    }

    /// What to write instead.
    pub fn instead(&self) -> &'static str {
        match self {
            Reason::Panic { .. } => {
                "index with `.at()` and `.put()` or `get`, use wrapping or checked arithmetic, and test divisors for zero"
            }
            Reason::NotInlined => {
                "write a loop for a recursion, and mark the function #[inline] or #[inline(always)]"
            }
            Reason::NoBody => "mark the function #[inline] in its crate, or use a function of `core`",
            Reason::Allocation => "use an array of fixed length or `kernel_api::Stack`",
            Reason::IndirectCall => "use a generic parameter or a `match`",
            Reason::Double => "use f32",
            Reason::Wide(_) => "use u32, and `kernel_api::device::mul_high` for the high half of a product",
            Reason::NarrowStore { .. } => "store u32: the neighbouring bytes belong to other invocations",
            Reason::MutableStatic(_) => "use a buffer or workgroup memory",
            Reason::WideAtomic => "use AtomicU32 or AtomicI32",
            Reason::Ordering(_) => "use Ordering::Relaxed, and a barrier or another pass for order",
            Reason::Pointer(_) => "keep indices instead of references",
            Reason::Copy(_) => "write a loop over the elements",
            Reason::Unaligned => "read whole words and shift",
            Reason::DivergentSubgroup => "call it on every path, and let the others hand in a neutral value",
            Reason::DivergentBarrier => {
                "reach the barrier on every path, under conditions that are the same for all invocations"
            }
            Reason::ControlFlow(_) => {
                "simplify the loop: one way out, no labelled breaks across several levels"
            }
            Reason::NoForm(_) => "avoid it, or compile without WGSL if it is WGSL that lacks it",
            Reason::Unknown(_) => "nothing is known that does the same: please report it",
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Panic { calls: 1 } => write!(f, "it can still panic"),
            Reason::Panic { calls } => write!(f, "it can still panic, in {calls} places"),
            Reason::NotInlined => {
                write!(f, "the function was not inlined: is it recursive, or #[inline(never)]?")
            }
            Reason::NoBody => write!(
                f,
                "the function has no body here: a C function, or one of another crate without #[inline]"
            ),
            Reason::Allocation => write!(f, "memory is allocated"),
            Reason::IndirectCall => write!(f, "a function pointer or trait object is called"),
            Reason::Double => write!(f, "f64 is used, which devices lack"),
            Reason::Wide(value) if value.is_empty() => {
                write!(f, "a value is wider than 32 bits, which not all devices have")
            }
            Reason::Wide(value) => {
                write!(f, "the value %{value} is wider than 32 bits, which not all devices have")
            }
            Reason::NarrowStore { bits } => {
                write!(f, "{bits} bits are stored into a buffer or workgroup memory")
            }
            Reason::MutableStatic(name) => write!(f, "the static `{name}` can be written"),
            Reason::WideAtomic => write!(f, "an atomic access is not of 32 bits"),
            Reason::Ordering(what)
            | Reason::Pointer(what)
            | Reason::Copy(what)
            | Reason::ControlFlow(what) => write!(f, "{what}"),
            Reason::Unaligned => {
                write!(f, "a word is accessed at an address that may not be a multiple of four")
            }
            Reason::DivergentBarrier => {
                write!(f, "a barrier stands under a condition that differs between invocations")
            }
            Reason::DivergentSubgroup => {
                write!(f, "a subgroup operation stands under a condition that differs between invocations")
            }
            Reason::NoForm(what) => write!(f, "there is no form for {what}"),
            Reason::Unknown(what) => write!(f, "{what} is not known to this compiler"),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "kernel `{}`", self.entry)?;
        if let Some(function) = &self.function {
            write!(f, ", `{function}`")?;
        }
        if let Some(place) = &self.place {
            write!(f, " ({place})")?;
        }
        write!(f, ": {}; instead: {}", self.reason, self.reason.instead())
    }
}
