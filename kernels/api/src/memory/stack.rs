//! An invocation's own stack.

use core::mem::MaybeUninit;

/// A bounded stack of an invocation's own; nothing is cleared when it is made.
///
/// ```
/// use kernel_api::Stack;
///
/// let mut stack = Stack::<u32, 2>::new();
/// assert!(stack.push(1) && stack.push(2));
/// assert!(!stack.push(3), "it is full");
/// assert_eq!(stack.pop(), Some(2));
/// ```
pub struct Stack<T, const N: usize> {
    items: [MaybeUninit<T>; N],
    len: u32,
}

impl<T: Copy, const N: usize> Stack<T, N> {
    /// An empty stack.
    #[inline(always)]
    #[allow(clippy::new_without_default)] // `Default` would promise a cheap copy of something that is `N` items large.
    pub fn new() -> Self {
        const { assert!(N <= u32::MAX as usize) };
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
            unsafe { self.items.as_mut_ptr().cast::<T>().add(self.len as usize).write(item) };
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
        Some(unsafe { self.items.as_ptr().cast::<T>().add(self.len as usize).read() })
    }

    /// Removes all items.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.len = 0;
    }
}

impl<T: Copy, const N: usize> Stack<T, N> {
    /// Empties the stack and hands it out with its length apart from its items: it can then live in a register, where the length of a
    /// [`Stack`] is loaded and stored with every item. For hot loops.
    #[inline(always)]
    pub fn open(&mut self) -> OpenStack<'_, T, N> {
        self.len = 0;
        OpenStack { items: &mut self.items, len: 0 }
    }
}

/// A [`Stack`] with its length apart; see [`Stack::open`].
pub struct OpenStack<'a, T, const N: usize> {
    items: &'a mut [MaybeUninit<T>; N],
    len: u32,
}

impl<T: Copy, const N: usize> OpenStack<'_, T, N> {
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

    /// As [`Stack::push`].
    #[inline(always)]
    pub fn push(&mut self, item: T) -> bool {
        let fits = (self.len as usize) < N;
        if fits {
            // SAFETY: `len < N`.
            unsafe { self.slot(self.len).write(item) };
            self.len += 1;
        }
        fits
    }

    /// As [`Stack::pop`].
    #[inline(always)]
    pub fn pop(&mut self) -> Option<T> {
        if self.len == 0 {
            return None;
        }
        self.len -= 1;
        // SAFETY: every item below `len` has been pushed since `open`, and `len <= N` always.
        Some(unsafe { self.slot(self.len).read() })
    }

    /// Puts `item` above the lowest `base` items, below those on top of which `precedes(theirs, item)` holds; `false` when the stack
    /// is full.
    #[inline(always)]
    pub fn insert(&mut self, base: u32, item: T, precedes: impl Fn(&T, &T) -> bool) -> bool {
        let mut at = self.len;
        let fits = self.push(item);
        while fits && at > base {
            // SAFETY: `at - 1 < at < len`, and every item below `len` has been pushed.
            let below = unsafe { self.slot(at - 1).read() };
            if !precedes(&below, &item) {
                break;
            }
            // SAFETY: as above.
            unsafe { self.slot(at).write(below) };
            at -= 1;
        }
        if fits {
            // SAFETY: `at < len`.
            unsafe { self.slot(at).write(item) };
        }
        fits
    }

    /// Where item `i` is. A pointer, so that an item of two words moves as two words (a `MaybeUninit` would as one of 64 bits, which
    /// devices may lack).
    ///
    /// # Safety
    /// `i < N`.
    #[inline(always)]
    unsafe fn slot(&mut self, i: u32) -> *mut T {
        // SAFETY: in range by the caller's promise.
        unsafe { self.items.as_mut_ptr().cast::<T>().add(i as usize) }
    }
}

#[cfg(test)]
mod tests {
    use super::Stack;

    #[test]
    fn the_last_pushed_comes_first() {
        let mut stack = Stack::<(u32, f32), 3>::new();
        assert!(stack.is_empty() && stack.pop().is_none());
        for k in 0..3 {
            assert!(stack.push((k, k as f32)));
        }
        assert_eq!(stack.pop(), Some((2, 2.0)));
        assert!(stack.push((7, 7.0)));
        assert_eq!(
            (stack.pop(), stack.pop(), stack.pop(), stack.pop()),
            (Some((7, 7.0)), Some((1, 1.0)), Some((0, 0.0)), None)
        );
    }

    #[test]
    fn a_full_stack_refuses_and_keeps_what_it_has() {
        let mut stack = Stack::<u32, 1>::new();
        assert!(stack.push(1) && !stack.push(2));
        assert_eq!((stack.len(), stack.pop()), (1, Some(1)));
    }

    #[test]
    fn an_inserted_item_goes_below_those_that_precede_it_but_not_below_the_base() {
        let mut memory = Stack::<u32, 5>::new();
        let mut stack = memory.open();
        for item in [1, 9, 4] {
            stack.push(item);
        }
        assert!(
            stack.insert(1, 6, |above, new| above < new) && stack.insert(1, 20, |above, new| above < new)
        );
        assert!(!stack.insert(0, 7, |_, _| true), "it is full");
        assert_eq!([(); 5].map(|()| stack.pop()), [4, 6, 9, 20, 1].map(Some));
    }

    #[test]
    fn a_cleared_stack_is_empty() {
        let mut stack = Stack::<u32, 2>::new();
        stack.push(1);
        stack.clear();
        assert_eq!(stack.pop(), None);
    }

    #[test]
    fn a_stack_for_nothing_holds_nothing() {
        assert!(!Stack::<u32, 0>::new().push(1));
    }
}
