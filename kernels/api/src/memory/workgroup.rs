//! Memory of a workgroup.

use super::Index;
use core::cell::UnsafeCell;

/// Workgroup memory of `N` elements, shared by the invocations of a workgroup; unordered except by [`barrier`](crate::barrier!).
///
/// An `UnsafeCell`, since LLVM may carry a value of a `&mut [T; N]` across a barrier. It exists on a device only: a kernel gets it
/// as a parameter with `#[spirv(workgroup)]`, and its content is undefined until it is set. There is no way to make one on the CPU,
/// where two threads could then set one element at once.
#[repr(transparent)]
pub struct Workgroup<T, const N: usize>(UnsafeCell<[T; N]>);

// SAFETY: elements are plain data, and what one invocation writes another one reads only behind a barrier.
unsafe impl<T: Send, const N: usize> Sync for Workgroup<T, N> {}

impl<T: Copy, const N: usize> Workgroup<T, N> {
    /// Element `i`.
    #[inline(always)]
    pub fn get<I: Index>(&self, i: I) -> T {
        // SAFETY: `element` lies in the array.
        unsafe { self.element(i.index()).read() }
    }

    /// Sets element `i`.
    #[inline(always)]
    pub fn set<I: Index>(&self, i: I, value: T) {
        // SAFETY: as in `get`.
        unsafe { self.element(i.index()).write(value) }
    }

    #[inline(always)]
    fn element(&self, i: usize) -> *mut T {
        #[cfg(not(feature = "device"))]
        assert!(i < N, "element {i} of a workgroup's {N}");
        // SAFETY: in range, or confined to the array by the device.
        unsafe { self.0.get().cast::<T>().add(i) }
    }

    /// rust-gpu's workgroup variable as ours.
    #[cfg(target_arch = "spirv")]
    #[doc(hidden)]
    #[inline(always)]
    pub fn over(variable: &mut [T; N]) -> &Self {
        // SAFETY: `repr(transparent)` over an `UnsafeCell` of the same array.
        unsafe { &*core::ptr::from_mut(variable).cast() }
    }
}

#[cfg(test)]
mod tests {
    use super::Workgroup;
    use core::cell::UnsafeCell;

    #[test]
    fn what_is_set_can_be_read() {
        let memory = Workgroup(UnsafeCell::new([0u32; 3]));
        memory.set(1u32, 5);
        assert_eq!([memory.get(0u32), memory.get(1usize), memory.get(2u32)], [0, 5, 0]);
    }

    #[test]
    #[should_panic(expected = "element 3 of a workgroup's 3")]
    fn out_of_range_panics() {
        Workgroup(UnsafeCell::new([0u32; 3])).get(3u32);
    }
}
