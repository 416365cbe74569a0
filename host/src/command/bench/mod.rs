//! `parallax bench`.

mod stereo;

use super::failure::{Blame, Failure};
use super::locate;
use super::options::size;
use super::report::{JsonOption, warn};
use parallax::bench::{self, BenchLine, Case};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is measured when no scene is named, as far as the models are there (alone, without the floor that their
/// scenes have): the last one ships with the project.
const SCENES: [&str; 5] = [
    "$PARALLAX_MODELS/stanford_dragon/dragon_vrip.ply",
    "$PARALLAX_MODELS/stanford_bunny/bun_zipper.ply",
    "$PARALLAX_MODELS/stanford_buddha/happy_buddha_113k.obj",
    "sponza",
    "spot",
];

const EXAMPLES: &str = "\
Examples:
  parallax bench traversal                     spot, and the large models if PARALLAX_MODELS has them
  parallax bench traversal dragon --json traversal.jsonl
  parallax bench traversal model.ply --size 512x512 --repetitions 9";

/// Options of `parallax bench`.
#[derive(clap::Args)]
pub struct Options {
    #[command(subcommand)]
    what: Measurement,
}

#[derive(clap::Subcommand)]
enum Measurement {
    /// Primary, diffuse and shadow rays per second on one thread, beside other libraries.
    #[command(after_help = EXAMPLES)]
    Traversal(Traversal),
    /// What the second view costs by each method, and how far it is from the traced one.
    #[command(after_help = stereo::EXAMPLES)]
    Stereo(stereo::Options),
}

#[derive(clap::Args)]
struct Traversal {
    /// Scene files, models or names of shipped scenes.
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Picture whose primary rays are traced.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1024x1024")]
    size: [u32; 2],
    /// How often everything is run; medians and quartiles are over these.
    #[arg(long, value_name = "N", default_value_t = 5)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    repetitions: u32,
    #[command(flatten)]
    json: JsonOption,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    match &options.what {
        Measurement::Traversal(options) => traversal(options),
        Measurement::Stereo(options) => stereo::run(options),
    }
}

fn traversal(options: &Traversal) -> Result<ExitCode, Failure> {
    let measured = bench::Options { size: options.size, repetitions: options.repetitions as usize };
    let cases = if options.scenes.is_empty() {
        usual_cases()?
    } else {
        options.scenes.iter().map(|path| case(path)).collect::<Result<_, _>>()?
    };
    let lines = bench::traversal(&cases, measured).work()?;
    let text: Vec<_> = lines.iter().map(ToString::to_string).collect();
    options.json.publish_text(&text.join("\n"), || json_lines(&lines))?;
    Ok(ExitCode::SUCCESS)
}

/// One object per line.
fn json_lines(lines: &[BenchLine]) -> serde_json::Result<String> {
    let lines: serde_json::Result<Vec<_>> = lines.iter().map(serde_json::to_string).collect();
    Ok(lines?.join("\n"))
}

/// The usual scenes; each that cannot be loaded is warned of.
fn usual_cases() -> Result<Vec<Case>, Failure> {
    let mut cases = Vec::new();
    for name in SCENES {
        match case(Path::new(name)) {
            Ok(case) => cases.push(case),
            Err(Failure::Usage(error)) => warn(&[format!("left out: {error:#}")]),
            Err(failure) => return Err(failure),
        }
    }
    Ok(cases)
}

fn case(path: &Path) -> Result<Case, Failure> {
    let path = locate::scene(Some(path)).usage()?;
    Ok(Case::of(&locate::load(&path, 0)?))
}
