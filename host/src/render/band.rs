//! The passes of one view over one band of rows.

use super::SceneData;
use super::buffers::SceneBuffers;
use super::renderer::Stages;
use super::shadows::{Proofs, Shadows};
use super::stereo::bounces;
use super::stereo::second::Inferred;
use crate::backend::{Backend, BackendError};
use kernel_api::Buffer;
use parallax_kernels::{bounce::Bounce, primary::Primary, shade::Shade, surface::Surface};
use parallax_shared::layout::{self, Hit, RayCounts, View};
use parallax_shared::shading::{bounce::is_whole, shadow};

/// The names of the views.
pub const EYES: [&str; 2] = ["left", "right"];

/// A run of rows of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Band {
    /// The first of them.
    pub first_row: u32,
    /// How many.
    pub rows: u32,
}

impl Band {
    /// Bands of at most `rows` rows that make up a picture of `height` rows.
    pub fn of_picture(height: u32, rows: u32) -> impl Iterator<Item = Self> {
        let rows = rows.max(1);
        let band = move |first_row| Self { first_row, rows: rows.min(height - first_row) };
        (0..height).step_by(rows as usize).map(band)
    }
}

/// Pixels, or points of a lattice, in the band of `view`.
pub(super) fn pixels_of(view: &View) -> usize {
    view.width as usize * view.rows as usize
}

/// What every stage has made of a band: one element per pixel, `width · rows` of them, unless something else
/// is said.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// What the primary rays hit.
    pub hits: Vec<Hit>,
    /// What shading knows of those points.
    pub surfaces: Vec<layout::Surface>,
    /// Bit by bit, which lights are seen; [`shadow_words`](Self::shadow_words) words per pixel, which follow
    /// each other. Empty where nobody noted them.
    pub shadow: Vec<u32>,
    /// Words of [`shadow`](Self::shadow) per pixel.
    pub shadow_words: usize,
    /// Linear colour without reflection and refraction; the fourth word is 1 where that is all, and 0 where they add to it.
    pub local: Vec<[f32; 4]>,
    /// Primary rays traced.
    pub primary_rays: Vec<RayCounts>,
    /// Rays to lights traced from the first surface.
    pub shadow_rays: Vec<RayCounts>,
    /// What reflection and refraction add, in scenes that have any.
    pub bounced: Option<Bounced>,
}

/// What the pass `bounce` makes of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounced {
    /// Linear colour with reflection and refraction; the fourth word is 1.
    pub colour: Vec<[f32; 4]>,
    /// Rays traced for it, those to lights included.
    pub rays: Vec<RayCounts>,
}

impl Values {
    /// The linear colour that is seen.
    pub fn colour(&self) -> &[[f32; 4]] {
        self.bounced.as_ref().map_or(&self.local, |bounced| &bounced.colour)
    }

    /// The rays that were traced, stage by stage.
    pub fn rays(&self) -> impl Iterator<Item = &[RayCounts]> {
        let bounced = self.bounced.iter().map(|bounced| &bounced.rays[..]);
        [&self.primary_rays[..], &self.shadow_rays].into_iter().chain(bounced)
    }

    /// The same as a copy, for which no ray was traced.
    pub(super) fn without_rays(&self) -> Self {
        let mut copy = self.clone();
        copy.primary_rays.fill(RayCounts::NONE);
        copy.shadow_rays.fill(RayCounts::NONE);
        copy.bounced.iter_mut().for_each(|bounced| bounced.rays.fill(RayCounts::NONE));
        copy
    }
}

impl Bounced {
    /// What is seen, and the rays for it: those of the pass `bounce` where the colours `own` that it was given are not whole. Elsewhere it
    /// has written nothing, and nothing is to be added.
    pub(crate) fn to(own: &[[f32; 4]], mut colour: Vec<[f32; 4]>, mut rays: Vec<RayCounts>) -> Self {
        let whole = own.iter().enumerate().filter(|(_, own)| is_whole(own));
        whole.for_each(|(pixel, own)| (colour[pixel], rays[pixel]) = (*own, RayCounts::NONE));
        Self { colour, rays }
    }
}

/// Both views of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The view that was traced first.
    pub source: Values,
    /// The other one.
    pub second: Values,
    /// How the other one was made from the first, where it was.
    pub inferred: Option<Inferred>,
}

/// The outputs of the pass `bounce`.
#[derive(Clone, Copy)]
pub(super) struct BounceBuffers {
    colours: Buffer<[f32; 4]>,
    rays: Buffer<RayCounts>,
}

impl BounceBuffers {
    pub fn create<B: Backend>(backend: &mut B, pixels: usize) -> Result<Self, BackendError> {
        Ok(Self {
            colours: backend.create("colours", pixels)?,
            rays: backend.create("bounced rays", pixels)?,
        })
    }

    /// Adds reflection and refraction at `surfaces` to the colours `local`.
    pub fn run<B: Backend>(
        &self,
        data: &SceneData,
        scene: &SceneBuffers,
        view: View,
        surfaces: Buffer<layout::Surface>,
        local: Buffer<[f32; 4]>,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let SceneBuffers { rows, triangles, records, texels } = *scene;
        let (info, effects, colours, counts) = (data.info, data.effects.0, self.colours, self.rays);
        let bounce = Bounce {
            view,
            info,
            rows,
            triangles,
            records,
            texels,
            surfaces,
            local,
            colours,
            counts,
            effects,
        };
        stages.run(&bounce, &view)
    }

    /// What is seen where the colours `own` were given to the pass.
    pub fn read<B: Backend>(&self, backend: &mut B, own: &[[f32; 4]]) -> Result<Bounced, BackendError> {
        Ok(Bounced::to(own, backend.read(self.colours)?, backend.read(self.rays)?))
    }

    pub fn release<B: Backend>(self, backend: &mut B) {
        backend.release(self.colours);
        backend.release(self.rays);
    }
}

/// The outputs of the passes over one band.
#[derive(Clone, Copy)]
pub(super) struct BandBuffers {
    pub hits: Buffer<Hit>,
    pub surfaces: Buffer<layout::Surface>,
    pub shadow: Buffer<u32>,
    pub local: Buffer<[f32; 4]>,
    primary_rays: Buffer<RayCounts>,
    shadow_rays: Buffer<RayCounts>,
    bounced: Option<BounceBuffers>,
    /// Where shadows are proven.
    pub proofs: Option<Proofs>,
}

impl BandBuffers {
    /// Size of the largest element that a buffer has per pixel.
    pub fn bytes_per_pixel(data: &SceneData) -> u32 {
        (size_of::<layout::Surface>() as u32).max(4 * shadow::words(data.info.lights))
    }

    /// Buffers for the band of `view`, poisoned: what no pass writes is found by whoever compares. `proofs`:
    /// shadows are proven, with proofs that another view uses, too, or not.
    pub fn create<B: Backend>(
        backend: &mut B,
        data: &SceneData,
        view: &View,
        proofs: Option<bool>,
    ) -> Result<Self, BackendError> {
        let pixels = pixels_of(view);
        Ok(Self {
            hits: backend.create("hits", pixels)?,
            surfaces: backend.create("surfaces", pixels)?,
            shadow: backend.create("shadow bits", pixels * shadow::words(data.info.lights) as usize)?,
            local: backend.create("local colours", pixels)?,
            primary_rays: backend.create("primary rays", pixels)?,
            shadow_rays: backend.create("shadow rays", pixels)?,
            bounced: bounces(data).then(|| BounceBuffers::create(backend, pixels)).transpose()?,
            proofs: proofs.map(|shared| Proofs::create(backend, data, view, shared)).transpose()?,
        })
    }

    /// The colours that are seen where the local ones are not whole.
    pub fn bounced_colours(&self) -> Buffer<[f32; 4]> {
        self.bounced.map_or(self.local, |bounced| bounced.colours)
    }

    /// Runs the passes in order.
    pub fn run<B: Backend>(
        &self,
        data: &SceneData,
        scene: &SceneBuffers,
        view: View,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { hits, surfaces, shadow: seen, local, primary_rays, shadow_rays, bounced, proofs } = *self;
        let SceneBuffers { rows, triangles, records, texels } = *scene;
        let (info, effects) = (data.info, data.effects.0);
        stages.run(&Primary { view, info, rows, hits, counts: primary_rays }, &view)?;
        stages.run(&Surface { view, info, triangles, records, hits, surfaces, effects }, &view)?;
        Shadows { view, surfaces, seen, counts: shadow_rays }.run(data, scene, proofs, stages)?;
        let colours = local;
        stages.run(&Shade { view, info, records, texels, surfaces, seen, colours, effects }, &view)?;
        match bounced {
            Some(bounced) => bounced.run(data, scene, view, surfaces, local, stages),
            None => Ok(()),
        }
    }

    /// Everything that the passes have written.
    pub fn read<B: Backend>(&self, backend: &mut B, data: &SceneData) -> Result<Values, BackendError> {
        let local = backend.read(self.local)?;
        let bounced = self.bounced.map(|bounced| bounced.read(backend, &local)).transpose()?;
        Ok(Values {
            hits: backend.read(self.hits)?,
            surfaces: backend.read(self.surfaces)?,
            shadow: backend.read(self.shadow)?,
            shadow_words: shadow::words(data.info.lights) as usize,
            local,
            primary_rays: backend.read(self.primary_rays)?,
            shadow_rays: backend.read(self.shadow_rays)?,
            bounced,
        })
    }

    /// Gives the memory back.
    pub fn release<B: Backend>(self, backend: &mut B) {
        backend.release(self.hits);
        backend.release(self.surfaces);
        backend.release(self.shadow);
        backend.release(self.local);
        backend.release(self.primary_rays);
        backend.release(self.shadow_rays);
        self.bounced.into_iter().for_each(|bounced| bounced.release(backend));
        self.proofs.into_iter().for_each(|proofs| proofs.release(backend));
    }
}

#[cfg(test)]
mod tests {
    use super::Band;

    #[test]
    fn bands_make_up_the_picture() {
        let bands =
            |height, rows| Band::of_picture(height, rows).map(|b| (b.first_row, b.rows)).collect::<Vec<_>>();
        assert_eq!(bands(20, 8), [(0, 8), (8, 8), (16, 4)]);
        assert_eq!(bands(8, 8), [(0, 8)]);
        assert_eq!(bands(3, 100), [(0, 3)]);
        assert_eq!(bands(2, 0), [(0, 1), (1, 1)]);
    }
}
