//! The outputs of the passes over the second view of a band.

use super::tables::TableBuffers;
use super::{Plan, bounces};
use crate::backend::{Backend, BackendError};
use crate::render::SceneData;
use crate::render::band::{BounceBuffers, Bounced};
use crate::render::method::{Method, Reflections};
use kernel_api::Buffer;
use parallax_shared::layout::{Hit, RayCounts, Surface, View};
use parallax_shared::shading::shadow;
use parallax_shared::stereo::source::{self, is_reused};

/// What was made of the second view of a band: one element per pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Inferred {
    /// The nearest source that lands on the pixel: its column (mirrored if the right eye is the source) plus 1, or 0.
    pub candidates: Vec<u32>,
    /// The last gap over the pixel: the right one of its columns plus 1, or 0.
    pub gaps: Vec<u32>,
    /// Where the pixel comes from: see [`parallax_shared::stereo::source`].
    pub source: Vec<u32>,
    /// What the pixel shows.
    pub hits: Vec<Hit>,
    /// What shading knows of it.
    pub surfaces: Vec<Surface>,
    /// Linear colour without reflection and refraction; the fourth word is 1.
    pub local: Vec<[f32; 4]>,
    /// Rays from the eye: one for each pixel that was traced or verified.
    pub primary_rays: Vec<RayCounts>,
    /// Rays to lights.
    pub shadow_rays: Vec<RayCounts>,
    /// What reflection and refraction add, in scenes that have any.
    pub bounced: Option<Bounced>,
}

impl Inferred {
    /// The linear colour that is seen.
    pub fn colour(&self) -> &[[f32; 4]] {
        self.bounced.as_ref().map_or(&self.local, |bounced| &bounced.colour)
    }

    /// The rays that were traced, stage by stage.
    pub fn rays(&self) -> impl Iterator<Item = &[RayCounts]> {
        let bounced = self.bounced.iter().map(|bounced| &bounced.rays[..]);
        [&self.primary_rays[..], &self.shadow_rays].into_iter().chain(bounced)
    }
}

const NO_RAYS: RayCounts = RayCounts { primary: 0, shadow: 0, reflected: 0, refracted: 0 };

/// The buffers of a second view that is not fully traced.
#[derive(Clone, Copy)]
pub struct SecondBuffers {
    pub(super) tables: TableBuffers,
    pub(super) source: Buffer<u32>,
    pub(super) hits: Buffer<Hit>,
    pub(super) colours: Buffer<[f32; 4]>,
    pub(super) light_rays: Buffer<RayCounts>,
    /// Where surfaces are wanted or needed.
    pub(super) surfaces: Option<Buffer<Surface>>,
    /// Where shadows are traced.
    pub(super) seen: Option<Buffer<u32>>,
    pub(super) bounced: Option<BounceBuffers>,
    /// Surfaces that are left to the pass `bounce` and colours with what was recalled, where reflections are reused.
    pub(super) recalled: Option<(Buffer<Surface>, Buffer<[f32; 4]>)>,
}

impl SecondBuffers {
    /// Buffers for the band of `view`.
    pub fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        view: &View,
    ) -> Result<Self, BackendError> {
        let pixels = view.width as usize * view.rows as usize;
        let traces = !plan.reuses_shadows();
        let bounces = bounces(data) && plan.options.method != Method::Ideal;
        let recalls = bounces && plan.options.reflections != Reflections::Trace;
        let recalled = |backend: &mut B| {
            Ok((backend.create("remaining surfaces", pixels)?, backend.create("recalled colours", pixels)?))
        };
        let words = pixels * shadow::words(data.info.lights) as usize;
        Ok(Self {
            tables: TableBuffers::create(backend, plan, pixels)?,
            source: backend.create("source", pixels)?,
            hits: backend.create("second hits", pixels)?,
            colours: backend.create("second colours", pixels)?,
            light_rays: backend.create("second light rays", pixels)?,
            surfaces: (plan.everything || traces || bounces)
                .then(|| backend.create("second surfaces", pixels))
                .transpose()?,
            seen: traces.then(|| backend.create("second shadow bits", words)).transpose()?,
            bounced: bounces.then(|| BounceBuffers::create(backend, pixels)).transpose()?,
            recalled: recalls.then(|| recalled(backend)).transpose()?,
        })
    }

    /// Everything that the passes have written, of a plan that wants everything.
    pub fn read<B: Backend>(&self, backend: &mut B) -> Result<Inferred, BackendError> {
        let source = backend.read(self.source)?;
        let mut shadow_rays = backend.read(self.light_rays)?;
        if self.seen.is_none() {
            // Only traced pixels have counts.
            shadow_rays
                .iter_mut()
                .zip(&source)
                .filter(|(_, s)| is_reused(**s))
                .for_each(|(r, _)| *r = NO_RAYS);
        }
        let primary =
            |&word: &u32| RayCounts { primary: u32::from(source::kind(word) != source::REUSED), ..NO_RAYS };
        Ok(Inferred {
            candidates: backend.read(self.tables.candidates)?,
            gaps: backend.read(self.tables.gaps)?,
            hits: backend.read(self.hits)?,
            surfaces: self.surfaces.map_or(Ok(Vec::new()), |surfaces| backend.read(surfaces))?,
            local: backend.read(self.colours)?,
            primary_rays: source.iter().map(primary).collect(),
            shadow_rays,
            bounced: self.bounced.map(|bounced| bounced.read(backend)).transpose()?,
            source,
        })
    }

    /// Gives the memory back.
    pub fn release<B: Backend>(self, backend: &mut B) {
        self.tables.release(backend);
        backend.release(self.source);
        backend.release(self.hits);
        backend.release(self.colours);
        backend.release(self.light_rays);
        self.surfaces.into_iter().for_each(|surfaces| backend.release(surfaces));
        self.seen.into_iter().for_each(|seen| backend.release(seen));
        self.bounced.into_iter().for_each(|bounced| bounced.release(backend));
        if let Some((remaining, recalled)) = self.recalled {
            backend.release(remaining);
            backend.release(recalled);
        }
    }
}
