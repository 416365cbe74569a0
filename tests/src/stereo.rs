//! Whole pictures as one band, by any method.

use parallax::backend::{Backend, Cpu};
use parallax::render::band::{Band, Pair, Values};
use parallax::render::stereo::second::Inferred;
use parallax::render::{First, Renderer, SceneData, StereoOptions};
pub use parallax::verify::input::pairs::{REPROJECTING, verified};
use parallax::verify::suite;
use std::ops::Deref;

/// Both orders of the eyes.
pub const ORDERS: [First; 2] = [First::Left, First::Right];

/// Both views on `backend`.
///
/// # Panics
/// When the backend fails.
pub fn pair_on<B: Backend>(backend: &mut B, data: &SceneData, options: &StereoOptions) -> Pair {
    suite::pair(backend, data, options).expect("options that go together, and a backend that works")
}

/// What the left eye sees, on the CPU.
///
/// # Panics
/// When it fails.
pub fn left(data: &SceneData) -> Values {
    let band = Band { first_row: 0, rows: data.views[0].height };
    let mut cpu = Cpu::new(0).expect("a CPU");
    Renderer::new(&mut cpu, data).and_then(|mut renderer| renderer.band(0, band)).expect("a view")
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
