//! Output buffers.

use super::Index;
use core::marker::PhantomData;
use core::sync::atomic::AtomicU8;
#[cfg(all(debug_assertions, not(feature = "device")))]
use core::sync::atomic::Ordering::Relaxed;

/// A buffer that invocations can only put values into, each element by one invocation of a pass.
///
/// Many invocations run at once, so a `&mut [T]` to the whole buffer would be undefined behaviour; this view never makes a
/// reference to an element. That no element is written twice in a pass is the kernel's contract, which whoever makes the view
/// answers for. Debug builds check it (a second write panics), on the CPU, where the backend has handed in one mark per element.
///
/// ```
/// use core::sync::atomic::AtomicU8;
/// use kernel_api::Out;
///
/// let mut data = [0u32; 2];
/// let marks = [const { AtomicU8::new(0) }; 2];
/// // SAFETY: one thread.
/// let out = unsafe { Out::new(&mut data, &marks) };
/// out.put(1u32, 7);
/// assert_eq!(data, [0, 7]);
/// ```
pub struct Out<'a, T> {
    data: *mut T,
    len: usize,
    #[cfg(all(debug_assertions, not(feature = "device")))]
    marks: &'a [AtomicU8],
    life: PhantomData<&'a mut [T]>,
}

impl<T> Clone for Out<'_, T> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Out<'_, T> {}

// SAFETY: the view only moves values of `T` into elements, which is sound from any thread when `T` may be sent there; that no two
// threads move one into the same element is what the caller of `new` promises.
unsafe impl<T: Send> Send for Out<'_, T> {}
// SAFETY: as for `Send`; `put` takes `&self` but never reads.
unsafe impl<T: Send> Sync for Out<'_, T> {}

impl<'a, T: Copy> Out<'a, T> {
    /// A view of `data`. `marks`, which debug builds use, has one zero per element or is empty (then nothing is checked).
    ///
    /// # Safety
    /// The caller hands the view only to invocations that write different elements, or runs them in one thread.
    #[inline(always)]
    pub unsafe fn new(data: &'a mut [T], marks: &'a [AtomicU8]) -> Self {
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
            assert!(mark.swap(1, Relaxed) == 0, "element {i} is written twice in one pass");
        }
        // SAFETY: `i` is in range (checked above, or confined by the device), the memory is exclusively borrowed for `'a`, and by
        // the promise made to `new` no other invocation writes this element.
        unsafe { self.data.add(i).write(value) }
    }
}

#[cfg(test)]
mod tests {
    use super::Out;
    use core::sync::atomic::AtomicU8;

    fn marks() -> [AtomicU8; 4] {
        [const { AtomicU8::new(0) }; 4]
    }

    #[test]
    fn each_element_takes_its_value() {
        let (mut data, marks) = ([0u32; 4], marks());
        // SAFETY: one thread.
        let out = unsafe { Out::new(&mut data, &marks) };
        (0..4u32).for_each(|i| out.put(i, i * i));
        assert_eq!((out.len(), out.is_empty()), (4, false));
        assert_eq!(data, [0, 1, 4, 9]);
    }

    #[test]
    fn without_marks_nothing_is_checked() {
        let mut data = [0u32; 1];
        // SAFETY: one thread.
        let out = unsafe { Out::new(&mut data, &[]) };
        out.put(0u32, 1);
        out.put(0u32, 2);
        assert_eq!(data, [2]);
    }

    #[test]
    #[cfg(debug_assertions)]
    #[should_panic(expected = "element 2 is written twice in one pass")]
    fn a_second_write_to_an_element_panics() {
        let (mut data, marks) = ([0u32; 4], marks());
        // SAFETY: one thread.
        let out = unsafe { Out::new(&mut data, &marks) };
        out.put(2u32, 1);
        out.put(2u32, 1);
    }

    #[test]
    #[should_panic(expected = "put at 4 of a view of 4 elements")]
    fn writing_out_of_range_panics() {
        let (mut data, marks) = ([0u32; 4], marks());
        // SAFETY: one thread.
        unsafe { Out::new(&mut data, &marks) }.put(4u32, 1);
    }
}
