//! What plain Rust has no word for: barriers, subgroup operations, the high word of a product.
//!
//! Three machines answer: `cpu` (one invocation after another), `ir` (external functions that the kernel compiler replaces) and
//! `spirv` (spirv-std, under rust-gpu).

/// Whether this code runs on a device. A constant by which an algorithm may choose between two drivers of the same arithmetic.
pub const ON_DEVICE: bool = cfg!(feature = "device");

#[cfg(not(feature = "device"))]
#[path = "cpu.rs"]
mod machine;

#[cfg(all(feature = "device", not(target_arch = "spirv")))]
#[path = "ir.rs"]
mod machine;

#[cfg(all(feature = "device", target_arch = "spirv"))]
#[path = "spirv.rs"]
mod machine;

/// With the feature `rust-gpu` it is checked that it fits spirv-std, on any target.
#[cfg(all(feature = "rust-gpu", not(target_arch = "spirv")))]
#[allow(dead_code)] // Here its functions are checked, not used.
#[path = "spirv.rs"]
mod spirv;

#[cfg(all(feature = "device", not(target_arch = "spirv")))]
#[doc(hidden)]
pub use machine::shim;

/// The high word of a 32 × 32 bit product, without 64-bit integers.
///
/// ```
/// assert_eq!(kernel_api::device::mul_high(0x8000_0001, 6), 3);
/// ```
#[inline(always)]
pub fn mul_high(a: u32, b: u32) -> u32 {
    machine::mul_high(a, b)
}

/// This machine's own square root: correctly rounded on a CPU, LLVM's intrinsic in a kernel.
///
/// `core` has no stable name for it, so it is `std`'s, of which nothing but the instruction is left.
#[inline(always)]
pub fn native_sqrt(a: f32) -> f32 {
    machine::sqrt(a)
}

/// `a · b + c` by this machine's own fused multiply-add: rounded once on a CPU, on a device as often as its driver likes. For probing a
/// driver; algorithms do without (DESIGN §3).
#[inline(always)]
pub fn native_fma(a: f32, b: f32, c: f32) -> f32 {
    machine::fma(a, b, c)
}

/// Keeps what follows from being copied into both sides of a condition before it: a barrier must stay one barrier. Its cost exceeds
/// the one up to which rustc's MIR jump threading copies a block, so it must stand in the kernel's own MIR.
#[doc(hidden)]
#[macro_export]
macro_rules! once {
    () => {{
        #[cfg(kernel_ir)]
        // SAFETY: the kernel compiler drops these calls.
        unsafe {
            $crate::rt::__k_weight();
            $crate::rt::__k_weight();
            $crate::rt::__k_weight();
            $crate::rt::__k_weight();
            $crate::rt::__k_weight();
        }
    }};
}

/// Waits until all invocations of the workgroup are here and see each other's writes to workgroup memory.
///
/// A macro, so that its weight stands in the kernel's own MIR: use it in the kernel crate itself, not in a crate that it calls. The
/// compiler refuses a barrier that only some invocations may reach. On the CPU it panics (there is no workgroup memory either).
#[macro_export]
macro_rules! barrier {
    () => {{
        $crate::once!();
        $crate::device::workgroup_barrier()
    }};
}

/// Use [`barrier!`](crate::barrier!).
#[doc(hidden)]
#[inline(always)]
pub fn workgroup_barrier() {
    machine::barrier()
}

/// Calls an operation of the module [`subgroup`](mod@crate::subgroup): `subgroup!(add(x))`.
///
/// A macro, for the reason that [`barrier!`](crate::barrier!) is one: who takes part in an operation is decided by where it stands.
///
/// ```
/// use kernel_api::subgroup;
///
/// // On the CPU a subgroup has one invocation.
/// assert_eq!(subgroup!(add(7)), 7);
/// assert!(subgroup!(all(true)));
/// ```
#[macro_export]
macro_rules! subgroup {
    ($operation:ident($($argument:expr),*)) => {{
        $crate::once!();
        $crate::subgroup::$operation($($argument),*)
    }};
}

/// Operations over the invocations of a subgroup that are active where it stands. On the CPU a subgroup has one invocation.
///
/// Call those that combine values by [`subgroup!`](macro@crate::subgroup). How many invocations a subgroup has differs from device
/// to device, and so do all these results: make sure that what a kernel writes in the end does not depend on it.
pub mod subgroup {
    use super::machine;

    macro_rules! operations {
        ($($(#[$doc:meta])* $name:ident($($argument:ident: $ty:ty),*) -> $result:ty, $machine:ident;)*) => {$(
            $(#[$doc])*
            #[inline(always)]
            pub fn $name($($argument: $ty),*) -> $result {
                machine::$machine($($argument),*)
            }
        )*};
    }
    operations! {
        /// Number of invocations.
        size() -> u32, subgroup_size;
        /// This invocation's number.
        lane() -> u32, subgroup_lane;
        /// Sum of all values, modulo 2³².
        add(value: u32) -> u32, subgroup_add;
        /// Smallest value.
        min(value: u32) -> u32, subgroup_min;
        /// Largest value.
        max(value: u32) -> u32, subgroup_max;
        /// Whether `value` holds in any invocation.
        any(value: bool) -> bool, subgroup_any;
        /// Whether `value` holds in all invocations.
        all(value: bool) -> bool, subgroup_all;
        /// Value of another invocation, whose number is the same in all of them.
        read(value: u32, lane: u32) -> u32, subgroup_read;
        /// In how many invocations `value` holds.
        count(value: bool) -> u32, subgroup_count;
    }
}

#[cfg(test)]
mod tests {
    use super::mul_high;

    #[test]
    fn the_high_word_is_that_of_the_64_bit_product() {
        let mut x = 1u32;
        for _ in 0..1000 {
            let a = x;
            x = x.wrapping_mul(1664525).wrapping_add(1013904223);
            let expected = ((a as u64 * x as u64) >> 32) as u32;
            assert_eq!(mul_high(a, x), expected, "{a} · {x}");
            #[cfg(feature = "rust-gpu")]
            assert_eq!(super::spirv::mul_high(a, x), expected, "{a} · {x}");
        }
        assert_eq!(mul_high(u32::MAX, u32::MAX), u32::MAX - 1);
    }

    #[test]
    fn a_subgroup_of_the_cpu_is_one_invocation() {
        assert_eq!((subgroup!(size()), subgroup!(lane()), subgroup!(count(true))), (1, 0, 1));
        assert_eq!((subgroup!(min(4)), subgroup!(max(5)), subgroup!(read(6, 0))), (4, 5, 6));
        assert!(!subgroup!(any(false)));
    }

    #[test]
    #[should_panic(expected = "a barrier outside a device")]
    fn a_barrier_of_the_cpu_panics() {
        barrier!();
    }
}
