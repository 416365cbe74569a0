//! What the papers print, as data. Where print has lost a table or a plot, that is what stands here.

use super::parts::Part;
use super::setting::{Materials, Setting};
use crate::render::{Method, Samples, StereoOptions};
use std::fmt;

/// Cost of the second view beside the first.
pub const COST: &str = "second view / mono";
/// Share of a traced second view's time that is saved.
pub const SAVED: &str = "time saved";
/// 001's M: the share of the second view's pixels that are traced.
pub const M: &str = "traced pixels";
/// Mean squared error of 000 §4.5.2.
pub const MSE: &str = "mse";
/// Share of the pixels whose colour differs from the traced one.
pub const DIFFERING: &str = "pixels that differ";
/// Mean distance of those colours in units of 8-bit sRGB.
pub const DISTANCE: &str = "their distance";

/// What a paper says of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Printed {
    /// So much.
    Value(f64),
    /// Between these, over scenes or machines.
    Range(f64, f64),
    /// So much or more.
    AtLeast(f64),
    /// So much or less.
    AtMost(f64),
    /// The paper has a plot or table of it that the print we have has lost.
    Lost,
}

/// A figure and where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Paper and table, figure or section.
    pub source: &'static str,
    /// What is there.
    pub printed: Printed,
}

impl Figure {
    /// The one number to hold ours against: of a range its lower end.
    pub fn value(&self) -> Option<f64> {
        match self.printed {
            Printed::Value(value) | Printed::Range(value, _) => Some(value),
            Printed::AtLeast(value) | Printed::AtMost(value) => Some(value),
            Printed::Lost => None,
        }
    }
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { source, printed } = self;
        match printed {
            Printed::Value(value) => write!(f, "{source}: {}", short(*value)),
            Printed::Range(low, high) => write!(f, "{source}: {} to {}", short(*low), short(*high)),
            Printed::AtLeast(value) => write!(f, "{source}: at least {}", short(*value)),
            Printed::AtMost(value) => write!(f, "{source}: at most {}", short(*value)),
            Printed::Lost => write!(f, "{source}: lost in print"),
        }
    }
}

/// Two decimals at most.
fn short(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

/// What a paper (or, for [`Part::Target`], our own aim) says of a metric of a method in a setting.
pub fn figure(part: Part, setting: &Setting, options: &StereoOptions, metric: &str) -> Option<Figure> {
    match part {
        Part::Target => target(setting, options, metric),
        Part::Dimensions | Part::Interaxial | Part::Lights => speedup(options, metric),
        Part::ErrorDimensions if metric == MSE => lost("000 fig. 36", options),
        Part::ErrorInteraxial if metric == MSE => lost("000 fig. 37", options),
        Part::ErrorDimensions | Part::ErrorInteraxial => None,
        Part::Single => single(options, metric),
        Part::Table1 => table_1(setting.materials, options, metric),
        Part::Nine => nine(options, metric),
        Part::Table2 => table_2(setting, options, metric),
        Part::Table3 => table_3(setting, options, metric),
        Part::Gather => gather(setting, options, metric),
    }
}

/// What issue 4 of this project asks for.
fn target(setting: &Setting, options: &StereoOptions, metric: &str) -> Option<Figure> {
    let ours = options.method == Method::Atomic && options.verify.is_some() && metric == COST;
    let most = if setting.interaxial_px > 15.0 { 11.0 } else { 7.0 };
    ours.then_some(Figure { source: "our aim", printed: Printed::AtMost(most) })
}

/// Of 000's plots 20 to 34 only the averages of figures 27 and 35 survive, as speedups of a pair over two traced views, in ranges
/// over the scenes, on two machines. A pair that is faster by s has a second view that costs 2 / (1 + s) − 1 of the first.
const SPEEDUPS: [(Method, [[f64; 2]; 2]); 3] = [
    (Method::Ideal, [[0.29, 0.65], [0.71, 0.92]]),
    (Method::Atomic, [[0.14, 0.47], [0.32, 0.67]]),
    (Method::Buffer, [[0.06, 0.40], [0.16, 0.58]]),
];

fn cost_of_speedup(speedup: f64) -> f64 {
    100.0 * (2.0 / (1.0 + speedup) - 1.0)
}

fn speedup(options: &StereoOptions, metric: &str) -> Option<Figure> {
    let source = "000 figs 27, 35";
    if metric != COST || options.verify.is_some() {
        return None;
    }
    if options.method == Method::EsIsler {
        // "Underperforming the baseline" on both machines.
        return Some(Figure { source, printed: Printed::AtLeast(100.0) });
    }
    let (_, machines) = SPEEDUPS.iter().find(|(method, _)| *method == options.method)?;
    let all = machines.as_flattened().iter().map(|speedup| cost_of_speedup(*speedup));
    let (low, high) = all.fold((f64::INFINITY, 0.0), |(low, high), cost| (cost.min(low), cost.max(high)));
    Some(Figure { source, printed: Printed::Range(low, high) })
}

/// 000 compares its atomic method with two traced views; the plots' values are lost.
fn lost(source: &'static str, options: &StereoOptions) -> Option<Figure> {
    let atomic = options.method == Method::Atomic && options.verify.is_none();
    atomic.then_some(Figure { source, printed: Printed::Lost })
}

/// 001's thirty pictures of 20 ellipsoids, on average.
fn single(options: &StereoOptions, metric: &str) -> Option<Figure> {
    let value = match metric {
        M => 7.07,
        SAVED => 84.0,
        DIFFERING => 14.6,
        DISTANCE => 2.64,
        _ => return None,
    };
    by_scanline(options, "001, one ray per pixel", Printed::Value(value))
}

fn table_1(materials: Materials, options: &StereoOptions, metric: &str) -> Option<Figure> {
    let value = match materials {
        _ if metric != SAVED => return None,
        Materials::Opaque => 94.6,
        Materials::Mirrors => 89.0,
        Materials::Glass => 80.0,
        Materials::Own => 72.0,
        Materials::Matt | Materials::Es => return None,
    };
    by_scanline(options, "001 table 1", Printed::Value(value))
}

/// The same thirty pictures with nine rays.
fn nine(options: &StereoOptions, metric: &str) -> Option<Figure> {
    let value = match metric {
        M => 7.84,
        SAVED => 80.0,
        DIFFERING => 15.6,
        DISTANCE => 3.18,
        _ => return None,
    };
    by_scanline(options, "001, nine rays per pixel", Printed::Value(value))
}

/// The table itself is lost; what the text says of the savings of its adaptive samplers, and of M.
fn table_3(setting: &Setting, options: &StereoOptions, metric: &str) -> Option<Figure> {
    let deepest = matches!(setting.samples, Samples::Adaptive { levels: 3, .. });
    let printed = match metric {
        SAVED if deepest => Printed::Value(66.0),
        SAVED => Printed::AtLeast(50.0),
        M if deepest => Printed::Value(33.8),
        M => Printed::AtMost(30.0),
        _ => return None,
    };
    by_scanline(options, "001 table 3 (lost in print), its text", printed)
}

/// The table itself is lost; its smallest figure stands in the text, which speaks of one ray per pixel.
fn table_2(setting: &Setting, options: &StereoOptions, metric: &str) -> Option<Figure> {
    let one_ray = metric == SAVED && setting.samples == Samples::One;
    let at_least = one_ray.then_some(Printed::AtLeast(68.0))?;
    by_scanline(options, "001 table 2 (lost in print), its text", at_least)
}

fn by_scanline(options: &StereoOptions, source: &'static str, printed: Printed) -> Option<Figure> {
    (options.method == Method::Scanline).then_some(Figure { source, printed })
}

/// 003, table 5.1: columns and rows of the picture, levels, and ms of one view, and of both by a gather table made on the CPU, in one
/// pass and in two passes. (Table 5.2, the times of the tables alone, contradicts the text that goes with it: 15.5 ms and 5.1 ms at
/// 1024 × 768 look swapped. It is not used.)
const GATHER: [([u32; 2], u32, [f64; 4]); 6] = [
    ([1024, 768], 0, [147.0, 250.0, 175.0, 186.0]),
    ([1024, 768], 2, [194.0, 345.0, 271.0, 282.0]),
    ([800, 600], 0, [91.0, 154.0, 109.0, 108.0]),
    ([800, 600], 2, [120.0, 216.0, 172.0, 171.0]),
    ([640, 480], 0, [58.0, 99.0, 70.0, 70.0]),
    ([640, 480], 2, [79.0, 145.0, 116.0, 115.0]),
];

fn gather(setting: &Setting, options: &StereoOptions, metric: &str) -> Option<Figure> {
    let column = match options.method {
        _ if metric != COST || options.verify.is_some() => return None,
        Method::Scanline => 1,
        Method::Gather1 => 2,
        Method::Gather2 => 3,
        _ => return None,
    };
    let levels = setting.levels?;
    let (.., times) = GATHER.iter().find(|(size, of, _)| *size == setting.size && *of == levels)?;
    let cost = 100.0 * (times[column] - times[0]) / times[0];
    Some(Figure { source: "003 table 5.1", printed: Printed::Value(cost) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Verify;

    fn text(part: Part, setting: &Setting, method: Method, metric: &str) -> Option<String> {
        figure(part, setting, &method.into(), metric).map(|figure| figure.to_string())
    }

    fn settings(part: Part) -> Vec<Setting> {
        part.settings(false)
    }

    #[test]
    fn speedups_become_costs_of_the_second_view() {
        assert_eq!(cost_of_speedup(0.0), 100.0);
        assert_eq!(cost_of_speedup(1.0), 0.0);
        let setting = &settings(Part::Interaxial)[0];
        let told = |method| text(Part::Interaxial, setting, method, COST).unwrap();
        assert_eq!(told(Method::Atomic), "000 figs 27, 35: 19.76 to 75.44");
        assert_eq!(told(Method::Ideal), "000 figs 27, 35: 4.17 to 55.04");
        assert_eq!(told(Method::EsIsler), "000 figs 27, 35: at least 100");
        assert_eq!(text(Part::Interaxial, setting, Method::Gather1, COST), None);
        let edges = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        assert_eq!(figure(Part::Interaxial, setting, &edges, COST), None, "000 verifies all");
    }

    #[test]
    fn several_rays_have_their_own_figures() {
        let told =
            |part: Part, number: usize, metric| text(part, &settings(part)[number], Method::Scanline, metric);
        assert_eq!(told(Part::Nine, 0, M).unwrap(), "001, nine rays per pixel: 7.84");
        assert!(told(Part::Table2, 0, SAVED).is_some() && told(Part::Table2, 1, SAVED).is_none());
        let deepest = settings(Part::Table3).len() - 1;
        assert!(told(Part::Table3, 0, M).unwrap().ends_with("at most 30"));
        assert!(told(Part::Table3, deepest, M).unwrap().ends_with(": 33.8"));
    }

    #[test]
    fn what_is_lost_is_said_to_be_lost() {
        let setting = &settings(Part::ErrorDimensions)[0];
        let figure = figure(Part::ErrorDimensions, setting, &Method::Atomic.into(), MSE).unwrap();
        assert_eq!((figure.to_string().as_str(), figure.value()), ("000 fig. 36: lost in print", None));
    }

    #[test]
    fn every_setting_of_the_tables_finds_its_figure() {
        let table_1 = settings(Part::Table1);
        let printed: Vec<_> =
            table_1.iter().map(|s| text(Part::Table1, s, Method::Scanline, SAVED).unwrap()).collect();
        assert_eq!(printed, ["001 table 1: 94.6", "001 table 1: 89", "001 table 1: 80", "001 table 1: 72"]);
        let gather = settings(Part::Gather);
        assert_eq!(gather.len(), GATHER.len());
        for setting in &gather {
            assert!(text(Part::Gather, setting, Method::Gather1, COST).is_some(), "{setting:?}");
        }
        // (175 − 147) / 147.
        let told = text(Part::Gather, &gather[0], Method::Gather1, COST);
        assert_eq!(told.unwrap(), "003 table 5.1: 19.05");
    }

    #[test]
    fn our_aim_depends_on_the_distance_of_the_eyes() {
        let edges = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        let aims: Vec<_> = settings(Part::Target)
            .iter()
            .map(|setting| figure(Part::Target, setting, &edges, COST).unwrap().value().unwrap())
            .collect();
        assert_eq!(aims.iter().filter(|aim| **aim == 7.0).count(), 5);
        assert_eq!(aims.iter().filter(|aim| **aim == 11.0).count(), 5);
    }
}
