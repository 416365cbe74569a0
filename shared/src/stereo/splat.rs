//! The tables by maxima, whatever the order in which columns come: 000 §3.1.2.2 ("atomic"), and 003 §5.4.3 (the gather table in one
//! pass, scatter positions computed while writing).
//!
//! Departures: both compare depths, this compares columns, which orders the sources of a pixel in the same way (see
//! [`run`](super::run)) and cannot tie. 000's prose asks for the maximum of z, which is the farthest where z points into the scene.

use super::reprojection::key;
use super::run::{Run, raise};
use crate::layout::Hit;
use core::sync::atomic::AtomicU32;
use kernel_api::At;

/// Lets the columns of a run land: raises `candidates` where they do and `gaps` between them.
#[inline(always)]
pub fn splat(run: &Run<'_>, hits: &[Hit], candidates: &[AtomicU32], gaps: &[AtomicU32]) {
    if !run.is_empty() {
        let targets = run.targets(hits);
        let target = |x| targets.at(x - run.first);
        run.walk(
            || run.target_before(hits),
            target,
            gaps,
            raise,
            |pixel, x| {
                raise(candidates.at_ref(pixel), key(x));
            },
        );
    }
}
