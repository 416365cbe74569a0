//! The buffers of pairs whose pixels have several rays.

use super::Grid;
use crate::backend::{Backend, BackendError};
use crate::render::SceneData;
use crate::render::band::pixels_of;
use crate::render::stereo::Plan;
use crate::render::stereo::tables::TableBuffers;
use kernel_api::Buffer;
use parallax_shared::layout::{Hit, RayCounts, Sample, Surface, View};
use parallax_shared::shading::shadow;

/// The points of one view of a band, and its pixels.
#[derive(Clone, Copy)]
pub(in crate::render) struct ViewBuffers {
    /// Where each point comes from.
    pub words: Buffer<u32>,
    pub hits: Buffer<Hit>,
    /// Which lights it sees.
    pub seen: Buffer<u32>,
    pub samples: Buffer<Sample>,
    /// Of pixels.
    pub colours: Buffer<[f32; 4]>,
    /// Of pixels.
    pub rays: Buffer<RayCounts>,
    /// What the middles of pixels show, where that is wanted.
    pub middles: Option<MiddleBuffers>,
}

/// What the rays through the middles of pixels meet.
#[derive(Clone, Copy)]
pub(in crate::render) struct MiddleBuffers {
    pub hits: Buffer<Hit>,
    pub surfaces: Buffer<Surface>,
    /// Nobody asks for them.
    pub rays: Buffer<RayCounts>,
}

/// What the second view is made with.
#[derive(Clone, Copy)]
pub(in crate::render) struct InferenceBuffers {
    pub tables: TableBuffers,
    /// Where each point may come from.
    pub planned: Buffer<u32>,
    /// The pixels that decide about nine points.
    pub aimed: Option<AimedBuffers>,
}

/// One element per pixel.
#[derive(Clone, Copy)]
pub(in crate::render) struct AimedBuffers {
    pub hits: Buffer<Hit>,
    pub words: Buffer<u32>,
    pub second_hits: Buffer<Hit>,
}

/// All of a band.
#[derive(Clone, Copy)]
pub(in crate::render) struct SampledBuffers {
    /// Where the points are.
    pub grid: Grid,
    pub source: ViewBuffers,
    pub second: ViewBuffers,
    pub inference: Option<InferenceBuffers>,
}

impl ViewBuffers {
    fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        grid: Grid,
        view: &View,
    ) -> Result<Self, BackendError> {
        let (points, pixels) = (pixels_of(&grid.view(view, 0)), pixels_of(view));
        Ok(Self {
            words: backend.create("words of points", points)?,
            hits: backend.create("hits of points", points)?,
            seen: backend.create("lights of points", points * shadow::words(data.info.lights) as usize)?,
            samples: backend.create("samples", points)?,
            colours: backend.create("colours", pixels)?,
            rays: backend.create("rays", pixels)?,
            middles: plan.everything.then(|| MiddleBuffers::create(backend, pixels)).transpose()?,
        })
    }

    fn release<B: Backend>(self, backend: &mut B) {
        backend.release(self.words);
        backend.release(self.hits);
        backend.release(self.seen);
        backend.release(self.samples);
        backend.release(self.colours);
        backend.release(self.rays);
        if let Some(MiddleBuffers { hits, surfaces, rays }) = self.middles {
            backend.release(hits);
            backend.release(surfaces);
            backend.release(rays);
        }
    }
}

impl MiddleBuffers {
    fn create<B: Backend>(backend: &mut B, pixels: usize) -> Result<Self, BackendError> {
        Ok(Self {
            hits: backend.create("hits", pixels)?,
            surfaces: backend.create("surfaces", pixels)?,
            rays: backend.create("rays through the middle", pixels)?,
        })
    }
}

impl InferenceBuffers {
    fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        grid: Grid,
        view: &View,
    ) -> Result<Self, BackendError> {
        let (points, pixels) = (pixels_of(&grid.view(view, 0)), pixels_of(view));
        let aimed = |backend: &mut B| {
            Ok(AimedBuffers {
                hits: backend.create("aimed hits", pixels)?,
                words: backend.create("words", pixels)?,
                second_hits: backend.create("second hits", pixels)?,
            })
        };
        Ok(Self {
            tables: TableBuffers::create(backend, plan, if grid.aims { pixels } else { points })?,
            planned: backend.create("planned points", points)?,
            aimed: grid.aims.then(|| aimed(backend)).transpose()?,
        })
    }

    fn release<B: Backend>(self, backend: &mut B) {
        self.tables.release(backend);
        backend.release(self.planned);
        if let Some(AimedBuffers { hits, words, second_hits }) = self.aimed {
            backend.release(hits);
            backend.release(words);
            backend.release(second_hits);
        }
    }
}

impl SampledBuffers {
    /// Buffers for the band of `view`.
    pub fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        view: &View,
        grid: Grid,
    ) -> Result<Self, BackendError> {
        let inference = |backend: &mut B| InferenceBuffers::create(backend, plan, grid, view);
        Ok(Self {
            grid,
            source: ViewBuffers::create(backend, plan, data, grid, view)?,
            second: ViewBuffers::create(backend, plan, data, grid, view)?,
            inference: plan.options.method.reuses().then(|| inference(backend)).transpose()?,
        })
    }

    /// Gives the memory back.
    pub fn release<B: Backend>(self, backend: &mut B) {
        self.source.release(backend);
        self.second.release(backend);
        self.inference.into_iter().for_each(|inference| inference.release(backend));
    }
}
