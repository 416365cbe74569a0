//! `parallax bench traversal`: the traversal beside obvhs' own ones and, with the feature `embree`, beside Embree 3.13.
//!
//! One thread, one process, the same rays for all, run in turn chunk by chunk, so that what disturbs one disturbs all; times are
//! medians over repetitions, and answers are checked against each other. Embree picks its AVX-512 kernels where the machine has it.
//!
//! obvhs is at a disadvantage here: it is compiled as this workspace compiles it, for the baseline and with glam's `scalar-math`, which
//! takes away the SSE2 vectors that its box tests and its CWBVH are written for. A build of its own is faster; features of one build
//! add up, so that only a package outside of this workspace could measure it.

mod contender;
#[cfg(feature = "embree")]
mod embree;
pub(crate) mod quartiles;
mod rays;
pub mod stereo;
mod timing;

pub use rays::Case;

use crate::build::BuildError;
use contender::{Contender, ObvhsBvh2, ObvhsCwbvh, Parallax};
use rays::RaySets;
use std::fmt;
use timing::{Timings, time};

/// How to measure.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Columns and rows of the picture whose primary rays are traced.
    pub size: [u32; 2],
    /// How often everything is run.
    pub repetitions: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { size: [1024, 1024], repetitions: 5 }
    }
}

/// Why there is no measurement.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// No structure.
    #[error("{case}: {error}")]
    Build {
        /// Which case.
        case: String,
        /// Why.
        error: BuildError,
    },
    /// The structure does not fit.
    #[error("{0}: too little memory for the structure")]
    OutOfMemory(String),
    /// Nothing to measure.
    #[error("{0}: no primary ray hits a triangle")]
    NothingHit(String),
    /// The others do not trace the same scene.
    #[error("{case}: {other} gives another answer than we for {rays} of {of} rays")]
    Disagree {
        /// Which case.
        case: String,
        /// Who.
        other: String,
        /// How often.
        rays: usize,
        /// Of how many.
        of: usize,
    },
    /// The scene cannot be rendered.
    #[error("{case}: {error}")]
    Render {
        /// Which case.
        case: String,
        /// Why.
        error: crate::render::RenderError,
    },
    /// Embree cannot be used.
    #[error("Embree: {0}")]
    Embree(String),
}

/// One figure, as `--json` writes it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct BenchLine {
    /// "traversal" or "stereo".
    pub bench: &'static str,
    /// Model and kind of rays.
    pub case: String,
    /// Where it ran.
    pub backend: String,
    /// Which traversal.
    pub method: String,
    /// What was measured: "rate", "speed" as a ratio to the reference, …
    pub metric: String,
    /// From the medians over repetitions.
    pub value: f64,
    /// "Mray/s", "×", "%", or nothing.
    pub unit: &'static str,
    /// Between the quartiles over repetitions, in the unit of `value`.
    pub spread: f64,
    /// What it is compared with.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<String>,
    /// The reference's rate in Mray/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference_value: Option<f64>,
}

impl fmt::Display for BenchLine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { case, method, value, unit, spread, metric, .. } = self;
        match self.bench {
            "stereo" => {
                write!(f, "{case:<32} {method:<20} {metric:<20} {value:8.3} {unit:<2} ± {:.3}", spread / 2.0)?
            }
            _ => write!(f, "{case:<28} {method:<16} {value:8.2} {unit:<6} ± {:.2}", spread / 2.0)?,
        }
        match &self.reference {
            Some(reference) => write!(f, "  of {reference}"),
            None => Ok(()),
        }
    }
}

/// Share of rays for which others may answer differently: they are not watertight, and round otherwise.
const TOLERATED: f64 = 1e-3;

/// Measures each case with primary, diffuse and shadow rays.
///
/// # Errors
/// See [`BenchError`].
pub fn traversal(cases: &[Case], options: Options) -> Result<Vec<BenchLine>, BenchError> {
    let mut lines = Vec::new();
    for case in cases {
        lines.extend(measure(case, options)?);
    }
    Ok(lines)
}

fn measure(case: &Case, options: Options) -> Result<Vec<BenchLine>, BenchError> {
    let ours = Parallax::new(case)?;
    let sets = RaySets::new(case, options.size, &ours);
    if sets.diffuse.is_empty() {
        return Err(BenchError::NothingHit(case.name.clone()));
    }
    let mut contenders: Vec<Box<dyn Contender>> = vec![
        Box::new(ours),
        Box::new(ObvhsCwbvh::new(&case.triangles)),
        Box::new(ObvhsBvh2::new(&case.triangles)),
    ];
    #[cfg(feature = "embree")]
    contenders.push(Box::new(embree::Scene::new(&case.triangles)?));
    contenders.shrink_to_fit();
    let mut lines = Vec::new();
    for (kind, rays, any) in
        [("primary", &sets.primary, false), ("diffuse", &sets.diffuse, false), ("shadow", &sets.shadow, true)]
    {
        let timings = time(&contenders, rays, any, options.repetitions);
        check(&format!("{} {kind}", case.name), &contenders, &timings, rays.len())?;
        lines.extend(report(&format!("{} {kind}", case.name), &contenders, &timings));
    }
    Ok(lines)
}

fn check(case: &str, all: &[Box<dyn Contender>], timings: &Timings, of: usize) -> Result<(), BenchError> {
    for (contender, &rays) in all.iter().zip(&timings.other_answers) {
        if rays as f64 > of as f64 * TOLERATED {
            return Err(BenchError::Disagree { case: case.into(), other: contender.name(), rays, of });
        }
    }
    Ok(())
}

/// The rates of all, then ours as a ratio to each other one.
fn report(case: &str, contenders: &[Box<dyn Contender>], timings: &Timings) -> Vec<BenchLine> {
    let backend = contenders[0].instruction_set();
    let line = |method: String, metric: &str, unit, (value, spread): (f64, f64)| BenchLine {
        bench: "traversal",
        case: case.into(),
        backend: format!("CPU ({backend}, 1 thread)"),
        method,
        metric: metric.into(),
        value,
        unit,
        spread,
        reference: None,
        reference_value: None,
    };
    let rates = contenders.iter().enumerate().map(|(i, contender)| {
        let backend = format!("CPU ({}, 1 thread)", contender.instruction_set());
        BenchLine { backend, ..line(contender.name(), "rate", "Mray/s", timings.rate(i)) }
    });
    let ratios = contenders.iter().enumerate().skip(1).map(|(i, contender)| BenchLine {
        reference: Some(contender.name()),
        reference_value: Some(timings.rate(i).0),
        ..line(contenders[0].name(), "speed", "×", timings.ratio(i))
    });
    rates.chain(ratios).collect()
}
