//! Time views (000 §4.5.3): how long each pixel of the second view takes.
//!
//! 000 reads a clock in each thread of the device. Here the pair is rendered, and then what its pixels took is done once more on the
//! processor, pixel by pixel, by the functions that the passes call: relative times are what these pictures are for. Finding candidates
//! is left out, which takes every pixel the same.

use super::Plan;
use crate::backend::Cpu;
use crate::render::band::{Band, Pair};
use crate::render::{RenderError, Renderer, SceneData, StereoOptions};
use parallax_shared::layout::{Hit, Sample, View};
use parallax_shared::sampling::sample;
use parallax_shared::scene::SceneView;
use parallax_shared::shading::surface::reconstruct;
use parallax_shared::stereo::settle::ray_end;
use parallax_shared::stereo::source::{self, HOLE, VERIFIED};
use parallax_shared::{camera, traversal};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Seconds that each pixel of the second view takes; with one ray per pixel.
///
/// # Errors
/// When the options do not go together or the backend fails.
pub fn seconds(cpu: &mut Cpu, data: &SceneData, options: &StereoOptions) -> Result<Vec<f32>, RenderError> {
    let plan = Plan::new(data, options, true)?;
    let mut renderer = Renderer::new(cpu, data)?;
    let (rows, height) = (renderer.suggested_rows(&plan), data.views[0].height);
    let mut seconds = Vec::new();
    for band in Band::of_picture(height, rows) {
        let pair = renderer.pair(&plan, band)?;
        seconds.extend(of_band(data, &plan, band, &pair));
    }
    Ok(seconds)
}

fn of_band(data: &SceneData, plan: &Plan, band: Band, pair: &Pair) -> Vec<f32> {
    let eyes = plan.options.first.eyes();
    let [source_view, view] = eyes.map(|eye| View { first_row: band.first_row, ..data.views[eye] });
    let pixels = pair.second.hits.len() as u32;
    let timed = |pixel: u32| {
        let word = match &pair.inferred {
            Some(inferred) => inferred.source[pixel as usize],
            None => source::traced(HOLE),
        };
        let (x, row) = (pixel % view.width, pixel / view.width);
        let work = Work { data, plan, views: [&source_view, &view], hits: &pair.source.hits, x, row, word };
        let started = Instant::now();
        black_box(work.done());
        started.elapsed().as_secs_f32()
    };
    (0..pixels).into_par_iter().map(timed).collect()
}

/// What is to be done for a pixel.
struct Work<'a> {
    data: &'a SceneData,
    plan: &'a Plan,
    views: [&'a View; 2],
    /// Of the source.
    hits: &'a [Hit],
    x: u32,
    /// Of the band.
    row: u32,
    word: u32,
}

impl Work<'_> {
    fn done(&self) -> Option<Sample> {
        let Self { data, plan, views: [source_view, view], hits, x, row, word } = *self;
        let SceneData { info, rows, triangles, records, texels, effects, .. } = data;
        let scene = SceneView { info, rows, triangles, records, texels, effects: *effects };
        let from = |column: u32| hits[(row * view.width + column) as usize];
        let mut ray = camera::primary_ray(view, x, view.first_row + row);
        let dir = ray.dir.into();
        let mut hit = None;
        if let Some(end) = ray_end(plan.of_picture(), word, |column| from(column).t) {
            ray.t_max = end;
            hit = Some(traversal::closest_hit(rows, &ray, info.extent));
        }
        if source::is_traced(word) {
            let surface = reconstruct(&scene, &ray, hit?, view.interaxial_px);
            return Some(sample::traced(&scene, &surface, dir, |_, _| {}));
        }
        if plan.copies() {
            return None;
        }
        let column = source::column(word);
        let there = camera::primary_ray(source_view, column, view.first_row + row);
        let surface = reconstruct(&scene, &there, from(column), view.interaxial_px);
        Some(sample::inferred(&scene, &surface, dir, source::kind(word) == VERIFIED, |_| u32::MAX))
    }
}
