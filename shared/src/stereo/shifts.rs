//! The tables in two passes: the scatter table first, then what lands where (003 §5.4.2).

use super::reprojection::key;
use super::run::{Run, last_target, raise};
use crate::layout::Hit;
use core::sync::atomic::AtomicU32;
use kernel_api::{At, Out};

/// Writes where the columns of a run land, plus 1: 0 … width + 1, of which the ends are outside of the picture; the largest number for
/// a column that was not sampled.
#[inline(always)]
pub fn shifts(run: &Run<'_>, hits: &[Hit], scattered: Out<u32>) {
    if !run.is_empty() {
        let targets = run.targets(hits);
        let mut x = run.first;
        while x < run.end {
            scattered.put(run.pixel(x), (targets.at(x - run.first) + 1) as u32);
            x += 1;
        }
    }
}

/// As [`splat`](super::splat::splat), with the targets that [`shifts`] has written.
#[inline(always)]
pub fn splat(run: &Run<'_>, scattered: &[u32], candidates: &[AtomicU32], gaps: &[AtomicU32]) {
    if !run.is_empty() {
        let target = |x| scattered.at(run.pixel(x)) as i32 - 1;
        let before = || last_target(run.first, target).1;
        run.walk(before, target, gaps, raise, |pixel, x| raise(candidates.at_ref(pixel), key(x)));
    }
}
