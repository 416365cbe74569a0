//! The passes that find which lights each pixel sees.

use super::SceneData;
use super::band::pixels_of;
use super::buffers::SceneBuffers;
use super::renderer::Stages;
use crate::backend::{Backend, BackendError};
use kernel_api::Buffer;
use parallax_kernels::stereo::shadow_guided::ShadowGuided;
use parallax_kernels::{prove::Prove, shadow::Shadow, shadow_proven::ShadowProven};
use parallax_shared::layout::{RayCounts, Reprojection, Surface, View};
use parallax_shared::shading::proof;

/// How much larger than the points of a tile its box is, of its size on each side, where the points of another view are to be in it,
/// too: half a pixel of seven, by which those may be off, and a little.
const MARGIN: f32 = 0.125;

/// What is known of the tiles of a band.
#[derive(Clone, Copy)]
pub(super) struct Proofs {
    /// See [`proof`].
    tiles: Buffer<u32>,
    /// For each pixel and light the pack that hides it; one word where nobody asks for it.
    hiding: Buffer<u32>,
    shared: bool,
}

impl Proofs {
    /// Bytes per pixel of the larger buffer.
    pub fn bytes_per_pixel(data: &SceneData) -> u32 {
        4 * data.info.lights
    }

    /// For the band of `view`. `shared`: another view is to use them, too.
    pub fn create<B: Backend>(
        backend: &mut B,
        data: &SceneData,
        view: &View,
        shared: bool,
    ) -> Result<Self, BackendError> {
        let count = proof::tiles(view.width) as usize * proof::tiles(view.rows) as usize;
        let pixels = pixels_of(view);
        let hiding = if shared { pixels * data.info.lights as usize } else { 0 };
        Ok(Self {
            tiles: backend.create("proofs", count * proof::words(data.info.lights) as usize)?,
            hiding: backend.create("hiding packs", hiding.max(1))?,
            shared,
        })
    }

    pub fn release<B: Backend>(self, backend: &mut B) {
        backend.release(self.tiles);
        backend.release(self.hiding);
    }
}

/// What the passes read and write.
#[derive(Clone, Copy)]
pub(super) struct Shadows {
    pub view: View,
    pub surfaces: Buffer<Surface>,
    pub seen: Buffer<u32>,
    pub counts: Buffer<RayCounts>,
}

impl Shadows {
    /// Runs them; with `proofs`, these are made first.
    pub fn run<B: Backend>(
        self,
        data: &SceneData,
        scene: &SceneBuffers,
        proofs: Option<Proofs>,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { view, surfaces, seen, counts } = self;
        let SceneBuffers { rows, records, .. } = *scene;
        let (info, effects) = (data.info, data.effects.0);
        let Some(Proofs { tiles: proofs, hiding, shared }) = proofs else {
            return stages.run(&Shadow { view, info, rows, records, surfaces, seen, counts, effects }, &view);
        };
        let margin = if shared { MARGIN } else { 0.0 };
        let prove = Prove { view, info, margin, rows, records, surfaces, proofs, effects };
        stages.run_over(&prove, [proof::tiles(view.width), proof::tiles(view.rows), 1])?;
        let keep = shared.into();
        let proven =
            ShadowProven { view, info, keep, rows, records, surfaces, proofs, seen, counts, hiding, effects };
        stages.run(&proven, &view)
    }

    /// Runs them with what is known of the other view, to which `p` and `candidates` lead.
    pub fn run_guided<B: Backend>(
        self,
        data: &SceneData,
        scene: &SceneBuffers,
        proofs: Proofs,
        (p, candidates): (Reprojection, Buffer<u32>),
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { view, surfaces, seen, counts } = self;
        let (SceneBuffers { rows, records, .. }, Proofs { tiles: proofs, hiding, .. }) = (*scene, proofs);
        let (info, effects) = (data.info, data.effects.0);
        let guided = ShadowGuided {
            p,
            view,
            info,
            rows,
            records,
            surfaces,
            proofs,
            candidates,
            hiding,
            seen,
            counts,
            effects,
        };
        stages.run(&guided, &view)
    }
}
