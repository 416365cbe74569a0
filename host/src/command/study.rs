//! `parallax study`.

use super::failure::{Blame, Failure};
use super::locate;
use super::options::{DeviceOptions, size};
use super::progress::Progress;
use super::report::{save, warn};
use anyhow::anyhow;
use parallax::backend::{self, Backend, Device, Profile, Selection};
use parallax::render::Overrides;
use parallax::study::{self, KNOBS, Knob, Measured, Study};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// For `--help`.
const EXAMPLES: &str = "\
Examples:
  parallax study --quick --out study           four scenes, small: three minutes on two cores
  parallax study dragon --out study --size 800x600
  parallax study sphereflake --out study --knob method,verify    all combinations of two knobs
  parallax study default --out study --backend gpu               with the price of strict arithmetic

Files: study.jsonl has an object for each point; study.html has plots, tables and pictures of errors, and needs no network.";

/// What is studied when no scene is named.
const SCENES: [&str; 4] = ["dragon", "sponza", "sphereflake", "cornell"];

/// Columns and rows where nobody says otherwise; and if it has to be quick.
const SIZES: [[u32; 2]; 2] = [[480, 360], [240, 180]];

/// Repetitions; and if it has to be quick.
const REPETITIONS: [usize; 2] = [7, 5];

/// Options of `parallax study`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Scene files, models or names of shipped scenes [default: dragon, sponza, sphereflake, cornell].
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Smaller pictures and fewer repetitions.
    #[arg(long)]
    quick: bool,
    /// Knobs of which all combinations are tried [default: each knob by itself].
    #[arg(long, value_name = "KNOB", value_delimiter = ',')]
    knob: Vec<String>,
    /// Size of each picture.
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// How often everything is run; medians and quartiles are over these.
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    repetitions: Option<u32>,
    /// Folder for study.jsonl and study.html; it is made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "study")]
    out: PathBuf,
    #[command(flatten)]
    device: DeviceOptions,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let knobs = options.knob.iter().map(|name| knob(name)).collect::<Result<Vec<_>, _>>().usage()?;
    let selection = Selection { profile: Profile::Strict, ..options.device.selection() };
    let mut device = backend::select(&selection).work()?;
    // On a CPU both profiles are one and the same; measuring it twice would only show noise.
    let mut fast = match device {
        Device::Cpu(_) => None,
        Device::Gpu(_) => Some(backend::select(&Selection { profile: Profile::Fast, ..selection }).work()?),
    };
    let mut scenes = Vec::new();
    for path in paths(options) {
        match measure(options, &path, &knobs, &mut device, &mut fast) {
            Ok(measured) => scenes.push(measured),
            Err(Failure::Usage(error)) if options.scenes.is_empty() => {
                warn(&[format!("left out: {error:#}")]);
            }
            Err(failure) => return Err(failure),
        }
    }
    if scenes.is_empty() {
        return Err(anyhow!("nothing was studied: all scenes are left out")).usage();
    }
    publish(options, &device.describe(), &scenes)
}

fn knob(name: &str) -> anyhow::Result<&'static Knob> {
    let names = || KNOBS.iter().map(|knob| knob.name).collect::<Vec<_>>().join(", ");
    KNOBS
        .iter()
        .find(|knob| knob.name == name)
        .ok_or_else(|| anyhow!("no knob `{name}`; there are {}", names()))
}

fn paths(options: &Options) -> Vec<PathBuf> {
    if options.scenes.is_empty() { SCENES.map(PathBuf::from).to_vec() } else { options.scenes.clone() }
}

fn measure(
    options: &Options,
    path: &Path,
    knobs: &[&Knob],
    device: &mut Device,
    fast: &mut Option<Device>,
) -> Result<Vec<Measured>, Failure> {
    let quick = usize::from(options.quick);
    let mut scene = locate::load(&locate::scene(Some(path)).usage()?, 0)?;
    let size = options.size.unwrap_or(SIZES[quick]);
    Overrides { size: Some(size), ..Overrides::default() }.apply(&mut scene).usage()?;
    let name = format!("{} {}x{}", scene.name, size[0], size[1]);
    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update(&name, done, total);
    let repetitions = options.repetitions.map_or(REPETITIONS[quick], |repetitions| repetitions as usize);
    let study = Study { name: name.clone(), scene: &scene, knobs, repetitions };
    study::study(&study, device, fast, &mut tell).work()
}

/// Writes the files, and tells a sentence per scene.
fn publish(options: &Options, machine: &str, scenes: &[Vec<Measured>]) -> Result<ExitCode, Failure> {
    let points = || scenes.iter().flatten().map(|measured| &measured.point);
    let lines = points().map(serde_json::to_string).collect::<Result<Vec<_>, _>>().work()?;
    save(&options.out.join("study.jsonl"), "--out", &(lines.join("\n") + "\n"))?;
    save(&options.out.join("study.html"), "--out", &study::page(machine, scenes))?;
    for scene in scenes {
        let points: Vec<_> = scene.iter().map(|measured| &measured.point).collect();
        if let Some(sentence) = study::sentence(&points) {
            println!("{sentence}");
        }
    }
    println!("Wrote {} points to {}", lines.len(), options.out.display());
    Ok(ExitCode::SUCCESS)
}
