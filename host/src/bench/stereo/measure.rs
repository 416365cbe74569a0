//! Measures a scene.
//!
//! All methods run in turn in each repetition, over buffers that are made once. The second view's cost is (stereo − mono) / mono, by
//! the source's passes of the same run: what disturbs one disturbs the other. Reading back and display are left out for all.

use super::paper::{COST, DIFFERING, DISTANCE, M, MSE, SAVED};
use super::{RAYS_SAVED, WRONG_DEPTH};
use crate::backend::{Backend, Cpu};
use crate::bench::quartiles::quartiles;
use crate::bench::{BenchError, BenchLine};
use crate::metrics;
use crate::render::band::{Band, EYES, Pair};
use crate::render::stereo::Plan;
use crate::render::stereo::statistics::{StereoReport, StereoStatistics};
use crate::render::{
    Method, RenderError, Renderer, SceneData, Shadows, StageTime, StereoOptions, value_name,
};
use parallax_shared::layout::Hit;
use std::collections::BTreeMap;

/// What is measured of a scene.
pub struct Case<'a> {
    /// For reports.
    pub name: String,
    /// The scene.
    pub data: &'a SceneData,
    /// How its pairs are rendered; the first one is the reference, and must be naive.
    pub methods: &'a [StereoOptions],
    /// How often everything is run; medians and quartiles are over these. 0: nothing is timed.
    pub repetitions: usize,
}

/// What one method has shown.
#[derive(Default)]
struct Measured {
    /// Seconds of the source, by repetition.
    mono: Vec<f64>,
    /// Seconds of the second view, by repetition.
    second: Vec<f64>,
    /// Cost of the second view, by repetition.
    cost: Vec<f64>,
    /// Seconds of each of its stages over the mono seconds, by repetition.
    stages: BTreeMap<&'static str, Vec<f64>>,
}

impl Measured {
    /// Adds a run. `views` are the names of the source and of the second view.
    fn add(&mut self, times: &[StageTime], views: [&str; 2]) {
        let of = |view| times.iter().filter(move |time| time.view == Some(view));
        let [mono, second] = views.map(|view| of(view).map(|time| time.seconds).sum::<f64>());
        self.mono.push(mono);
        self.second.push(second);
        self.cost.push(second / mono);
        for time in of(views[1]) {
            self.stages.entry(time.stage).or_default().push(time.seconds / mono);
        }
    }
}

/// A method with the options that it does not have by itself.
pub fn label(options: &StereoOptions) -> String {
    let verify = options.verify.map_or(String::new(), |verify| format!(" verify={}", value_name(&verify)));
    let shadows = match options.shadows {
        Shadows::Reuse => String::new(),
        shadows => format!(" shadows={}", value_name(&shadows)),
    };
    format!("{}{verify}{shadows}", options.method.name())
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
    let qualities = qualities(cpu, case).map_err(failed)?;
    let measured = times(cpu, case, progress).map_err(failed)?;
    let mut lines = Vec::new();
    for ((options, of_method), quality) in case.methods.iter().zip(&measured).zip(&qualities) {
        let saved = saved(of_method, &measured[0]);
        let mut line = |metric: &str, unit, (value, spread): (f64, f64)| {
            lines.push(BenchLine {
                bench: "stereo",
                case: case.name.clone(),
                backend: backend.clone(),
                method: label(options),
                metric: metric.into(),
                value,
                unit,
                spread,
                reference: None,
                reference_value: None,
            });
        };
        if case.repetitions > 0 {
            line(COST, "%", percent(&of_method.cost));
            if options.method == Method::Naive {
                line("mono", "ms", median_and_spread(&of_method.mono, 1e3));
            } else {
                line(SAVED, "%", percent(&saved));
            }
        }
        for (stage, share) in &of_method.stages {
            line(&format!("of it {stage}"), "%", percent(share));
        }
        for &(metric, unit, value) in quality {
            line(metric, unit, (value, 0.0));
        }
    }
    Ok(lines)
}

/// By repetition, which share of the traced second view's time a method saves: of seconds, as a method may change the first view, too.
fn saved(measured: &Measured, naive: &Measured) -> Vec<f64> {
    measured.second.iter().zip(&naive.second).map(|(second, traced)| 1.0 - second / traced).collect()
}

/// A metric, its unit and its value.
type Quality = (&'static str, &'static str, f64);

/// How good each method's second view is; of the reference there is nothing to say.
fn qualities(cpu: &mut Cpu, case: &Case<'_>) -> Result<Vec<Vec<Quality>>, RenderError> {
    let mut renderer = Renderer::new(cpu, case.data)?;
    let band = whole(case.data);
    let mut pair = |options: &StereoOptions| {
        let plan = Plan::new(case.data, options, true)?;
        renderer.pair(&plan, band).map(|pair| (plan, pair))
    };
    let Some((reference, others)) = case.methods.split_first() else { return Ok(vec![]) };
    let (_, naive) = pair(reference)?;
    let truth = Picture { colours: metrics::srgb8(naive.second.colour()), hits: &naive.second.hits };
    let mut qualities = vec![vec![]];
    for options in others {
        let (plan, pair) = pair(options)?;
        let mut of_method = quality(case.data, &pair, &truth);
        of_method.extend(counts(case.data, &plan, &pair));
        qualities.push(of_method);
    }
    Ok(qualities)
}

fn whole(data: &SceneData) -> Band {
    Band { first_row: 0, rows: data.views[0].height }
}

fn times(
    cpu: &mut Cpu,
    case: &Case<'_>,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Vec<Measured>, RenderError> {
    if case.repetitions == 0 {
        return Ok(case.methods.iter().map(|_| Measured::default()).collect());
    }
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
            let times = renderer.time_pair(plan, buffers, band)?;
            if round > 0 {
                measured.add(&times, plan.options.first.eyes().map(|eye| EYES[eye]));
            }
        }
        progress(round as u64, case.repetitions as u64);
    }
    buffers.into_iter().for_each(|buffers| renderer.release(buffers));
    Ok(measured)
}

/// A second view as errors are taken of it.
struct Picture<'a> {
    colours: Vec<[u8; 3]>,
    hits: &'a [Hit],
}

/// How far the second view is from the traced one.
fn quality(data: &SceneData, pair: &Pair, truth: &Picture<'_>) -> Vec<Quality> {
    let e = data.views[0].interaxial_px;
    let (shown, hits) = (&metrics::srgb8(pair.second.colour()), &pair.second.hits[..]);
    let (share, distance) = metrics::differing(shown, &truth.colours);
    let [same, nearer, farther] = metrics::error_shares(e, (shown, hits), (&truth.colours, truth.hits));
    vec![
        (MSE, "", metrics::mse(shown, &truth.colours)),
        ("error at the same depth", "%", 100.0 * same),
        ("error by what is nearer", "%", 100.0 * nearer),
        ("error by what is farther", "%", 100.0 * farther),
        (DIFFERING, "%", 100.0 * share),
        (DISTANCE, "", distance),
        (WRONG_DEPTH, "%", 100.0 * metrics::wrong_depth(e, hits, truth.hits)),
    ]
}

/// What was reused, traced and saved; nothing of methods that do not infer the second view.
fn counts(data: &SceneData, plan: &Plan, pair: &Pair) -> Vec<Quality> {
    let Some(statistics) = StereoStatistics::of_band(pair) else { return vec![] };
    let report = StereoReport::new(data, plan, &statistics);
    let share = |count: u64| 100.0 * count as f64 / statistics.pixels.max(1) as f64;
    vec![
        (M, "%", 100.0 * report.m),
        ("holes", "%", share(report.holes)),
        ("gaps", "%", share(report.gaps)),
        ("bad pixels", "%", share(report.bad)),
        ("verified", "%", share(report.verified)),
        ("overlapped", "%", share(report.overlapped)),
        ("largest overlap", "", report.largest_overlap.into()),
        ("Lemma 1's bound", "", report.lemma_bound.into()),
        (RAYS_SAVED, "%", report.saved_percent),
        ("001's worst case", "%", report.worst_case_saved_percent),
    ]
}

/// Median and distance of the quartiles, in per cent.
fn percent(shares: &[f64]) -> (f64, f64) {
    median_and_spread(shares, 100.0)
}

/// Median and distance of the quartiles, times `unit`.
fn median_and_spread(values: &[f64], unit: f64) -> (f64, f64) {
    let [low, median, high] = quartiles(values.iter().copied());
    (unit * median, unit * (high - low))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Verify;

    #[test]
    fn methods_are_named_with_their_options() {
        assert_eq!(label(&Method::Atomic.into()), "atomic");
        let options = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        assert_eq!(label(&options), "atomic verify=edges");
        let options = StereoOptions { shadows: Shadows::Prove, ..Method::Guided.into() };
        assert_eq!(label(&options), "guided shadows=prove");
    }

    #[test]
    fn frames_become_their_mean() {
        let line = |metric: &str, value, spread| BenchLine {
            bench: "stereo",
            case: "spheres".into(),
            backend: "CPU".into(),
            method: "atomic".into(),
            metric: metric.into(),
            value,
            unit: "%",
            spread,
            reference: None,
            reference_value: None,
        };
        let frames = [vec![line("a", 1.0, 0.5), line("b", 8.0, 0.0)], vec![line("a", 3.0, 0.25)]];
        let told: Vec<_> = super::super::mean(&frames).iter().map(|l| (l.value, l.spread)).collect();
        assert_eq!(told, [(2.0, 0.5), (8.0, 0.0)]);
        assert!(super::super::mean(&[]).is_empty());
    }

    #[test]
    fn medians_and_quartiles() {
        assert_eq!(percent(&[0.25, 0.5, 0.75, 0.0, 1.0]), (50.0, 50.0));
        assert_eq!(percent(&[]), (0.0, 0.0));
        assert_eq!(median_and_spread(&[0.002], 1e3), (2.0, 0.0));
    }

    #[test]
    fn what_is_saved_is_beside_the_traced_view_of_the_same_repetition() {
        let seconds = |second: &[f64]| Measured { second: second.to_vec(), ..Measured::default() };
        assert_eq!(saved(&seconds(&[0.25, 0.5]), &seconds(&[1.0, 2.0])), [0.75, 0.75]);
    }
}
