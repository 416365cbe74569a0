//! The second view of a pair from the first: the passes that every method has in common.
//!
//! A method fills two tables with what each pixel of the second view may show ([`tables`]). Then `settle` verifies candidates,
//! traces what is missing and copies colours; `light` shades what was traced; `gloss` shades reused points again where they shine.
//! Only scenes that reflect, and images of more than colours, need surfaces (`inherit`).

pub mod overlap;
pub mod savings;
pub mod second;
pub mod statistics;
mod tables;
mod unseen;

use super::band::BandBuffers;
use super::buffers::SceneBuffers;
use super::method::{Method, Shadows, StereoOptions, Verify};
use super::renderer::Stages;
use super::{RenderError, SceneData};
use crate::backend::{Backend, BackendError};
use parallax_kernels::stereo::{
    copy::Copy, gloss::Gloss, inherit::Inherit, light::Light, settle::Settle, trace::Trace,
};
use parallax_kernels::{shade::Shade, shadow::Shadow};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Reprojection, View};
use parallax_shared::stereo::run::RUN;
use parallax_shared::stereo::settle::{VERIFY_ALL, VERIFY_EDGES, VERIFY_NONE};
use second::SecondBuffers;

/// What a scene and the options say of every band's reprojection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The options.
    pub options: StereoOptions,
    /// For a band, but for its rows.
    reprojection: Reprojection,
    /// Whether surfaces and hits of all pixels are wanted, and not only their colours.
    pub everything: bool,
}

impl Plan {
    /// How pairs of `data` are rendered.
    ///
    /// # Errors
    /// When the options do not go together.
    pub fn new(data: &SceneData, options: &StereoOptions, everything: bool) -> Result<Self, RenderError> {
        options.check()?;
        let [source, _] = options.first.eyes();
        let View { width, interaxial_px, .. } = data.views[source];
        let reprojection = Reprojection {
            width,
            rows: 0,
            interaxial_px,
            mirrored: source as u32,
            verify: match options.verify() {
                Verify::None => VERIFY_NONE,
                Verify::Edges => VERIFY_EDGES,
                Verify::All => VERIFY_ALL,
            },
            checked_from: unseen::checked_from(data, source),
            depth: tables::depth(data, options),
            exclusive: tables::is_exclusive(options).into(),
            inclusive: 0,
            keep_hits: everything.into(),
            copies: options.copies_colours(data).into(),
            samples: 0,
            seed: 0,
            padding: [0; 3],
        };
        Ok(Self { options: *options, reprojection, everything })
    }

    /// For a band of so many rows.
    pub fn of_band(&self, rows: u32) -> Reprojection {
        Reprojection { rows, ..self.reprojection }
    }

    /// Words that the largest buffer with an element per pixel has for it.
    pub fn words_per_pixel(&self) -> u32 {
        self.reprojection.depth
    }
}

/// Makes the second view `view` of a band from `source`, which has been rendered.
pub(super) fn second_view<B: Backend>(
    plan: &Plan,
    data: &SceneData,
    scene: &SceneBuffers,
    source: &BandBuffers,
    second: &SecondBuffers,
    view: View,
    stages: &mut Stages<'_, '_, B>,
) -> Result<(), BackendError> {
    let pixels = view.width * view.rows;
    if plan.options.method == Method::Ideal {
        return stages.run_over(&Copy { colours: source.colour(), copied: second.colours }, [pixels, 1, 1]);
    }
    let p = tables::fill(plan, &second.tables, plan.of_band(view.rows), source.hits, stages)?;
    let SceneBuffers { rows, triangles, records, texels } = *scene;
    let (info, effects) = (data.info, data.effects.0);
    let settle = Settle {
        p,
        candidates: second.tables.candidates,
        gaps: second.tables.gaps,
        source_hits: source.hits,
        source_colours: source.local,
        words: second.source,
        hits: second.hits,
        colours: second.colours,
    };
    stages.run_over(&settle, [p.width.div_ceil(RUN), p.rows, 1])?;
    let (words, hits, source_hits) = (second.source, second.hits, source.hits);
    stages.run(&Trace { p, view, info, rows, source_hits, words, hits }, &view)?;
    let (from, colours) = (second.source, second.colours);
    if plan.options.shadows == Shadows::Reuse {
        let counts = second.light_rays;
        let light = Light {
            view,
            info,
            rows,
            triangles,
            records,
            texels,
            source: from,
            hits,
            colours,
            counts,
            effects,
        };
        stages.run(&light, &view)?;
        if p.copies == 0 {
            let (source_surfaces, source_seen) = (source.surfaces, source.shadow);
            let gloss = Gloss {
                view,
                info,
                records,
                texels,
                source: from,
                source_surfaces,
                source_seen,
                colours,
                effects,
            };
            stages.run(&gloss, &view)?;
        }
    }
    let Some(surfaces) = second.surfaces else { return Ok(()) };
    let source_surfaces = source.surfaces;
    let inherit =
        Inherit { view, info, triangles, records, source: from, source_surfaces, hits, surfaces, effects };
    stages.run(&inherit, &view)?;
    if let Some(seen) = second.seen {
        let counts = second.light_rays;
        stages.run(&Shadow { view, info, rows, records, surfaces, seen, counts, effects }, &view)?;
        stages.run(&Shade { view, info, records, texels, surfaces, seen, colours, effects }, &view)?;
    }
    match second.bounced {
        Some(bounced) => bounced.run(data, scene, view, surfaces, colours, stages),
        None => Ok(()),
    }
}

/// Whether reflection or refraction follows the local colours.
pub(super) fn bounces(data: &SceneData) -> bool {
    data.effects.0 & Effects::REFLECTION.with(Effects::REFRACTION).0 != 0
}
