//! Measures the points of a study.
//!
//! All points of a scene run in turn in each repetition, so that what disturbs one disturbs all. A time is that of the passes of both
//! views; building, uploading and reading back are left out. Errors are the second view's, which has everything that a knob can spoil.

use super::knob::Knob;
use super::{Machine, Settings, StrictPrice, gain, grid};
use crate::backend::{Backend, Device, Profile};
use crate::bench::quartiles::quartiles;
use crate::build::Quality;
use crate::metrics::{Perceived, ViewError, rel_mse, srgb8};
use crate::render::band::Band;
use crate::render::stereo::Plan;
use crate::render::{
    Method, RayTotals, RenderError, Renderer, Samples, SceneData, StereoOptions, ViewImages, render,
};
use crate::scene::Scene;
use serde::Serialize;

/// Rays per pixel of the truth: more than any knob asks for.
const TRUTH: Samples = Samples::Jittered(8);

/// A pixel whose ꟻLIP is above this looks different.
const VISIBLE: f64 = 0.1;

/// What to study.
pub struct Study<'a> {
    /// For reports.
    pub name: String,
    /// The scene.
    pub scene: &'a Scene,
    /// Knobs of which all combinations are tried; if there are none, each knob by itself.
    pub knobs: &'a [&'a Knob],
    /// How often everything is run.
    pub repetitions: usize,
}

/// How far a picture is from another one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Distance {
    /// Mean squared error, PSNR, differing pixels, disparities.
    #[serde(flatten)]
    pub view: ViewError,
    /// Relative mean squared error of linear colours.
    pub rel_mse: f64,
    /// Mean ꟻLIP.
    pub flip: f64,
    /// Percentage of pixels whose ꟻLIP is above 0.1.
    pub flip_visible_percent: f64,
}

/// A point of a study: settings for a scene on a backend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// Which scene.
    pub scene: String,
    /// Columns of a view.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Where it ran.
    pub backend: String,
    /// The arithmetic.
    pub profile: &'static str,
    /// The knobs that are not as usual.
    pub settings: String,
    /// Median time of the passes of both views.
    pub milliseconds: f64,
    /// Distance of the quartiles.
    pub spread: f64,
    /// What it gives for its time, over what the traced pair gives: [`gain`](super::gain). In JSON null for +∞.
    pub gain: f64,
    /// Rays of both views, by kind.
    pub rays: RayTotals,
    /// Bytes of the scene and its structure, as they are uploaded.
    pub scene_bytes: u64,
    /// Most bytes of buffers on the backend at once: the scene, and what the passes of both views of a band write.
    pub peak_bytes: u64,
    /// Against the traced pair with one ray per pixel.
    pub to_traced: Distance,
    /// Against the traced pair with many rays per pixel.
    pub to_truth: Distance,
}

/// A point, and the picture of its errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The figures.
    pub point: Point,
    /// ꟻLIP of each pixel against the traced pair.
    pub flip: Vec<f64>,
}

/// A scene on a backend.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// All points; the first one is the traced pair.
    pub points: Vec<Measured>,
    /// The price of the strict profile, if it was studied.
    pub strict: Option<StrictPrice>,
}

impl Case {
    /// The points without their pictures.
    pub fn points(&self) -> Vec<&Point> {
        self.points.iter().map(|measured| &measured.point).collect()
    }
}

/// Measures all points of a scene on `machine`, without those of the fast profile where that is the strict one. `progress` is told how
/// many of how many runs are done.
///
/// # Errors
/// When the scene cannot be rendered.
pub fn study(
    study: &Study<'_>,
    machine: &mut Machine,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Case, RenderError> {
    let data = SceneData::new(study.scene, Quality::Full)?;
    let points: Vec<_> = grid(&data, study.knobs)
        .into_iter()
        .filter(|s| s.profile == Profile::Strict || !machine.has_one_arithmetic())
        .collect();
    let scenes = Scenes::new(study.scene, data, &points)?;
    let many = StereoOptions { samples: TRUTH, ..Method::Naive.into() };
    let strict = machine.device(Profile::Strict);
    let truth = both(strict, &scenes.all[0].1, &many)?;
    let traced = both(strict, &scenes.all[0].1, &Method::Naive.into())?;
    let mut measured = Vec::new();
    let mut times = vec![Vec::new(); points.len()];
    let total = (points.len() * (study.repetitions + 1)) as u64;
    for round in 0..=study.repetitions {
        for (number, settings) in points.iter().enumerate() {
            let device = machine.device(settings.profile);
            let data = scenes.of(settings);
            if round == 0 {
                measured.push(quality(study, device, data, settings, [&traced, &truth])?);
            } else {
                let cost = cost(device, data, &settings.stereo, 1)?;
                times[number].push(cost.seconds);
                measured[number].point.peak_bytes = cost.peak_bytes;
            }
            progress((round * points.len() + number + 1) as u64, total);
        }
    }
    for (measured, times) in measured.iter_mut().zip(&times) {
        let [low, median, high] = quartiles(times.iter().map(|seconds| 1e3 * seconds));
        (measured.point.milliseconds, measured.point.spread) = (median, high - low);
    }
    if let Some(base) = measured.first().map(|measured| measured.point.clone()) {
        measured.iter_mut().for_each(|measured| measured.point.gain = gain(&measured.point, &base));
    }
    let mut case = Case { points: measured, strict: None };
    case.strict = StrictPrice::new(&case.points(), machine.has_one_arithmetic());
    Ok(case)
}

/// The scene as each build quality and depth limit has it.
struct Scenes {
    all: Vec<((Quality, Option<u32>), SceneData)>,
}

impl Scenes {
    fn new(scene: &Scene, full: SceneData, points: &[Settings]) -> Result<Self, RenderError> {
        let mut all = vec![((Quality::Full, None), full)];
        for settings in points {
            let key = (settings.quality, settings.max_depth);
            if !all.iter().any(|(known, _)| *known == key) {
                let mut scene = scene.clone();
                scene.max_depth = settings.max_depth.unwrap_or(scene.max_depth);
                all.push((key, SceneData::new(&scene, settings.quality)?));
            }
        }
        Ok(Self { all })
    }

    fn of(&self, settings: &Settings) -> &SceneData {
        let key = (settings.quality, settings.max_depth);
        let found = self.all.iter().find(|(known, _)| *known == key);
        &found.unwrap_or(&self.all[0]).1
    }
}

/// A view, and what a viewer sees of it.
struct Picture {
    view: ViewImages,
    perceived: Perceived,
}

impl Picture {
    fn new(view: ViewImages, width: u32) -> Self {
        let perceived = Perceived::new(&srgb8(&view.colour), width as usize);
        Self { view, perceived }
    }
}

/// Both views: of a truth, as either can be the one that a method makes from the other.
fn both(device: &mut Device, data: &SceneData, options: &StereoOptions) -> Result<[Picture; 2], RenderError> {
    let images = render(device, data, options, &mut |_, _| {})?.images;
    Ok(images.views.map(|view| Picture::new(view, images.width)))
}

fn quality(
    study: &Study<'_>,
    device: &mut Device,
    data: &SceneData,
    settings: &Settings,
    [traced, truth]: [&[Picture; 2]; 2],
) -> Result<Measured, RenderError> {
    let mut frame = render(device, data, &settings.stereo, &mut |_, _| {})?;
    let [_, second] = settings.stereo.first.eyes();
    let shown = Picture::new(std::mem::take(&mut frame.images.views[second]), frame.images.width);
    let (to_traced, flip) = distance(&shown, &traced[second]);
    let (to_truth, _) = distance(&shown, &truth[second]);
    let bytes = size_of_val(&data.rows[..])
        + size_of_val(&data.triangles[..])
        + size_of_val(&data.records[..])
        + size_of_val(&data.texels[..]);
    let point = Point {
        scene: study.name.clone(),
        width: data.views[0].width,
        height: data.views[0].height,
        backend: device.describe(),
        profile: settings.profile.name(),
        settings: settings.label(),
        milliseconds: 0.0,
        spread: 0.0,
        gain: 1.0,
        rays: frame.rays,
        scene_bytes: bytes as u64,
        peak_bytes: 0,
        to_traced,
        to_truth,
    };
    Ok(Measured { point, flip })
}

fn distance(shown: &Picture, truth: &Picture) -> (Distance, Vec<f64>) {
    let flip = shown.perceived.flip(&truth.perceived);
    let pixels = flip.len().max(1) as f64;
    let visible = flip.iter().filter(|&&value| value > VISIBLE).count();
    let distance = Distance {
        view: ViewError::new(&shown.view, &truth.view),
        rel_mse: rel_mse(&shown.view.colour, &truth.view.colour),
        flip: flip.iter().sum::<f64>() / pixels,
        flip_visible_percent: 100.0 * visible as f64 / pixels,
    };
    (distance, flip)
}

/// What the passes of both views take.
pub(super) struct Cost {
    pub seconds: f64,
    /// Most bytes of buffers at once, the scene included.
    pub peak_bytes: u64,
}

/// Runs the passes of both views so many times and takes the time of the last one: from the second on, no page of a buffer is touched for
/// the first time. Nothing is read back, and buffers are those that this needs.
pub(super) fn cost(
    device: &mut Device,
    data: &SceneData,
    options: &StereoOptions,
    runs: u32,
) -> Result<Cost, RenderError> {
    // What others have held until now does not count.
    device.take_peak_bytes();
    let plan = Plan::new(data, options, false)?;
    let mut renderer = Renderer::new(device, data)?;
    let rows = renderer.suggested_rows(&plan);
    let mut seconds = 0.0;
    for band in Band::of_picture(data.views[0].height, rows) {
        let buffers = renderer.pair_buffers(&plan, band)?;
        for _ in 1..runs {
            renderer.time_pair(&plan, &buffers, band)?;
        }
        let times = renderer.time_pair(&plan, &buffers, band)?;
        seconds += times.iter().filter(|time| time.view.is_some()).map(|time| time.seconds).sum::<f64>();
        renderer.release(buffers);
    }
    drop(renderer);
    Ok(Cost { seconds, peak_bytes: device.take_peak_bytes() })
}
