//! The registry of knobs.

use crate::backend::Profile;
use crate::build::Quality;
use crate::render::sampling::TOLERANCE;
use crate::render::{Depth, First, Method, Reflections, Samples, SceneData, Shadows, StereoOptions, Verify};
use parallax_shared::effects::Effects;
use std::num::NonZeroU32;

/// Everything that can be chosen of how a scene is rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// How the pair is made.
    pub stereo: StereoOptions,
    /// The arithmetic.
    pub profile: Profile,
    /// How well the acceleration structure is built.
    pub quality: Quality,
    /// Levels of reflection and refraction, if not the scene's own.
    pub max_depth: Option<u32>,
}

/// A knob: something that trades accuracy for time.
pub struct Knob {
    /// Its name.
    pub name: &'static str,
    /// What it belongs to.
    pub family: &'static str,
    /// What it should do.
    pub about: &'static str,
    /// From which settings it is turned by itself: some that can have all of its values.
    pub bases: &'static [fn() -> Settings],
    /// What it can be set to; the first value is the most accurate one.
    pub values: &'static [Value],
}

/// A value of a knob.
pub struct Value {
    /// Its name.
    pub name: &'static str,
    set: fn(&mut Settings),
}

const fn value(name: &'static str, set: fn(&mut Settings)) -> Value {
    Value { name, set }
}

/// Sets so many levels of adaptive sampling; the tolerance stays, if there is one.
fn adapt(settings: &mut Settings, levels: u32) {
    let tolerance = match settings.stereo.samples {
        Samples::Adaptive { tolerance, .. } => tolerance,
        _ => TOLERANCE,
    };
    settings.stereo.samples = Samples::Adaptive { levels, tolerance };
}

/// Sets the tolerance of adaptive sampling; does nothing to other sampling.
fn tolerate(settings: &mut Settings, difference: f32) {
    if let Samples::Adaptive { tolerance, .. } = &mut settings.stereo.samples {
        *tolerance = difference;
    }
}

/// One slot per pixel and so many `more`.
const fn slots(more: u32) -> Depth {
    Depth::Fixed(NonZeroU32::MIN.saturating_add(more))
}

/// The bases of knobs that all settings have.
pub(super) const USUAL: &[fn() -> Settings] = &[Settings::default, Settings::reusing];

/// All knobs. One whose values change nothing but those of another one comes after it.
pub const KNOBS: &[Knob] = &[
    Knob {
        name: "method",
        family: "second view",
        about: "how the second view is made; all but naive and guided reuse points of the first",
        bases: USUAL,
        values: &[
            value("naive", |s| s.stereo.method = Method::Naive),
            value("guided", |s| s.stereo.method = Method::Guided),
            value("atomic", |s| s.stereo.method = Method::Atomic),
            value("buffer", |s| s.stereo.method = Method::Buffer),
            value("gather-1", |s| s.stereo.method = Method::Gather1),
            value("gather-2", |s| s.stereo.method = Method::Gather2),
            value("es-isler", |s| s.stereo.method = Method::EsIsler),
            value("scanline", |s| s.stereo.method = Method::Scanline),
            value("scanline-rtl", |s| s.stereo.method = Method::ScanlineRtl),
            value("ideal", |s| s.stereo.method = Method::Ideal),
        ],
    },
    Knob {
        name: "verify",
        family: "second view",
        about: "which reprojected points a short ray checks",
        bases: USUAL,
        values: &[
            value("all", |s| s.stereo.verify = Some(Verify::All)),
            value("edges", |s| s.stereo.verify = Some(Verify::Edges)),
            value("none", |s| s.stereo.verify = Some(Verify::None)),
        ],
    },
    Knob {
        name: "first",
        family: "second view",
        about: "which view is traced; the other one is made from it",
        bases: USUAL,
        values: &[
            value("left", |s| s.stereo.first = First::Left),
            value("right", |s| s.stereo.first = First::Right),
        ],
    },
    Knob {
        name: "slots",
        family: "second view",
        about: "slots per pixel of the method buffer; of points that share one the nearest stays",
        bases: &[Settings::buffering],
        values: &[
            value("lemma", |s| s.stereo.depth = Depth::Lemma),
            value("adaptive", |s| s.stereo.depth = Depth::Adaptive),
            value("4", |s| s.stereo.depth = slots(3)),
            value("1", |s| s.stereo.depth = slots(0)),
        ],
    },
    Knob {
        name: "shadows",
        family: "second view",
        about: "whether the second view has shadow rays of its own",
        bases: USUAL,
        values: &[
            value("trace", |s| s.stereo.shadows = Shadows::Trace),
            value("prove", |s| s.stereo.shadows = Shadows::Prove),
            value("reuse", |s| s.stereo.shadows = Shadows::Reuse),
        ],
    },
    Knob {
        name: "reflections",
        family: "second view",
        about: "up to which angle between the eyes' rays reflections are reused",
        bases: USUAL,
        values: &[
            value("trace", |s| s.stereo.reflections = Reflections::Trace),
            value("0.5", |s| s.stereo.reflections = Reflections::Within(0.5)),
            value("2", |s| s.stereo.reflections = Reflections::Within(2.0)),
        ],
    },
    Knob {
        name: "samples",
        family: "anti-aliasing",
        about: "rays per pixel",
        bases: USUAL,
        values: &[
            value("4x4", |s| s.stereo.samples = Samples::Jittered(4)),
            value("nine", |s| s.stereo.samples = Samples::Nine),
            value("2x2", |s| s.stereo.samples = Samples::Jittered(2)),
            value("adaptive-2", |s| adapt(s, 2)),
            value("adaptive-1", |s| adapt(s, 1)),
            value("1", |s| s.stereo.samples = Samples::One),
        ],
    },
    Knob {
        name: "tolerance",
        family: "anti-aliasing",
        about: "by how much colours differ that ask for more rays of adaptive sampling",
        bases: &[Settings::adapting],
        values: &[
            value("1/64", |s| tolerate(s, 1.0 / 64.0)),
            value("1/16", |s| tolerate(s, TOLERANCE)),
            value("1/4", |s| tolerate(s, 1.0 / 4.0)),
        ],
    },
    Knob {
        name: "profile",
        family: "arithmetic",
        about: "correctly rounded division and square root without contraction, or the driver's own; one and the same on a CPU",
        bases: USUAL,
        values: &[
            value("strict", |s| s.profile = Profile::Strict),
            value("fast", |s| s.profile = Profile::Fast),
        ],
    },
    Knob {
        name: "bvh",
        family: "acceleration structure",
        about: "build quality: changes time and never a bit of the picture",
        bases: USUAL,
        values: &[
            value("full", |s| s.quality = Quality::Full),
            value("quick", |s| s.quality = Quality::Quick),
        ],
    },
    Knob {
        name: "depth",
        family: "light transport",
        about: "levels of reflection and refraction",
        bases: USUAL,
        values: &[
            value("scene", |s| s.max_depth = None),
            value("2", |s| s.max_depth = Some(2)),
            value("1", |s| s.max_depth = Some(1)),
            value("0", |s| s.max_depth = Some(0)),
        ],
    },
];

impl Default for Settings {
    /// The truth that costs least: both views traced, one ray per pixel.
    fn default() -> Self {
        Self {
            stereo: StereoOptions::default(),
            profile: Profile::Strict,
            quality: Quality::Full,
            max_depth: None,
        }
    }
}

impl Settings {
    /// What most users would take for speed.
    pub fn reusing() -> Self {
        let stereo = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        Self { stereo, ..Self::default() }
    }

    /// The same with a slot for each point that may land on a pixel.
    pub fn buffering() -> Self {
        let stereo = StereoOptions { method: Method::Buffer, ..Self::reusing().stereo };
        Self { stereo, ..Self::default() }
    }

    /// More rays where they are needed.
    pub fn adapting() -> Self {
        let mut settings = Self::default();
        adapt(&mut settings, 2);
        settings
    }

    /// The exact second view that costs least.
    pub fn proving() -> Self {
        let stereo = StereoOptions { shadows: Shadows::Prove, ..Method::Guided.into() };
        Self { stereo, ..Self::default() }
    }

    /// Whether the scene has what the settings differ in from the default, and the library can do it.
    pub(super) fn is_of_use(&self, data: &SceneData) -> bool {
        let bounces = data.effects.has(Effects::REFLECTION) && data.info.max_depth > 0;
        let reused = self.stereo.first == First::Left || self.stereo.method.reuses();
        // Who traces both views has the second one's own shadows.
        let shadows = self.stereo.shadows != Shadows::Trace || self.stereo.method.reuses();
        let turned = self.stereo.reflections != Reflections::Trace || self.max_depth.is_some();
        let shallower = self.max_depth.is_none_or(|depth| depth < data.info.max_depth);
        self.stereo.check().is_ok() && reused && shadows && shallower && (bounces || !turned)
    }

    /// The knobs that have to be turned to come here from [`Settings::default`], as `name=value`.
    pub fn label(&self) -> String {
        let (mut told, mut names) = (Self::default(), Vec::new());
        for knob in KNOBS {
            let own = knob.values.iter().find(|value| self.with(value) == *self);
            if let Some(value) = own.filter(|value| told.with(value) != told) {
                told = told.with(value);
                names.push(format!("{}={}", knob.name, value.name));
            }
        }
        if names.is_empty() { "method=naive".into() } else { names.join(" ") }
    }

    /// The settings of a [`label`](Self::label); none if it names a knob or a value that there is not.
    pub fn parse(label: &str) -> Option<Self> {
        label.split_whitespace().try_fold(Self::default(), |settings, setting| {
            let (name, value) = setting.split_once('=')?;
            let knob = KNOBS.iter().find(|knob| knob.name == name)?;
            knob.values.iter().find(|known| known.name == value).map(|value| settings.with(value))
        })
    }

    /// These, with one knob set to `value`.
    #[must_use]
    pub fn with(&self, value: &Value) -> Self {
        let mut settings = *self;
        (value.set)(&mut settings);
        settings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_name_what_is_not_as_usual() {
        assert_eq!(Settings::default().label(), "method=naive");
        assert_eq!(Settings::reusing().label(), "method=atomic verify=edges");
        let quick = Settings { quality: Quality::Quick, max_depth: Some(1), ..Settings::reusing() };
        assert_eq!(quick.label(), "method=atomic verify=edges bvh=quick depth=1");
    }
}
