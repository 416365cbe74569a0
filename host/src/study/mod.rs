//! `parallax study`: what each knob that trades accuracy for time costs and gains.
//!
//! Knobs are declared once, in [`KNOBS`]; a family that comes later adds its own there and nothing else. Each point of a study is a
//! setting of all knobs, rendered in turn with all others of its scene on the same backend, and held against the truth. Backends are
//! studied one after the other, and nothing is compared across them.

mod choose;
mod effects;
mod findings;
mod grid;
mod html;
mod knob;
mod machine;
mod measure;
mod scatter;
mod strict;

pub use choose::{Choice, ChoiceError, Target, Wish, choose};
pub use effects::{Change, EffectCost, effects};
pub use findings::{frontier, gain, ranking, sentence};
pub use grid::grid;
pub use html::page;
pub use knob::{KNOBS, Knob, Settings, Value};
pub use machine::Machine;
pub use measure::{Case, Measured, Point, Study, study};
pub use strict::StrictPrice;
