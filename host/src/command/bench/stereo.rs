//! `parallax bench stereo`.

use super::json_lines;
use crate::command::failure::{Blame, Failure};
use crate::command::locate;
use crate::command::options::size;
use crate::command::progress::Progress;
use crate::command::report::{JsonOption, save, warn};
use anyhow::anyhow;
use clap::ValueEnum;
use parallax::backend::{Backend, Cpu};
use parallax::bench::BenchLine;
use parallax::bench::stereo::{Case, HEADLINES, Measured, Part, Setting, mean, page, stereo};
use parallax::build::Quality;
use parallax::render::{Method, Overrides, SceneData, Shadows, StereoOptions, Verify};
use parallax::scene::Scene;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// For `--help`.
pub const EXAMPLES: &str = "\
Examples:
  parallax bench stereo --quick --html stereo.html      all parts, small: two minutes on two cores
  parallax bench stereo --json all.jsonl --html all.html  the papers' benchmarks in full: about an hour
  parallax bench stereo --part target,table1
  parallax bench stereo dragon --size 200x200,600x600 --interaxial 15 --json dragon.jsonl
  parallax bench stereo default --as-is";

/// Repetitions where none are asked for: of all parts but the target, which has 9; and in a hurry.
const REPETITIONS: [u32; 2] = [3, 1];
const TARGET_REPETITIONS: [u32; 2] = [9, 2];

/// Options of `parallax bench stereo`.
#[derive(clap::Args)]
pub struct Options {
    /// Scene files, models or names of shipped scenes, instead of the parts.
    #[arg(value_name = "SCENE", conflicts_with_all = ["part", "quick", "html"])]
    scenes: Vec<PathBuf>,
    /// What is measured [default: all parts].
    #[arg(long, value_enum, value_name = "PART", value_delimiter = ',')]
    part: Vec<Part>,
    /// Smaller pictures, fewer steps and repetitions.
    #[arg(long)]
    quick: bool,
    /// Write plots and tables to FILE, beside what the papers print.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Sizes of each picture of SCENE [default: 600x600].
    #[arg(long, value_name = "WxH", value_parser = size, value_delimiter = ',', requires = "scenes")]
    size: Vec<[u32; 2]>,
    /// Distances between the eyes in pixels of the zero-parallax plane [default: 15,50].
    #[arg(long, value_name = "PX", value_delimiter = ',', requires = "scenes")]
    interaxial: Vec<f32>,
    /// Numbers of lights [default: 5].
    #[arg(long, value_name = "N", value_delimiter = ',', requires = "scenes")]
    lights: Vec<u32>,
    /// Keep SCENE's highlights, mirrors and glass: otherwise all its materials are matt, as Al-Hagri's are.
    #[arg(long, requires = "scenes")]
    as_is: bool,
    /// How often everything is run; medians and quartiles are over these [default: 9 for SCENE and the part `target`, 3 for other
    /// parts; fewer with --quick].
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=1000))]
    repetitions: Option<u32>,
    /// Threads; 0 for one per core.
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
    #[command(flatten)]
    json: JsonOption,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let mut cpu = Cpu::new(options.threads).work()?;
    if options.scenes.is_empty() { parts(options, &mut cpu) } else { scenes(options, &mut cpu) }?;
    Ok(ExitCode::SUCCESS)
}

/// Measures the parts, and tells the headlines; the rest is in the files.
fn parts(options: &Options, cpu: &mut Cpu) -> Result<(), Failure> {
    let parts = if options.part.is_empty() { Part::value_variants() } else { &options.part[..] };
    let mut measured = Vec::new();
    for &part in parts {
        measured.extend(measure_part(options, part, cpu)?);
    }
    if measured.is_empty() {
        return Err(anyhow!("nothing was measured: all scenes are left out")).usage();
    }
    let lines: Vec<_> = measured.iter().flat_map(|measured| measured.lines.clone()).collect();
    let headlines = lines.iter().filter(|line| HEADLINES.contains(&line.metric.as_str()));
    let text: Vec<_> = headlines.map(ToString::to_string).collect();
    if let Some(path) = &options.html {
        save(path, "--html", &page(&cpu.describe(), &measured))?;
    }
    options.json.publish_text(&text.join("\n"), || json_lines(&lines))
}

fn measure_part(options: &Options, part: Part, cpu: &mut Cpu) -> Result<Vec<Measured>, Failure> {
    let usual = if part == Part::Target { TARGET_REPETITIONS } else { REPETITIONS };
    let repetitions = match options.repetitions.unwrap_or(usual[usize::from(options.quick)]) {
        _ if part.is_error() => 0,
        repetitions => repetitions as usize,
    };
    let (mut measured, mut missing) = (Vec::new(), Vec::new());
    let mut last = LastScene::default();
    for setting in part.settings(options.quick) {
        if missing.contains(&setting.scene) {
            continue;
        }
        if let Err(failure) = last.frame(setting.scene, 0) {
            let Failure::Usage(error) = failure else { return Err(failure) };
            warn(&[format!("{}: left out: {error:#}", part.name())]);
            missing.push(setting.scene);
            continue;
        }
        let lines = measure_setting(part, &setting, &mut last, cpu, repetitions)?;
        measured.push(Measured::new(part, setting, lines));
    }
    Ok(measured)
}

/// The frame of a scene that was read last: settings that follow each other mostly differ in something else.
#[derive(Default)]
struct LastScene(Option<(&'static str, u32, Scene)>);

impl LastScene {
    /// A frame of a shipped scene.
    fn frame(&mut self, name: &'static str, frame: u32) -> Result<Scene, Failure> {
        match &self.0 {
            Some((last, of, scene)) if (*last, *of) == (name, frame) => Ok(scene.clone()),
            _ => {
                let scene = locate::load(&locate::scene(Some(Path::new(name))).usage()?, frame)?;
                self.0 = Some((name, frame, scene.clone()));
                Ok(scene)
            }
        }
    }
}

/// The lines of a setting: of an animation, the means over its frames.
fn measure_setting(
    part: Part,
    setting: &Setting,
    last: &mut LastScene,
    cpu: &mut Cpu,
    repetitions: usize,
) -> Result<Vec<BenchLine>, Failure> {
    let methods = part.methods(setting);
    let mut frames = Vec::new();
    for frame in setting.frame_numbers() {
        let mut scene = last.frame(setting.scene, frame)?;
        setting.apply(&mut scene).usage()?;
        frames.push(measure(cpu, &scene, setting.label(), &methods, repetitions)?);
    }
    Ok(mean(&frames))
}

fn measure(
    cpu: &mut Cpu,
    scene: &Scene,
    name: String,
    methods: &[StereoOptions],
    repetitions: usize,
) -> Result<Vec<BenchLine>, Failure> {
    let data = SceneData::new(scene, Quality::Full).usage()?;
    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update(&name, done, total);
    let case = Case { name: name.clone(), data: &data, methods, repetitions };
    stereo(cpu, &case, &mut tell).work()
}

/// Measures the scenes that were named, by all methods.
fn scenes(options: &Options, cpu: &mut Cpu) -> Result<(), Failure> {
    let mut lines = Vec::new();
    for path in &options.scenes {
        lines.extend(measure_scene(options, path, cpu)?);
    }
    let text: Vec<_> = lines.iter().map(ToString::to_string).collect();
    options.json.publish_text(&text.join("\n"), || json_lines(&lines))
}

/// Measures a scene at each size, distance of the eyes and number of lights.
fn measure_scene(options: &Options, path: &Path, cpu: &mut Cpu) -> Result<Vec<BenchLine>, Failure> {
    let loaded = locate::load(&locate::scene(Some(path)).usage()?, 0)?;
    let sizes = or_default(&options.size, &[[600, 600]]);
    let distances = or_default(&options.interaxial, &[15.0, 50.0]);
    let numbers = or_default(&options.lights, &[5]);
    let repetitions = options.repetitions.unwrap_or(TARGET_REPETITIONS[0]);
    let mut lines = Vec::new();
    for (&size, &interaxial, &lights) in every(sizes, distances, numbers) {
        let mut scene = loaded.clone();
        let overrides = Overrides {
            size: Some(size),
            interaxial_px: Some(interaxial),
            lights: Some(lights),
            diffuse: !options.as_is,
        };
        overrides.apply(&mut scene).usage()?;
        let name = format!("{} {}x{} e={interaxial} lights={lights}", scene.name, size[0], size[1]);
        lines.extend(measure(cpu, &scene, name, &methods(), repetitions as usize)?);
    }
    Ok(lines)
}

fn or_default<'a, T>(given: &'a [T], default: &'a [T]) -> &'a [T] {
    if given.is_empty() { default } else { given }
}

/// What is measured of the methods.
fn methods() -> Vec<StereoOptions> {
    let every = Method::value_variants().iter().map(|&method| StereoOptions::from(method));
    let edges = [Method::Buffer, Method::Atomic]
        .map(|method| StereoOptions { verify: Some(Verify::Edges), ..method.into() });
    let proving = [Method::Naive, Method::Guided]
        .map(|method| StereoOptions { shadows: Shadows::Prove, ..method.into() });
    every.chain(edges).chain(proving).collect()
}

/// All combinations.
fn every<'a, A, B, C>(a: &'a [A], b: &'a [B], c: &'a [C]) -> impl Iterator<Item = (&'a A, &'a B, &'a C)> {
    a.iter().flat_map(move |a| b.iter().flat_map(move |b| c.iter().map(move |c| (a, b, c))))
}
