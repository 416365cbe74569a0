//! Hard cases on the user's own machine: what its driver does, whether the suite holds there, and which profile is safe.
//!
//! The suite is that of the tests: `tests/tests/hard_cases` runs each of [`CASES`].

pub mod cases;
pub mod input;
pub mod probes;
pub mod suite;

pub use cases::{CASES, Case};
pub use probes::{Answer, Answers};

use crate::backend::{Backend, Cpu, Gpu};
use crate::render::RenderError;
use serde::Serialize;
use std::time::Instant;
use suite::{Suite, Tally};

/// What a case returns: what does not hold is in its tally, an error is a backend's.
pub type Outcome = Result<(), RenderError>;

/// A GPU in both profiles.
pub struct Gpus {
    /// In the strict one.
    pub strict: Gpu,
    /// In the fast one.
    pub fast: Gpu,
}

/// What came of a case.
#[derive(Clone, Debug, Serialize)]
pub struct CaseReport {
    /// What it is about.
    pub group: &'static str,
    /// What it shows.
    pub name: String,
    /// Whether the device took part, beside the processor.
    pub on_device: bool,
    /// Rays, pixels or numbers that were tried.
    pub cases: u64,
    /// Checks that did not hold.
    pub failures: u64,
    /// What the first of them says.
    pub first_failure: Option<String>,
    /// How long it took.
    pub seconds: f64,
}

/// Whether a profile may be used.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// Whether it does what it promises, as far as was tried.
    pub is_safe: bool,
    /// Why.
    pub why: String,
}

/// What verifying a machine has shown.
#[derive(Clone, Debug, Serialize)]
pub struct Verification {
    /// The processor.
    pub cpu: String,
    /// The device and its driver, if one was verified.
    pub device: Option<String>,
    /// Whether the whole range was tried of what has one.
    pub full: bool,
    /// What processor and driver do.
    pub probes: Vec<Answers>,
    /// Every case.
    pub cases: Vec<CaseReport>,
    /// The strict profile: the same bits everywhere.
    pub strict: Verdict,
    /// The fast profile: agreement within stated bounds. Nothing to be said without a device.
    pub fast: Option<Verdict>,
}

/// Probes the machines, runs every case, and concludes. `progress` is told what is being done and how far it is.
///
/// A case that a backend fails in counts as one that does not hold.
///
/// # Errors
/// When a backend fails in a probe.
pub fn verify(
    cpu: &mut Cpu,
    mut gpus: Option<&mut Gpus>,
    full: bool,
    progress: &mut dyn FnMut(&str, u64, u64),
) -> Result<Verification, RenderError> {
    let mut probes = vec![probes::probe(cpu, "CPU")?];
    if let Some(gpus) = gpus.as_deref_mut() {
        probes.push(probes::probe(&mut gpus.strict, "strict")?);
        probes.push(probes::probe(&mut gpus.fast, "fast")?);
    }
    let mut cases = Vec::new();
    for (number, case) in (0u64..).zip(CASES) {
        let strict = gpus.as_deref_mut().map(|gpus| &mut gpus.strict);
        let mut tell = |done, total| {
            // A case with parts is told by them, a short one by its number.
            let (done, total) = if total > 1 { (done, total) } else { (number, CASES.len() as u64) };
            progress(case.group, done, total);
        };
        tell(0, 1);
        cases.push(run(case, cpu, strict, full, &mut tell));
    }
    let fast = gpus.as_deref_mut().map(|gpus| fast_verdict(cpu, &mut gpus.fast)).transpose()?;
    Ok(Verification {
        cpu: cpu.describe(),
        device: gpus.map(|gpus| gpus.strict.describe()),
        full,
        strict: strict_verdict(&probes, &cases),
        probes,
        cases,
        fast,
    })
}

/// Runs one case.
pub fn run(
    case: &Case,
    cpu: &mut Cpu,
    gpu: Option<&mut Gpu>,
    full: bool,
    progress: suite::Progress<'_>,
) -> CaseReport {
    let start = Instant::now();
    let mut suite = Suite::new(cpu, gpu, full, progress);
    if let Err(error) = (case.run)(&mut suite) {
        suite.check(false, || error.to_string());
    }
    let Tally { tried, failures, first_failure, on_device } = suite.into_tally();
    let name = case.name.replace('_', " ");
    let seconds = start.elapsed().as_secs_f64();
    CaseReport { group: case.group, name, on_device, cases: tried, failures, first_failure, seconds }
}

/// Safe where nothing failed and every machine that runs strict kernels does what they are made for.
fn strict_verdict(probes: &[Answers], cases: &[CaseReport]) -> Verdict {
    let strict = probes.iter().filter(|answers| answers.machine != "fast");
    let unfit: Vec<_> = strict
        .flat_map(|answers| answers.named().map(|named| (answers.machine, named)))
        .filter(|(_, (_, answer))| !answer.strict_can_do)
        .map(|(machine, (name, answer))| format!("{machine}: {name}: {}", answer.says))
        .collect();
    let failed: Vec<_> =
        cases.iter().filter(|case| case.failures > 0).map(|case| case.name.clone()).collect();
    let tried: u64 = cases.iter().map(|case| case.cases).sum();
    let on_device = cases.iter().any(|case| case.on_device);
    let problems = [unfit, failed].concat();
    let why = match (problems.is_empty(), on_device) {
        (true, true) => format!("the same bits on processor and device, and no failure in {tried} cases"),
        (true, false) => format!("no failure in {tried} cases on the processor; NO DEVICE WAS VERIFIED"),
        (false, _) => problems.join("; "),
    };
    Verdict { is_safe: problems.is_empty(), why }
}

/// Runs a pair in the fast profile.
fn fast_verdict(cpu: &mut Cpu, gpu: &mut Gpu) -> Result<Verdict, RenderError> {
    let (beyond, elements) = cases::pictures::beyond_the_fast_bounds(cpu, gpu)?;
    let why = match beyond {
        0 => format!("a pair with every effect agrees within the stated bounds ({elements} elements)"),
        _ => format!("{beyond} of {elements} elements of a pair are beyond the stated bounds"),
    };
    Ok(Verdict { is_safe: beyond == 0, why })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(strict_can_do: bool) -> Answer {
        Answer { says: "something".into(), strict_can_do }
    }

    fn answers(machine: &'static str, division: bool) -> Answers {
        let good = || answer(true);
        Answers {
            machine,
            contraction: good(),
            fma: good(),
            rounding: good(),
            denormals: good(),
            zeros: good(),
            division: answer(division),
            square_root: good(),
            loops: good(),
        }
    }

    fn case(failures: u64) -> CaseReport {
        let (group, name) = ("boxes", "slabs".to_owned());
        CaseReport { group, name, on_device: true, cases: 7, failures, first_failure: None, seconds: 0.0 }
    }

    #[test]
    fn strict_is_safe_where_nothing_fails_and_its_machines_are_fit() {
        let safe = strict_verdict(
            &[answers("CPU", true), answers("strict", true), answers("fast", false)],
            &[case(0)],
        );
        assert!(safe.is_safe && safe.why.contains("7 cases"), "{}", safe.why);
        let unfit = strict_verdict(&[answers("strict", false)], &[case(0)]);
        assert!(!unfit.is_safe && unfit.why == "strict: division: something", "{}", unfit.why);
        let failed = strict_verdict(&[answers("strict", true)], &[case(0), case(2)]);
        assert!(!failed.is_safe && failed.why == "slabs", "{}", failed.why);
    }
}
