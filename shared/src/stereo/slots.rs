//! The 3D buffer (000 §3.1.2.1): each pixel has slots for the sources that land on it, of which the nearest is then chosen.
//!
//! Lemma 1, corrected. Let d / r be the distance of the nearest surface (000 says "r away"). Then t ≥ 1 / r, and the disparities lie
//! in [e (1 − r), e], an interval of length r·e. The sources of one pixel have different shifts; whole numbers to which such an
//! interval is rounded span at most ⌈r·e⌉, so there are at most ⌈r·e⌉ + 1 of them (rounding adds one to the lemma), and their columns
//! differ by at most ⌈r·e⌉. Slot `x mod depth` of so many slots is therefore free of collisions.
//!
//! Departures: 000 Alg. 2 resets slots that other invocations fill, and chooses the slot by the source pixel's index in the whole
//! picture; here a pass of its own empties them, and columns count. With fewer slots than the lemma asks for, a maximum keeps the
//! nearest of the sources that share one.

use super::reprojection::{EMPTY, key};
use super::run::{Run, is_inside, landing, overwrite, raise};
use crate::layout::{Hit, Reprojection};
use core::sync::atomic::AtomicU32;
use kernel_api::At;

/// Puts the columns of a run into slots of the pixels where they land, and raises `gaps` between them.
#[inline(always)]
pub fn put(run: &Run<'_>, hits: &[Hit], slots: &[AtomicU32], gaps: &[AtomicU32]) {
    let (depth, exclusive) = (run.p.depth, run.p.exclusive != 0);
    if !run.is_empty() && depth > 0 {
        let targets = run.targets(hits);
        let target = |x| targets.at(x - run.first);
        run.walk(
            || run.target_before(hits),
            target,
            gaps,
            raise,
            |pixel, x| {
                let slot = slots.at_ref(pixel * depth + x % depth);
                if exclusive { overwrite(slot, key(x)) } else { raise(slot, key(x)) }
            },
        );
    }
}

/// The nearest of the sources in the slots of a pixel: its key, or [`EMPTY`].
#[inline(always)]
pub fn nearest(slots: &[u32], pixel: u32, depth: u32) -> u32 {
    let (mut nearest, mut slot) = (EMPTY, 0);
    while slot < depth {
        let key = slots.at(pixel * depth + slot);
        nearest = if key > nearest { key } else { nearest };
        slot += 1;
    }
    nearest
}

/// The smallest and the largest shift of the sources of `row` that land in the picture; [0, −1] when none does.
///
/// Sources of one pixel differ by no more columns than their shifts do, so that largest − smallest + 1 slots are enough.
#[inline(always)]
pub fn shift_range(p: &Reprojection, hits: &[Hit], row: u32) -> [i32; 2] {
    let (mut range, mut x) = ([0, -1], 0);
    while x < p.width {
        let target = landing(p, hits, x, row);
        if is_inside(p, target) {
            range = including(range, target - x as i32);
        }
        x += 1;
    }
    range
}

/// The range with a shift.
#[inline(always)]
fn including([low, high]: [i32; 2], shift: i32) -> [i32; 2] {
    if low > high {
        [shift, shift]
    } else {
        [if shift < low { shift } else { low }, if shift > high { shift } else { high }]
    }
}
