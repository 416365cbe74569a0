//! The tables of a row by one walk from right to left, in which the first event on a pixel wins: 001's other variant, which can
//! compute colours while it walks, as nothing is overwritten.
//!
//! Departure: 001 sets its flag HIT on gaps too, and would then never trace them. A pixel needs a third state, which is here the
//! table of gaps: the result is that of [`scanline`](super::scanline).

use super::reprojection::{EMPTY, key, pixel};
use super::run::{gap, is_inside, landing, last_target};
use crate::layout::{Hit, Reprojection};
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use kernel_api::At;

/// Fills `row` of both tables, which must be empty and belong to this invocation alone.
#[inline(always)]
pub fn scanline_rtl(p: &Reprojection, hits: &[Hit], candidates: &[AtomicU32], gaps: &[AtomicU32], row: u32) {
    let (mut target, mut x, mut is_last) = (p.width as i32, p.width, false);
    while !is_last {
        if is_inside(p, target) {
            fill(candidates.at_ref(pixel(p, target as u32, row)), key(x));
        }
        let (columns, before) = last_target(x, |x| landing(p, hits, x, row));
        let (mut cleared, end) = gap(p, before, target);
        while cleared < end {
            fill(gaps.at_ref(pixel(p, cleared as u32, row)), key(x));
            cleared += 1;
        }
        is_last = columns == 0;
        target = before;
        x = columns.wrapping_sub(1);
    }
}

/// Fills an entry that is empty.
#[inline(always)]
fn fill(entry: &AtomicU32, key: u32) {
    if entry.load(Relaxed) == EMPTY {
        entry.store(key, Relaxed);
    }
}
