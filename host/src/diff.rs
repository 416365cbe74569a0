//! Both backends, every stage, both views: the differential contract (DESIGN §4) as a function.
//!
//! The picture is rendered band by band on two backends and compared band by band, so that a picture of any
//! size needs the memory of a band.

use crate::backend::{Backend, Gpu, Profile};
use crate::compare::{Bound, Difference, Kind, Stage, StageReport, compare};
use crate::render::band::{Band, EYES, Pair, Values};
use crate::render::stereo::Plan;
use crate::render::stereo::second::Inferred;
use crate::render::{RenderError, Renderer, SceneData, StereoOptions};
use serde::Serialize;
use std::fmt;

/// What comparing two backends has shown.
#[derive(Clone, Debug, Serialize)]
pub struct Differential {
    /// Whether every stage passes.
    pub equal: bool,
    /// The profile whose bounds were applied.
    pub profile: &'static str,
    /// The GPU.
    pub adapter: String,
    /// Its driver.
    pub driver: String,
    /// The other side.
    pub reference: String,
    /// Every stage of every view, in the order in which they are computed.
    pub stages: Vec<StageReport>,
}

/// Renders a scene on `reference` and on `gpu` and compares every stage; the bounds are those of the profile
/// of `gpu`. `progress` is told how many of how many rows are done.
///
/// # Errors
/// When a backend fails. A difference is none.
pub fn against_gpu<B: Backend>(
    reference: &mut B,
    gpu: &mut Gpu,
    data: &SceneData,
    options: &StereoOptions,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Differential, RenderError> {
    let (profile, report) = (gpu.profile(), gpu.report().clone());
    let described = reference.describe();
    let stages = stages(reference, gpu, data, options, profile, progress)?;
    Ok(Differential {
        equal: !stages.is_empty() && stages.iter().all(|stage| stage.equal),
        profile: profile.name(),
        adapter: report.name,
        driver: report.driver,
        reference: described,
        stages,
    })
}

/// Compares every stage of both views of a scene on two backends.
///
/// # Errors
/// When a backend fails.
pub fn stages<L: Backend, R: Backend>(
    left: &mut L,
    right: &mut R,
    data: &SceneData,
    options: &StereoOptions,
    profile: Profile,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Vec<StageReport>, RenderError> {
    let plan = Plan::new(data, options, true)?;
    let height = data.views[0].height;
    let mut left = Renderer::new(left, data)?;
    let mut right = Renderer::new(right, data)?;
    let rows = left.suggested_rows(&plan).min(right.suggested_rows(&plan));
    let mut reports: [Vec<Compared>; 2] = Default::default();
    let eyes = options.first.eyes().map(|eye| EYES[eye]);
    for band in Band::of_picture(height, rows) {
        let (left, right) = (left.pair(&plan, band)?, right.pair(&plan, band)?);
        let source = (words_of(&left.source), words_of(&right.source));
        let second = (words_of_second(&left), words_of_second(&right));
        for ((reports, view), (left, right)) in reports.iter_mut().zip(eyes).zip([source, second]) {
            merge(reports, compare_words(view, profile, left, right));
        }
        progress(u64::from(band.first_row + band.rows), u64::from(height));
    }
    Ok(reports.into_iter().flatten().map(Compared::conclude).collect())
}

/// One stage's words and what they are.
struct Words {
    stage: &'static str,
    kind: Kind,
    components: usize,
    words: Vec<u32>,
}

impl Words {
    /// `N` words of each of `items`.
    fn of<T, const N: usize>(
        stage: &'static str,
        kind: Kind,
        items: &[T],
        words: impl Fn(&T) -> [u32; N],
    ) -> Self {
        Self { stage, kind, components: N, words: items.iter().flat_map(words).collect() }
    }
}

fn bits<const N: usize>(values: [f32; N]) -> [u32; N] {
    values.map(f32::to_bits)
}

/// Every stage of a band. [`Kind::AnyWord`] is used only where all ones mean something; the other words of
/// the same records tell there whether anything was written.
fn words_of(values: &Values) -> Vec<Words> {
    let (hits, surfaces) = (&values.hits, &values.surfaces);
    let rays =
        |stage, counts| Words::of(stage, Kind::Word, counts, |count| bytemuck::cast::<_, [u32; 4]>(*count));
    let mut stages = vec![
        Words::of("prim_id", Kind::AnyWord, hits, |hit| [hit.prim_id]),
        Words::of("t", Kind::FloatOrInfinity, hits, |hit| bits([hit.t])),
        Words::of("surface prim_id", Kind::AnyWord, surfaces, |s| [s.prim_id]),
        Words::of("position", Kind::Float, surfaces, |s| bits(s.position)),
        Words::of("u", Kind::Float, surfaces, |s| bits([s.uv[0]])),
        Words::of("v", Kind::Float, surfaces, |s| bits([s.uv[1]])),
        Words::of("normal", Kind::Float, surfaces, |s| bits(s.normal)),
        Words::of("shading normal", Kind::Float, surfaces, |s| bits(s.shading_normal)),
        Words::of("material", Kind::Word, surfaces, |s| [s.material]),
        Words::of("error", Kind::Float, surfaces, |s| bits([s.error])),
        Words::of("disparity", Kind::Float, surfaces, |s| bits([s.disparity])),
    ];
    if !values.shadow.is_empty() {
        let (components, words) = (values.shadow_words, values.shadow.clone());
        stages.push(Words { stage: "shadow", kind: Kind::AnyWord, components, words });
    }
    stages.extend([
        Words::of("local colour", Kind::Float, &values.local, |colour| bits(*colour)),
        rays("primary rays", &values.primary_rays[..]),
        rays("shadow rays", &values.shadow_rays[..]),
    ]);
    if let Some(bounced) = &values.bounced {
        stages.push(rays("bounced rays", &bounced.rays[..]));
    }
    stages.push(Words::of("colour", Kind::Float, values.colour(), |colour| bits(*colour)));
    stages
}

/// Every stage of a second view: how it was made, if it was made from the first, and what it shows.
fn words_of_second(pair: &Pair) -> Vec<Words> {
    let word = |stage, words: &[u32]| Words::of(stage, Kind::Word, words, |word| [*word]);
    let mut stages = Vec::new();
    if let Some(Inferred { candidates, gaps, source, .. }) = &pair.inferred {
        stages.extend([word("candidates", candidates), word("gaps", gaps), word("source", source)]);
    }
    stages.extend(words_of(&pair.second));
    stages
}

/// A stage of the bands so far, and the bound that it is held to.
struct Compared {
    bound: Bound,
    report: StageReport,
}

fn compare_words(view: &str, profile: Profile, left: Vec<Words>, right: Vec<Words>) -> Vec<Compared> {
    let pairs = left.into_iter().zip(right);
    let compared = |(left, right): (Words, Words)| {
        let Words { stage, kind, components, .. } = left;
        let bound = Bound::of(profile, kind);
        let stage = Stage { view, stage, kind, components, bound };
        Compared { bound, report: compare(&stage, &left.words, &right.words) }
    };
    pairs.map(compared).collect()
}

/// Adds the stages of a further band, which lies below, to those of the bands before.
fn merge(all: &mut Vec<Compared>, band: Vec<Compared>) {
    if all.is_empty() {
        *all = band;
        return;
    }
    for (all, band) in all.iter_mut().zip(band) {
        all.add(band.report);
    }
}

impl Compared {
    fn add(&mut self, band: StageReport) {
        let all = &mut self.report;
        let (before, added) = (all.elements as f64, band.elements as f64);
        let first = band.first_differing.map(|mut first| {
            first.index += all.elements;
            first
        });
        all.first_differing = all.first_differing.take().or(first);
        let squares = all.mean_squared_error * before + band.mean_squared_error * added;
        all.mean_squared_error = squares / (before + added);
        all.elements += band.elements;
        all.differing += band.differing;
        all.unwritten += band.unwritten;
        all.not_finite += band.not_finite;
        all.max_ulps = all.max_ulps.max(band.max_ulps);
        all.max_absolute = all.max_absolute.max(band.max_absolute);
        all.problem = all.problem.take().or(band.problem);
    }

    /// What holds for the whole view: the share of elements that may differ is one of all bands together.
    fn conclude(self) -> StageReport {
        let Self { bound, mut report } = self;
        let valid = report.problem.is_none() && report.unwritten == 0 && report.not_finite == 0;
        report.equal = valid && report.differing <= (bound.share * report.elements as f64) as usize;
        report
    }
}

impl fmt::Display for Differential {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "{} against {} ({}), {} profile",
            self.reference, self.adapter, self.driver, self.profile
        )?;
        writeln!(
            f,
            "  {:<6} {:<16} {:>10} {:>10}  first difference",
            "view", "stage", "elements", "differing"
        )?;
        for stage in &self.stages {
            let StageReport { view, stage: name, elements, differing, .. } = stage;
            writeln!(f, "  {view:<6} {name:<16} {elements:>10} {differing:>10}  {}", remark(stage))?;
        }
        writeln!(f, "{}", if self.equal { "equal" } else { "DIFFERENT" })
    }
}

/// What else is to be said of a stage: the first difference, or why it fails without one.
fn remark(stage: &StageReport) -> String {
    let mut remarks: Vec<String> = stage.problem.iter().cloned().collect();
    if let Some(Difference { index, component, left, right }) = &stage.first_differing {
        remarks.push(format!("[{index}].{component}: {left} and {right}"));
    }
    for (count, what) in [(stage.unwritten, "unwritten"), (stage.not_finite, "not finite")] {
        if count > 0 {
            remarks.push(format!("{count} {what}"));
        }
    }
    if stage.differing > 0 && stage.equal {
        remarks.push("within the bound".into());
    }
    remarks.join("; ")
}
