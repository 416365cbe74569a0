//! A study as one HTML file.

use super::findings::{ranking, sentence};
use super::{Case, KNOBS, Knob, Measured, StrictPrice, scatter};
use crate::html::{STYLE, escaped, half_spread, number};
use base64::prelude::{BASE64_STANDARD, Engine};
use image::ImageEncoder;

/// The page without its content.
const PAGE: &str = include_str!("page.html");

/// A page that needs nothing but itself, on each scene on each of the `backends`.
pub fn page(backends: &[String], cases: &[Case]) -> String {
    let sentences: String = cases
        .iter()
        .filter_map(|case| sentence(&case.points()))
        .map(|sentence| format!("<li>{}</li>\n", escaped(&sentence)))
        .collect();
    let prices: String = cases.iter().filter_map(|case| case.strict.as_ref()).map(price_row).collect();
    let knobs: String = KNOBS.iter().map(knob_row).collect();
    let sections: String = cases.iter().map(section).collect();
    PAGE.replace("{{style}}", STYLE)
        .replace("{{backends}}", &escaped(&backends.join("; ")))
        .replace("{{sentences}}", &sentences)
        .replace("{{prices}}", &prices)
        .replace("{{knobs}}", &knobs)
        .replace("{{sections}}", &sections)
}

/// What strict arithmetic costs for a scene on a backend.
fn price_row(price: &StrictPrice) -> String {
    let fast = match price.fast_ms {
        Some(fast) => [
            format!("{}<small>{}</small>", number(fast), half_spread(price.fast_spread)),
            format!("{:+.1} %", price.price_percent),
        ],
        None => ["the same code".into(), "0, by construction".into()],
    };
    let [fast, cost] = fast;
    let strict = format!("{}<small>{}</small>", number(price.strict_ms), half_spread(price.strict_spread));
    let (differing, flip) = (number(price.differing_percent), format!("{:.4}", price.flip));
    let cells = [strict, fast, cost, differing, flip].map(|cell| format!("<td class=\"number\">{cell}</td>"));
    let (scene, backend) = (escaped(&price.scene), escaped(&price.backend));
    format!("<tr><td>{scene}</td><td>{backend}</td>{}</tr>\n", cells.concat())
}

fn knob_row(knob: &Knob) -> String {
    let values: Vec<_> = knob.values.iter().map(|value| value.name).collect();
    format!(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        knob.name,
        knob.family,
        values.join(", "),
        escaped(knob.about)
    )
}

/// The plots and the table of a scene on a backend.
fn section(case: &Case) -> String {
    let points = case.points();
    let Some(first) = points.first() else { return String::new() };
    let plots = [
        scatter::svg("Against the traced pair, one ray per pixel", "mean ꟻLIP", &points, |p| {
            p.to_traced.flip
        }),
        scatter::svg("Against many rays per pixel", "mean squared error", &points, |p| p.to_truth.view.mse),
    ];
    format!(
        "<section>\n<h2>{}</h2>\n<p class=\"machine\">{}</p>\n<div class=\"plots\">\n{}</div>\n{}</section>\n",
        escaped(&format!("{} {}×{}", first.scene, first.width, first.height)),
        escaped(&first.backend),
        plots.concat(),
        table(case)
    )
}

/// The points by their [`ranking`]; those that no other one beats are bold.
fn table(case: &Case) -> String {
    let Some(naive) = case.points.first().map(|measured| measured.point.milliseconds) else {
        return String::new();
    };
    let ranks = ranking(&case.points());
    let rows: String =
        ranks.into_iter().map(|(index, is_best)| row(&case.points[index], naive, is_best)).collect();
    let heads =
        ["gain", "ms", "of naive", "Mrays", "MB", "ꟻLIP", "visible %", "MSE", "differ %", "MSE to truth"]
            .map(|head| format!("<th class=\"number\">{head}</th>"));
    format!(
        "<div class=\"table\"><table>\n<tr><th>settings</th>{}</tr>\n{rows}</table></div>\n",
        heads.concat()
    )
}

/// A point: its settings with the picture of its errors, and its figures.
fn row(Measured { point, flip }: &Measured, naive: f64, is_best: bool) -> String {
    let errors = match point.to_traced.flip > 0.0 {
        true => map(flip, point.width, point.height).map_or(String::new(), |uri| {
            format!(
                "<details><summary>errors</summary><img alt=\"ꟻLIP of each pixel\" src=\"{uri}\"></details>"
            )
        }),
        false => String::new(),
    };
    let figures = [
        format!("{:.2}", point.gain),
        format!("{}<small>{}</small>", number(point.milliseconds), half_spread(point.spread)),
        format!("{:.0} %", 100.0 * point.milliseconds / naive),
        number(point.rays.all() as f64 / 1e6),
        number(point.peak_bytes as f64 / 1e6),
        format!("{:.4}", point.to_traced.flip),
        number(point.to_traced.flip_visible_percent),
        number(point.to_traced.view.mse),
        number(point.to_traced.view.differing_percent),
        number(point.to_truth.view.mse),
    ];
    let cells = figures.map(|figure| format!("<td class=\"number\">{figure}</td>"));
    let class = if is_best { " class=\"best\"" } else { "" };
    format!("<tr{class}><td>{}{errors}</td>{}</tr>\n", escaped(&point.settings), cells.concat())
}

/// A picture of errors as a data URI: black where there is none, through red and yellow to white.
fn map(flip: &[f64], width: u32, height: u32) -> Option<String> {
    let pixels: Vec<u8> = flip
        .iter()
        .flat_map(|value| [0.0, 1.0, 2.0].map(|third| (255.0 * (3.0 * value - third).clamp(0.0, 1.0)) as u8))
        .collect();
    let mut png = Vec::new();
    image::codecs::png::PngEncoder::new(&mut png)
        .write_image(&pixels, width, height, image::ExtendedColorType::Rgb8)
        .ok()?;
    Some(format!("data:image/png;base64,{}", BASE64_STANDARD.encode(&png)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::backend::{Choice, Selection};
    use crate::render::Overrides;
    use crate::study::{Machine, Point, Study, study};

    #[test]
    fn a_study_becomes_a_page_that_needs_nothing_else() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/cornell.toml");
        let mut scene = crate::scene::load(path.as_ref()).unwrap();
        Overrides { size: Some([24, 16]), ..Overrides::default() }.apply(&mut scene).unwrap();
        let knobs: Vec<_> = KNOBS.iter().filter(|knob| ["method", "bvh"].contains(&knob.name)).collect();
        let case = Study { name: "a < b".into(), scene: &scene, knobs: &knobs, repetitions: 1 };
        let one_thread = Selection { backend: Choice::Cpu, threads: 1, ..Selection::default() };
        let mut machine = Machine::open(&one_thread).unwrap();
        let (mut last, mut total) = (0, 0);
        let case = study(&case, &mut machine, &mut |done, of| (last, total) = (done, of)).unwrap();
        let points = case.points();
        assert_eq!((points.len(), last), (20, total), "ten methods, two structures");
        for point in &points {
            let copies = point.settings.contains("ideal");
            assert!(point.milliseconds > 0.0 && point.rays.all() > 0 && point.scene_bytes > 0);
            assert!(point.peak_bytes > point.scene_bytes, "buffers of pixels come on top of the scene");
            assert!(!copies || point.to_traced.flip > 0.0, "{}", point.settings);
            let exact = ["method=naive", "method=guided", "bvh=quick"].contains(&&point.settings[..]);
            assert!(!exact || point.to_traced.view.mse == 0.0, "{}", point.settings);
        }
        let page = page(&["one core & a fan".into(), "a card".into()], std::slice::from_ref(&case));
        for outside in ["http:", "https:", "@import", "url(", "<script", "{{", "}}"] {
            assert!(!page.contains(outside), "{outside}");
        }
        assert_eq!(page.matches("<circle").count(), 2 * points.len());
        assert_eq!(page.matches("<td class=\"number\">").count(), 10 * points.len() + 5);
        let first = ranking(&points)[0].0;
        let place = |point: &Point| page.find(&format!("<td>{}<", point.settings)).unwrap();
        assert!(points.iter().all(|point| place(point) >= place(points[first])), "the best one comes first");
        assert!(page.contains("a &lt; b") && page.contains("one core &amp; a fan; a card"));
        assert!(page.contains("0, by construction"), "what strict arithmetic costs on a CPU");
        assert!(page.contains("src=\"data:image/png;base64,"), "errors of the copied view");
    }
}
