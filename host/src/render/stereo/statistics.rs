//! What a second view was made of: 001's and 000's counts, and what they save. No pass pays for them: they are read from the map of
//! sources and from the first view's hits, on the host.

use super::Plan;
use super::overlap::{Overlap, lemma_bound};
use super::plan_report::PlanReport;
use super::savings::Surfaces;
use crate::render::band::Pair;
use crate::render::{RayTotals, SceneData};
use parallax_shared::effects::Effects;
use parallax_shared::layout::RayCounts;
use parallax_shared::stereo::source::{self, BAD, GAP, GUIDED, HOLE, REUSED, UNGUIDED, UNSAMPLED, VERIFIED};
use serde::Serialize;
use std::ops::AddAssign;

/// Counts of a band or of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StereoStatistics {
    /// Pixels of the second view, or points that were sampled where a pixel has several.
    pub pixels: u64,
    /// Pixels that the first view shows, without a ray.
    pub reused: u64,
    /// Pixels that the first view shows, verified by a ray.
    pub verified: u64,
    /// Traced pixels on which nothing lands (000: missed pixels).
    pub holes: u64,
    /// Traced pixels between neighbouring columns that land apart (001: bad pixels).
    pub gaps: u64,
    /// Pixels whose verifying ray met something nearer (000: bad pixels).
    pub bad: u64,
    /// Traced pixels for which the first view was a hint (`guided`).
    pub guided: u64,
    /// Traced pixels of `guided` without a hint.
    pub unguided: u64,
    /// What lands where.
    pub overlap: Overlap,
    /// The smallest `t` in the first view: 1 / r of Lemma 1. `None` when it shows nothing.
    pub nearest_t: Option<f32>,
    /// Rays of the first view.
    pub first_rays: RayTotals,
    /// Rays of the second one.
    pub second_rays: RayTotals,
}

impl StereoStatistics {
    /// Those of a band; `None` when the second view was not made from the first (`naive`, `ideal`).
    pub fn of_band(pair: &Pair) -> Option<Self> {
        let inferred = pair.inferred.as_ref()?;
        let count = |kind| inferred.source.iter().filter(|&&word| source::kind(word) == kind).count() as u64;
        let first = &pair.source;
        let nearest_t = first.hits.iter().map(|hit| hit.t).filter(|t| t.is_finite()).min_by(f32::total_cmp);
        Some(Self {
            pixels: inferred.source.len() as u64 - count(UNSAMPLED),
            reused: count(REUSED),
            verified: count(VERIFIED),
            holes: count(HOLE),
            gaps: count(GAP),
            bad: count(BAD),
            guided: count(GUIDED),
            unguided: count(UNGUIDED),
            overlap: inferred.overlap,
            nearest_t,
            first_rays: totals(first.rays()),
            second_rays: totals(pair.second.rays()),
        })
    }

    /// Pixels for which a ray found the surface that they show.
    pub fn traced(&self) -> u64 {
        self.holes + self.gaps + self.bad + self.guided + self.unguided
    }

    /// 001's M: the traced share of the pixels.
    pub fn m(&self) -> f64 {
        share(self.traced(), self.pixels)
    }

    /// Rays that verified a candidate, or found it hidden.
    pub fn verification_rays(&self) -> u64 {
        self.verified + self.bad
    }
}

/// a / b; 0 of nothing.
fn share(a: u64, b: u64) -> f64 {
    if b == 0 { 0.0 } else { a as f64 / b as f64 }
}

fn totals<'a>(stages: impl Iterator<Item = &'a [RayCounts]>) -> RayTotals {
    stages.fold(RayTotals::default(), |mut all, stage| {
        all += stage;
        all
    })
}

impl AddAssign for StereoStatistics {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.reused += other.reused;
        self.verified += other.verified;
        self.holes += other.holes;
        self.gaps += other.gaps;
        self.bad += other.bad;
        self.guided += other.guided;
        self.unguided += other.unguided;
        self.overlap += other.overlap;
        self.nearest_t = [self.nearest_t, other.nearest_t].into_iter().flatten().min_by(f32::total_cmp);
        self.first_rays += other.first_rays;
        self.second_rays += other.second_rays;
    }
}

/// The statistics of a picture as reports have them, beside what the papers' formulas say.
#[derive(Clone, Debug, Serialize)]
pub struct StereoReport {
    /// How it was to be made.
    #[serde(flatten)]
    pub plan: PlanReport,
    /// See [`StereoStatistics`].
    pub reused: u64,
    /// See [`StereoStatistics`].
    pub verified: u64,
    /// See [`StereoStatistics`].
    pub holes: u64,
    /// See [`StereoStatistics`].
    pub gaps: u64,
    /// See [`StereoStatistics`].
    pub bad: u64,
    /// Pixels on which more than one source lands.
    pub overlapped: u64,
    /// The most sources on one pixel.
    pub largest_overlap: u32,
    /// How many there can be at most (Lemma 1 of 000, with rounding).
    pub lemma_bound: u32,
    /// The distance to the zero-parallax plane over that of the nearest surface, in depth.
    pub r: f64,
    /// The traced share of the pixels.
    pub m: f64,
    /// Rays for verification; those that found something are among the primary rays too.
    pub verification_rays: u64,
    /// Rays that the second view needed less than the first.
    pub rays_saved: RaysSaved,
    /// What the scene's surfaces make rays do.
    pub surfaces: Surfaces,
    /// 001's savings in the worst case for such surfaces, with this M.
    pub worst_case_saved_percent: f64,
    /// What was saved of all rays.
    pub saved_percent: f64,
}

/// How many rays of each kind the second view needed less than the first; negative if it needed more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RaysSaved {
    /// From the eye.
    pub primary: i64,
    /// To lights.
    pub shadow: i64,
    /// In mirror direction.
    pub reflected: i64,
    /// Through a surface.
    pub refracted: i64,
}

impl StereoReport {
    /// What the picture of `data` tells that was made as `plan` says.
    pub fn new(data: &SceneData, plan: &Plan, statistics: &StereoStatistics) -> Self {
        let StereoStatistics { reused, verified, holes, gaps, bad, overlap, nearest_t, .. } = *statistics;
        let (p, surfaces) = (plan.of_picture(), surfaces(data.effects));
        let (first, second) = (&statistics.first_rays, &statistics.second_rays);
        let less = |first: u64, second: u64| first as i64 - second as i64;
        Self {
            plan: PlanReport::new(data, plan),
            reused,
            verified,
            holes,
            gaps,
            bad,
            overlapped: overlap.overlapped,
            largest_overlap: overlap.largest,
            lemma_bound: lemma_bound(p.interaxial_px, nearest_t),
            r: nearest_t.map_or(0.0, |t| 1.0 / f64::from(t)),
            m: statistics.m(),
            verification_rays: statistics.verification_rays(),
            rays_saved: RaysSaved {
                primary: less(first.primary, second.primary),
                shadow: less(first.shadow, second.shadow),
                reflected: less(first.reflected, second.reflected),
                refracted: less(first.refracted, second.refracted),
            },
            surfaces,
            worst_case_saved_percent: surfaces.worst_case_percent(
                statistics.m(),
                data.info.lights,
                data.info.max_depth + 1,
            ),
            saved_percent: 100.0 * (1.0 - share(second.all(), first.all())),
        }
    }
}

/// What surfaces of a scene with these effects make rays do at most; materials without a diffuse part are not told apart.
fn surfaces(effects: Effects) -> Surfaces {
    match (effects.has(Effects::REFLECTION), effects.has(Effects::REFRACTION)) {
        (false, false) => Surfaces::Diffuse,
        (true, true) => Surfaces::DiffuseWithBoth,
        _ => Surfaces::DiffuseWithOne,
    }
}
