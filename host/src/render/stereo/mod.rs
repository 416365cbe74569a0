//! The second view of a pair from the first: the passes that every method has in common.
//!
//! A method fills two tables with what each pixel of the second view may show (`tables`). Then `settle` verifies candidates,
//! traces what is missing and copies colours; `light` shades what was traced; `gloss` shades reused points again where they shine.
//! Only scenes that reflect, and images of more than colours, need surfaces (`inherit`).

pub mod maps;
pub mod overlap;
pub mod plan_report;
pub mod savings;
pub mod second;
pub mod statistics;
pub(super) mod tables;
pub mod time_view;
mod unseen;

use super::band::BandBuffers;
use super::buffers::SceneBuffers;
use super::method::{Method, Reflections, Shadows, StereoOptions, Verify};
use super::renderer::Stages;
use super::sampling::Grid;
use super::shadows;
use super::{RenderError, SceneData};
use crate::backend::{Backend, BackendError};
use kernel_api::Buffer;
use parallax_kernels::shade::Shade;
use parallax_kernels::stereo::{
    copy::Copy, gloss::Gloss, guided::Guided, inherit::Inherit, light::Light, recall::Recall, settle::Settle,
    trace::Trace,
};
use parallax_shared::effects::Effects;
use parallax_shared::layout::{Reprojection, Surface, View};
use parallax_shared::stereo::run::RUN;
use parallax_shared::stereo::settle::{VERIFY_ALL, VERIFY_EDGES, VERIFY_NONE};
use second::SecondBuffers;
use tables::TableBuffers;

/// What a scene and the options say of every band's reprojection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The options.
    pub options: StereoOptions,
    /// For a band, but for its rows.
    reprojection: Reprojection,
    /// Whether surfaces and hits of all pixels are wanted, and not only their colours.
    pub everything: bool,
    /// Where a pixel has several rays: their places.
    pub(super) grid: Option<Grid>,
}

impl Plan {
    /// How pairs of `data` are rendered.
    ///
    /// # Errors
    /// When the options do not go together, or a picture has too many points.
    pub fn new(data: &SceneData, options: &StereoOptions, everything: bool) -> Result<Self, RenderError> {
        options.check()?;
        let grid = options.samples.grid();
        let [source, _] = options.first.eyes();
        // The picture whose columns are reprojected: of pixels, or of points.
        let moved = match grid {
            Some(grid) if !grid.aims => grid.checked_view(&data.views[source])?,
            _ => data.views[source],
        };
        let checked_from = match options.method.reuses() {
            true => unseen::checked_from(data, source),
            false => data.views[source].width,
        };
        let reprojection = Reprojection {
            width: moved.width,
            rows: 0,
            interaxial_px: moved.interaxial_px,
            mirrored: source as u32,
            verify: match options.verify() {
                Verify::None => VERIFY_NONE,
                Verify::Edges => VERIFY_EDGES,
                Verify::All => VERIFY_ALL,
            },
            checked_from: match grid {
                Some(grid) if !grid.aims => grid.column_of(checked_from, &data.views[source]),
                _ => checked_from,
            },
            depth: tables::depth(data, options, &moved),
            exclusive: tables::is_exclusive(options).into(),
            inclusive: grid.is_some_and(|grid| grid.aims).into(),
            keep_hits: (everything && grid.is_none()).into(),
            copies: (options.copies_colours(data) && grid.is_none()).into(),
            sparse: grid.is_some_and(|grid| grid.levels > 0).into(),
        };
        Ok(Self { options: *options, reprojection, everything, grid })
    }

    /// For a band of so many rows, of pixels or of points.
    pub fn of_band(&self, rows: u32) -> Reprojection {
        Reprojection { rows, ..self.reprojection }
    }

    /// For the picture, without rows.
    pub fn of_picture(&self) -> &Reprojection {
        &self.reprojection
    }

    /// Whether the colours of points that the source shows are copied.
    pub(super) fn copies(&self) -> bool {
        self.reprojection.copies != 0
    }

    /// Whether the light that points of the source see is theirs in the second view, too.
    pub(super) fn reuses_shadows(&self) -> bool {
        self.options.shadows == Shadows::Reuse && self.options.method != Method::Guided
    }

    /// Whether proofs for tiles say which lights points see; if so, whether those of the source serve the second view.
    pub(super) fn proofs(&self) -> Option<bool> {
        let shared = self.options.method == Method::Guided;
        (self.options.shadows == Shadows::Prove).then_some(shared)
    }

    /// Words that the largest buffer with an element per pixel has for it.
    pub fn words_per_pixel(&self) -> u32 {
        self.reprojection.depth
    }
}

/// Everything that the passes of a second view need.
#[derive(Clone, Copy)]
pub(super) struct SecondView<'a> {
    pub plan: &'a Plan,
    pub data: &'a SceneData,
    pub scene: &'a SceneBuffers,
    /// The first view, which has been rendered.
    pub source: &'a BandBuffers,
    pub second: &'a SecondBuffers,
    pub view: View,
}

impl SecondView<'_> {
    /// Makes the second view of a band.
    pub fn run<B: Backend>(&self, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
        let Self { plan, data, scene, source, second, view } = *self;
        if plan.options.method == Method::Ideal {
            let pixels = view.width * view.rows;
            let (local, colours, copied) = (source.local, source.bounced_colours(), second.colours);
            return stages.run_over(&Copy { local, colours, copied }, [pixels, 1, 1]);
        }
        let p = tables::fill(plan, &second.tables, plan.of_band(view.rows), source.hits, stages)?;
        self.find(p, stages)?;
        if plan.reuses_shadows() {
            self.light(p, stages)?;
        }
        let Some(surfaces) = second.surfaces else { return Ok(()) };
        self.inherit(surfaces, stages)?;
        let Some(bounced) = second.bounced else { return Ok(()) };
        let local = self.recall(stages)?;
        bounced.run(data, scene, view, surfaces, local, stages)
    }

    /// The colours that the pass `bounce` starts from: those that the source's reflections serve are whole.
    fn recall<B: Backend>(&self, stages: &mut Stages<'_, '_, B>) -> Result<Buffer<[f32; 4]>, BackendError> {
        let Self { plan, data, source: first, second, view, .. } = *self;
        let local = second.colours;
        let (Reflections::Within(degrees), Some(recalled)) = (plan.options.reflections, second.recalled)
        else {
            return Ok(local);
        };
        let [eye, _] = plan.options.first.eyes();
        let source_view = View { first_row: view.first_row, rows: view.rows, ..data.views[eye] };
        let (source, source_local, source_colours) = (second.source, first.local, first.bounced_colours());
        let cos_limit = f64::from(degrees).to_radians().cos() as f32;
        let recall =
            Recall { source_view, view, cos_limit, source, source_local, source_colours, local, recalled };
        stages.run(&recall, &view)?;
        Ok(recalled)
    }

    /// What each pixel shows.
    fn find<B: Backend>(&self, p: Reprojection, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
        let Self { plan, data, scene, source, second, view } = *self;
        let (info, rows) = (data.info, scene.rows);
        let (words, hits, colours, source_hits) = (second.source, second.hits, second.colours, source.hits);
        let TableBuffers { candidates, gaps, .. } = second.tables;
        if plan.options.method == Method::Guided {
            return stages.run(&Guided { p, view, info, rows, candidates, source_hits, words, hits }, &view);
        }
        let source_colours = source.local;
        let settle = Settle { p, candidates, gaps, source_hits, source_colours, words, hits, colours };
        stages.run_over(&settle, [p.width.div_ceil(RUN), p.rows, 1])?;
        stages.run(&Trace { p, view, info, rows, source_hits, words, hits }, &view)
    }

    /// Colours where they were not copied.
    fn light<B: Backend>(&self, p: Reprojection, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
        let Self { data, scene, source: first, second, view, .. } = *self;
        let SceneBuffers { rows, triangles, records, texels } = *scene;
        let (info, effects) = (data.info, data.effects.0);
        let (source, hits, colours, counts) = (second.source, second.hits, second.colours, second.light_rays);
        let light =
            Light { view, info, rows, triangles, records, texels, source, hits, colours, counts, effects };
        stages.run(&light, &view)?;
        if p.copies != 0 {
            return Ok(());
        }
        let (source_surfaces, source_seen) = (first.surfaces, first.shadow);
        let gloss =
            Gloss { view, info, records, texels, source, source_surfaces, source_seen, colours, effects };
        stages.run(&gloss, &view)
    }

    /// Surfaces, of all pixels if they are wanted or shaded here, else of those that reflect; and, where nothing is reused of the source's
    /// shadows, what they look like.
    fn inherit<B: Backend>(
        &self,
        surfaces: Buffer<Surface>,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { plan, data, scene, source: first, second, view, .. } = *self;
        let SceneBuffers { triangles, records, texels, .. } = *scene;
        let (info, effects) = (data.info, data.effects.0);
        let (source, source_surfaces, hits) = (second.source, first.surfaces, second.hits);
        let all = (plan.everything || second.seen.is_some()).into();
        let colours = second.colours;
        let inherit = Inherit {
            view,
            info,
            all,
            triangles,
            records,
            source,
            source_surfaces,
            hits,
            colours,
            surfaces,
            effects,
        };
        stages.run(&inherit, &view)?;
        let Some(seen) = second.seen else { return Ok(()) };
        let counts = second.light_rays;
        let shadows = shadows::Shadows { view, surfaces, seen, counts };
        match first.proofs {
            Some(proofs) => {
                let towards = (plan.of_band(view.rows), second.tables.candidates);
                shadows.run_guided(data, scene, proofs, towards, stages)?;
            }
            None => shadows.run(data, scene, None, stages)?,
        }
        stages.run(&Shade { view, info, records, texels, surfaces, seen, colours, effects }, &view)
    }
}

/// Whether reflection or refraction follows the local colours.
pub(super) fn bounces(data: &SceneData) -> bool {
    data.effects.0 & Effects::REFLECTION.with(Effects::REFRACTION).0 != 0
}
