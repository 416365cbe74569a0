//! `parallax bench stereo`: what the second view of a pair costs by each method, of what that is made up, and how far it is from the
//! truth, beside what the papers print.

mod html;
mod measure;
mod paper;
mod parts;
mod plot;
mod setting;
mod summary;

pub use html::page;
pub use measure::{Case, label, stereo};
pub use parts::Part;
pub use setting::{Materials, Setting};

use super::BenchLine;
use crate::render::StereoOptions;
use paper::{COST, M, MSE, Printed, SAVED};

/// The metrics that are told first.
pub const HEADLINES: [&str; 6] = [COST, SAVED, M, MSE, WRONG_DEPTH, RAYS_SAVED];
/// Share of pixels whose depth is wrong by more than rounding to pixels.
const WRONG_DEPTH: &str = "wrong depth";
/// Share of all rays of a second view that are saved.
const RAYS_SAVED: &str = "rays saved";

/// A setting of a part and what it has shown.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Of which part.
    pub part: Part,
    /// What was measured.
    pub setting: Setting,
    /// The figures.
    pub lines: Vec<BenchLine>,
}

impl Measured {
    /// Puts what the papers print beside the lines of a setting.
    pub fn new(part: Part, setting: Setting, lines: Vec<BenchLine>) -> Self {
        let methods = part.methods(&setting);
        let with_reference = |line: BenchLine| {
            let options = methods.iter().find(|options| label(options) == line.method);
            match options {
                Some(options) => refer(part, &setting, options, line),
                None => line,
            }
        };
        let lines = lines.into_iter().map(with_reference).collect();
        Self { part, lines, setting }
    }

    /// The lowest and highest value that a paper prints for a line.
    fn printed(&self, line: &BenchLine) -> Option<[f64; 2]> {
        let methods = self.part.methods(&self.setting);
        let options = methods.iter().find(|options| label(options) == line.method)?;
        match paper::figure(self.part, &self.setting, options, &line.metric)?.printed {
            Printed::Value(value) => Some([value, value]),
            Printed::Range(low, high) => Some([low, high]),
            Printed::AtLeast(_) | Printed::AtMost(_) | Printed::Lost => None,
        }
    }
}

/// The lines of several frames as one: means of values, and the largest spread. Every frame has the same lines but for stages that one
/// of them did not need.
pub fn mean(frames: &[Vec<BenchLine>]) -> Vec<BenchLine> {
    let Some((first, _)) = frames.split_first() else { return vec![] };
    let same =
        |line: &BenchLine, other: &BenchLine| line.method == other.method && line.metric == other.metric;
    let mean = |line: &BenchLine| {
        let all: Vec<_> =
            frames.iter().filter_map(|lines| lines.iter().find(|other| same(line, other))).collect();
        let value = all.iter().map(|line| line.value).sum::<f64>() / all.len().max(1) as f64;
        let spread = all.iter().map(|line| line.spread).fold(0.0, f64::max);
        BenchLine { value, spread, ..line.clone() }
    };
    first.iter().map(mean).collect()
}

/// The line with what a paper says of it.
fn refer(part: Part, setting: &Setting, options: &StereoOptions, line: BenchLine) -> BenchLine {
    let figure = paper::figure(part, setting, options, &line.metric);
    BenchLine {
        case: format!("{}: {}", part.name(), line.case),
        reference: figure.map(|figure| figure.to_string()),
        reference_value: figure.and_then(|figure| figure.value()),
        ..line
    }
}
