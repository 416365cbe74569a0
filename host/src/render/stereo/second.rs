//! The outputs of the passes over the second view of a band.

use super::overlap::Overlap;
use super::tables::TableBuffers;
use super::{Plan, bounces};
use crate::backend::{Backend, BackendError};
use crate::render::SceneData;
use crate::render::band::{BounceBuffers, Values, pixels_of};
use crate::render::method::{Method, Reflections};
use kernel_api::Buffer;
use parallax_shared::layout::{Hit, RayCounts, Surface, View};
use parallax_shared::shading::shadow;
use parallax_shared::stereo::source::{self, is_reused};

/// How the second view of a band was made: one element per pixel, or per point of the lattice at which several rays a pixel are
/// reprojected.
#[derive(Clone, Debug, PartialEq)]
pub struct Inferred {
    /// The nearest source that lands there: its column (mirrored if the right eye is the source) plus 1, or 0.
    pub candidates: Vec<u32>,
    /// The last gap over it: the right one of its columns plus 1, or 0.
    pub gaps: Vec<u32>,
    /// Where it comes from: see [`parallax_shared::stereo::source`].
    pub source: Vec<u32>,
    /// What of the source lands where.
    pub overlap: Overlap,
}

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
    /// Colours with what was recalled, where reflections are reused.
    pub(super) recalled: Option<Buffer<[f32; 4]>>,
}

impl SecondBuffers {
    /// Buffers for the band of `view`.
    pub fn create<B: Backend>(
        backend: &mut B,
        plan: &Plan,
        data: &SceneData,
        view: &View,
    ) -> Result<Self, BackendError> {
        let pixels = pixels_of(view);
        let traces = !plan.reuses_shadows();
        let bounces = bounces(data) && plan.options.method != Method::Ideal;
        let recalls = bounces && plan.options.reflections != Reflections::Trace;
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
            recalled: recalls.then(|| backend.create("recalled colours", pixels)).transpose()?,
        })
    }

    /// Everything that the passes have written, of a plan that wants everything: what the view shows, and how it was made from the
    /// `source`.
    pub fn read<B: Backend>(
        &self,
        backend: &mut B,
        plan: &Plan,
        source: &Values,
    ) -> Result<(Values, Inferred), BackendError> {
        let words = backend.read(self.source)?;
        let mut shadow_rays = backend.read(self.light_rays)?;
        if self.seen.is_none() {
            // Only traced pixels have counts.
            let reused = shadow_rays.iter_mut().zip(&words).filter(|(_, word)| is_reused(**word));
            reused.for_each(|(rays, _)| *rays = RayCounts::NONE);
        }
        let primary = |&word: &u32| RayCounts {
            primary: u32::from(source::kind(word) != source::REUSED),
            ..RayCounts::NONE
        };
        let local = backend.read(self.colours)?;
        let recalled = self.recalled.map(|recalled| backend.read(recalled)).transpose()?;
        let own = recalled.as_ref().unwrap_or(&local);
        let bounced = self.bounced.map(|bounced| bounced.read(backend, own)).transpose()?;
        let values = Values {
            hits: backend.read(self.hits)?,
            surfaces: self.surfaces.map_or(Ok(Vec::new()), |surfaces| backend.read(surfaces))?,
            shadow: self.seen.map_or(Ok(Vec::new()), |seen| backend.read(seen))?,
            shadow_words: source.shadow_words,
            local,
            primary_rays: words.iter().map(primary).collect(),
            shadow_rays,
            bounced,
        };
        let inferred = Inferred {
            candidates: backend.read(self.tables.candidates)?,
            gaps: backend.read(self.tables.gaps)?,
            source: words,
            overlap: Overlap::of_band(plan.of_picture(), &source.hits),
        };
        Ok((values, inferred))
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
        self.recalled.into_iter().for_each(|recalled| backend.release(recalled));
    }
}
