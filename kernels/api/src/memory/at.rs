//! Elements of slices and arrays.

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
///
/// ```
/// use kernel_api::At;
///
/// let mut own = [5u32, 6, 7];
/// own.put(1u32, 60);
/// assert_eq!(own.at(1u32), 60);
/// assert_eq!(own.tail(1u32), [60, 7]);
/// ```
pub trait At<T> {
    /// The element at `i`.
    fn at<I: Index>(&self, i: I) -> T
    where
        T: Copy;
    /// A reference to the element at `i`.
    fn at_ref<I: Index>(&self, i: I) -> &T;
    /// The elements from `i` on; none when `i` is the length.
    fn tail<I: Index>(&self, i: I) -> &[T];
    /// The `N` elements from `i` on: one check for all of them.
    fn window<const N: usize>(&self, i: u32) -> &[T; N];
    /// Hints that the `N` elements from `i` on will be read before long; may be beyond the end. Does nothing on a device, and on
    /// processors for which Rust has no such instruction.
    fn prefetch<const N: usize>(&self, i: u32);
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
    fn window<const N: usize>(&self, i: u32) -> &[T; N] {
        let i = i as usize;
        #[cfg(not(feature = "device"))]
        if i + N > self.len() {
            beyond(N, i, self.len());
        }
        // SAFETY: in range (checked above); on the device as in `at_ref`.
        unsafe { &*self.as_ptr().add(i).cast() }
    }

    #[inline(always)]
    fn prefetch<const N: usize>(&self, i: u32) {
        #[cfg(all(not(feature = "device"), target_arch = "x86_64"))]
        {
            use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            let first = self.as_ptr().wrapping_add(i as usize).cast::<i8>();
            let mut at = 0;
            while at < size_of::<[T; N]>() {
                // SAFETY: a hint reads nothing and never faults, wherever it points.
                unsafe { _mm_prefetch::<_MM_HINT_T0>(first.wrapping_add(at)) };
                at += CACHE_LINE;
            }
        }
        #[cfg(any(feature = "device", not(target_arch = "x86_64")))]
        let _ = i;
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

/// Bytes that one prefetch brings.
#[cfg(all(not(feature = "device"), target_arch = "x86_64"))]
const CACHE_LINE: usize = 64;

/// Out of line and by value, so that a loop around [`At::window`] keeps nothing in memory for the message.
#[cfg(not(feature = "device"))]
#[cold]
#[inline(never)]
fn beyond(count: usize, from: usize, len: usize) -> ! {
    panic!("{count} elements from {from} on of {len}")
}

#[cfg(test)]
mod tests {
    use super::At;

    #[test]
    fn both_kinds_of_index_name_the_same_element() {
        let items = [3u32, 1, 4];
        assert_eq!(items.at(2u32), items.at(2usize));
        assert_eq!(items.at_ref(0u32), &3);
    }

    #[test]
    fn the_tail_at_the_length_is_empty() {
        assert!([1u32, 2].tail(2u32).is_empty());
    }

    #[test]
    #[should_panic(expected = "range start index 3")]
    fn a_tail_beyond_the_length_panics() {
        [1u32, 2].tail(3u32);
    }

    #[test]
    fn a_window_has_what_it_says() {
        assert_eq!([1u32, 2, 3].window::<2>(1), &[2, 3]);
    }

    #[test]
    #[should_panic(expected = "2 elements from 2 on of 3")]
    fn a_window_beyond_the_length_panics() {
        [1u32, 2, 3].window::<2>(2);
    }

    #[test]
    fn a_prefetch_may_point_anywhere() {
        [1u32, 2].prefetch::<2>(0);
        [1u32, 2].prefetch::<40>(u32::MAX);
    }

    #[test]
    #[should_panic(expected = "index out of bounds")]
    fn reading_out_of_range_panics() {
        [1u32, 2].at(2u32);
    }

    #[test]
    #[should_panic(expected = "index out of bounds")]
    fn writing_out_of_range_panics() {
        [1u32, 2].put(u32::MAX, 0);
    }
}
