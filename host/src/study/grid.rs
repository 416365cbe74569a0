//! Which settings a study tries.

use super::knob::USUAL;
use super::{KNOBS, Knob, Settings};
use crate::render::SceneData;

/// The settings of a study, of which the first are the traced pair: from its bases, each knob by itself is set to each of its values;
/// of `knobs`, if there are any, all combinations, in whichever order they are named. What makes no sense for the scene is left out.
pub fn grid(data: &SceneData, knobs: &[&Knob]) -> Vec<Settings> {
    let mut all = vec![Settings::default()];
    all.extend(if knobs.is_empty() { alone() } else { combined(knobs) });
    let mut kept: Vec<Settings> = Vec::new();
    for settings in all {
        if settings.is_of_use(data) && !kept.contains(&settings) {
            kept.push(settings);
        }
    }
    kept
}

/// Each value of each knob, from the knob's bases; and what takes two knobs.
fn alone() -> Vec<Settings> {
    let of_knob = |knob: &'static Knob| {
        let from =
            move |base: &'static fn() -> Settings| knob.values.iter().map(move |value| base().with(value));
        knob.bases.iter().flat_map(from)
    };
    let usual = USUAL.iter().map(|base| base());
    usual.chain(KNOBS.iter().flat_map(of_knob)).chain([Settings::proving()]).collect()
}

/// All combinations of some knobs.
fn combined(knobs: &[&Knob]) -> Vec<Settings> {
    let named = KNOBS.iter().filter(|knob| knobs.iter().any(|named| named.name == knob.name));
    named.fold(vec![Settings::default()], |all, knob| {
        let turned =
            |settings: &Settings| knob.values.iter().map(|value| settings.with(value)).collect::<Vec<_>>();
        all.iter().flat_map(turned).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::Quality;
    use crate::render::{First, Method, StereoOptions};

    fn data(name: &str) -> SceneData {
        let path = format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        SceneData::new(&crate::scene::load(path.as_ref()).unwrap(), Quality::Quick).unwrap()
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
    fn knobs_of_some_methods_are_turned_there_alone() {
        let of = |name: &str, all: &[Settings]| -> Vec<_> {
            all.iter().map(Settings::label).filter(|label| label.contains(name)).collect()
        };
        let all = grid(&data("cornell"), &[]);
        assert_eq!(of("first=", &all), ["method=atomic verify=edges first=right"]);
        let slots = ["adaptive", "4", "1"].map(|n| format!("method=buffer verify=edges slots={n}"));
        assert_eq!(of("slots=", &all), slots);
        let within = ["1/64", "1/4"].map(|difference| format!("samples=adaptive-2 tolerance={difference}"));
        assert_eq!(of("tolerance=", &all), within);
        let right = Settings {
            stereo: StereoOptions { first: First::Right, ..Method::Naive.into() },
            ..Settings::default()
        };
        assert!(!right.is_of_use(&data("cornell")), "both views are traced");
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
        let data = data("cornell");
        let combined = |names: [&str; 2]| {
            let named = names.map(|name| KNOBS.iter().find(|knob| knob.name == name).unwrap());
            grid(&data, &named)
        };
        assert_eq!(combined(["bvh", "profile"]).len(), 4);
        let adaptive = combined(["samples", "tolerance"]);
        assert_eq!(adaptive.len(), 4 + 2 * 3, "a tolerance is for two of six");
        assert_eq!(adaptive, combined(["tolerance", "samples"]));
    }
}
