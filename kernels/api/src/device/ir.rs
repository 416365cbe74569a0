//! The kernel compiler's machine: external functions that it replaces by instructions.

#[inline(always)]
pub fn sqrt(a: f32) -> f32 {
    a.sqrt()
}

#[inline(always)]
pub fn fma(a: f32, b: f32, c: f32) -> f32 {
    a.mul_add(b, c)
}

macro_rules! replaced {
    ($($name:ident($($argument:ident: $ty:ty),*) $(-> $result:ty)?, $external:ident;)*) => {$(
        #[inline(always)]
        pub fn $name($($argument: $ty),*) $(-> $result)? {
            // SAFETY: the kernel compiler replaces the call by an instruction that is defined for all arguments.
            unsafe { shim::$external($($argument),*) }
        }
    )*};
}
replaced! {
    mul_high(a: u32, b: u32) -> u32, __k_umulhi;
    barrier(), __k_barrier;
    subgroup_size() -> u32, __k_subgroup_size;
    subgroup_lane() -> u32, __k_subgroup_lane;
    subgroup_add(value: u32) -> u32, __k_subgroup_add;
    subgroup_min(value: u32) -> u32, __k_subgroup_umin;
    subgroup_max(value: u32) -> u32, __k_subgroup_umax;
    subgroup_any(value: bool) -> bool, __k_subgroup_any;
    subgroup_all(value: bool) -> bool, __k_subgroup_all;
    subgroup_read(value: u32, lane: u32) -> u32, __k_subgroup_readlane;
    subgroup_count(value: bool) -> u32, __k_subgroup_count;
}

/// The external functions that the kernel compiler knows, and what the entry points are built from.
#[allow(missing_docs)] // Their meaning stands in the kernel compiler, next to what replaces them.
pub mod shim {
    use glam::UVec3;

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
    unsafe fn vector(kind: u32) -> UVec3 {
        unsafe { UVec3::new(__k_builtin(kind, 0), __k_builtin(kind, 1), __k_builtin(kind, 2)) }
    }
    #[inline(always)]
    pub unsafe fn global_invocation_id() -> UVec3 {
        unsafe { vector(0) }
    }
    #[inline(always)]
    pub unsafe fn local_invocation_id() -> UVec3 {
        unsafe { vector(1) }
    }
    #[inline(always)]
    pub unsafe fn workgroup_id() -> UVec3 {
        unsafe { vector(2) }
    }
    #[inline(always)]
    pub unsafe fn num_workgroups() -> UVec3 {
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
