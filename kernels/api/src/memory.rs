//! Views of buffers and of an invocation's own arrays: the only module of `shared`, `kernels` and `kernel-api` with `unsafe`.
//!
//! On the CPU every access is checked and a wrong index panics (a defect of the kernel, which tests find). On the device a panic
//! is impossible: accesses are unchecked there, and an index out of range is subject to the driver's robust buffer access.

use core::marker::PhantomData;
use core::mem::MaybeUninit;

/// An index into a view: `u32` (preferred, as it is what a device has) or `usize`.
pub trait Index: Copy {
    /// The index as `usize`.
    fn index(self) -> usize;
}

impl Index for u32 {
    #[inline(always)]
    fn index(self) -> usize {
        self as usize
    }
}

impl Index for usize {
    #[inline(always)]
    fn index(self) -> usize {
        self
    }
}

/// Element access that panics on the CPU when the index is out of range and is unchecked on the device.
pub trait At<T> {
    /// The element at `i`.
    fn at<I: Index>(&self, i: I) -> T
    where
        T: Copy;
    /// A reference to the element at `i`.
    fn at_ref<I: Index>(&self, i: I) -> &T;
    /// The elements from `i` on.
    fn tail<I: Index>(&self, i: I) -> &[T];
    /// Sets the element at `i` of an array that belongs to this invocation alone.
    fn put<I: Index>(&mut self, i: I, value: T);
}

impl<T> At<T> for [T] {
    #[inline(always)]
    fn at<I: Index>(&self, i: I) -> T
    where
        T: Copy,
    {
        *self.at_ref(i)
    }

    #[inline(always)]
    fn at_ref<I: Index>(&self, i: I) -> &T {
        #[cfg(not(feature = "device"))]
        return &self[i.index()];
        // SAFETY: on the device no Rust object is behind the slice: the access becomes an indexed buffer access, which
        // `robustBufferAccess` confines to the buffer.
        #[cfg(feature = "device")]
        return unsafe { self.get_unchecked(i.index()) };
    }

    #[inline(always)]
    fn tail<I: Index>(&self, i: I) -> &[T] {
        #[cfg(not(feature = "device"))]
        return &self[i.index()..];
        // SAFETY: as in `at_ref`.
        #[cfg(feature = "device")]
        return unsafe { self.get_unchecked(i.index()..) };
    }

    #[inline(always)]
    fn put<I: Index>(&mut self, i: I, value: T) {
        #[cfg(not(feature = "device"))]
        return self[i.index()] = value;
        // SAFETY: as in `at_ref`.
        #[cfg(feature = "device")]
        return unsafe { *self.get_unchecked_mut(i.index()) = value };
    }
}

/// A buffer that invocations can only put values into, each element by one invocation of a pass.
///
/// Many invocations run at once, so a `&mut [T]` to the whole buffer would be undefined behaviour; this view never makes a
/// reference to an element. That no element is written twice in a pass is the kernel's contract. Debug builds check it (a second
/// write panics), on the CPU, where the backend has handed in one mark per element.
pub struct Out<'a, T> {
    data: *mut T,
    len: usize,
    #[cfg(all(debug_assertions, not(feature = "device")))]
    marks: &'a [core::sync::atomic::AtomicU8],
    life: PhantomData<&'a mut [T]>,
}

impl<T> Clone for Out<'_, T> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Out<'_, T> {}

// SAFETY: the view only moves values of `T` into distinct elements (see the contract above), which is sound from any thread when
// `T` may be sent there.
unsafe impl<T: Send> Send for Out<'_, T> {}
// SAFETY: as for `Send`; `put` takes `&self` but never reads.
unsafe impl<T: Send> Sync for Out<'_, T> {}

impl<'a, T: Copy> Out<'a, T> {
    /// A view of `data`. `marks`, which debug builds use, has one zero per element or is empty (then nothing is checked).
    #[inline(always)]
    pub fn new(data: &'a mut [T], marks: &'a [core::sync::atomic::AtomicU8]) -> Self {
        let _ = marks;
        Self {
            data: data.as_mut_ptr(),
            len: data.len(),
            #[cfg(all(debug_assertions, not(feature = "device")))]
            marks,
            life: PhantomData,
        }
    }

    /// Number of elements.
    #[inline(always)]
    pub fn len(&self) -> u32 {
        self.len as u32
    }

    /// Whether there is no element.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Sets element `i`. Out of range it panics on the CPU; on the device the write is dropped by robust buffer access.
    #[inline(always)]
    pub fn put<I: Index>(&self, i: I, value: T) {
        let i = i.index();
        #[cfg(not(feature = "device"))]
        assert!(i < self.len, "put at {i} of a view of {} elements", self.len);
        #[cfg(all(debug_assertions, not(feature = "device")))]
        if let Some(mark) = self.marks.get(i) {
            let before = mark.swap(1, core::sync::atomic::Ordering::Relaxed);
            assert!(before == 0, "element {i} is written twice in one pass");
        }
        // SAFETY: `i` is in range (checked above, or confined by the device), the memory is exclusively borrowed for `'a`, and by
        // the contract no other invocation writes this element.
        unsafe { self.data.add(i).write(value) }
    }
}

/// A bounded stack of an invocation's own; nothing is cleared when it is made.
pub struct Stack<T, const N: usize> {
    items: [MaybeUninit<T>; N],
    len: u32,
}

impl<T: Copy, const N: usize> Stack<T, N> {
    /// An empty stack.
    #[inline(always)]
    #[allow(clippy::new_without_default)] // `Default` would promise a cheap copy of something that is `N` items large.
    pub fn new() -> Self {
        Self { items: [const { MaybeUninit::uninit() }; N], len: 0 }
    }

    /// Number of items.
    #[inline(always)]
    pub fn len(&self) -> u32 {
        self.len
    }

    /// Whether there is no item.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Puts `item` on top; returns `false`, and leaves the stack as it was, when it is full.
    #[inline(always)]
    pub fn push(&mut self, item: T) -> bool {
        let fits = (self.len as usize) < N;
        if fits {
            // SAFETY: `len < N`.
            unsafe { *self.items.get_unchecked_mut(self.len as usize) = MaybeUninit::new(item) };
            self.len += 1;
        }
        fits
    }

    /// Takes the top item.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<T> {
        if self.len == 0 {
            return None;
        }
        self.len -= 1;
        // SAFETY: every item below `len` has been pushed, and `len <= N` always.
        Some(unsafe { self.items.get_unchecked(self.len as usize).assume_init() })
    }

    /// Removes all items.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }
}

/// Workgroup memory of `N` elements, shared by the invocations of a workgroup; unordered except by [`barrier`](crate::barrier!).
///
/// An `UnsafeCell`, since LLVM may carry a value of a `&mut [T; N]` across a barrier. It exists on a device only: a kernel gets it
/// as a parameter with `#[spirv(workgroup)]`.
#[repr(transparent)]
pub struct Workgroup<T, const N: usize>(core::cell::UnsafeCell<[T; N]>);

// SAFETY: elements are plain data, and what one invocation writes another one reads only behind a barrier.
unsafe impl<T: Send, const N: usize> Sync for Workgroup<T, N> {}

impl<T: Copy, const N: usize> Workgroup<T, N> {
    /// Element `i`.
    #[inline(always)]
    pub fn get<I: Index>(&self, i: I) -> T {
        debug_assert!(i.index() < N);
        // SAFETY: on the device (the only place where this type exists) the access is confined to the array.
        unsafe { *self.0.get().cast::<T>().add(i.index()) }
    }

    /// Sets element `i`.
    #[inline(always)]
    pub fn set<I: Index>(&self, i: I, value: T) {
        debug_assert!(i.index() < N);
        // SAFETY: as in `get`.
        unsafe { *self.0.get().cast::<T>().add(i.index()) = value }
    }
}
