//! Runs the passes of a scene on a backend, band by band.

use super::band::{Band, BandBuffers, EYES, Pair, Second, Values};
use super::stereo::second::SecondBuffers;
use super::stereo::{self, Plan};
use super::times::Times;
use super::{Method, RenderError, SceneBuffers, SceneData, StageTime};
use crate::backend::{Backend, BackendError};
use kernel_api::Pass;
use parallax_shared::layout::View;

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
    pub fn suggested_rows(&self, plan: &Plan) -> u32 {
        let View { width, height, .. } = self.data.views[0];
        let bytes = BandBuffers::bytes_per_pixel(self.data).max(4 * plan.words_per_pixel());
        self.backend.suggested_rows(width, height, bytes)
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
        let view = self.view(eye, band);
        let buffers = BandBuffers::create(self.backend, self.data, &view)?;
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
        if plan.options.method == Method::Naive {
            let (source, second) = (self.band(first, band)?, self.band(other, band)?);
            return Ok(Pair { source, second: Second::Traced(second) });
        }
        let buffers = PairBuffers::create(self.backend, plan, self.data, &self.view(first, band))?;
        let pair = self.run_both(plan, band, &buffers).and_then(|()| self.read_pair(plan, &buffers));
        buffers.release(self.backend);
        Ok(pair?)
    }

    /// Runs the passes of both views.
    fn run_both(&mut self, plan: &Plan, band: Band, buffers: &PairBuffers) -> Result<(), BackendError> {
        let [first, other] = plan.options.first.eyes();
        let views = [self.view(first, band), self.view(other, band)];
        self.run_band(first, views[0], &buffers.source)?;
        let (data, scene) = (self.data, self.scene);
        let stages = &mut Stages { renderer: self, eye: other };
        match &buffers.second {
            SecondView::Traced(second) => second.run(data, &scene, views[1], stages),
            SecondView::Inferred(second) => {
                let (scene, source) = (&scene, &buffers.source);
                stereo::SecondView { plan, data, scene, source, second, view: views[1] }.run(stages)
            }
        }
    }

    fn read_pair(&mut self, plan: &Plan, buffers: &PairBuffers) -> Result<Pair, BackendError> {
        let [first, other] = plan.options.first.eyes();
        let source = self.read_band(first, &buffers.source)?;
        let second = match &buffers.second {
            SecondView::Traced(second) => Second::Traced(self.read_band(other, second)?),
            SecondView::Inferred(_) if plan.options.method == Method::Ideal => {
                Second::Traced(source.without_rays())
            }
            SecondView::Inferred(second) => {
                let Self { backend, times, .. } = self;
                let inferred = times.measure(Some(EYES[other]), "read back", || second.read(*backend));
                Second::Inferred(inferred?)
            }
        };
        Ok(Pair { source, second })
    }

    /// Renders the source, or both views, `times` over without reading anything back, and tells each time how many seconds the
    /// source and the second view took: for benchmarks. Buffers are made once, as an animation would.
    ///
    /// # Errors
    /// When the backend fails.
    pub fn time_pair(
        &mut self,
        plan: &Plan,
        buffers: &PairBuffers,
        band: Band,
    ) -> Result<[f64; 2], RenderError> {
        let [first, other] = plan.options.first.eyes();
        let before = [self.times.of(EYES[first]), self.times.of(EYES[other])];
        self.run_both(plan, band, buffers)?;
        Ok([self.times.of(EYES[first]) - before[0], self.times.of(EYES[other]) - before[1]])
    }

    /// Buffers for [`time_pair`](Self::time_pair), to be given back by [`release`](Self::release).
    ///
    /// # Errors
    /// When there is not enough memory.
    pub fn pair_buffers(&mut self, plan: &Plan, band: Band) -> Result<PairBuffers, RenderError> {
        let view = self.view(plan.options.first.eyes()[0], band);
        Ok(PairBuffers::create(self.backend, plan, self.data, &view)?)
    }

    /// Gives buffers back.
    pub fn release(&mut self, buffers: PairBuffers) {
        buffers.release(self.backend);
    }

    /// The times of the stages so far.
    pub fn times(&self) -> &[StageTime] {
        self.times.all()
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
pub struct PairBuffers {
    source: BandBuffers,
    second: SecondView,
}

enum SecondView {
    Traced(BandBuffers),
    Inferred(SecondBuffers),
}

impl PairBuffers {
    fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        view: &View,
    ) -> Result<Self, BackendError> {
        Ok(Self {
            source: BandBuffers::create(backend, data, view)?,
            second: match plan.options.method {
                Method::Naive => SecondView::Traced(BandBuffers::create(backend, data, view)?),
                _ => SecondView::Inferred(SecondBuffers::create(backend, plan, data, view)?),
            },
        })
    }

    fn release<B: Backend>(self, backend: &mut B) {
        self.source.release(backend);
        match self.second {
            SecondView::Traced(second) => second.release(backend),
            SecondView::Inferred(second) => second.release(backend),
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
