//! `parallax render`.

use super::choice::ChoiceOptions;
use super::failure::{Blame, Failure};
use super::frames::{self, Frames};
use super::options::{DeviceOptions, Loaded, MethodOptions, SceneOptions};
use super::progress::Progress;
use super::report::{self, JsonOption, duration, grouped};
use parallax::backend::{self, Backend, Cpu, Device};
use parallax::build::Quality;
use parallax::metrics::ViewError;
use parallax::output::{self, Diagnostics, Format, Scales};
use parallax::render::stereo::statistics::StereoReport;
use parallax::render::stereo::time_view;
use parallax::render::{self, Frame, Method, RayTotals, Samples, SceneData, StageTime, StereoOptions};
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::hash::{DefaultHasher, Hasher};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

const EXAMPLES: &str = "\
Examples:
  parallax render                              the default scene, in every format, into the folder `out`
  parallax render scenes/spot.toml --size 1200x900 --format anaglyph
  parallax render model.ply --interaxial 20 --aov --out pictures
  parallax render --backend gpu --adapter llvmpipe --json -
  parallax render --method atomic --verify edges --first right
  parallax render spheres --method atomic --maps --reference
  parallax render default --samples adaptive-2 --method scanline
  parallax render dragon --budget-ms 200       the best picture of that time, by what `parallax study dragon` has shown
  parallax render spheres_turned --frames 0..239 --out turning    (stopped, it goes on where it was)

Files: NAME.exr holds both views in linear light (attribute multiView; with --aov also t, disparity, prim_id
and normal); NAME_left.png, NAME_right.png, NAME_anaglyph.png and NAME_side-by-side.png are sRGB.

Maps (of the view that is made from the other one):
  map        reused grey, verified blue, hole orange, gap yellow, bad red, guided light blue, unguided green,
             not sampled black; there is none where the second view was traced
  disparity  blue behind the zero-parallax plane, red in front of it
  rays       lighter pixels took more rays, of all kinds
  time       lighter pixels take longer, measured on the processor
  error      distance from the traced view, in 8-bit colours times 25.5";

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
    /// Write pictures of how the second view was made: NAME_map.png (what became of each pixel), NAME_disparity.png,
    /// NAME_rays.png and, with one ray per pixel, NAME_time.png.
    #[arg(long)]
    maps: bool,
    /// Render the pair by the method `naive`, too, and tell how far the second view is from it; with --maps also
    /// NAME_error.png.
    #[arg(long)]
    reference: bool,
    #[command(flatten)]
    choice: ChoiceOptions,
    /// Frames of an animation, first and last: NAME_000000.exr and so on. What is there already is kept.
    #[arg(long, value_name = "A..B")]
    frames: Option<Frames>,
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
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<ViewError>,
    #[serde(skip_serializing_if = "Option::is_none")]
    maps: Option<Scales>,
    warnings: Vec<String>,
    files: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let stereo = options.method.stereo()?;
    if options.choice.is_made() {
        return by_study(options);
    }
    match options.frames {
        Some(frames) => animate(options, &stereo, frames),
        None => {
            let started = Instant::now();
            let loaded = options.scene.load()?;
            report::warn(&loaded.warnings);
            let mut device = backend::select(&options.device.selection()).work()?;
            let name = loaded.scene.name.clone();
            let frame = Render { stereo: &stereo, quality: Quality::Full, name: &name, started };
            options.json.publish(&render(options, &frame, loaded, &mut device)?)?;
            Ok(ExitCode::SUCCESS)
        }
    }
}

/// Renders with the settings that a study suggests.
fn by_study(options: &Options) -> Result<ExitCode, Failure> {
    let started = Instant::now();
    let mut loaded = options.scene.load()?;
    report::warn(&loaded.warnings);
    let selection = options.device.selection();
    let mut device = backend::select(&selection).work()?;
    let settings = options.choice.choose(&loaded.scene, &device, selection.profile)?;
    loaded.scene.max_depth = settings.max_depth.unwrap_or(loaded.scene.max_depth);
    let name = loaded.scene.name.clone();
    let frame = Render { stereo: &settings.stereo, quality: settings.quality, name: &name, started };
    options.json.publish(&render(options, &frame, loaded, &mut device)?)?;
    Ok(ExitCode::SUCCESS)
}

/// Renders the frames that are not there yet. JSON is an object a line, for each frame that was rendered.
fn animate(options: &Options, stereo: &StereoOptions, frames: Frames) -> Result<ExitCode, Failure> {
    let first = options.scene.load_frame(frames.first)?;
    report::warn(&first.warnings);
    let mut device = backend::select(&options.device.selection()).work()?;
    frames::claim(&options.out, &first.scene.name, &settings(options, stereo, &first)?)?;
    let (mut text, mut lines) = (Vec::new(), Vec::new());
    for frame in frames.first..=frames.last {
        let picture = frames::picture(&options.out, &first.scene.name, frame);
        if picture.is_file() {
            text.push(format!("frame {frame}: {} is there", picture.display()));
            continue;
        }
        let started = Instant::now();
        let loaded = options.scene.load_frame(frame)?;
        let name = frames::name(&first.scene.name, frame);
        let of_frame = Render { stereo, quality: Quality::Full, name: &name, started };
        let report = render(options, &of_frame, loaded, &mut device)?;
        let rays = grouped(report.rays.all());
        text.push(format!(
            "frame {frame}: {} in {}, {rays} rays",
            picture.display(),
            duration(report.seconds)
        ));
        lines.push(serde_json::to_string(&report).work()?);
    }
    options.json.publish_text(&text.join("\n"), || Ok(lines.join("\n")))?;
    Ok(ExitCode::SUCCESS)
}

/// Everything on which the files of a frame depend, but for the frame.
fn settings(
    options: &Options,
    stereo: &StereoOptions,
    first: &Loaded,
) -> Result<Map<String, Value>, Failure> {
    let rig = &first.scene.rig;
    let mut content = DefaultHasher::new();
    content.write(&std::fs::read(&first.path).work()?);
    let settings: [(_, Value); 13] = [
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("scene", format!("{:016x}", content.finish()).into()),
        ("width", rig.width.into()),
        ("height", rig.height.into()),
        ("interaxial_px", rig.interaxial_px.into()),
        ("lights", first.scene.lights.len().into()),
        ("diffuse", options.scene.is_diffuse().into()),
        ("method", format!("{stereo:?}").into()),
        ("profile", options.device.selection().profile.name().into()),
        ("format", format!("{:?}", options.format).into()),
        ("aov", options.aov.into()),
        ("maps", options.maps.into()),
        ("reference", options.reference.into()),
    ];
    Ok(settings.map(|(key, value)| (key.to_string(), value)).into_iter().collect())
}

/// How one pair is rendered.
#[derive(Clone, Copy)]
struct Render<'a> {
    stereo: &'a StereoOptions,
    quality: Quality,
    /// What the files are called.
    name: &'a str,
    started: Instant,
}

/// Renders the scene and writes its files.
fn render(
    options: &Options,
    frame: &Render<'_>,
    loaded: Loaded,
    device: &mut Device,
) -> Result<Report, Failure> {
    let Render { stereo, quality, name, started } = *frame;
    let Loaded { scene, path, warnings, seconds } = loaded;
    let mut stages = vec![StageTime { view: None, stage: "load", seconds }];
    let mut clock = Clock(Instant::now());
    let data = SceneData::new(&scene, quality).usage()?;
    stereo.check_size(&data).usage()?;
    stages.push(clock.stage("build"));

    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update(name, done, total);
    let frame = render::render(device, &data, stereo, &mut tell).work()?;
    drop(progress);
    stages.extend(frame.times);

    let second = stereo.first.eyes()[1];
    let reference = match options.reference {
        true => Some(reference(stereo, &data, device, name)?.images),
        false => None,
    };
    let error =
        reference.as_ref().map(|truth| ViewError::new(&frame.images.views[second], &truth.views[second]));
    clock = Clock(Instant::now());
    let (images, maps, mut files) = (&frame.images, &frame.maps, Vec::new());
    let mut scales = None;
    if options.maps {
        let seconds = times(options, stereo, &data)?;
        let (seconds, reference) = (seconds.as_deref(), reference.as_ref());
        let shown = Diagnostics { images, maps, second, seconds, reference };
        let (pictures, of_maps) = output::write_maps(&shown, &options.out, name).work()?;
        files.extend(pictures);
        scales = Some(of_maps);
        stages.push(clock.stage("maps"));
    }
    files.extend(output::write(images, &options.out, name, options.format, options.aov).work()?);
    stages.push(clock.stage("write files"));
    Ok(Report {
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
        profile: options.device.selection().profile.name(),
        stages,
        seconds: started.elapsed().as_secs_f64(),
        rays: frame.rays,
        stereo: frame.stereo,
        error,
        maps: scales,
        warnings,
        files,
    })
}

/// The same pair, traced.
fn reference(
    stereo: &StereoOptions,
    data: &SceneData,
    device: &mut Device,
    name: &str,
) -> Result<Frame, Failure> {
    let naive = StereoOptions { first: stereo.first, samples: stereo.samples, ..StereoOptions::default() };
    let (mut progress, what) = (Progress::new(), format!("{name}, the reference"));
    let mut tell = |done, total| progress.update(&what, done, total);
    render::render(device, data, &naive, &mut tell).work()
}

/// How long each pixel of the second view takes, where that is known.
fn times(options: &Options, stereo: &StereoOptions, data: &SceneData) -> Result<Option<Vec<f32>>, Failure> {
    if stereo.samples != Samples::One || stereo.method == Method::Ideal {
        return Ok(None);
    }
    let mut cpu = Cpu::new(options.device.selection().threads).work()?;
    Ok(Some(time_view::seconds(&mut cpu, data, stereo).work()?))
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
        if let Some(error) = &self.error {
            tell_error(f, error)?;
        }
        if let Some(Scales { disparity_px, rays, time_us }) = self.maps {
            let time = time_us.map_or(String::new(), |us| format!(", {us:.1} µs"));
            writeln!(f, "Maps: full colour is a disparity of {disparity_px:.1} px, white {rays} rays{time}")?;
        }
        writeln!(f, "Wrote")?;
        self.files.iter().try_for_each(|file| writeln!(f, "  {}", file.display()))
    }
}

/// How far the second view is from the traced one.
fn tell_error(f: &mut fmt::Formatter, error: &ViewError) -> fmt::Result {
    let ViewError { mse, psnr_db, differing_percent, distance, .. } = *error;
    let ViewError { wrong_depth_percent, largest_disparity_error_px, .. } = *error;
    writeln!(f, "Error against `naive`")?;
    writeln!(f, "  MSE {mse:.4}, PSNR {psnr_db:.1} dB")?;
    writeln!(f, "  {differing_percent:.2} % of the pixels differ, by {distance:.2} of 255 on average")?;
    writeln!(
        f,
        "  {wrong_depth_percent:.3} % have another depth; disparities differ by up to {largest_disparity_error_px:.1} px"
    )
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
