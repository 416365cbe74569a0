//! `parallax bench`.

use super::failure::{Blame, Failure};
use super::locate;
use super::options::size;
use super::progress::Progress;
use super::report::{JsonOption, warn};
use anyhow::Context;
use clap::ValueEnum;
use parallax::backend::Cpu;
use parallax::bench::{self, BenchLine, Case};
use parallax::build::Quality;
use parallax::render::{Method, Overrides, SceneData, StereoOptions, Verify};
use parallax::scene;
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

/// The scenes of Al-Hagri 2012, table 5, as far as the models are there.
const STEREO_SCENES: [&str; 5] = ["spheres", "spheres_turned", "sponza", "buddha", "dragon"];

const STEREO_EXAMPLES: &str = "\
Examples:
  parallax bench stereo                        Al-Hagri's scenes at 600x600, eyes 15 and 50 px apart, 5 lights
  parallax bench stereo --quick spheres dragon
  parallax bench stereo dragon --size 200x200,600x600,1000x1000 --interaxial 15 --json dimensions.jsonl
  parallax bench stereo default --as-is";

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
    #[command(after_help = STEREO_EXAMPLES)]
    Stereo(Stereo),
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

#[derive(clap::Args)]
struct Stereo {
    /// Scene files, models or names of shipped scenes.
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Sizes of each picture.
    #[arg(long, value_name = "WxH", value_parser = size, value_delimiter = ',', default_value = "600x600")]
    size: Vec<[u32; 2]>,
    /// Distances between the eyes in pixels of the zero-parallax plane.
    #[arg(long, value_name = "PX", value_delimiter = ',', default_value = "15,50")]
    interaxial: Vec<f32>,
    /// Numbers of lights.
    #[arg(long, value_name = "N", value_delimiter = ',', default_value = "5")]
    lights: Vec<u32>,
    /// Keep highlights, mirrors and glass: by default all materials are matt, as Al-Hagri's are.
    #[arg(long)]
    as_is: bool,
    /// How often everything is run; medians and quartiles are over these.
    #[arg(long, value_name = "N", default_value_t = 9)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    repetitions: u32,
    /// One distance and few repetitions: a minute or two on two cores.
    #[arg(long)]
    quick: bool,
    /// Threads; 0 for one per core.
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
    #[command(flatten)]
    json: JsonOption,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    match &options.what {
        Measurement::Traversal(options) => traversal(options),
        Measurement::Stereo(options) => stereo(options),
    }
}

/// What is measured of the methods.
fn methods() -> Vec<StereoOptions> {
    let every = Method::value_variants().iter().map(|&method| StereoOptions::from(method));
    let edges = [Method::Buffer, Method::Atomic]
        .map(|method| StereoOptions { verify: Some(Verify::Edges), ..method.into() });
    every.chain(edges).collect()
}

fn stereo(options: &Stereo) -> Result<ExitCode, Failure> {
    let scenes: Vec<PathBuf> = match &options.scenes[..] {
        [] => STEREO_SCENES.iter().map(PathBuf::from).collect(),
        scenes => scenes.to_vec(),
    };
    let mut cpu = Cpu::new(options.threads).work()?;
    let methods = methods();
    let mut lines = Vec::new();
    for path in &scenes {
        match measure_scene(options, path, &methods, &mut cpu) {
            Ok(measured) => lines.extend(measured),
            // Models that are not there are left out of the usual scenes, and missed among chosen ones.
            Err(Failure::Usage(error)) if options.scenes.is_empty() => {
                warn(&[format!("left out: {error:#}")])
            }
            Err(failure) => return Err(failure),
        }
    }
    let text: Vec<_> = lines.iter().map(ToString::to_string).collect();
    options.json.publish_text(&text.join("\n"), || json_lines(&lines))?;
    Ok(ExitCode::SUCCESS)
}

/// Measures a scene at each size, distance of the eyes and number of lights.
fn measure_scene(
    options: &Stereo,
    path: &Path,
    methods: &[StereoOptions],
    cpu: &mut Cpu,
) -> Result<Vec<BenchLine>, Failure> {
    let path = locate::scene(Some(path)).usage()?;
    let loaded = scene::load(&path).with_context(|| format!("bad scene {}", path.display())).usage()?;
    let (distances, repetitions) = match options.quick {
        true => (&options.interaxial[..1], options.repetitions.min(3)),
        false => (&options.interaxial[..], options.repetitions),
    };
    let mut lines = Vec::new();
    for (&size, &interaxial, &lights) in every(&options.size, distances, &options.lights) {
        let mut scene = loaded.clone();
        let overrides = Overrides {
            size: Some(size),
            interaxial_px: Some(interaxial),
            lights: Some(lights),
            diffuse: !options.as_is,
        };
        overrides.apply(&mut scene).usage()?;
        let data = SceneData::new(&scene, Quality::Full).usage()?;
        let name = format!("{} {}x{} e={interaxial} lights={lights}", scene.name, size[0], size[1]);
        let case = bench::stereo::Case { name, data: &data, methods, repetitions: repetitions as usize };
        let mut progress = Progress::new();
        let mut tell = |done, total| progress.update(&case.name, done, total);
        lines.extend(bench::stereo::stereo(cpu, &case, &mut tell).work()?);
    }
    Ok(lines)
}

/// All combinations.
fn every<'a, A, B, C>(a: &'a [A], b: &'a [B], c: &'a [C]) -> impl Iterator<Item = (&'a A, &'a B, &'a C)> {
    a.iter().flat_map(move |a| b.iter().flat_map(move |b| c.iter().map(move |c| (a, b, c))))
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
    let scene = scene::load(&path).with_context(|| format!("bad scene {}", path.display())).usage()?;
    Ok(Case::of(&scene))
}
