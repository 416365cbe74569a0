//! What matters most of a part's measurements: a row for each method, and a column for each headline.

use super::{HEADLINES, Measured};
use crate::bench::BenchLine;
use crate::html::{escaped, half_spread, number};
use std::fmt::Write;

/// The table; cells have what a paper says below our figure.
pub fn table(measured: &[&Measured]) -> String {
    let told = |metric: &&str| measured.iter().any(|m| m.lines.iter().any(|line| line.metric == **metric));
    let columns: Vec<&str> = HEADLINES.iter().copied().filter(|metric| told(metric)).collect();
    let heads: String = columns.iter().map(|column| format!("<th>{}</th>", escaped(column))).collect();
    let cases: String = measured.iter().map(|measured| case(measured, &columns)).collect();
    format!(
        "<div class=\"table\"><table class=\"summary\">\n<tr><th>method</th>{heads}</tr>\n{cases}</table></div>\n"
    )
}

/// A setting: its name, and its methods.
fn case(measured: &Measured, columns: &[&str]) -> String {
    let mut methods: Vec<&str> = Vec::new();
    for line in &measured.lines {
        if !methods.contains(&line.method.as_str()) {
            methods.push(&line.method);
        }
    }
    let mut rows = format!(
        "<tr class=\"setting\"><th colspan=\"{}\">{}</th></tr>\n",
        columns.len() + 1,
        escaped(&measured.setting.label())
    );
    for method in methods {
        let figure = |metric: &&str| {
            measured.lines.iter().find(|line| line.method == method && line.metric == **metric)
        };
        let cells: String = columns.iter().map(|metric| cell(figure(metric))).collect();
        let _ = writeln!(rows, "<tr><td class=\"method\">{}</td>{cells}</tr>", escaped(method));
    }
    rows
}

fn cell(line: Option<&BenchLine>) -> String {
    let Some(BenchLine { value, unit, spread, reference, .. }) = line else { return "<td></td>".into() };
    let paper =
        reference.as_ref().map_or(String::new(), |paper| format!("<small>{}</small>", escaped(paper)));
    format!("<td class=\"number\">{} {unit} {}{paper}</td>", number(*value), half_spread(*spread))
}
