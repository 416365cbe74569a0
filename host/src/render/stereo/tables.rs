//! The tables of candidates and gaps, by each method's passes.

use super::super::method::{Depth, Method, StereoOptions};
use super::super::renderer::Stages;
use super::overlap::lemma_bound;
use super::{Plan, unseen};
use crate::backend::{Backend, BackendError};
use crate::render::SceneData;
use kernel_api::Buffer;
use parallax_kernels::stereo::scanline::Scanline;
use parallax_kernels::stereo::scanline_rtl::ScanlineRtl;
use parallax_kernels::stereo::shifts::{Shifts, SplatShifts};
use parallax_kernels::stereo::slots::{NearestSlot, ShiftRange, Slots};
use parallax_kernels::stereo::splat::Splat;
use parallax_kernels::stereo::tables::Clear;
use parallax_shared::layout::{Hit, Reprojection, View};
use parallax_shared::stereo::run::RUN;

/// How many slots a pixel of the picture `moved` has before the source is known: 0 for methods without, 1 where the source will tell.
pub fn depth(data: &SceneData, options: &StereoOptions, moved: &View) -> u32 {
    let View { width, interaxial_px, .. } = *moved;
    match (options.method, options.depth) {
        (Method::Buffer, Depth::Lemma) => {
            lemma_bound(interaxial_px, unseen::nearest(data, options.first.eyes()[0])).min(width)
        }
        (Method::Buffer, Depth::Adaptive) => 1,
        (Method::Buffer, Depth::Fixed(depth)) => depth.get().min(width),
        _ => 0,
    }
}

/// Whether the slots are so many that no two sources share one.
pub fn is_exclusive(options: &StereoOptions) -> bool {
    !matches!(options.depth, Depth::Fixed(_))
}

/// The tables, and what a method needs to fill them.
#[derive(Clone, Copy)]
pub struct TableBuffers {
    pub candidates: Buffer<u32>,
    pub gaps: Buffer<u32>,
    /// Of `gather-2`.
    targets: Option<Buffer<u32>>,
    /// Of `buffer`, unless the source tells how many.
    slots: Option<Buffer<u32>>,
}

impl TableBuffers {
    /// Tables for a band.
    pub fn create<B: Backend>(backend: &mut B, plan: &Plan, pixels: usize) -> Result<Self, BackendError> {
        let StereoOptions { method, depth, .. } = plan.options;
        let fixed = method == Method::Buffer && depth != Depth::Adaptive;
        let slots = pixels * plan.of_picture().depth as usize;
        Ok(Self {
            candidates: backend.create("candidates", pixels)?,
            gaps: backend.create("gaps", pixels)?,
            targets: (method == Method::Gather2).then(|| backend.create("targets", pixels)).transpose()?,
            slots: fixed.then(|| backend.create("slots", slots)).transpose()?,
        })
    }

    /// Gives the memory back.
    pub fn release<B: Backend>(self, backend: &mut B) {
        [Some(self.candidates), Some(self.gaps), self.targets, self.slots]
            .into_iter()
            .flatten()
            .for_each(|buffer| backend.release(buffer));
    }
}

/// Fills the tables of a band from the source's `hits`. Returns the reprojection with the number of slots that were used.
pub fn fill<B: Backend>(
    plan: &Plan,
    tables: &TableBuffers,
    p: Reprojection,
    hits: Buffer<Hit>,
    stages: &mut Stages<'_, '_, B>,
) -> Result<Reprojection, BackendError> {
    let TableBuffers { candidates, gaps, .. } = *tables;
    let runs = [p.width.div_ceil(RUN), p.rows, 1];
    clear(gaps, stages)?;
    if plan.options.method != Method::Buffer {
        clear(candidates, stages)?;
    }
    match plan.options.method {
        Method::Naive | Method::Ideal => {}
        Method::Scanline => {
            stages.run_over(&Scanline { p, lines: p.rows, hits, candidates, gaps }, [1, 1, 1])?;
        }
        Method::ScanlineRtl => {
            stages.run_over(&ScanlineRtl { p, lines: p.rows, hits, candidates, gaps }, [1, 1, 1])?;
        }
        Method::EsIsler => {
            stages.run_over(&Scanline { p, lines: 1, hits, candidates, gaps }, [p.rows, 1, 1])?;
        }
        Method::Gather1 | Method::Atomic | Method::Guided => {
            stages.run_over(&Splat { p, hits, candidates, gaps }, runs)?
        }
        Method::Gather2 => {
            if let Some(targets) = tables.targets {
                stages.run_over(&Shifts { p, hits, targets }, runs)?;
                stages.run_over(&SplatShifts { p, targets, candidates, gaps }, runs)?;
            }
        }
        Method::Buffer => return by_slots(tables, p, hits, stages),
    }
    Ok(p)
}

fn clear<B: Backend>(table: Buffer<u32>, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
    stages.run_over(&Clear { table }, [table.len.div_ceil(RUN), 1, 1])
}

fn by_slots<B: Backend>(
    tables: &TableBuffers,
    mut p: Reprojection,
    hits: Buffer<Hit>,
    stages: &mut Stages<'_, '_, B>,
) -> Result<Reprojection, BackendError> {
    let TableBuffers { candidates, gaps, slots, .. } = *tables;
    let (slots, is_own) = match slots {
        Some(slots) => (slots, false),
        None => {
            p.depth = depth_of_hits(p, hits, stages)?;
            let pixels = p.width as usize * p.rows as usize;
            (stages.backend().create("slots", pixels * p.depth as usize)?, true)
        }
    };
    let result = (|| {
        clear(slots, stages)?;
        stages.run_over(&Slots { p, hits, slots, gaps }, [p.width.div_ceil(RUN), p.rows, 1])?;
        stages.run_over(&NearestSlot { p, slots, candidates }, [p.width, p.rows, 1])
    })();
    if is_own {
        stages.backend().release(slots);
    }
    result.map(|()| p)
}

/// The slots that the hits of a band need: their shifts differ by less.
fn depth_of_hits<B: Backend>(
    p: Reprojection,
    hits: Buffer<Hit>,
    stages: &mut Stages<'_, '_, B>,
) -> Result<u32, BackendError> {
    let ranges = stages.backend().create("shift ranges", p.rows as usize)?;
    let shifts = stages.run_over(&ShiftRange { p, hits, ranges }, [p.rows, 1, 1]);
    let shifts = shifts.and_then(|()| stages.backend().read(ranges));
    stages.backend().release(ranges);
    Ok(shifts?.iter().map(|[low, high]| (high - low + 1).max(1) as u32).max().unwrap_or(1))
}
