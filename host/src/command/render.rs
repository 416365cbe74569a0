//! `parallax render`.

use super::failure::{Blame, Failure};
use super::options::{DeviceOptions, Loaded, MethodOptions, SceneOptions};
use super::progress::Progress;
use super::report::{self, JsonOption, duration, grouped};
use parallax::backend::{self, Backend};
use parallax::build::Quality;
use parallax::output::{self, Format};
use parallax::render::stereo::statistics::StereoReport;
use parallax::render::{self, RayTotals, SceneData, StageTime};
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

const EXAMPLES: &str = "\
Examples:
  parallax render                              the default scene, in every format, into the folder `out`
  parallax render scenes/spot.toml --size 1200x900 --format anaglyph
  parallax render model.ply --interaxial 20 --aov --out pictures
  parallax render --backend gpu --adapter llvmpipe --json -

Files: NAME.exr holds both views in linear light (attribute multiView; with --aov also t, disparity, prim_id
and normal); NAME_left.png, NAME_right.png, NAME_anaglyph.png and NAME_side-by-side.png are sRGB.";

/// Options of `parallax render`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    #[command(flatten)]
    scene: SceneOptions,
    #[command(flatten)]
    method: MethodOptions,
    #[command(flatten)]
    device: DeviceOptions,
    /// Which PNG files to write.
    #[arg(long, value_enum, default_value = "all")]
    format: Format,
    /// Add t, disparity, primitive id and normal to the EXR file.
    #[arg(long)]
    aov: bool,
    /// Folder for the files; it is made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
    #[command(flatten)]
    json: JsonOption,
}

/// What a rendering tells.
#[derive(Serialize)]
struct Report {
    scene: String,
    scene_file: PathBuf,
    primitives: u64,
    lights: usize,
    effects: Vec<&'static str>,
    width: u32,
    height: u32,
    interaxial_px: f32,
    method: &'static str,
    backend: String,
    profile: &'static str,
    stages: Vec<StageTime>,
    seconds: f64,
    rays: RayTotals,
    #[serde(skip_serializing_if = "Option::is_none")]
    stereo: Option<StereoReport>,
    warnings: Vec<String>,
    files: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let started = Instant::now();
    let stereo = options.method.stereo()?;
    let Loaded { scene, path, warnings, seconds } = options.scene.load()?;
    report::warn(&warnings);
    let mut stages = vec![StageTime { view: None, stage: "load", seconds }];
    let selection = options.device.selection();
    let mut device = backend::select(&selection).work()?;
    let mut clock = Clock(Instant::now());
    let data = SceneData::new(&scene, Quality::Full).usage()?;
    stages.push(clock.stage("build"));

    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update("rendering", done, total);
    let frame = render::render(&mut device, &data, &stereo, &mut tell).work()?;
    drop(progress);
    stages.extend(frame.times);

    clock = Clock(Instant::now());
    let files =
        output::write(&frame.images, &options.out, &scene.name, options.format, options.aov).work()?;
    stages.push(clock.stage("write files"));
    options.json.publish(&Report {
        scene: scene.name,
        scene_file: path,
        primitives: data.primitives(),
        lights: scene.lights.len(),
        effects: data.effect_names(),
        width: scene.rig.width,
        height: scene.rig.height,
        interaxial_px: scene.rig.interaxial_px,
        method: stereo.method.name(),
        backend: device.describe(),
        profile: selection.profile.name(),
        stages,
        seconds: started.elapsed().as_secs_f64(),
        rays: frame.rays,
        stereo: frame.stereo,
        warnings,
        files,
    })?;
    Ok(ExitCode::SUCCESS)
}

/// Times one thing after another.
struct Clock(Instant);

impl Clock {
    /// What has passed since the last time, as a stage of the whole picture.
    fn stage(&mut self, stage: &'static str) -> StageTime {
        let seconds = self.0.elapsed().as_secs_f64();
        self.0 = Instant::now();
        StageTime { view: None, stage, seconds }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "{} ({}): {} primitives, {} lights",
            self.scene,
            self.scene_file.display(),
            grouped(self.primitives),
            self.lights
        )?;
        let effects = if self.effects.is_empty() { "none".into() } else { self.effects.join(", ") };
        writeln!(f, "  effects     {effects}")?;
        writeln!(
            f,
            "  picture     2 × {}×{}, eyes {} px apart",
            self.width, self.height, self.interaxial_px
        )?;
        writeln!(f, "  backend     {}, {} profile, method {}", self.backend, self.profile, self.method)?;
        writeln!(f, "Time {}", duration(self.seconds))?;
        for time in &self.stages {
            let view = time.view.unwrap_or_default();
            writeln!(f, "  {view:<6}{:<12}{:>10}", time.stage, duration(time.seconds))?;
        }
        writeln!(f, "Rays {}", grouped(self.rays.all()))?;
        let RayTotals { primary, shadow, reflected, refracted } = self.rays;
        let kinds =
            [("primary", primary), ("shadow", shadow), ("reflected", reflected), ("refracted", refracted)];
        for (kind, count) in kinds {
            writeln!(f, "  {kind:<14}{:>14}", grouped(count))?;
        }
        if let Some(stereo) = &self.stereo {
            writeln!(f, "Second view")?;
            tell_stereo(f, stereo)?;
        }
        writeln!(f, "Wrote")?;
        self.files.iter().try_for_each(|file| writeln!(f, "  {}", file.display()))
    }
}

/// What the second view was made of.
fn tell_stereo(f: &mut fmt::Formatter, stereo: &StereoReport) -> fmt::Result {
    let StereoReport { reused, verified, holes, gaps, bad, overlapped, .. } = *stereo;
    let pixels = [("reused", reused), ("verified", verified), ("holes", holes), ("gaps", gaps), ("bad", bad)];
    for (kind, count) in pixels.into_iter().chain([("overlapped", overlapped)]) {
        writeln!(f, "  {kind:<14}{:>14}", grouped(count))?;
    }
    let StereoReport { largest_overlap, lemma_bound, m, saved_percent, worst_case_saved_percent, .. } =
        stereo;
    writeln!(f, "  {:<14}{largest_overlap:>14}  of at most {lemma_bound}", "on one pixel")?;
    writeln!(f, "  {:<14}{m:>14.4}", "M")?;
    writeln!(f, "  {:<14}{saved_percent:>12.1} %  at worst {worst_case_saved_percent:.1} %", "rays saved")
}
