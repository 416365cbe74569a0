//! Options that let a study choose how a picture is rendered.

use super::failure::{Blame, Failure};
use anyhow::Context;
use parallax::backend::{Backend, Device, Profile};
use parallax::scene::Scene;
use parallax::study::{self, Choice, Settings, Target, Wish};
use std::path::PathBuf;

/// What a study chooses instead of the user.
const CHOSEN: [&str; 9] =
    ["method", "verify", "shadows", "first", "depth", "reflections", "samples", "tolerance", "frames"];

/// By what a study chooses.
#[derive(clap::Args)]
pub struct ChoiceOptions {
    /// Choose settings by a study (see --study): the best picture whose passes take at most MS milliseconds for both views.
    #[arg(long, value_name = "MS", conflicts_with_all = CHOSEN)]
    budget_ms: Option<f64>,
    /// Choose settings by a study: the fastest ones whose mean ꟻLIP against many rays per pixel is at most ERROR (with --budget-ms: the
    /// best within both).
    #[arg(long, value_name = "ERROR", conflicts_with_all = CHOSEN)]
    max_error: Option<f64>,
    /// The study by which --budget-ms and --max-error choose: what `parallax study` has written.
    #[arg(long, value_name = "FILE", default_value = "study/study.jsonl")]
    study: PathBuf,
}

impl ChoiceOptions {
    /// Whether a study chooses at all.
    pub fn is_made(&self) -> bool {
        self.budget_ms.is_some() || self.max_error.is_some()
    }

    /// The settings for a scene on `device`, by the study's points of that backend alone; says on stderr which ones they are. A CPU's
    /// points are all strict, which is the same code there as fast.
    pub fn choose(&self, scene: &Scene, device: &Device, profile: Profile) -> Result<Settings, Failure> {
        let file = self.study.display();
        let study = std::fs::read_to_string(&self.study)
            .with_context(|| format!("cannot read {file}; `parallax study SCENE` makes a study"))
            .usage()?;
        let pixels = u64::from(scene.rig.width) * u64::from(scene.rig.height);
        let profile = if matches!(device, Device::Cpu(_)) { Profile::Strict } else { profile };
        let backend = device.describe();
        let target = Target { scene: &scene.name, pixels, backend: &backend, profile: profile.name() };
        let wish = Wish { budget_ms: self.budget_ms, max_error: self.max_error };
        let choice = study::choose(&study, &target, &wish).with_context(|| file.to_string()).usage()?;
        let Choice { settings, milliseconds, error } = choice;
        eprintln!("chosen: {} (about {milliseconds:.1} ms, an error of {error:.4})", settings.label());
        Ok(settings)
    }
}
