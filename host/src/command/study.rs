//! `parallax study`.

use super::failure::{Blame, Failure};
use super::locate;
use super::options::{BackendsOptions, size};
use super::progress::Progress;
use super::report::{save, warn};
use anyhow::anyhow;
use parallax::backend::Profile;
use parallax::build::Quality;
use parallax::render::{Overrides, SceneData};
use parallax::scene::Scene;
use parallax::study::{self, Case, KNOBS, Knob, Machine, Study};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// For `--help`.
const EXAMPLES: &str = "\
Examples:
  parallax study --quick --out study           four scenes, small: three minutes on two cores
  parallax study dragon --out study --size 800x600
  parallax study sphereflake --out study --knob method,verify    all combinations of two knobs
  parallax study spot whitted --effects --out study    what each effect costs, as code and as work
  parallax study default --out study --backend cpu,gpu           two backends, each by itself

Files: study.jsonl has an object for each point; strict.jsonl one for the price of strict arithmetic on each
backend; study.html has plots, tables and pictures of errors, and needs no network; effects.jsonl has the costs
of effects.";

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
    /// Folder for study.jsonl, strict.jsonl and study.html; it is made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "study")]
    out: PathBuf,
    #[command(flatten)]
    backends: BackendsOptions,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let knobs = options.knob.iter().map(|name| knob(name)).collect::<Result<Vec<_>, _>>().usage()?;
    let mut machines = Machine::open_all(&options.backends.selections()).work()?;
    if options.effects {
        return effects(options, &mut machines);
    }
    let mut cases = Vec::new();
    for scene in scenes(options) {
        cases.extend(measure(options, &scene?, &knobs, &mut machines)?);
    }
    require(&cases)?;
    publish(options, &machines, &cases)
}

/// The scenes that are asked for, one after the other. Of those that nobody named, one that cannot be had is left out with a warning.
fn scenes(options: &Options) -> impl Iterator<Item = Result<Scene, Failure>> {
    paths(options).into_iter().filter_map(|path| match load(options, &path) {
        Err(Failure::Usage(error)) if options.scenes.is_empty() => {
            warn(&[format!("left out: {error:#}")]);
            None
        }
        loaded => Some(loaded),
    })
}

/// Fails if all scenes were left out.
fn require<T>(found: &[T]) -> Result<(), Failure> {
    match found.is_empty() {
        true => Err(anyhow!("nothing was studied: all scenes are left out")).usage(),
        false => Ok(()),
    }
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

/// Studies a scene on each backend.
fn measure(
    options: &Options,
    scene: &Scene,
    knobs: &[&Knob],
    machines: &mut [Machine],
) -> Result<Vec<Case>, Failure> {
    let study = Study { name: scene.name.clone(), scene, knobs, repetitions: repetitions(options) };
    let on = |machine: &mut Machine| {
        let (mut progress, what) = (Progress::new(), told(&study.name, machine));
        study::study(&study, machine, &mut |done, total| progress.update(&what, done, total)).work()
    };
    machines.iter_mut().map(on).collect()
}

/// A scene on a backend, in words.
fn told(scene: &str, machine: &Machine) -> String {
    format!("{scene} on {}", machine.describe())
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
fn effects(options: &Options, machines: &mut [Machine]) -> Result<ExitCode, Failure> {
    let mut all = Vec::new();
    for scene in scenes(options) {
        let scene = scene?;
        let data = SceneData::new(&scene, Quality::Full).usage()?;
        for machine in &mut *machines {
            let (mut progress, what) = (Progress::new(), told(&scene.name, machine));
            let mut tell = |done, total| progress.update(&what, done, total);
            let device = machine.device(Profile::Strict);
            let costs = study::effects(&scene.name, &data, device, repetitions(options), &mut tell).work()?;
            drop(progress);
            println!("{what}");
            costs.iter().for_each(|cost| println!("{cost}"));
            all.extend(costs);
        }
    }
    require(&all)?;
    save_lines(options, "effects.jsonl", &all)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes an object a line to a file of the folder.
fn save_lines(options: &Options, name: &str, objects: &[impl Serialize]) -> Result<(), Failure> {
    let lines = objects.iter().map(|object| Ok(serde_json::to_string(object)? + "\n"));
    let text: String = lines.collect::<serde_json::Result<_>>().work()?;
    save(&options.out.join(name), "--out", &text)
}

/// Writes the files, and tells a sentence per scene and backend, and what strict arithmetic costs there.
fn publish(options: &Options, machines: &[Machine], cases: &[Case]) -> Result<ExitCode, Failure> {
    let points: Vec<_> = cases.iter().flat_map(Case::points).collect();
    let prices: Vec<_> = cases.iter().filter_map(|case| case.strict.as_ref()).collect();
    let backends: Vec<_> = machines.iter().map(Machine::describe).collect();
    save_lines(options, "study.jsonl", &points)?;
    save_lines(options, "strict.jsonl", &prices)?;
    save(&options.out.join("study.html"), "--out", &study::page(&backends, cases))?;
    cases.iter().filter_map(|case| study::sentence(&case.points())).for_each(|said| println!("{said}"));
    prices.iter().for_each(|price| println!("{price}"));
    println!("Wrote {} points to {}", points.len(), options.out.display());
    Ok(ExitCode::SUCCESS)
}
