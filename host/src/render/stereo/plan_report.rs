//! How a second view is to be made, as reports have it: what can be told before anything is rendered.

use super::Plan;
use crate::render::method::{Method, Reflections};
use crate::render::{Depth, SceneData, value_name};
use serde::Serialize;
use std::fmt;

/// What a plan says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlanReport {
    /// The method.
    pub method: &'static str,
    /// What is verified; none where nothing is reused.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verify: Option<String>,
    /// How lights are looked for.
    pub shadows: String,
    /// The view that is traced.
    pub first: String,
    /// Where reflections come from: `trace`, or an angle in degrees.
    pub reflections: String,
    /// Rays per pixel.
    pub samples: String,
    /// How many slots a pixel (or point) of the method `buffer` has: `lemma`, `adaptive` or their number.
    pub depth: String,
    /// How many these are; 0 for methods without, 1 where the source will tell.
    pub slots: u32,
    /// Columns that are reprojected: of pixels, or of points.
    pub columns: u32,
    /// The distance of the eyes in such columns.
    pub interaxial: f32,
    /// From this column on every candidate is verified, as only the second eye sees what is in front of it; counted from the right if
    /// the right view is the first, and as many as there are if there is nothing.
    pub checked_from: u32,
    /// Whether colours are copied, not shaded anew for the other eye.
    pub copies_colours: bool,
}

impl PlanReport {
    /// What `plan` says of pairs of `data`.
    pub fn new(data: &SceneData, plan: &Plan) -> Self {
        let (options, p) = (&plan.options, plan.of_picture());
        Self {
            method: options.method.name(),
            verify: options.method.reuses().then(|| value_name(&options.verify())),
            shadows: value_name(&options.shadows),
            first: value_name(&options.first),
            reflections: match options.reflections {
                Reflections::Trace => "trace".into(),
                Reflections::Within(degrees) => degrees.to_string(),
            },
            samples: options.samples.to_string(),
            depth: match options.depth {
                Depth::Lemma => "lemma".into(),
                Depth::Adaptive => "adaptive".into(),
                Depth::Fixed(depth) => depth.to_string(),
            },
            slots: p.depth,
            columns: p.width,
            interaxial: p.interaxial_px,
            checked_from: p.checked_from,
            copies_colours: options.method.reuses() && options.copies_colours(data),
        }
    }
}

impl fmt::Display for PlanReport {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { method, first, samples, .. } = self;
        write!(f, "{method}, {samples} samples per pixel, the {first} view first")?;
        let Some(verify) = &self.verify else { return Ok(()) };
        let Self { shadows, columns, interaxial, checked_from, .. } = self;
        write!(f, "\n              {columns} columns are moved by up to {interaxial}")?;
        write!(f, "\n              verify {verify}, shadows {shadows}, ")?;
        write!(f, "colours {}", if self.copies_colours { "copied" } else { "shaded anew" })?;
        if checked_from < columns {
            write!(
                f,
                "\n              from column {checked_from} on all are verified: only the other eye sees there"
            )?;
        }
        if *method == Method::Buffer.name() {
            write!(f, "\n              {} slots for each ({})", self.slots, self.depth)?;
        }
        Ok(())
    }
}
