//! What plain Rust has no word for: barriers, subgroup operations, the high word of a product.
//!
//! The kernel compiler replaces each external `__k_*` function; they exist on the device only.

/// The high word of a 32 × 32 bit product, without 64-bit integers.
#[inline(always)]
pub fn mul_high(a: u32, b: u32) -> u32 {
    #[cfg(not(feature = "device"))]
    return ((a as u64 * b as u64) >> 32) as u32;
    // SAFETY: a pure function that the kernel compiler replaces by OpUMulExtended.
    #[cfg(feature = "device")]
    return unsafe { shim::__k_umulhi(a, b) };
}

/// This machine's own square root: correctly rounded on a CPU, LLVM's intrinsic in a kernel.
///
/// `core` has no stable name for it, so it is `std`'s, of which nothing but the instruction is left.
#[inline(always)]
pub fn native_sqrt(a: f32) -> f32 {
    a.sqrt()
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
/// A macro, so that its weight stands in the kernel's own MIR. The compiler refuses a barrier that only some invocations may reach.
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
    // SAFETY: replaced by OpControlBarrier.
    #[cfg(feature = "device")]
    unsafe {
        shim::__k_barrier()
    }
    #[cfg(not(feature = "device"))]
    unimplemented!("a barrier outside a device")
}

/// Operations over the invocations of a subgroup. On the CPU a subgroup has one invocation.
pub mod subgroup {
    macro_rules! operation {
        ($($(#[$doc:meta])* $name:ident, $shim:ident, ($($arg:ident: $ty:ty),*) -> $ret:ty, $single:expr;)*) => {$(
            $(#[$doc])*
            #[inline(always)]
            pub fn $name($($arg: $ty),*) -> $ret {
                // SAFETY: replaced by the subgroup instruction of the same meaning.
                #[cfg(feature = "device")]
                return unsafe { super::shim::$shim($($arg),*) };
                #[cfg(not(feature = "device"))]
                return $single;
            }
        )*};
    }
    operation! {
        /// Number of invocations.
        size, __k_subgroup_size, () -> u32, 1;
        /// This invocation's number.
        lane, __k_subgroup_lane, () -> u32, 0;
        /// Sum of all values, modulo 2³².
        add, __k_subgroup_add, (value: u32) -> u32, value;
        /// Smallest value.
        min, __k_subgroup_umin, (value: u32) -> u32, value;
        /// Largest value.
        max, __k_subgroup_umax, (value: u32) -> u32, value;
        /// Whether `value` holds in any invocation.
        any, __k_subgroup_any, (value: bool) -> bool, value;
        /// Whether `value` holds in all invocations.
        all, __k_subgroup_all, (value: bool) -> bool, value;
        /// Value of another invocation.
        read, __k_subgroup_readlane, (value: u32, lane: u32) -> u32, { let _ = lane; value };
        /// In how many invocations `value` holds.
        count, __k_subgroup_count, (value: bool) -> u32, value as u32;
    }
}

/// The external functions that the kernel compiler knows, and what the entry points are built from.
#[cfg(feature = "device")]
#[doc(hidden)]
#[allow(missing_docs)]
pub mod shim {
    unsafe extern "C" {
        pub fn __k_weight();
        pub fn __k_barrier();
        pub fn __k_umulhi(a: u32, b: u32) -> u32;
        pub fn __k_subgroup_size() -> u32;
        pub fn __k_subgroup_lane() -> u32;
        pub fn __k_subgroup_add(v: u32) -> u32;
        pub fn __k_subgroup_umin(v: u32) -> u32;
        pub fn __k_subgroup_umax(v: u32) -> u32;
        pub fn __k_subgroup_any(v: bool) -> bool;
        pub fn __k_subgroup_all(v: bool) -> bool;
        pub fn __k_subgroup_readlane(v: u32, lane: u32) -> u32;
        pub fn __k_subgroup_count(v: bool) -> u32;
        pub fn __k_spec(id: u32, default: u32) -> u32;
        pub fn __k_threads(x: u32, y: u32, z: u32);
        fn __k_builtin(kind: u32, component: u32) -> u32;
        /// kind 0: storage that is read, 1: storage that is written, 2: uniform, 3: push constant, 4: workgroup
        fn __k_root(kind: u32, set: u32, binding: u32, size: u32, align: u32) -> *mut u8;
        fn __k_words(set: u32, binding: u32) -> u32;
    }

    #[inline(always)]
    unsafe fn vector(kind: u32) -> glam::UVec3 {
        unsafe { glam::UVec3::new(__k_builtin(kind, 0), __k_builtin(kind, 1), __k_builtin(kind, 2)) }
    }
    #[inline(always)]
    pub unsafe fn global_invocation_id() -> glam::UVec3 {
        unsafe { vector(0) }
    }
    #[inline(always)]
    pub unsafe fn local_invocation_id() -> glam::UVec3 {
        unsafe { vector(1) }
    }
    #[inline(always)]
    pub unsafe fn workgroup_id() -> glam::UVec3 {
        unsafe { vector(2) }
    }
    #[inline(always)]
    pub unsafe fn num_workgroups() -> glam::UVec3 {
        unsafe { vector(3) }
    }
    #[inline(always)]
    pub unsafe fn local_invocation_index() -> u32 {
        unsafe { __k_builtin(4, 0) }
    }
    #[inline(always)]
    unsafe fn root<T>(kind: u32, set: u32, binding: u32) -> *mut T {
        unsafe { __k_root(kind, set, binding, size_of::<T>() as u32, align_of::<T>() as u32).cast() }
    }
    #[inline(always)]
    unsafe fn len<T>(set: u32, binding: u32) -> usize {
        unsafe { (__k_words(set, binding) * 4 / size_of::<T>() as u32) as usize }
    }
    #[inline(always)]
    pub unsafe fn slice<'a, T>(set: u32, binding: u32) -> &'a [T] {
        unsafe { core::slice::from_raw_parts(root(0, set, binding), len::<T>(set, binding)) }
    }
    #[inline(always)]
    pub unsafe fn out<'a, T: Copy>(set: u32, binding: u32) -> crate::Out<'a, T> {
        unsafe {
            let data = core::slice::from_raw_parts_mut(root(1, set, binding), len::<T>(set, binding));
            crate::Out::new(data, &[])
        }
    }
    #[inline(always)]
    pub unsafe fn uniform<'a, T>(set: u32, binding: u32) -> &'a T {
        unsafe { &*root(2, set, binding) }
    }
    #[inline(always)]
    pub unsafe fn push_constant<'a, T>() -> &'a T {
        unsafe { &*root(3, 0, 0) }
    }
    #[inline(always)]
    pub unsafe fn workgroup<'a, T>(number: u32) -> &'a T {
        unsafe { &*root(4, 0, number) }
    }
}
