//! `parallax study`: what each knob that trades accuracy for time costs and gains.
//!
//! Knobs are declared once, in [`KNOBS`]; a family that comes later adds its own there and nothing else. Each point of a study is a
//! setting of all knobs, rendered in turn with all others of its scene, and held against the truth.

mod choose;
mod effects;
mod findings;
mod html;
mod knob;
mod measure;
mod scatter;

pub use choose::{Choice, ChoiceError, Target, Wish, choose};
pub use effects::{Change, EffectCost, effects};
pub use findings::{frontier, sentence};
pub use html::page;
pub use knob::{KNOBS, Knob, Settings, Value, grid};
pub use measure::{Measured, Point, Study, study};
