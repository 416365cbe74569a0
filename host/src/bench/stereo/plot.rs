//! Line plots as SVG, drawn without anybody's help: nothing is fetched when the page is looked at.

use crate::html::{escaped, number};
use std::fmt::Write;

/// Size of the picture in SVG units.
const SIZE: [f64; 2] = [560.0, 320.0];
/// What is left of, above, right of and below the axes.
const MARGINS: [f64; 4] = [56.0, 12.0, 12.0, 44.0];
/// Colours of the series, told apart by most eyes (Okabe and Ito 2008); when they are used up they come again with dashed lines and
/// hollow markers.
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"];

/// A point of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Where.
    pub x: f64,
    /// How much: the median.
    pub y: f64,
    /// Distance of the quartiles.
    pub spread: f64,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// For the legend.
    pub name: String,
    /// In the order of x.
    pub points: Vec<Point>,
    /// The lowest and highest value that a paper prints of it.
    pub printed: Option<[f64; 2]>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Style {
    colour: &'static str,
    is_hollow: bool,
}

impl Style {
    /// Styles, one for each series in turn.
    fn all() -> impl Iterator<Item = Self> {
        let with = |is_hollow| COLOURS.into_iter().map(move |colour| Self { colour, is_hollow });
        with(false).chain(with(true)).cycle()
    }

    fn line(self) -> &'static str {
        if self.is_hollow { " stroke-dasharray=\"7 5\"" } else { "" }
    }

    fn marker(self) -> String {
        let fill = if self.is_hollow { "#fff" } else { self.colour };
        format!("fill=\"{fill}\" stroke=\"{}\"", self.colour)
    }
}

/// A plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Above it.
    pub title: String,
    /// Below the axis.
    pub x: String,
    /// Beside the axis.
    pub y: String,
    /// What is drawn.
    pub series: Vec<Series>,
}

/// A linear axis from one round number to another.
struct Axis {
    low: f64,
    high: f64,
    step: f64,
    from: f64,
    to: f64,
}

impl Axis {
    /// An axis for `values` drawn between `from` and `to`.
    fn new(values: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.filter(|value| value.is_finite()) {
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        if low == high {
            high = low + low.abs().max(1.0);
        }
        let step = round_step((high - low) / 5.0);
        Self { low: (low / step).floor() * step, high: (high / step).ceil() * step, step, from, to }
    }

    fn at(&self, value: f64) -> f64 {
        let share = (value - self.low) / (self.high - self.low);
        self.from + share.clamp(0.0, 1.0) * (self.to - self.from)
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let count = ((self.high - self.low) / self.step).round() as u32;
        let (low, step) = (self.low, self.step);
        (0..=count).map(move |i| low + f64::from(i) * step)
    }
}

/// 1, 2 or 5 times a power of ten, at least `least`.
fn round_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power).into_iter().find(|step| *step >= least).unwrap_or(least)
}

impl Plot {
    /// The plot with its title and its legend; a paper's range is a pale band.
    pub fn svg(&self) -> String {
        let [left, top, right, bottom] = MARGINS;
        let points = || self.series.iter().flat_map(|series| &series.points);
        let printed = self.series.iter().filter_map(|series| series.printed).flatten();
        let x = Axis::new(points().map(|p| p.x), [left, SIZE[0] - right]);
        let heights = points().flat_map(|p| [p.y - p.spread / 2.0, p.y + p.spread / 2.0]);
        let y = Axis::new(heights.chain(printed).chain([0.0]), [SIZE[1] - bottom, top]);
        let mut svg = String::new();
        self.frame(&mut svg, &x, &y);
        for (series, style) in self.series.iter().zip(Style::all()) {
            series.draw(&mut svg, style, &x, &y);
        }
        let title = escaped(&self.title);
        let [width, height] = SIZE;
        format!(
            "<figure><figcaption>{title}</figcaption>\n<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">\n\
             {svg}</svg>\n<p class=\"legend\">{}</p></figure>\n",
            self.legend()
        )
    }

    fn frame(&self, svg: &mut String, x: &Axis, y: &Axis) {
        for value in y.ticks() {
            let (at, text) = (y.at(value), number(value));
            let _ = writeln!(
                svg,
                "<line class=\"grid\" x1=\"{}\" x2=\"{}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/><text x=\"{}\" y=\"{:.1}\" \
                 text-anchor=\"end\">{text}</text>",
                x.from,
                x.to,
                x.from - 6.0,
                at + 4.0
            );
        }
        for value in x.ticks() {
            let (at, text) = (x.at(value), number(value));
            let _ = writeln!(
                svg,
                "<text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{text}</text>",
                y.from + 18.0
            );
        }
        let middle = (x.from + x.to) / 2.0;
        let _ = writeln!(
            svg,
            "<text x=\"{middle}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n<text transform=\"translate(14 {}) rotate(-90)\" \
             text-anchor=\"middle\">{}</text>",
            SIZE[1] - 6.0,
            escaped(&self.x),
            (y.from + y.to) / 2.0,
            escaped(&self.y)
        );
    }

    fn legend(&self) -> String {
        let entry = |(series, style): (&Series, Style)| {
            let printed = match series.printed {
                Some([low, high]) if low < high => {
                    format!(" (pale band: paper, {} to {})", number(low), number(high))
                }
                Some([value, _]) => format!(" (dashed: paper, {})", number(value)),
                None => String::new(),
            };
            let Style { colour, is_hollow } = style;
            let inside = if is_hollow { "#fff" } else { colour };
            format!(
                "<span><i style=\"background:{inside};border-color:{colour}\"></i>{}{printed}</span>",
                escaped(&series.name)
            )
        };
        self.series.iter().zip(Style::all()).map(entry).collect::<Vec<_>>().join(" ")
    }
}

impl Series {
    fn draw(&self, svg: &mut String, style: Style, x: &Axis, y: &Axis) {
        let Style { colour, .. } = style;
        if let Some([low, high]) = self.printed {
            let (top, bottom) = (y.at(high), y.at(low));
            let _ = writeln!(
                svg,
                "<rect x=\"{}\" y=\"{top:.1}\" width=\"{}\" height=\"{:.1}\" fill=\"{colour}\" fill-opacity=\"0.08\" stroke=\"{colour}\" \
                 stroke-opacity=\"0.5\" stroke-dasharray=\"3 4\"/>",
                x.from,
                x.to - x.from,
                bottom - top
            );
        }
        let line: Vec<_> = self.points.iter().map(|p| format!("{:.1},{:.1}", x.at(p.x), y.at(p.y))).collect();
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"{}/>",
            line.join(" "),
            style.line()
        );
        for point in &self.points {
            let (at, half) = (x.at(point.x), point.spread / 2.0);
            let _ = writeln!(
                svg,
                "<line x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{:.1}\" y2=\"{:.1}\" stroke=\"{colour}\"/><circle cx=\"{at:.1}\" cy=\"{:.1}\" \
                 r=\"3\" {}><title>{}: {} at {}</title></circle>",
                y.at(point.y - half),
                y.at(point.y + half),
                y.at(point.y),
                style.marker(),
                escaped(&self.name),
                number(point.y),
                number(point.x)
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(values: &[f64]) -> Vec<f64> {
        Axis::new(values.iter().copied(), [0.0, 100.0]).ticks().collect()
    }

    #[test]
    fn axes_end_at_round_numbers() {
        assert_eq!(ticks(&[0.0, 97.0]), [0.0, 20.0, 40.0, 60.0, 80.0, 100.0]);
        assert_eq!(ticks(&[200.0, 1500.0]), [0.0, 500.0, 1000.0, 1500.0]);
        assert_eq!(ticks(&[f64::NAN, f64::INFINITY]).last(), Some(&1.0));
        assert_eq!(ticks(&[7.0]).first(), Some(&6.0));
    }

    #[test]
    fn values_stand_where_they_belong() {
        let axis = Axis::new([0.0, 100.0].into_iter(), [200.0, 0.0]);
        assert_eq!([0.0, 50.0, 100.0, 1e9, -5.0].map(|v| axis.at(v)), [200.0, 100.0, 0.0, 0.0, 200.0]);
    }

    #[test]
    fn no_two_series_look_alike() {
        let styles: Vec<_> = Style::all().take(2 * COLOURS.len()).collect();
        for (i, style) in styles.iter().enumerate() {
            assert!(!styles[..i].contains(style), "{style:?}");
        }
        assert_ne!(styles[0].line(), styles[COLOURS.len()].line());
        assert_ne!(styles[0].marker(), styles[COLOURS.len()].marker());
    }

    #[test]
    fn each_series_has_a_line_points_and_what_a_paper_prints() {
        let points = [1.0, 2.0, 3.0].map(|x| Point { x, y: 10.0 * x, spread: 1.0 }).to_vec();
        let series = |name: &str, printed| Series { name: name.into(), points: points.clone(), printed };
        let plot = Plot {
            title: "a < b".into(),
            x: "x".into(),
            y: "%".into(),
            series: vec![series("ours", None), series("theirs & co", Some([5.0, 12.0]))],
        };
        let svg = plot.svg();
        let count = |what: &str| svg.matches(what).count();
        assert_eq!((count("<polyline"), count("<circle"), count("<rect")), (2, 6, 1));
        assert!(svg.contains("a &lt; b") && svg.contains("theirs &amp; co (pale band: paper, 5 to 12)"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
