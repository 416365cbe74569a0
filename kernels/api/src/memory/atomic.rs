//! Atomic words.

use core::sync::atomic::{AtomicI32, AtomicU32};

/// The same words as signed numbers.
///
/// ```
/// use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
///
/// let words = [AtomicU32::new(u32::MAX)];
/// kernel_api::memory::signed(&words)[0].fetch_add(3, Relaxed);
/// assert_eq!(words[0].load(Relaxed), 2);
/// ```
#[inline]
pub fn signed(words: &[AtomicU32]) -> &[AtomicI32] {
    // SAFETY: both are one word with the size and alignment of a `u32` and the same bit validity, and both are only ever accessed
    // atomically.
    unsafe { core::slice::from_raw_parts(words.as_ptr().cast(), words.len()) }
}
