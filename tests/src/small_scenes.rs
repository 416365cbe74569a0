//! Small scenes that several tests look at, and what the processor makes of them.

use crate::stage::{Stage, Stages};
use parallax::backend::Cpu;
pub use parallax::verify::input::small_scenes::*;

/// What the CPU makes of it.
///
/// # Panics
/// When it fails.
pub fn render(stage: &Stage) -> Stages {
    stage.render(&mut Cpu::new(1).unwrap()).unwrap()
}
