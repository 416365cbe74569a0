//! The passes of a pair whose pixels have several rays.

use super::Grid;
use super::buffers::{InferenceBuffers, SampledBuffers, ViewBuffers};
use crate::backend::{Backend, BackendError};
use crate::render::band::{Pair, Values};
use crate::render::method::Method;
use crate::render::renderer::Stages;
use crate::render::stereo::overlap::Overlap;
use crate::render::stereo::second::Inferred;
use crate::render::stereo::{Plan, bounces, tables};
use crate::render::{SceneBuffers, SceneData};
use kernel_api::Buffer;
use parallax_kernels::sampling::aim::{Aim, Spread};
use parallax_kernels::sampling::{
    average::Average, begin::Begin, carry::Carry, infer::Infer, refine::Refine, sample::Sample,
};
use parallax_kernels::stereo::{copy::Copy, settle::Settle, trace::Trace};
use parallax_kernels::{primary::Primary, surface::Surface};
use parallax_shared::layout::{Hit, RayCounts, Refinement, Reprojection, View};
use parallax_shared::stereo::run::RUN;
use parallax_shared::stereo::source::{self, REUSED};

/// A band of a pair.
#[derive(Clone, Copy)]
pub(in crate::render) struct SampledPair<'a> {
    pub plan: &'a Plan,
    pub data: &'a SceneData,
    pub scene: &'a SceneBuffers,
    /// The band in the source, and in the second view.
    pub views: [View; 2],
    pub buffers: &'a SampledBuffers,
}

impl SampledPair<'_> {
    /// Samples the first view.
    pub fn run_source<B: Backend>(&self, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
        // Nothing is verified, so it does not matter whose hits these are.
        let others = self.buffers.second.hits;
        self.sample(&self.views[0], &self.buffers.source, others, None, stages)
    }

    /// Makes the second view.
    pub fn run_second<B: Backend>(&self, stages: &mut Stages<'_, '_, B>) -> Result<(), BackendError> {
        let SampledBuffers { source, second, inference, .. } = self.buffers;
        let view = &self.views[1];
        if self.plan.options.method == Method::Ideal {
            let (local, colours, copied) = (source.colours, source.colours, second.colours);
            let copy = Copy { local, colours, copied };
            return stages.run_over(&copy, [view.width * view.rows, 1, 1]);
        }
        if let Some(inference) = inference {
            self.plan_points(inference, stages)?;
        }
        self.sample(view, second, source.hits, inference.as_ref(), stages)
    }

    /// Decides what each point of the second view may come from.
    fn plan_points<B: Backend>(
        &self,
        inference: &InferenceBuffers,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { plan, data, scene, views: [_, view], buffers } = *self;
        let grid = buffers.grid;
        let points = grid.view(&view, grid.levels);
        let (source, second, planned) = (&buffers.source, &buffers.second, inference.planned);
        let Some(aimed) = inference.aimed else {
            let p = tables::fill(plan, &inference.tables, plan.of_band(points.rows), source.hits, stages)?;
            return self.settle(p, inference, source.hits, planned, second.hits, stages);
        };
        let (p, words) = (plan.of_band(view.rows), aimed.words);
        stages.run(&Aim { p, points, hits: source.hits, aimed: aimed.hits }, &view)?;
        let p = tables::fill(plan, &inference.tables, p, aimed.hits, stages)?;
        self.settle(p, inference, aimed.hits, words, aimed.second_hits, stages)?;
        let (info, rows, source_hits, hits) = (data.info, scene.rows, aimed.hits, aimed.second_hits);
        stages.run(&Trace { p, view, info, rows, source_hits, words, hits }, &view)?;
        stages.run(&Spread { p, points, words, planned }, &points)
    }

    /// Puts what the tables say into `words`. Hits and colours stay as they are: the reprojection of points asks for neither.
    fn settle<B: Backend>(
        &self,
        p: Reprojection,
        inference: &InferenceBuffers,
        source_hits: Buffer<Hit>,
        words: Buffer<u32>,
        hits: Buffer<Hit>,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let tables::TableBuffers { candidates, gaps, .. } = inference.tables;
        let (source_colours, colours) = (self.buffers.source.colours, self.buffers.second.colours);
        let settle = Settle { p, candidates, gaps, source_hits, source_colours, words, hits, colours };
        stages.run_over(&settle, [p.width.div_ceil(RUN), p.rows, 1])
    }

    /// Samples the points of a view, level by level, and makes pixels of them. `others` are the hits of the other view's points.
    fn sample<B: Backend>(
        &self,
        view: &View,
        buffers: &ViewBuffers,
        others: Buffer<Hit>,
        inference: Option<&InferenceBuffers>,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let ViewBuffers { words, hits, samples, colours, rays: counts, .. } = *buffers;
        let plans = inference.is_some().into();
        // Without a plan nobody looks at it, but some buffer has to be bound.
        let planned = inference.map_or(buffers.seen, |inference| inference.planned);
        for level in 0..=self.buffers.grid.levels {
            let points = self.buffers.grid.view(view, level);
            if level == 0 {
                stages.run(&Begin { view: points, plans, planned, words, hits }, &points)?;
            } else {
                let coarser = self.buffers.grid.view(view, level - 1);
                let refinement = Refinement { tolerance: self.plan.options.samples.tolerance(), plans };
                let refine = Refine { view: coarser, refinement, samples, planned, words };
                stages.run_over(&refine, Grid::invocations(&coarser))?;
            }
            self.sample_level(points, buffers, others, plans == 1, stages)?;
        }
        stages.run(
            &Average { lattice: self.buffers.grid.lattice(view), words, samples, colours, counts },
            view,
        )?;
        self.middles(view, buffers, stages)
    }

    /// Samples the points of a level.
    fn sample_level<B: Backend>(
        &self,
        view: View,
        buffers: &ViewBuffers,
        source_hits: Buffer<Hit>,
        infers: bool,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Self { plan, data, .. } = *self;
        let grid = self.buffers.grid;
        let SceneBuffers { rows, triangles, records, texels } = *self.scene;
        let ViewBuffers { words, hits, seen, samples, .. } = *buffers;
        let (info, effects, invocations) = (data.info, data.effects.0, Grid::invocations(&view));
        let p = plan.of_band(view.rows);
        stages.run_over(&Trace { p, view, info, rows, source_hits, words, hits }, invocations)?;
        let sample =
            Sample { view, info, rows, triangles, records, texels, words, hits, seen, samples, effects };
        stages.run_over(&sample, invocations)?;
        let (source_seen, source_samples) = (self.buffers.source.seen, self.buffers.source.samples);
        if !infers {
            return Ok(());
        }
        let carries = plan.options.copies_colours(data);
        if carries {
            stages.run_over(&Carry { view, words, source_samples, samples }, invocations)?;
        }
        if carries && !bounces(data) {
            return Ok(());
        }
        let (source_view, carried) = (grid.view(&self.views[0], grid.levels), carries.into());
        let infer = Infer {
            source_view,
            view,
            info,
            carried,
            rows,
            triangles,
            records,
            texels,
            words,
            source_hits,
            source_seen,
            samples,
            effects,
        };
        stages.run_over(&infer, invocations)
    }

    /// What the middles of pixels show, if that is wanted.
    fn middles<B: Backend>(
        &self,
        view: &View,
        buffers: &ViewBuffers,
        stages: &mut Stages<'_, '_, B>,
    ) -> Result<(), BackendError> {
        let Some(middles) = buffers.middles else { return Ok(()) };
        let SceneBuffers { rows, triangles, records, .. } = *self.scene;
        let (view, info, effects) = (*view, self.data.info, self.data.effects.0);
        let (hits, surfaces, counts) = (middles.hits, middles.surfaces, middles.rays);
        stages.run(&Primary { view, info, rows, hits, counts }, &view)?;
        stages.run(&Surface { view, info, triangles, records, hits, surfaces, effects }, &view)
    }

    /// Everything that was made.
    pub fn read<B: Backend>(&self, backend: &mut B) -> Result<Pair, BackendError> {
        let SampledBuffers { source: first, second, inference, .. } = self.buffers;
        let source = read_view(backend, first)?;
        if self.plan.options.method == Method::Ideal {
            let second = source.without_rays();
            return Ok(Pair { source, second, inferred: None });
        }
        let mut second_values = read_view(backend, second)?;
        let Some(inference) = inference else {
            return Ok(Pair { source, second: second_values, inferred: None });
        };
        let (words, moved) = match inference.aimed {
            Some(aimed) => (backend.read(aimed.words)?, backend.read(aimed.hits)?),
            None => (backend.read(second.words)?, backend.read(first.hits)?),
        };
        if inference.aimed.is_some() {
            // The rays that aim are those of pixels.
            let aiming = second_values.primary_rays.iter_mut().zip(&words);
            aiming.for_each(|(rays, word)| rays.primary += u32::from(source::kind(*word) != REUSED));
        }
        let inferred = Inferred {
            candidates: backend.read(inference.tables.candidates)?,
            gaps: backend.read(inference.tables.gaps)?,
            source: words,
            overlap: Overlap::of_band(self.plan.of_picture(), &moved),
        };
        Ok(Pair { source, second: second_values, inferred: Some(inferred) })
    }
}

/// What a view shows: the colours of its pixels, and what is in their middles.
fn read_view<B: Backend>(backend: &mut B, buffers: &ViewBuffers) -> Result<Values, BackendError> {
    let middles = buffers.middles;
    let primary_rays = backend.read(buffers.rays)?;
    Ok(Values {
        hits: middles.map_or(Ok(Vec::new()), |middles| backend.read(middles.hits))?,
        surfaces: middles.map_or(Ok(Vec::new()), |middles| backend.read(middles.surfaces))?,
        shadow: Vec::new(),
        shadow_words: 0,
        local: backend.read(buffers.colours)?,
        shadow_rays: vec![RayCounts::NONE; primary_rays.len()],
        primary_rays,
        bounced: None,
    })
}
