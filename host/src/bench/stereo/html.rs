//! The measurements as one HTML file: plots, tables, and what the papers print beside them.

use super::paper::{COST, MSE};
use super::plot::{Plot, Point, Series};
use super::{Measured, Part, summary};
use crate::bench::BenchLine;
use crate::html::{STYLE, escaped, half_spread, number};
use crate::render::Method;
use std::fmt::Write;

/// The page without its content.
const PAGE: &str = include_str!("page.html");

/// A page that needs nothing but itself. `machine` says where it was measured.
pub fn page(machine: &str, measured: &[Measured]) -> String {
    let mut parts: Vec<Part> = Vec::new();
    for part in measured.iter().map(|measured| measured.part) {
        if !parts.contains(&part) {
            parts.push(part);
        }
    }
    let of = |part| measured.iter().filter(|m| m.part == part).collect::<Vec<_>>();
    let sections: String = parts.into_iter().map(|part| section(part, &of(part))).collect();
    PAGE.replace("{{style}}", STYLE)
        .replace("{{machine}}", &escaped(machine))
        .replace("{{sections}}", &sections)
}

fn section(part: Part, measured: &[&Measured]) -> String {
    let plots: String = plots(part, measured).iter().map(Plot::svg).collect();
    let plots = if plots.is_empty() { plots } else { format!("<div class=\"plots\">\n{plots}</div>\n") };
    let lines = measured.iter().flat_map(|measured| &measured.lines);
    let numbers = format!("<details><summary>All numbers</summary>\n{}</details>\n", table(lines));
    let summary = if plots.is_empty() { summary::table(measured) } else { String::new() };
    format!(
        "<section>\n<h2>{}</h2>\n<p>{}</p>\n{plots}{summary}{numbers}</section>\n",
        escaped(&part.name()),
        part.about()
    )
}

/// A plot for each scene.
fn plots(part: Part, measured: &[&Measured]) -> Vec<Plot> {
    let mut plots: Vec<Plot> = Vec::new();
    let (metric, y) =
        if part.is_error() { (MSE, "mean squared error") } else { (COST, "% of the first view") };
    for measured in measured {
        let Some((axis, x)) = part.axis(&measured.setting) else { continue };
        let title = measured.setting.scene;
        if !plots.iter().any(|plot| plot.title == title) {
            plots.push(Plot { title: title.into(), x: axis.into(), y: y.into(), series: vec![] });
        }
        let Some(plot) = plots.iter_mut().find(|plot| plot.title == title) else { continue };
        // The copy's error is so large that the others would lie on the axis; its numbers are in the table.
        let drawn = |line: &&BenchLine| {
            line.metric == metric && (metric == COST || line.method != Method::Ideal.name())
        };
        for line in measured.lines.iter().filter(drawn) {
            add(plot, line, x, measured.printed(line));
        }
    }
    plots
}

fn add(plot: &mut Plot, line: &BenchLine, x: f64, printed: Option<[f64; 2]>) {
    let point = Point { x, y: line.value, spread: line.spread };
    match plot.series.iter_mut().find(|series| series.name == line.method) {
        Some(series) => series.points.push(point),
        None => plot.series.push(Series { name: line.method.clone(), points: vec![point], printed }),
    }
}

/// Each case is a heading over its lines, not a column: on a narrow screen it would leave no room for the values.
fn table<'a>(lines: impl Iterator<Item = &'a BenchLine>) -> String {
    let (mut rows, mut last) = (String::new(), None);
    for line in lines {
        let BenchLine { case, method, metric, value, unit, spread, reference, .. } = line;
        let spread = half_spread(*spread);
        if last != Some(case) {
            let _ = writeln!(rows, "<tr><th class=\"case\" colspan=\"6\">{}</th></tr>", escaped(case));
            last = Some(case);
        }
        let _ = writeln!(
            rows,
            "<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td>{unit}</td><td>{spread}</td><td>{}</td></tr>",
            escaped(method),
            escaped(metric),
            number(*value),
            escaped(reference.as_deref().unwrap_or(""))
        );
    }
    format!(
        "<div class=\"table\"><table>\n<tr><th>method</th><th>what</th><th>value</th><th></th><th></th><th>paper</th></tr>\n\
         {rows}</table></div>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::stereo::refer;

    /// Made-up measurements of a part, with a value that grows from line to line.
    fn made_up(part: Part) -> Vec<Measured> {
        let lines = |setting: &super::super::Setting| {
            let metric = if part.is_error() { MSE } else { COST };
            part.methods(setting)
                .iter()
                .enumerate()
                .map(|(i, options)| {
                    let line = BenchLine {
                        bench: "stereo",
                        case: setting.label(),
                        backend: "CPU".into(),
                        method: super::super::label(options),
                        metric: metric.into(),
                        value: 10.0 + i as f64,
                        unit: "%",
                        spread: 0.5,
                        reference: None,
                        reference_value: None,
                    };
                    refer(part, setting, options, line)
                })
                .collect()
        };
        let settings = part.settings(true).into_iter();
        settings.map(|setting| Measured { part, lines: lines(&setting), setting }).collect()
    }

    #[test]
    fn every_line_is_in_a_table_and_every_axis_has_plots() {
        let (mut measured, mut lines, mut curves) = (Vec::new(), 0, 0);
        for part in [Part::Target, Part::Dimensions, Part::ErrorInteraxial, Part::Table1] {
            measured.extend(made_up(part));
        }
        for measured in &measured {
            lines += measured.lines.len();
        }
        for part in [Part::Dimensions, Part::ErrorInteraxial] {
            let scenes = if part == Part::Dimensions { 3 } else { 1 };
            let methods = part.methods(&part.settings(true)[0]).len();
            curves += scenes * if part.is_error() { methods - 1 } else { methods };
        }
        let page = page("two cores & a fan", &measured);
        assert_eq!(page.matches("<tr><td>").count(), lines);
        assert_eq!(page.matches("class=\"case\"").count(), measured.len(), "a heading over each case");
        assert_eq!(page.matches("<polyline").count(), curves);
        assert_eq!(page.matches("<h2>").count(), 4);
        let tables = [Part::Target, Part::Table1].map(|part| part.settings(true).len());
        assert_eq!(page.matches("<tr class=\"setting\">").count(), tables.iter().sum::<usize>());
        assert!(page.contains("<small>our aim: at most 7</small>"));
        assert!(page.contains("two cores &amp; a fan") && page.contains("000 fig. 37: lost in print"));
        assert!(page.contains("000 figs 27, 35: 19.76 to 75.44"));
    }

    #[test]
    fn the_page_needs_nothing_else() {
        let page = page("here", &made_up(Part::Interaxial));
        for outside in ["http:", "https:", "src=", "@import", "url(", "<script", "{{", "}}"] {
            assert!(!page.contains(outside), "{outside}");
        }
        assert!(page.contains("name=\"viewport\"") && page.contains("overflow-x: auto"));
    }

    #[test]
    fn a_paper_s_range_is_drawn_with_the_method_it_is_of() {
        let plots = plots(Part::Interaxial, &made_up(Part::Interaxial).iter().collect::<Vec<_>>());
        assert_eq!(plots.len(), 1);
        let of = |method: Method| plots[0].series.iter().find(|s| s.name == method.name()).unwrap();
        assert!(of(Method::Atomic).printed.is_some_and(|[low, high]| low < 20.0 && high > 75.0));
        assert_eq!(of(Method::Naive).printed, None);
        assert_eq!(of(Method::Atomic).points.len(), 2);
    }
}
