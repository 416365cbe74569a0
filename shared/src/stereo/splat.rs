//! The tables by maxima, whatever the order in which columns come: 000 §3.1.2.2 ("atomic"), and 003 §5.4.3 (the gather table in one
//! pass, scatter positions computed while writing).
//!
//! Departures: both compare depths, this compares columns, which orders the sources of a pixel in the same way (see
//! [`run`](super::run)) and cannot tie. 000's prose asks for the maximum of z, which is the farthest where z points into the scene.

use super::reprojection::key;
use super::run::Run;
use crate::layout::Hit;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use kernel_api::At;

/// Lets the columns of a run land: raises `candidates` where they do and `gaps` between them.
#[inline(always)]
pub fn splat(run: &Run<'_>, hits: &[Hit], candidates: &[AtomicU32], gaps: &[AtomicU32]) {
    if !run.is_empty() {
        let targets = run.targets(hits);
        run.walk(
            run.target_before(hits),
            |x| targets.at(x - run.first),
            gaps,
            |pixel, x| {
                candidates.at_ref(pixel).fetch_max(key(x), Relaxed);
            },
        );
    }
}
