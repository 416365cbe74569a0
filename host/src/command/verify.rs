//! `parallax verify`.

use super::failure::{Blame, Failure};
use super::options::SidesOptions;
use super::progress::Progress;
use super::report::{JsonOption, duration, grouped};
use anyhow::Context;
use parallax::backend::{Cpu, Gpu, Profile};
use parallax::verify::{self, Answers, CaseReport, Gpus, Verdict, Verification};
use serde::Serialize;
use std::fmt;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  parallax verify                              the processor, and the best GPU (or a software driver)
  parallax verify --adapter llvmpipe --json verification.json
  parallax verify --full                       all 2^32 square roots and a thousand million divisions
  parallax verify --cpu                        the processor alone

The strict profile is safe where nothing fails: every result has the same bits on processor and device.
Exit code: 0 when it is safe, 1 when it is not or when there is no device to verify.";

/// Options of `parallax verify`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Try all square roots and 10⁹ divisions, on every backend. Minutes on a processor, longer on a software driver.
    #[arg(long)]
    full: bool,
    /// Verify the processor alone.
    #[arg(long, conflicts_with = "adapter")]
    cpu: bool,
    #[command(flatten)]
    sides: SidesOptions,
    #[command(flatten)]
    json: JsonOption,
}

/// What a verification tells.
#[derive(Serialize)]
#[serde(transparent)]
struct Report(Verification);

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let mut cpu = Cpu::new(options.sides.threads).work()?;
    let mut gpus = if options.cpu { None } else { Some(open(options.sides.adapter.as_deref())?) };
    let mut progress = Progress::new();
    let mut tell = |what: &str, done, total| progress.update(what, done, total);
    let verification = verify::verify(&mut cpu, gpus.as_mut(), options.full, &mut tell).work()?;
    drop(progress);
    let is_safe = verification.strict.is_safe;
    options.json.publish(&Report(verification))?;
    Ok(if is_safe { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The same adapter in both profiles.
fn open(adapter: Option<&str>) -> Result<Gpus, Failure> {
    let hint = "there is no device to verify; `--cpu` verifies the processor alone";
    let strict = Gpu::open(Profile::Strict, adapter).context(hint).work()?;
    let fast = strict.in_profile(Profile::Fast).work()?;
    Ok(Gpus { strict, fast })
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Verification { cpu, device, probes, cases, strict, fast, .. } = &self.0;
        writeln!(f, "{cpu}")?;
        writeln!(
            f,
            "{}\n",
            device.as_deref().unwrap_or("NO DEVICE: what follows is about the processor alone.")
        )?;
        write_probes(f, probes)?;
        writeln!(f, "\n  {:<62} {:>14} {:>9} {:>9}  where", "case", "tried", "failures", "time")?;
        for case in cases {
            let name = format!("{}: {}", case.group.replace('_', " "), case.name);
            let (tried, time) = (grouped(case.cases), duration(case.seconds));
            writeln!(f, "  {name:<62} {tried:>14} {:>9} {time:>9}  {}", case.failures, place(case))?;
            if let Some(failure) = &case.first_failure {
                writeln!(f, "      {failure}")?;
            }
        }
        let total = cases.iter().map(|case| case.cases).sum();
        writeln!(f, "\n{} cases", grouped(total))?;
        write_verdict(f, "strict", strict)?;
        match fast {
            Some(fast) => write_verdict(f, "fast", fast),
            None => writeln!(f, "fast    not tried: no device"),
        }
    }
}

/// A line for each probe that all machines answer alike, else one for each machine.
fn write_probes(f: &mut fmt::Formatter, machines: &[Answers]) -> fmt::Result {
    let Some(first) = machines.first() else { return Ok(()) };
    for (row, (name, answer)) in first.named().into_iter().enumerate() {
        let others: Vec<_> =
            machines.iter().map(|answers| (answers.machine, answers.named()[row].1)).collect();
        if others.iter().all(|(_, other)| other.says == answer.says) {
            writeln!(f, "  {name:<20} {:<7} {}", "all", answer.says)?;
            continue;
        }
        for (i, (machine, answer)) in others.into_iter().enumerate() {
            let mark = if answer.strict_can_do || machine == "fast" { "" } else { "  UNSAFE" };
            let name = if i == 0 { name } else { "" };
            writeln!(f, "  {name:<20} {machine:<7} {}{mark}", answer.says)?;
        }
    }
    Ok(())
}

/// Which machines a case ran on.
fn place(case: &CaseReport) -> &'static str {
    match (case.on_device, case.cases) {
        (true, _) => "processor, device",
        (false, 0) => "not tried: no device",
        (false, _) => "processor",
    }
}

fn write_verdict(f: &mut fmt::Formatter, profile: &str, verdict: &Verdict) -> fmt::Result {
    let word = if verdict.is_safe { "safe" } else { "NOT SAFE" };
    writeln!(f, "{profile:<7} {word}: {}", verdict.why)
}
