//! Runs the passes of a scene on a backend, band by band.

use super::band::{Band, BandBuffers, EYES, Pair, Values};
use super::sampling::buffers::SampledBuffers;
use super::sampling::pair::SampledPair;
use super::shadows::Proofs;
use super::stereo::second::SecondBuffers;
use super::stereo::{Plan, SecondView};
use super::times::Times;
use super::{Method, RenderError, SceneBuffers, SceneData, StageTime};
use crate::backend::{Backend, BackendError};
use kernel_api::Pass;
use parallax_shared::layout::{Sample, View};
use parallax_shared::shading::shadow;

/// A scene on a backend, ready to be rendered. Dropping it gives the backend's memory back.
pub struct Renderer<'a, B: Backend> {
    backend: &'a mut B,
    data: &'a SceneData,
    scene: SceneBuffers,
    times: Times,
}

impl<'a, B: Backend> Renderer<'a, B> {
    /// Uploads the scene.
    ///
    /// # Errors
    /// When there is not enough memory for it.
    pub fn new(backend: &'a mut B, data: &'a SceneData) -> Result<Self, RenderError> {
        let mut times = Times::default();
        let scene = times.measure(None, "upload", || SceneBuffers::upload(backend, data))?;
        Ok(Self { backend, data, scene, times })
    }

    /// How many rows a band should have at most, so that no watchdog fires and every buffer can be bound.
    ///
    /// Where a pixel has several rays, rows at the edge of a band do not see which points their neighbours sample: bands are then the same
    /// on every backend, as long as their buffers can be bound.
    pub fn suggested_rows(&self, plan: &Plan) -> u32 {
        const SAMPLED: u32 = 16;
        let View { width, height, .. } = self.data.views[0];
        let of_tables = 4 * plan.of_picture().depth;
        match plan.grid {
            None => {
                let of_proofs = plan.proofs().map_or(0, |_| Proofs::bytes_per_pixel(self.data));
                let bytes = BandBuffers::bytes_per_pixel(self.data).max(of_tables).max(of_proofs);
                self.backend.suggested_rows(width, height, bytes)
            }
            Some(grid) => {
                let (n, words) = (grid.per_pixel, shadow::words(self.data.info.lights));
                let bytes = of_tables.max(4 * words).max(size_of::<Sample>() as u32);
                (self.backend.suggested_rows(n * width + 1, n * height, bytes) / n).clamp(1, SAMPLED)
            }
        }
    }

    /// The view of `eye` over a band.
    fn view(&self, eye: usize, band: Band) -> View {
        View { first_row: band.first_row, rows: band.rows, ..self.data.views[eye] }
    }

    /// Renders a band of the view of `eye` (0 left, 1 right) and returns what every stage has made of it.
    ///
    /// # Errors
    /// When the backend fails; then the values of this band are lost.
    pub fn band(&mut self, eye: usize, band: Band) -> Result<Values, RenderError> {
        self.band_proving(eye, band, None)
    }

    /// The same with proofs for tiles, which are shared or not.
    fn band_proving(&mut self, eye: usize, band: Band, proofs: Option<bool>) -> Result<Values, RenderError> {
        let view = self.view(eye, band);
        let buffers = BandBuffers::create(self.backend, self.data, &view, proofs)?;
        let values = self.run_band(eye, view, &buffers).and_then(|()| self.read_band(eye, &buffers));
        buffers.release(self.backend);
        Ok(values?)
    }

    fn run_band(&mut self, eye: usize, view: View, buffers: &BandBuffers) -> Result<(), BackendError> {
        let (data, scene) = (self.data, self.scene);
        buffers.run(data, &scene, view, &mut Stages { renderer: self, eye })
    }

    fn read_band(&mut self, eye: usize, buffers: &BandBuffers) -> Result<Values, BackendError> {
        let Self { backend, data, times, .. } = self;
        times.measure(Some(EYES[eye]), "read back", || buffers.read(*backend, data))
    }

    /// Renders both views of a band as `plan` says and returns what every stage has made of them.
    ///
    /// # Errors
    /// When the backend fails; then the values of this band are lost.
    pub fn pair(&mut self, plan: &Plan, band: Band) -> Result<Pair, RenderError> {
        let [first, other] = plan.options.first.eyes();
        if plan.options.method == Method::Naive && plan.grid.is_none() {
            let proofs = plan.proofs();
            let (source, second) =
                (self.band_proving(first, band, proofs)?, self.band_proving(other, band, proofs)?);
            return Ok(Pair { source, second, inferred: None });
        }
        let buffers = Outputs::create(self.backend, plan, self.data, &self.view(first, band))?;
        let pair = self.run_both(plan, band, &buffers).and_then(|()| self.read_pair(plan, band, &buffers));
        buffers.release(self.backend);
        Ok(pair?)
    }

    /// Runs the passes of both views.
    fn run_both(&mut self, plan: &Plan, band: Band, buffers: &Outputs) -> Result<(), BackendError> {
        let [first, other] = plan.options.first.eyes();
        let view = self.view(other, band);
        let (data, scene) = (self.data, self.scene);
        match buffers {
            Outputs::Sampled(buffers) => {
                let pair = self.sampled(plan, band, buffers, &scene);
                pair.run_source(&mut Stages { renderer: self, eye: first })?;
                pair.run_second(&mut Stages { renderer: self, eye: other })
            }
            Outputs::Traced { source, second } => {
                self.run_band(first, self.view(first, band), source)?;
                second.run(data, &scene, view, &mut Stages { renderer: self, eye: other })
            }
            Outputs::Inferred { source, second } => {
                self.run_band(first, self.view(first, band), source)?;
                let scene = &scene;
                let pair = SecondView { plan, data, scene, source, second, view };
                pair.run(&mut Stages { renderer: self, eye: other })
            }
        }
    }

    fn sampled<'p>(
        &self,
        plan: &'p Plan,
        band: Band,
        buffers: &'p SampledBuffers,
        scene: &'p SceneBuffers,
    ) -> SampledPair<'p>
    where
        'a: 'p,
    {
        let views = plan.options.first.eyes().map(|eye| self.view(eye, band));
        SampledPair { plan, data: self.data, scene, views, buffers }
    }

    fn read_pair(&mut self, plan: &Plan, band: Band, buffers: &Outputs) -> Result<Pair, BackendError> {
        let [first, other] = plan.options.first.eyes();
        let scene = self.scene;
        let (source, second) = match buffers {
            Outputs::Sampled(buffers) => {
                let pair = self.sampled(plan, band, buffers, &scene);
                let Self { backend, times, .. } = self;
                return times.measure(None, "read back", || pair.read(*backend));
            }
            Outputs::Traced { source, second } => {
                let (source, second) = (self.read_band(first, source)?, self.read_band(other, second)?);
                return Ok(Pair { source, second, inferred: None });
            }
            Outputs::Inferred { source, second } => (self.read_band(first, source)?, second),
        };
        if plan.options.method == Method::Ideal {
            let second = source.without_rays();
            return Ok(Pair { source, second, inferred: None });
        }
        let Self { backend, times, .. } = self;
        let read = || second.read(*backend, plan, &source);
        let (second, inferred) = times.measure(Some(EYES[other]), "read back", read)?;
        Ok(Pair { source, second, inferred: Some(inferred) })
    }

    /// Renders both views without reading anything back, and tells how long each stage took: for benchmarks. Buffers are made once, as an
    /// animation would.
    ///
    /// # Errors
    /// When the backend fails.
    pub fn time_pair(
        &mut self,
        plan: &Plan,
        buffers: &PairBuffers,
        band: Band,
    ) -> Result<Vec<StageTime>, RenderError> {
        let before = std::mem::take(&mut self.times);
        let run = self.run_both(plan, band, &buffers.0);
        let times = std::mem::replace(&mut self.times, before);
        run?;
        Ok(times.into_vec())
    }

    /// Buffers for [`time_pair`](Self::time_pair), to be given back by [`release`](Self::release).
    ///
    /// # Errors
    /// When there is not enough memory.
    pub fn pair_buffers(&mut self, plan: &Plan, band: Band) -> Result<PairBuffers, RenderError> {
        let view = self.view(plan.options.first.eyes()[0], band);
        Ok(PairBuffers(Outputs::create(self.backend, plan, self.data, &view)?))
    }

    /// Gives buffers back.
    pub fn release(&mut self, buffers: PairBuffers) {
        buffers.0.release(self.backend);
    }

    /// The time that each stage has taken so far.
    pub fn finish(mut self) -> Vec<StageTime> {
        std::mem::take(&mut self.times).into_vec()
    }
}

impl<B: Backend> Drop for Renderer<'_, B> {
    fn drop(&mut self) {
        self.scene.release(self.backend);
    }
}

/// The outputs of all passes over both views of a band.
pub struct PairBuffers(Outputs);

enum Outputs {
    /// Both views are traced, with one ray per pixel.
    Traced { source: BandBuffers, second: BandBuffers },
    /// The second view is made from the first.
    Inferred { source: BandBuffers, second: SecondBuffers },
    /// Pixels have several rays.
    Sampled(SampledBuffers),
}

impl Outputs {
    fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        view: &View,
    ) -> Result<Self, BackendError> {
        if let Some(grid) = plan.grid {
            return Ok(Self::Sampled(SampledBuffers::create(backend, plan, data, view, grid)?));
        }
        let proofs = plan.proofs();
        let source = BandBuffers::create(backend, data, view, proofs)?;
        Ok(match plan.options.method {
            Method::Naive => {
                Self::Traced { source, second: BandBuffers::create(backend, data, view, proofs)? }
            }
            _ => Self::Inferred { source, second: SecondBuffers::create(backend, plan, data, view)? },
        })
    }

    fn release<B: Backend>(self, backend: &mut B) {
        match self {
            Self::Traced { source, second } => {
                source.release(backend);
                second.release(backend);
            }
            Self::Inferred { source, second } => {
                source.release(backend);
                second.release(backend);
            }
            Self::Sampled(buffers) => buffers.release(backend),
        }
    }
}

/// Runs the passes of one view and times them.
pub(super) struct Stages<'r, 'a, B: Backend> {
    renderer: &'r mut Renderer<'a, B>,
    eye: usize,
}

impl<B: Backend> Stages<'_, '_, B> {
    /// Runs a pass over the pixels of the band and waits for it, so that its time is its own.
    pub fn run<P: Pass>(&mut self, pass: &P, view: &View) -> Result<(), BackendError> {
        self.run_over(pass, [view.width, view.rows, 1])
    }

    /// The same for a pass whose invocations are something else than pixels.
    pub fn run_over<P: Pass>(&mut self, pass: &P, invocations: [u32; 3]) -> Result<(), BackendError> {
        let Renderer { backend, times, .. } = &mut *self.renderer;
        times.measure(Some(EYES[self.eye]), P::NAME, || {
            backend.run(pass, invocations)?;
            backend.finish()
        })
    }

    /// The backend.
    pub fn backend(&mut self) -> &mut B {
        self.renderer.backend
    }
}
