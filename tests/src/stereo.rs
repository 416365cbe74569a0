//! Whole pictures as one band, by any method.

use parallax::backend::{Backend, Cpu};
use parallax::render::band::{Band, Pair, Values};
use parallax::render::stereo::Plan;
use parallax::render::stereo::second::Inferred;
use parallax::render::{First, Renderer, SceneData, StereoOptions};
pub use parallax::verify::input::pairs::{REPROJECTING, verified};
use std::ops::Deref;

/// Both orders of the eyes.
pub const ORDERS: [First; 2] = [First::Left, First::Right];

/// Both views on `backend`.
///
/// # Panics
/// When the backend fails.
pub fn pair_on<B: Backend>(backend: &mut B, data: &SceneData, options: &StereoOptions) -> Pair {
    let plan = Plan::new(data, options, true).expect("options that go together");
    let band = Band { first_row: 0, rows: data.views[0].height };
    Renderer::new(backend, data).and_then(|mut renderer| renderer.pair(&plan, band)).expect("a pair")
}

/// Both views on the CPU.
pub fn pair(data: &SceneData, options: &StereoOptions) -> Pair {
    pair_on(&mut Cpu::new(0).expect("a CPU"), data, options)
}

/// A second view that was made from the first, and how.
#[derive(Clone, Debug)]
pub struct Shown {
    /// What it shows.
    pub values: Values,
    /// How it was made.
    pub inferred: Inferred,
}

impl Deref for Shown {
    type Target = Values;

    fn deref(&self) -> &Values {
        &self.values
    }
}

/// The second view, which was made from the first.
///
/// # Panics
/// When it was traced.
pub fn inferred(pair: Pair) -> Shown {
    Shown { values: pair.second, inferred: pair.inferred.expect("the second view was traced") }
}

/// The second view, traced like the first.
///
/// # Panics
/// When it was not.
pub fn naive(data: &SceneData, first: First) -> Values {
    let pair = pair(data, &StereoOptions { first, ..StereoOptions::default() });
    assert!(pair.inferred.is_none(), "naive infers nothing");
    pair.second
}
