//! Runs the passes of a scene on a backend, band by band.

use super::band::{Band, BandBuffers, EYES, Values};
use super::times::Times;
use super::{RenderError, SceneBuffers, SceneData, StageTime};
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
    pub fn suggested_rows(&self) -> u32 {
        let View { width, height, .. } = self.data.views[0];
        self.backend.suggested_rows(width, height, BandBuffers::bytes_per_pixel(self.data))
    }

    /// Renders a band of the view of `eye` (0 left, 1 right) and returns what every stage has made of it.
    ///
    /// # Errors
    /// When the backend fails; then the values of this band are lost.
    pub fn band(&mut self, eye: usize, band: Band) -> Result<Values, RenderError> {
        let view = View { first_row: band.first_row, rows: band.rows, ..self.data.views[eye] };
        let buffers = BandBuffers::create(self.backend, self.data, &view)?;
        let (data, scene) = (self.data, self.scene);
        let passes = buffers.run(data, &scene, view, &mut Stages { renderer: self, eye });
        let values = passes.and_then(|()| {
            self.times.measure(Some(EYES[eye]), "read back", || buffers.read(self.backend, data))
        });
        buffers.release(self.backend);
        Ok(values?)
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

/// Runs the passes of one view and times them.
pub(super) struct Stages<'r, 'a, B: Backend> {
    renderer: &'r mut Renderer<'a, B>,
    eye: usize,
}

impl<B: Backend> Stages<'_, '_, B> {
    /// Runs a pass over the pixels of the band and waits for it, so that its time is its own.
    pub fn run<P: Pass>(&mut self, pass: &P, view: &View) -> Result<(), BackendError> {
        let Renderer { backend, times, .. } = &mut *self.renderer;
        times.measure(Some(EYES[self.eye]), P::NAME, || {
            backend.run(pass, [view.width, view.rows, 1])?;
            backend.finish()
        })
    }
}
