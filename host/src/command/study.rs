//! `parallax study`.

use super::failure::{Blame, Failure};
use super::locate;
use super::options::{DeviceOptions, size};
use super::progress::Progress;
use super::report::{save, warn};
use anyhow::anyhow;
use parallax::backend::{self, Backend, Device, Profile, Selection};
use parallax::build::Quality;
use parallax::render::{Overrides, SceneData};
use parallax::scene::Scene;
use parallax::study::{self, KNOBS, Knob, Measured, Study};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// For `--help`.
const EXAMPLES: &str = "\
Examples:
  parallax study --quick --out study           four scenes, small: three minutes on two cores
  parallax study dragon --out study --size 800x600
  parallax study sphereflake --out study --knob method,verify    all combinations of two knobs
  parallax study spot whitted --effects --out study    what each effect costs, as code and as work
  parallax study default --out study --backend gpu               with the price of strict arithmetic

Files: study.jsonl has an object for each point; study.html has plots, tables and pictures of errors, and needs
no network; effects.jsonl has the costs of effects.";

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
    /// What each effect costs instead: with its code where nothing uses it, and left out where something does.
    #[arg(long, conflicts_with = "knob")]
    effects: bool,
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
    if options.effects {
        return effects(options, &mut device);
    }
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
    let scene = load(options, path)?;
    let name = scene.name.clone();
    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update(&name, done, total);
    let repetitions = repetitions(options);
    let study = Study { name: name.clone(), scene: &scene, knobs, repetitions };
    study::study(&study, device, fast, &mut tell).work()
}

/// The scene in the size that is asked for.
fn load(options: &Options, path: &Path) -> Result<Scene, Failure> {
    let mut scene = locate::load(&locate::scene(Some(path)).usage()?, 0)?;
    let size = options.size.unwrap_or(SIZES[usize::from(options.quick)]);
    Overrides { size: Some(size), ..Overrides::default() }.apply(&mut scene).usage()?;
    Ok(scene)
}

fn repetitions(options: &Options) -> usize {
    options.repetitions.map_or(REPETITIONS[usize::from(options.quick)], |repetitions| repetitions as usize)
}

/// Measures what effects cost, and writes effects.jsonl.
fn effects(options: &Options, device: &mut Device) -> Result<ExitCode, Failure> {
    let mut lines = Vec::new();
    for path in paths(options) {
        let scene = load(options, &path)?;
        let name = scene.name.clone();
        let data = SceneData::new(&scene, Quality::Full).usage()?;
        let mut progress = Progress::new();
        let mut tell = |done, total| progress.update(&name, done, total);
        let costs = study::effects(&name, &data, device, repetitions(options), &mut tell).work()?;
        drop(progress);
        println!("{name}");
        costs.iter().for_each(|cost| println!("{cost}"));
        lines.extend(costs.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>().work()?);
    }
    save(&options.out.join("effects.jsonl"), "--out", &(lines.join("\n") + "\n"))?;
    Ok(ExitCode::SUCCESS)
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
