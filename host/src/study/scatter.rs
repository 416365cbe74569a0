//! Time against error on logarithmic axes.

use super::Point;
use super::findings::frontier;
use crate::html::{escaped, number};
use std::fmt::Write;

const SIZE: [f64; 2] = [560.0, 360.0];
const LEFT: f64 = 64.0;
const BOTTOM: f64 = 44.0;
const TOP: f64 = 12.0;
const RIGHT: f64 = 16.0;

/// A logarithmic axis over whole powers of ten.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let logs: Vec<f64> =
            values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10).collect();
        let low = logs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low > high {
            return Self { low: 0.0, high: 1.0, from, to };
        }
        Self { low: low.floor(), high: high.ceil().max(low.floor() + 1.0), from, to }
    }

    /// Where a value is; what has no logarithm lies at the low end.
    fn at(&self, value: f64) -> f64 {
        let log = if value > 0.0 { value.log10() } else { self.low };
        self.from + ((log - self.low) / (self.high - self.low)).clamp(0.0, 1.0) * (self.to - self.from)
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        (self.low as i32..=self.high as i32).map(|power| 10.0_f64.powi(power))
    }
}

/// A plot of `points`; those that no other one beats are filled and joined. A pointer over one shows its settings.
pub fn svg(title: &str, what: &str, points: &[&Point], error: impl Fn(&Point) -> f64 + Copy) -> String {
    let x = Axis::new(points.iter().map(|point| point.milliseconds), LEFT, SIZE[0] - RIGHT);
    // Room below the smallest error for points without any.
    let exact = points.iter().any(|point| error(point) == 0.0);
    let floor =
        points.iter().map(|point| error(point)).filter(|error| *error > 0.0).fold(f64::INFINITY, f64::min);
    let below = exact.then_some(floor / 10.0);
    let y = Axis::new(points.iter().map(|point| error(point)).chain(below), SIZE[1] - BOTTOM, TOP);
    let best = frontier(points, error);
    let mut body = frame(&x, &y, exact);
    let line: Vec<_> =
        best.iter().map(|p| format!("{:.1},{:.1}", x.at(p.milliseconds), y.at(error(p)))).collect();
    let _ = writeln!(body, "<polyline class=\"frontier\" points=\"{}\"/>", line.join(" "));
    for point in points {
        let class = if best.iter().any(|other| std::ptr::eq(*other, *point)) { "best" } else { "other" };
        let _ = writeln!(
            body,
            "<circle class=\"{class}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"5\"><title>{}: {} ms, {what} {}</title></circle>",
            x.at(point.milliseconds),
            y.at(error(point)),
            escaped(&point.settings),
            number(point.milliseconds),
            number(error(point))
        );
    }
    let [width, height] = SIZE;
    let middle = [(LEFT + width - RIGHT) / 2.0, (TOP + height - BOTTOM) / 2.0];
    let _ = writeln!(
        body,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">milliseconds, both views</text>\n<text transform=\"translate(14 {}) \
         rotate(-90)\" text-anchor=\"middle\">{}</text>",
        middle[0],
        height - 8.0,
        middle[1],
        escaped(what)
    );
    let title = escaped(title);
    format!(
        "<figure><figcaption>{title}</figcaption>\n<svg viewBox=\"0 0 {width} {height}\" role=\"img\" \
         aria-label=\"{title}\">\n{body}</svg></figure>\n"
    )
}

fn frame(x: &Axis, y: &Axis, exact: bool) -> String {
    let mut svg = String::new();
    for (number_of_tick, value) in y.ticks().enumerate() {
        let text = if exact && number_of_tick == 0 { "none".into() } else { number(value) };
        let _ = writeln!(
            svg,
            "<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{2:.1}\" y2=\"{2:.1}\"/>\
             <text x=\"{3}\" y=\"{4:.1}\" text-anchor=\"end\">{text}</text>",
            x.from,
            x.to,
            y.at(value),
            x.from - 6.0,
            y.at(value) + 4.0
        );
    }
    for value in x.ticks() {
        let _ = writeln!(
            svg,
            "<line class=\"grid\" x1=\"{0:.1}\" x2=\"{0:.1}\" y1=\"{1}\" y2=\"{2}\"/>\
             <text x=\"{0:.1}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
            x.at(value),
            y.from,
            y.to,
            y.from + 16.0,
            number(value)
        );
    }
    svg
}
