//! `parallax diff`.

use super::failure::{Blame, Failure};
use super::options::{Loaded, MethodOptions, SceneOptions, SidesOptions};
use super::progress::Progress;
use super::report::{self, JsonOption};
use parallax::backend::{Cpu, Gpu, Profile};
use parallax::build::Quality;
use parallax::diff::{self, Differential};
use parallax::render::SceneData;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  parallax diff                                the default scene on the CPU and on the best GPU
  parallax diff scenes/spot.toml --adapter llvmpipe --size 160x120
  parallax diff model.ply --profile fast --json difference.json

In the strict profile every bit of every stage must be equal; in the fast one stated bounds hold.
Exit code: 0 when the backends agree, 1 when they do not.";

/// Options of `parallax diff`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    #[command(flatten)]
    scene: SceneOptions,
    #[command(flatten)]
    method: MethodOptions,
    #[command(flatten)]
    sides: SidesOptions,
    /// Arithmetic of the GPU, and what is asked of the comparison: the same bits, or stated bounds.
    #[arg(long, value_enum, default_value_t)]
    profile: Profile,
    #[command(flatten)]
    json: JsonOption,
}

/// What a comparison tells.
#[derive(Serialize)]
struct Report {
    scene: String,
    scene_file: PathBuf,
    width: u32,
    height: u32,
    method: &'static str,
    #[serde(flatten)]
    differential: Differential,
    warnings: Vec<String>,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let stereo = options.method.stereo()?;
    let Loaded { scene, path, warnings, .. } = options.scene.load()?;
    report::warn(&warnings);
    let data = SceneData::new(&scene, Quality::Full).usage()?;
    stereo.check_size(&data).usage()?;
    let mut gpu = Gpu::open(options.profile, options.sides.adapter.as_deref()).work()?;
    let mut cpu = Cpu::new(options.sides.threads).work()?;
    let mut progress = Progress::new();
    let mut tell = |done, total| progress.update("comparing", done, total);
    let differential = diff::against_gpu(&mut cpu, &mut gpu, &data, &stereo, &mut tell).work()?;
    drop(progress);
    let equal = differential.equal;
    options.json.publish(&Report {
        scene: scene.name,
        scene_file: path,
        width: scene.rig.width,
        height: scene.rig.height,
        method: stereo.method.name(),
        differential,
        warnings,
    })?;
    Ok(if equal { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "{} ({}), 2 × {}×{}", self.scene, self.scene_file.display(), self.width, self.height)?;
        self.differential.fmt(f)
    }
}
