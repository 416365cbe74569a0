//! The registry of knobs.

use crate::backend::Profile;
use crate::build::Quality;
use crate::render::sampling::TOLERANCE;
use crate::render::{Method, Reflections, Samples, SceneData, Shadows, StereoOptions, Verify};
use parallax_shared::effects::Effects;

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

const fn adaptive(levels: u32) -> Samples {
    Samples::Adaptive { levels, tolerance: TOLERANCE }
}

/// All knobs.
pub const KNOBS: &[Knob] = &[
    Knob {
        name: "method",
        family: "second view",
        about: "how the second view is made; all but naive and guided reuse points of the first",
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
        values: &[
            value("all", |s| s.stereo.verify = Some(Verify::All)),
            value("edges", |s| s.stereo.verify = Some(Verify::Edges)),
            value("none", |s| s.stereo.verify = Some(Verify::None)),
        ],
    },
    Knob {
        name: "shadows",
        family: "second view",
        about: "whether the second view has shadow rays of its own",
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
        values: &[
            value("4x4", |s| s.stereo.samples = Samples::Jittered(4)),
            value("nine", |s| s.stereo.samples = Samples::Nine),
            value("2x2", |s| s.stereo.samples = Samples::Jittered(2)),
            value("adaptive-2", |s| s.stereo.samples = adaptive(2)),
            value("adaptive-1", |s| s.stereo.samples = adaptive(1)),
            value("1", |s| s.stereo.samples = Samples::One),
        ],
    },
    Knob {
        name: "profile",
        family: "arithmetic",
        about: "correctly rounded division and square root without contraction, or the driver's own; one and the same on a CPU",
        values: &[
            value("strict", |s| s.profile = Profile::Strict),
            value("fast", |s| s.profile = Profile::Fast),
        ],
    },
    Knob {
        name: "bvh",
        family: "acceleration structure",
        about: "build quality: changes time and never a bit of the picture",
        values: &[
            value("full", |s| s.quality = Quality::Full),
            value("quick", |s| s.quality = Quality::Quick),
        ],
    },
    Knob {
        name: "depth",
        family: "light transport",
        about: "levels of reflection and refraction",
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

    /// The exact second view that costs least.
    pub fn proving() -> Self {
        let stereo = StereoOptions { shadows: Shadows::Prove, ..Method::Guided.into() };
        Self { stereo, ..Self::default() }
    }

    /// Whether the scene has what the settings differ in from the default, and the library can do it.
    fn is_of_use(&self, data: &SceneData) -> bool {
        let bounces = data.effects.has(Effects::REFLECTION) && data.info.max_depth > 0;
        let turned = self.stereo.reflections != Reflections::Trace || self.max_depth.is_some();
        let shallower = self.max_depth.is_none_or(|depth| depth < data.info.max_depth);
        self.stereo.check().is_ok() && shallower && (bounces || !turned)
    }

    /// The knobs that are not as in [`Settings::default`], as `name=value`.
    pub fn label(&self) -> String {
        let plain = Self::default();
        let named = KNOBS.iter().filter_map(|knob| {
            let of = |settings: &Self| {
                knob.values.iter().find(|value| settings.with(value) == *settings).map(|value| value.name)
            };
            of(self).filter(|value| of(&plain) != Some(value)).map(|value| format!("{}={value}", knob.name))
        });
        let label = named.collect::<Vec<_>>().join(" ");
        if label.is_empty() { "method=naive".into() } else { label }
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

/// The settings of a study: from the traced pair and from the usual reprojection, each knob by itself is set to each of its values; of
/// `knobs`, if there are any, all combinations. What makes no sense for the scene is left out.
pub fn grid(data: &SceneData, knobs: &[&Knob]) -> Vec<Settings> {
    let bases = [Settings::default(), Settings::reusing()];
    let mut all = bases.to_vec();
    if knobs.is_empty() {
        let alone =
            |base: Settings| KNOBS.iter().flat_map(|knob| knob.values).map(move |value| base.with(value));
        all.extend(bases.into_iter().flat_map(alone));
        all.push(Settings::proving());
    } else {
        all.truncate(1);
        for knob in knobs {
            all = all
                .iter()
                .flat_map(|settings| knob.values.iter().map(|value| settings.with(value)))
                .collect();
        }
        all.insert(0, Settings::default());
    }
    let mut kept: Vec<Settings> = Vec::new();
    for settings in all {
        if settings.is_of_use(data) && !kept.contains(&settings) {
            kept.push(settings);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data(name: &str) -> SceneData {
        let path = format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        SceneData::new(&crate::scene::load(path.as_ref()).unwrap(), Quality::Quick).unwrap()
    }

    #[test]
    fn labels_name_what_is_not_as_usual() {
        assert_eq!(Settings::default().label(), "method=naive");
        assert_eq!(Settings::reusing().label(), "method=atomic verify=edges");
        let quick = Settings { quality: Quality::Quick, max_depth: Some(1), ..Settings::reusing() };
        assert_eq!(quick.label(), "method=atomic verify=edges bvh=quick depth=1");
    }

    #[test]
    fn every_value_is_tried_where_it_can_matter() {
        let labels: Vec<_> = grid(&data("whitted"), &[]).iter().map(Settings::label).collect();
        let missing = |name: &str| !labels.iter().any(|label| label.contains(name));
        for knob in KNOBS {
            // The scene's own depth is left out: the default.
            for value in knob.values.iter().filter(|value| value.name != "scene") {
                let setting = format!("{}={}", knob.name, value.name);
                let default = Settings::default().with(value) == Settings::default();
                let deep = setting == "depth=2";
                assert!(default || deep || !missing(&setting), "{setting}: {labels:?}");
            }
        }
        assert!(!grid(&data("cornell"), &[]).iter().any(|s| s.max_depth.is_some()), "nothing reflects there");
    }

    #[test]
    fn labels_say_all_there_is_to_settings() {
        for name in ["whitted", "cornell"] {
            for settings in grid(&data(name), &[]) {
                assert_eq!(Settings::parse(&settings.label()), Some(settings), "{}", settings.label());
            }
        }
        for wrong in ["method", "method=magic", "magic=naive", "=", "method=naive,"] {
            assert_eq!(Settings::parse(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn named_knobs_are_combined() {
        let knobs: Vec<_> = KNOBS.iter().filter(|knob| ["bvh", "profile"].contains(&knob.name)).collect();
        assert_eq!(grid(&data("cornell"), &knobs).len(), 4);
    }
}
