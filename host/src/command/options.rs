//! Options that several subcommands share.

use super::failure::{Blame, Failure};
use super::locate;
use anyhow::anyhow;
use parallax::backend::{Choice, Profile, Selection};
use parallax::render::{
    Depth, First, Method, Overrides, Reflections, Samples, Shadows, StereoOptions, Verify,
};
use parallax::rig::DISPLAY_WIDTH;
use parallax::scene::Scene;
use std::path::PathBuf;
use std::time::Instant;

/// Which scene, and what is to be otherwise than it says.
#[derive(clap::Args)]
pub struct SceneOptions {
    /// A scene file (.toml), a model (.obj, .ply) or the name of a shipped scene [default: the default scene]
    #[arg(value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Size of each picture, for example 800x600; the depth that the scene's interaxial distance gives is
    /// kept.
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Distance between the eyes in pixels of the zero-parallax plane.
    #[arg(long, value_name = "PX", allow_negative_numbers = true)]
    interaxial: Option<f32>,
    /// Keep the first N lights, or add further ones around the scene and dim all to the same total.
    #[arg(long, value_name = "N")]
    lights: Option<u32>,
    /// Make all materials matt: no highlights, mirrors or glass.
    #[arg(long)]
    diffuse: bool,
}

/// A scene that has been read, and how long that took.
pub struct Loaded {
    /// The scene, with the changes that were asked for.
    pub scene: Scene,
    /// Its file.
    pub path: PathBuf,
    /// What a user should know about it.
    pub warnings: Vec<String>,
    /// Seconds.
    pub seconds: f64,
}

impl SceneOptions {
    /// Finds and reads the scene and changes it as asked.
    pub fn load(&self) -> Result<Loaded, Failure> {
        self.load_frame(0)
    }

    /// Whether all materials are made matt.
    pub fn is_diffuse(&self) -> bool {
        self.diffuse
    }

    /// The same for a frame of an animation.
    pub fn load_frame(&self, frame: u32) -> Result<Loaded, Failure> {
        let started = Instant::now();
        let path = locate::scene(self.scene.as_deref()).usage()?;
        let mut scene = locate::load(&path, frame)?;
        let overrides = Overrides {
            size: self.size,
            interaxial_px: self.interaxial,
            lights: self.lights,
            diffuse: self.diffuse,
        };
        overrides.apply(&mut scene).usage()?;
        let warnings = warnings(&scene);
        Ok(Loaded { scene, path, warnings, seconds: started.elapsed().as_secs_f64() })
    }
}

/// What the loader has put up with, and whether the rig, as it is now, breaks the guide of eq. (12).
fn warnings(scene: &Scene) -> Vec<String> {
    let of_rig = scene.rig.guide_warning(DISPLAY_WIDTH);
    scene.warnings.iter().map(ToString::to_string).chain(of_rig).collect()
}

/// How the pair is rendered.
#[derive(clap::Args)]
pub struct MethodOptions {
    /// How the second view is made.
    #[arg(long, value_enum, default_value_t)]
    method: Method,
    /// Which candidates of the second view a ray verifies [default: all for buffer and atomic, else none]
    #[arg(long, value_enum)]
    verify: Option<Verify>,
    /// How the second view knows which lights a point sees.
    #[arg(long, value_enum, default_value_t)]
    shadows: Shadows,
    /// Which view is traced; the other one is made from it.
    #[arg(long, value_enum, default_value_t)]
    first: First,
    /// Slots per pixel of the method `buffer`: `lemma` (as many as the nearest surface asks for), `adaptive` (as many
    /// as the traced view asks for) or a number.
    #[arg(long, value_name = "SLOTS", default_value = "lemma")]
    depth: Depth,
    /// Reflections and refractions of the second view: `trace` (rays of its own) or an angle in degrees (those of the
    /// traced view where the rays of both eyes are no farther apart).
    #[arg(long, value_name = "ANGLE", default_value = "trace")]
    reflections: Reflections,
    /// Rays per pixel: `1`; `nine` (with those on the edges, of which the middle one is reprojected for all); `2x2` to
    /// `8x8` (jittered, each reprojected by itself); `adaptive-1` to `adaptive-4` (the corners, and up to 17x17 where
    /// they differ).
    #[arg(long, value_name = "SAMPLES", default_value = "1")]
    samples: Samples,
    /// By how much colours (linear, 0 to 1) differ that ask for more rays of adaptive sampling [default: 0.0625]
    #[arg(long, value_name = "DIFFERENCE")]
    tolerance: Option<f32>,
}

impl MethodOptions {
    /// The same as the library wants it, if it goes together.
    pub fn stereo(&self) -> Result<StereoOptions, Failure> {
        let Self { method, verify, shadows, first, depth, reflections, samples, tolerance } = *self;
        let samples = match (samples, tolerance) {
            (samples, None) => samples,
            (Samples::Adaptive { levels, .. }, Some(tolerance)) => Samples::Adaptive { levels, tolerance },
            _ => return Err(anyhow!("--tolerance is for adaptive --samples")).usage(),
        };
        let options = StereoOptions { method, verify, shadows, first, depth, reflections, samples };
        options.check().usage()?;
        Ok(options)
    }
}

/// Where to render, and with which arithmetic.
#[derive(clap::Args)]
pub struct DeviceOptions {
    /// Where to render.
    #[arg(long, value_enum, default_value_t)]
    backend: Choice,
    #[command(flatten)]
    machine: MachineOptions,
    /// Arithmetic: the same bits everywhere, or the driver's own division, square root and contraction.
    #[arg(long, value_enum, default_value_t)]
    profile: Profile,
}

/// Which GPU, and how much of the CPU.
#[derive(clap::Args)]
struct MachineOptions {
    /// The GPU whose name contains NAME, software drivers included; see `parallax devices`.
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
    /// Threads of the CPU backend; 0 for one per core.
    #[arg(long, value_name = "N", default_value_t = 0)]
    threads: usize,
}

impl DeviceOptions {
    /// The same as the backends' library wants it.
    pub fn selection(&self) -> Selection {
        Selection {
            backend: self.backend,
            adapter: self.machine.adapter.clone(),
            profile: self.profile,
            threads: self.machine.threads,
        }
    }
}

/// The two sides of a comparison.
#[derive(clap::Args)]
pub struct SidesOptions {
    /// The GPU whose name contains NAME; by default the best, or a software driver if there is no hardware.
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
    /// Threads of the CPU backend; 0 for one per core.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub threads: usize,
}

/// On which backends something is measured, one after the other.
#[derive(clap::Args)]
pub struct BackendsOptions {
    /// Where to render; several by commas or by giving the option again. --adapter is for those that are no CPU.
    #[arg(long, value_enum, value_delimiter = ',', default_value = "auto")]
    backend: Vec<Choice>,
    #[command(flatten)]
    machine: MachineOptions,
}

impl BackendsOptions {
    /// A selection for each backend. The adapter is for those that can have one; for `cpu` only if there is no other, which is an error.
    pub fn selections(&self) -> Vec<Selection> {
        let all_cpu = self.backend.iter().all(|backend| *backend == Choice::Cpu);
        let adapter = |backend| self.machine.adapter.clone().filter(|_| backend != Choice::Cpu || all_cpu);
        let of = |&backend: &Choice| Selection {
            backend,
            adapter: adapter(backend),
            profile: Profile::default(),
            threads: self.machine.threads,
        };
        self.backend.iter().map(of).collect()
    }
}

/// Parses `800x600`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match parsed {
        Some([width, height]) if width > 0 && height > 0 => Ok([width, height]),
        _ => Err("expected width and height in pixels, for example 800x600".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::{BackendsOptions, MachineOptions, size};
    use parallax::backend::Choice;

    #[test]
    fn an_adapter_is_for_the_backends_that_can_have_one() {
        let of = |backend: &[Choice]| {
            let machine = MachineOptions { adapter: Some("card".into()), threads: 3 };
            let selections = BackendsOptions { backend: backend.to_vec(), machine }.selections();
            selections.into_iter().map(|selection| (selection.backend, selection.adapter.is_some())).collect()
        };
        let both: Vec<_> = of(&[Choice::Cpu, Choice::Gpu]);
        assert_eq!(both, [(Choice::Cpu, false), (Choice::Gpu, true)]);
        assert_eq!(of(&[Choice::Cpu]), [(Choice::Cpu, true)], "and that is refused where it is opened");
    }

    #[test]
    fn sizes() {
        assert_eq!(size("800x600"), Ok([800, 600]));
        for wrong in ["", "800", "x", "800x", "0x600", "800x-1", "800x600x2", "8e2x600", "99999999999x1"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }
}
