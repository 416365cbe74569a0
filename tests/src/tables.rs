//! The tables that a second view is made from: by each pass that can make them, and by a literal sequential algorithm.

use parallax::backend::{Backend, BackendError};
use parallax_kernels::stereo::scanline::Scanline;
use parallax_kernels::stereo::scanline_rtl::ScanlineRtl;
use parallax_kernels::stereo::shifts::{Shifts, SplatShifts};
use parallax_kernels::stereo::slots::{NearestSlot, Slots};
use parallax_kernels::stereo::splat::Splat;
use parallax_kernels::stereo::tables::Clear;
use parallax_shared::camera;
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::reprojection::shift_px;
use parallax_shared::stereo::run::RUN;

/// What makes tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Producer {
    /// Maxima.
    Splat,
    /// A scatter table, then maxima.
    Shifts,
    /// A 3D buffer of so many slots; whether it is said that no two sources share one.
    Slots(u32, bool),
    /// All rows one after the other.
    Scanline,
    /// Rows in parallel.
    Lines,
    /// All rows one after the other, from right to left.
    RightToLeft,
}

/// Both tables of a band.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tables {
    /// The column, plus 1, of the nearest source that lands on each pixel; 0 for none.
    pub candidates: Vec<u32>,
    /// The right column, plus 1, of the last pair of columns between whose targets each pixel lies; 0 for none.
    pub gaps: Vec<u32>,
}

impl Producer {
    /// Makes the tables on `backend`, of which nothing is left there.
    ///
    /// # Errors
    /// Those of the backend.
    pub fn run<B: Backend>(
        self,
        backend: &mut B,
        p: Reprojection,
        source: &[Hit],
    ) -> Result<Tables, BackendError> {
        let hits = backend.upload("hits", source)?;
        let [candidates, gaps] = [empty(backend, source.len())?, empty(backend, source.len())?];
        let runs = [p.width.div_ceil(RUN), p.rows, 1];
        match self {
            Self::Splat => backend.run(&Splat { p, hits, candidates, gaps }, runs)?,
            Self::Shifts => {
                let targets = backend.create("targets", source.len())?;
                backend.run(&Shifts { p, hits, targets }, runs)?;
                backend.run(&SplatShifts { p, targets, candidates, gaps }, runs)?;
                backend.release(targets);
            }
            Self::Slots(depth, exclusive) => {
                let p = Reprojection { depth, exclusive: exclusive.into(), ..p };
                let slots = empty(backend, source.len() * depth as usize)?;
                backend.run(&Slots { p, hits, slots, gaps }, runs)?;
                backend.run(&NearestSlot { p, slots, candidates }, [p.width, p.rows, 1])?;
                backend.release(slots);
            }
            Self::Scanline => {
                backend.run(&Scanline { p, lines: p.rows, hits, candidates, gaps }, [1, 1, 1])?;
            }
            Self::Lines => backend.run(&Scanline { p, lines: 1, hits, candidates, gaps }, [p.rows, 1, 1])?,
            Self::RightToLeft => {
                backend.run(&ScanlineRtl { p, lines: p.rows, hits, candidates, gaps }, [1, 1, 1])?;
            }
        }
        let tables = Tables { candidates: backend.read(candidates)?, gaps: backend.read(gaps)? };
        backend.release(hits);
        backend.release(candidates);
        backend.release(gaps);
        Ok(tables)
    }
}

fn empty<B: Backend>(backend: &mut B, len: usize) -> Result<kernel_api::Buffer<u32>, BackendError> {
    let table = backend.create("table", len)?;
    backend.run(&Clear { table }, [table.len.div_ceil(RUN), 1, 1])?;
    Ok(table)
}

/// A band of `width` columns and `rows` rows, by `interaxial_px`, without any option.
pub fn reprojection(width: u32, rows: u32, interaxial_px: f32) -> Reprojection {
    Reprojection { width, rows, interaxial_px, checked_from: width, ..bytemuck::Zeroable::zeroed() }
}

/// What 001's algorithm does to a row when it is followed word by word.
pub struct Literal {
    /// What the tables should hold: of each pixel the last column that was written, the last pair that cleared it.
    pub tables: Tables,
    /// The column of the source whose colour stands in each pixel in the end; `None` where it must be traced.
    pub picture: Vec<Option<u32>>,
}

/// 001's algorithm on a picture that begins empty: each column, from left to right, first clears what lies between the last column's
/// target and its own, then overwrites its target. With `p.mirrored` from right to left.
pub fn literal(p: &Reprojection, hits: &[Hit]) -> Literal {
    let pixels = hits.len();
    let tables = Tables { candidates: vec![0; pixels], gaps: vec![0; pixels] };
    let mut literal = Literal { tables, picture: vec![None; pixels] };
    for row in 0..p.rows as i32 {
        let width = p.width as i32;
        let at = |x: i32| (row * width + if p.mirrored == 0 { x } else { width - 1 - x }) as usize;
        let mut last_target = -1;
        for x in 0..=width {
            let disparity = |x| camera::disparity_px(p.interaxial_px, hits[at(x)].t);
            let target = if x < width { x + shift_px(disparity(x)) } else { width };
            let is_separated = target - last_target > 1;
            for cleared in last_target + 1..target.min(width) {
                literal.clear(at(cleared), x);
            }
            if x < width && (0..width).contains(&target) {
                literal.write(at(target), x);
                if is_separated && p.inclusive != 0 {
                    literal.clear(at(target), x);
                }
            }
            // Where to the left of the picture does not matter.
            last_target = target.max(-1);
        }
    }
    literal
}

impl Literal {
    fn clear(&mut self, pixel: usize, column: i32) {
        self.picture[pixel] = None;
        self.tables.gaps[pixel] = column as u32 + 1;
    }

    fn write(&mut self, pixel: usize, column: i32) {
        self.picture[pixel] = Some(column as u32);
        self.tables.candidates[pixel] = column as u32 + 1;
    }
}
