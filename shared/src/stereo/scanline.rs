//! The tables of a row by one walk from left to right: 001's algorithm as it is, and 000 Alg. 1 (Es and İşler: rows in parallel).
//!
//! Departures from 000 Alg. 1: its test `oldR − rep > 1` is the other way round, it marks `I_ri` where `I_r,rep` is meant, and like
//! 001 it lets a target below 0 through (see [`run`](super::run)). 003 fig. 5.4 clears from `prev` on, which is a valid pixel.

use super::reprojection::{NOWHERE, key};
use super::run::{Run, overwrite};
use crate::layout::{Hit, Reprojection};
use core::sync::atomic::AtomicU32;
use kernel_api::At;

/// Fills `row` of both tables, which must be empty and belong to this invocation alone. Keys grow on the way, so the last store to a
/// pixel is the largest one.
#[inline(always)]
pub fn scanline(p: &Reprojection, hits: &[Hit], candidates: &[AtomicU32], gaps: &[AtomicU32], row: u32) {
    let (mut before, mut number) = (-1, 0);
    let mut run = Run::new(p, number, row);
    while !run.is_empty() {
        let targets = run.targets(hits);
        let target = |x| targets.at(x - run.first);
        let last = run.walk(
            || before,
            target,
            gaps,
            overwrite,
            |pixel, x| {
                overwrite(candidates.at_ref(pixel), key(x));
            },
        );
        before = if last == NOWHERE { before } else { last };
        number += 1;
        run = Run::new(p, number, row);
    }
}
