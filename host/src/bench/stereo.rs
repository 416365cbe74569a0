//! `parallax bench stereo`: what the second view of a pair costs by each method, of what that is made up, and how far it is from the
//! truth.
//!
//! All methods run in turn in each repetition, over buffers that are made once. The second view's cost is (stereo − mono) / mono, by
//! the source's passes of the same run: what disturbs one disturbs the other. Reading back and display are left out for all.

use super::{BenchError, BenchLine};
use crate::backend::{Backend, Cpu};
use crate::metrics;
use crate::render::band::{Band, Pair, Second};
use crate::render::stereo::Plan;
use crate::render::{Method, Renderer, SceneData, StereoOptions, Verify};
use parallax_shared::stereo::source;
use std::collections::BTreeMap;

/// What is measured of a scene.
pub struct Case<'a> {
    /// For reports.
    pub name: String,
    /// The scene.
    pub data: &'a SceneData,
    /// How its pairs are rendered; the first one is the reference, and must be naive.
    pub methods: &'a [StereoOptions],
    /// How often everything is run; medians and quartiles are over these.
    pub repetitions: usize,
}

/// What one method has shown.
#[derive(Default)]
struct Measured {
    /// Cost of the second view, by repetition.
    cost: Vec<f64>,
    /// Seconds of each of its stages over the mono seconds, by repetition.
    stages: BTreeMap<&'static str, Vec<f64>>,
}

/// A method with the options that it does not have by itself.
pub fn label(options: &StereoOptions) -> String {
    let verify = options.verify.map_or(String::new(), |verify| format!(" verify={}", name_of(verify)));
    let shadows = if options.shadows == Default::default() { "" } else { " shadows=trace" };
    format!("{}{verify}{shadows}", options.method.name())
}

const fn name_of(verify: Verify) -> &'static str {
    match verify {
        Verify::None => "none",
        Verify::Edges => "edges",
        Verify::All => "all",
    }
}

/// Measures a case on `cpu`. `progress` is told how many of how many repetitions are done.
///
/// # Errors
/// When the backend fails or options do not go together.
pub fn stereo(
    cpu: &mut Cpu,
    case: &Case<'_>,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Vec<BenchLine>, BenchError> {
    let failed = |error| BenchError::Render { case: case.name.clone(), error };
    let backend = cpu.describe();
    let pairs = pairs(cpu, case).map_err(failed)?;
    let measured = times(cpu, case, progress).map_err(failed)?;
    let mut lines = Vec::new();
    for ((options, measured), pair) in case.methods.iter().zip(&measured).zip(&pairs) {
        let mut line = |metric: String, unit, (value, spread): (f64, f64)| {
            lines.push(BenchLine {
                bench: "stereo",
                case: case.name.clone(),
                backend: backend.clone(),
                method: label(options),
                metric,
                value,
                unit,
                spread,
                reference: None,
                reference_value: None,
            });
        };
        line("second view / mono".into(), "%", percent(&measured.cost));
        for (stage, share) in &measured.stages {
            line(format!("of it {stage}"), "%", percent(share));
        }
        if options.method != Method::Naive {
            for (metric, unit, value) in quality(case.data, pair, &pairs[0]) {
                line(metric.into(), unit, (value, 0.0));
            }
        }
    }
    Ok(lines)
}

/// Both views by each method, once.
fn pairs(cpu: &mut Cpu, case: &Case<'_>) -> Result<Vec<Pair>, crate::render::RenderError> {
    let mut renderer = Renderer::new(cpu, case.data)?;
    let band = whole(case.data);
    case.methods.iter().map(|options| renderer.pair(&Plan::new(case.data, options, true)?, band)).collect()
}

fn whole(data: &SceneData) -> Band {
    Band { first_row: 0, rows: data.views[0].height }
}

fn times(
    cpu: &mut Cpu,
    case: &Case<'_>,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Vec<Measured>, crate::render::RenderError> {
    let mut renderer = Renderer::new(cpu, case.data)?;
    let band = whole(case.data);
    let plans = case
        .methods
        .iter()
        .map(|options| Plan::new(case.data, options, false))
        .collect::<Result<Vec<_>, _>>()?;
    let buffers =
        plans.iter().map(|plan| renderer.pair_buffers(plan, band)).collect::<Result<Vec<_>, _>>()?;
    let mut measured: Vec<Measured> = plans.iter().map(|_| Measured::default()).collect();
    // The first round warms caches and buffers up.
    for round in 0..=case.repetitions {
        for ((plan, buffers), measured) in plans.iter().zip(&buffers).zip(&mut measured) {
            let before = renderer.times().to_vec();
            let [mono, second] = renderer.time_pair(plan, buffers, band)?;
            if round == 0 {
                continue;
            }
            measured.cost.push(second / mono);
            let view = crate::render::band::EYES[plan.options.first.eyes()[1]];
            for time in renderer.times().iter().filter(|time| time.view == Some(view)) {
                let earlier = before.iter().find(|t| (t.view, t.stage) == (time.view, time.stage));
                let seconds = time.seconds - earlier.map_or(0.0, |time| time.seconds);
                if seconds > 0.0 {
                    measured.stages.entry(time.stage).or_default().push(seconds / mono);
                }
            }
        }
        progress(round as u64, case.repetitions as u64);
    }
    buffers.into_iter().for_each(|buffers| renderer.release(buffers));
    Ok(measured)
}

/// How far the second view is from the naive one, and what was reused for it.
fn quality(data: &SceneData, pair: &Pair, naive: &Pair) -> Vec<(&'static str, &'static str, f64)> {
    let (shown, truth) = (&pair.second, &naive.second);
    let mse = metrics::mse(shown.colour(), truth.colour());
    let (share, distance) = metrics::differing(shown.colour(), truth.colour());
    let wrong = metrics::wrong_depth(data.views[0].interaxial_px, shown.hits(), truth.hits());
    let mut lines = vec![
        ("mse", "", mse),
        ("pixels that differ", "%", 100.0 * share),
        ("their distance", "", distance),
        ("wrong depth", "%", 100.0 * wrong),
    ];
    if let Second::Inferred(inferred) = shown {
        let kinds = [
            ("holes", source::HOLE),
            ("gaps", source::GAP),
            ("bad pixels", source::BAD),
            ("verified", source::VERIFIED),
        ];
        let count = |kind| inferred.source.iter().filter(|&&word| source::kind(word) == kind).count();
        let share = |kind| 100.0 * count(kind) as f64 / inferred.source.len() as f64;
        lines.extend(kinds.map(|(name, kind)| (name, "%", share(kind))));
    }
    lines
}

/// Median and distance of the quartiles, in per cent.
fn percent(shares: &[f64]) -> (f64, f64) {
    let mut sorted = shares.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |quarter: usize| sorted.get((sorted.len().max(1) - 1) * quarter / 4).copied().unwrap_or(0.0);
    (100.0 * at(2), 100.0 * (at(3) - at(1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_named_with_their_options() {
        assert_eq!(label(&Method::Atomic.into()), "atomic");
        let options = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        assert_eq!(label(&options), "atomic verify=edges");
    }

    #[test]
    fn medians_and_quartiles() {
        assert_eq!(percent(&[0.25, 0.5, 0.75, 0.0, 1.0]), (50.0, 50.0));
        assert_eq!(percent(&[]), (0.0, 0.0));
    }
}
