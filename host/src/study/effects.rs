//! What each effect costs: its code where nothing uses it, and its work where something does.
//!
//! A scene is rendered as it is; with the code of each effect that it does not call for, which changes no bit of its picture; with
//! the code of all effects; and without each effect that it does call for, which does change the picture. All run in turn in each
//! repetition, twice, of which the second run counts: its buffers are there, as those of an animation are. Each time is told over
//! that of the scene as it is, in the same repetition.

use super::measure::cost;
use crate::backend::{Backend, Device};
use crate::bench::quartiles::quartiles;
use crate::render::{Method, RenderError, SceneData};
use parallax_shared::effects::Effects;
use serde::Serialize;
use std::fmt;

/// What is different from the scene as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Nothing.
    None,
    /// The effect's code is there, too, and nothing uses it.
    Carried,
    /// The effect is left out.
    Off,
}

/// The cost of an effect.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EffectCost {
    /// Which scene.
    pub scene: String,
    /// Where it ran.
    pub backend: String,
    /// The effect's name; "all" for all of them together.
    pub effect: &'static str,
    /// What is different.
    pub change: Change,
    /// Median time of the passes of both views, both traced.
    pub milliseconds: f64,
    /// Median of the times over those of the scene as it is.
    pub ratio: f64,
    /// Distance of the quartiles of that ratio.
    pub spread: f64,
}

/// The variants of a scene that calls for `own`; the first one is the scene as it is.
fn variants(own: Effects) -> Vec<(&'static str, Change, Effects)> {
    let one = |&(effect, name): &(Effects, &'static str)| match own.has(effect) {
        true => (name, Change::Off, Effects(own.0 & !effect.0)),
        false => (name, Change::Carried, own.with(effect)),
    };
    let all = [("as it is", Change::None, own), ("all", Change::Carried, Effects::ALL)];
    all.into_iter().chain(Effects::NAMES.iter().map(one)).collect()
}

/// Measures all effects on a scene. `progress` is told how many of how many runs are done.
///
/// # Errors
/// When the scene cannot be rendered.
pub fn effects(
    name: &str,
    data: &SceneData,
    device: &mut Device,
    repetitions: usize,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Vec<EffectCost>, RenderError> {
    let variants = variants(data.effects);
    let mut data = data.clone();
    let mut times = vec![Vec::new(); variants.len()];
    let total = (variants.len() * (repetitions + 1)) as u64;
    // The first round warms up, and lets a driver compile.
    for round in 0..=repetitions {
        for (number, (.., effects)) in variants.iter().enumerate() {
            data.effects = *effects;
            let seconds = cost(device, &data, &Method::Naive.into(), 2)?.seconds;
            if round > 0 {
                times[number].push(seconds);
            }
            progress((round * variants.len() + number + 1) as u64, total);
        }
    }
    let backend = device.describe();
    let told = |((effect, change, _), seconds): (&(&'static str, Change, Effects), &Vec<f64>)| {
        let ratios = seconds.iter().zip(&times[0]).map(|(of, own)| of / own);
        let [_, milliseconds, _] = quartiles(seconds.iter().map(|seconds| 1e3 * seconds));
        let [low, ratio, high] = quartiles(ratios);
        let scene = name.to_owned();
        EffectCost {
            scene,
            backend: backend.clone(),
            effect,
            change: *change,
            milliseconds,
            ratio,
            spread: high - low,
        }
    };
    Ok(variants.iter().zip(&times).map(told).collect())
}

impl fmt::Display for EffectCost {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let change = match self.change {
            Change::None => "",
            Change::Carried => "carried, unused",
            Change::Off => "off",
        };
        let Self { effect, milliseconds, ratio, spread, .. } = self;
        write!(f, "  {effect:<16}{change:<16}{milliseconds:>10.2} ms {ratio:>7.3} × ± {:.3}", spread / 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::backend::Cpu;
    use crate::build::Quality;
    use crate::render::Overrides;

    #[test]
    fn each_effect_is_carried_or_left_out() {
        let own = Effects::LIGHTS.with(Effects::SPHERES);
        let variants = variants(own);
        assert_eq!(variants.len(), Effects::NAMES.len() + 2);
        assert_eq!((variants[0].1, variants[0].2), (Change::None, own));
        assert_eq!(variants[1].2, Effects::ALL);
        for (name, change, effects) in &variants[2..] {
            let had = ["lights", "spheres"].contains(name);
            assert_eq!(*change, if had { Change::Off } else { Change::Carried }, "{name}");
            assert_eq!((effects.0 ^ own.0).count_ones(), 1, "{name}");
        }
    }

    #[test]
    fn costs_are_over_the_scene_as_it_is() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/cornell.toml");
        let mut scene = crate::scene::load(path.as_ref()).unwrap();
        Overrides { size: Some([24, 16]), ..Overrides::default() }.apply(&mut scene).unwrap();
        let data = SceneData::new(&scene, Quality::Quick).unwrap();
        let mut device = Device::Cpu(Cpu::new(1).unwrap());
        let costs = effects("box", &data, &mut device, 3, &mut |_, _| {}).unwrap();
        assert_eq!((costs[0].ratio, costs[0].spread), (1.0, 0.0));
        assert!(costs.iter().all(|cost| cost.milliseconds > 0.0 && cost.ratio > 0.0));
        assert!(costs[1].to_string().contains("all             carried, unused"));
    }
}
