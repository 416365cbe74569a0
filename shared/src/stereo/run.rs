//! Eight columns of a row at a time: what the parallel producers of the tables have in common.
//!
//! 001 walks a row from left to right: source column i first clears the pixels between the target of column i − 1 and its own, then
//! writes its own. The last event on a pixel decides. With i + 1 as the key of both events no order is needed: a pixel is reused iff
//! the largest key of a write there exceeds the largest key of a clearing. Of the sources of one pixel, that with the largest column
//! has the smallest shift, hence the smallest `t`: it is the nearest one.
//!
//! Columns that were not sampled (001's adaptive sampling leaves most of a row out) neither land nor end a gap: between two sampled
//! neighbours what lands is questionable, whatever their distance in the source.
//!
//! The picture's edges are columns like others: column −1 lands on −1 and column w on w, so that the strip before the first target
//! and that behind the last one are gaps (001's initialisation and its last-pixel rule in one).

use super::reprojection::{NOWHERE, is_sampled, key, pixel, target};
use crate::layout::{Hit, Reprojection};
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use kernel_api::At;

/// Columns of a run: on a CPU their targets are computed in eight lanes.
pub const RUN: u32 = 8;

/// Something for each column of a run, or for each that there would be if the row went on.
pub type Lanes = [i32; RUN as usize];

/// A run of columns of a row of the source. Columns are mirrored ones, as everywhere in this module.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// How the band is reprojected.
    pub p: &'a Reprojection,
    /// Row of the band.
    pub row: u32,
    /// The first column.
    pub first: u32,
    /// The one behind the last.
    pub end: u32,
}

impl<'a> Run<'a> {
    /// Run `number` of `row`; without columns when there is no such run.
    #[inline(always)]
    pub fn new(p: &'a Reprojection, number: u32, row: u32) -> Self {
        let there = row < p.rows && number * RUN < p.width;
        let first = if there { number * RUN } else { p.width };
        Self { p, row, first, end: if p.width - first < RUN { p.width } else { first + RUN } }
    }

    /// Whether there is nothing to do.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.first == self.end
    }

    /// Memory index of column `x`.
    #[inline(always)]
    pub fn pixel(&self, x: u32) -> u32 {
        pixel(self.p, x, self.row)
    }

    /// Where the columns land; of no meaning behind the row's end.
    #[inline(always)]
    pub fn targets(&self, hits: &[Hit]) -> Lanes {
        let t = self.depths(hits);
        let mut targets = [0; RUN as usize];
        for lane in 0..RUN as usize {
            targets[lane] = target(self.p, t[lane], self.first + lane as u32);
        }
        if self.p.sparse != 0 {
            for lane in 0..RUN as usize {
                targets[lane] = if is_sampled(t[lane]) { targets[lane] } else { NOWHERE };
            }
        }
        targets
    }

    /// `t` of the columns, and zeros behind the row's end. A whole run is read without a check for each lane.
    #[inline(always)]
    fn depths(&self, hits: &[Hit]) -> [f32; RUN as usize] {
        let mut t = [0.0; RUN as usize];
        if self.end - self.first == RUN {
            let (from, flip) = match self.p.mirrored {
                0 => (self.first, 0),
                _ => (self.end - 1, RUN as usize - 1),
            };
            let hits: &[Hit; RUN as usize] = hits.window(self.pixel(from));
            for lane in 0..RUN as usize {
                t[lane] = hits[lane ^ flip].t;
            }
        } else {
            let mut x = self.first;
            while x < self.end {
                t.put(x - self.first, hits.at_ref(self.pixel(x)).t);
                x += 1;
            }
        }
        t
    }

    /// Where the last sampled column before the run lands; −1 when there is none.
    #[inline(always)]
    pub fn target_before(&self, hits: &[Hit]) -> i32 {
        last_target(self.first, |x| landing(self.p, hits, x, self.row)).1
    }

    /// Calls `land(pixel, x)` for each sampled column `x` of the run that lands in the picture, and `set(entry, key)` for each entry of
    /// `gaps` between the targets: of column x, `target(x)`, and `before()` of the column before the run. Returns the last target;
    /// [`NOWHERE`] if no column of the run was sampled and the row goes on: then there is nothing to do, and `before` is not asked.
    ///
    /// 001's and 000's pseudocode guard a target by `j < w` alone; in front of the zero-parallax plane j < 0 occurs too.
    #[inline(always)]
    pub fn walk(
        &self,
        before: impl Fn() -> i32,
        target: impl Fn(u32) -> i32,
        gaps: &[AtomicU32],
        set: impl Fn(&AtomicU32, u32),
        land: impl Fn(u32, u32),
    ) -> i32 {
        let (mut x, is_sparse) = (self.first, self.p.sparse != 0);
        while is_sparse && x < self.end && target(x) == NOWHERE {
            x += 1;
        }
        if x == self.end && self.end < self.p.width {
            return NOWHERE;
        }
        let mut before = before();
        while x < self.end {
            let target = target(x);
            if !is_sparse || target != NOWHERE {
                self.mark(before, target, |pixel| set(gaps.at_ref(pixel), key(x)));
                if is_inside(self.p, target) {
                    land(self.pixel(target as u32), x);
                }
                before = target;
            }
            x += 1;
        }
        if self.end == self.p.width {
            self.mark(before, self.p.width as i32, |pixel| set(gaps.at_ref(pixel), key(self.end)));
        }
        before
    }

    /// Calls `set` for the pixels between two targets.
    #[inline(always)]
    fn mark(&self, before: i32, target: i32, set: impl Fn(u32)) {
        let (mut x, end) = gap(self.p, before, target);
        while x < end {
            set(self.pixel(x as u32));
            x += 1;
        }
    }
}

/// Raises an entry, whoever else does.
#[inline(always)]
pub fn raise(entry: &AtomicU32, key: u32) {
    entry.fetch_max(key, Relaxed);
}

/// Overwrites an entry of an invocation whose keys grow.
#[inline(always)]
pub fn overwrite(entry: &AtomicU32, key: u32) {
    entry.store(key, Relaxed);
}

/// Where column `x` of `row` lands; column w, which there is not, on w.
#[inline(always)]
pub fn landing(p: &Reprojection, hits: &[Hit], x: u32, row: u32) -> i32 {
    if x >= p.width {
        return p.width as i32;
    }
    let t = hits.at_ref(pixel(p, x, row)).t;
    if p.sparse == 0 || is_sampled(t) { target(p, t, x) } else { NOWHERE }
}

/// How many columns there are up to the last one before `end` that was sampled, and where it lands: 0 and −1 when none was.
#[inline(always)]
pub fn last_target(end: u32, target: impl Fn(u32) -> i32) -> (u32, i32) {
    let mut columns = end;
    while columns > 0 {
        let last = target(columns - 1);
        if last != NOWHERE {
            return (columns, last);
        }
        columns -= 1;
    }
    (0, -1)
}

/// Whether a target is in the picture; −1, as a number without a sign, is not.
#[inline(always)]
pub fn is_inside(p: &Reprojection, target: i32) -> bool {
    (target as u32) < p.width
}

/// The gap between two targets: its first column and the one behind its last. Inclusive gaps that are any have their right target
/// too (001's remedy for ghosts of several rays a pixel: "all pixels from the one after the first through the second").
#[inline(always)]
pub fn gap(p: &Reprojection, before: i32, target: i32) -> (i32, i32) {
    let first = before + 1;
    let inclusive = p.inclusive != 0 && first < target && target < p.width as i32;
    (first, target + inclusive as i32)
}
