//! What a study has found.

use super::Point;

/// How much two times must differ to be told apart: more than these machines' noise.
const NOISE: f64 = 0.03;

/// Whether a point is a bound and no pair: the method `ideal` copies the first view, which no error of colours tells from a view of its
/// own that is a little off.
fn is_bound(point: &Point) -> bool {
    point.settings.contains("method=ideal")
}

/// The points that no other one beats in both time and error, from the fastest on, without bounds.
pub fn frontier<'a>(points: &[&'a Point], error: impl Fn(&Point) -> f64) -> Vec<&'a Point> {
    let mut sorted: Vec<_> = points.iter().copied().filter(|point| !is_bound(point)).collect();
    sorted.sort_by(|a, b| a.milliseconds.total_cmp(&b.milliseconds).then(error(a).total_cmp(&error(b))));
    let mut best = f64::INFINITY;
    sorted.retain(|point| {
        let better = error(point) < best;
        best = best.min(error(point));
        better
    });
    sorted
}

/// How much more a point gives for its time than `base`, the traced pair: times and mean squared errors against the truth, multiplied,
/// of `base` over those of the point. 1 for `base`; 2 for half the error in the same time, and for the same error in half the time.
/// More rays that are thrown at random would stay at 1, as n times the rays take n times the time and leave an nth of the error; those
/// of a grid leave less. +∞ for a point without error, if `base` has one.
pub fn gain(point: &Point, base: &Point) -> f64 {
    let errors = base.to_truth.view.mse / point.to_truth.view.mse;
    let times = base.milliseconds / point.milliseconds;
    // Of two pictures without errors none is better.
    if errors.is_nan() { times } else { times * errors }
}

/// The indices of `points` as a table has them, and whether they are on the frontier of time and error against the truth: first those
/// that are, then the others, then bounds, all from the greatest gain on. Equal gains keep their order.
pub fn ranking(points: &[&Point]) -> Vec<(usize, bool)> {
    let best = frontier(points, |point| point.to_truth.view.mse);
    let is_best = |point: &Point| best.iter().any(|other| std::ptr::eq(*other, point));
    let mut ranks: Vec<_> = points.iter().map(|point| is_best(point)).enumerate().collect();
    let group = |&(index, is_best): &(usize, bool)| (!is_best, is_bound(points[index]));
    let gain = |rank: &(usize, bool)| points[rank.0].gain;
    ranks.sort_by(|a, b| group(a).cmp(&group(b)).then(gain(b).total_cmp(&gain(a))));
    ranks
}

/// Whether a point takes less time by more than noise and spread explain.
fn is_faster(point: &Point, naive: &Point) -> bool {
    let margin = (NOISE * naive.milliseconds).max(naive.spread + point.spread);
    point.milliseconds < naive.milliseconds - margin
}

/// A sentence on a scene on a backend: what is free, and what the best bargain costs. The first point is the traced pair.
pub fn sentence(points: &[&Point]) -> Option<String> {
    let (naive, others) = points.split_first()?;
    let ratio = |point: &Point| point.milliseconds / naive.milliseconds;
    let exact = |point: &&&Point| point.to_traced.view.differing_percent == 0.0;
    let mut said = Vec::new();
    let free = others.iter().filter(exact).filter(|point| is_faster(point, naive));
    if let Some(free) = free.min_by(|a, b| ratio(a).total_cmp(&ratio(b))) {
        let saved = 100.0 * (1.0 - ratio(free));
        said.push(format!("{} changes no pixel and saves {saved:.0} % of the time", free.settings));
    } else {
        said.push("nothing that leaves every pixel as it is saves time".into());
    }
    let one_ray = |point: &&&Point| !point.settings.contains("samples=") && !is_bound(point);
    let bargain = others.iter().filter(one_ray).filter(|point| !exact(point));
    if let Some(point) = bargain.min_by(|a, b| ratio(a).total_cmp(&ratio(b))) {
        let (saved, error) = (100.0 * (1.0 - ratio(point)), point.to_traced);
        said.push(format!(
            "{} saves {saved:.0} % and differs visibly in {:.2} % of the pixels",
            point.settings, error.flip_visible_percent
        ));
    }
    let smoother = others.iter().filter(|point| point.settings.contains("samples="));
    if let Some(point) = smoother.max_by(|a, b| a.gain.total_cmp(&b.gain)) {
        let removed = 100.0 * (1.0 - point.to_truth.view.mse / naive.to_truth.view.mse);
        let cost = 100.0 * (ratio(point) - 1.0);
        let change = if cost < 0.0 { "saves" } else { "costs" };
        said.push(format!(
            "{} {change} {:.0} % and removes {removed:.0} % of the error",
            point.settings,
            cost.abs()
        ));
    }
    Some(format!("For {} on {}, {}.", naive.scene, naive.backend, said.join("; ")))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::metrics::ViewError;
    use crate::render::RayTotals;
    use crate::study::measure::Distance;

    fn distance(mse: f64) -> Distance {
        let view = ViewError {
            mse,
            psnr_db: 0.0,
            differing_percent: mse,
            distance: 0.0,
            wrong_depth_percent: 0.0,
            largest_disparity_error_px: 0.0,
        };
        Distance { view, rel_mse: 0.0, flip: mse, flip_visible_percent: mse }
    }

    /// A point with its time and its errors against the traced pair and the truth.
    pub fn point(settings: &str, milliseconds: f64, to_traced: f64, to_truth: f64) -> Point {
        Point {
            scene: "box".into(),
            width: 1,
            height: 1,
            profile: "strict",
            backend: "CPU".into(),
            settings: settings.into(),
            milliseconds,
            spread: 0.5,
            gain: 800.0 / (milliseconds * to_truth),
            rays: RayTotals::default(),
            scene_bytes: 0,
            peak_bytes: 0,
            to_traced: distance(to_traced),
            to_truth: distance(to_truth),
        }
    }

    #[test]
    fn the_frontier_has_what_nothing_beats() {
        let points = [("a", 10.0, 0.0), ("b", 5.0, 2.0), ("c", 6.0, 3.0), ("d", 12.0, 0.0), ("e", 5.0, 4.0)]
            .map(|(name, time, error)| point(name, time, error, 0.0));
        let best = frontier(&points.iter().collect::<Vec<_>>(), |point| point.to_traced.flip);
        assert_eq!(best.iter().map(|point| &point.settings[..]).collect::<Vec<_>>(), ["b", "a"]);
    }

    #[test]
    fn gain_weighs_time_against_error() {
        let base = point("method=naive", 100.0, 0.0, 8.0);
        let of = |milliseconds, error| gain(&point("x", milliseconds, 0.0, error), &base);
        assert_eq!([of(100.0, 8.0), of(50.0, 8.0), of(100.0, 4.0), of(400.0, 2.0)], [1.0, 2.0, 2.0, 1.0]);
        assert_eq!((of(50.0, 16.0), of(100.0, 0.0)), (1.0, f64::INFINITY));
        let perfect = point("method=naive", 100.0, 0.0, 0.0);
        assert_eq!(gain(&point("x", 50.0, 0.0, 0.0), &perfect), 2.0);
    }

    #[test]
    fn what_nothing_beats_comes_first_and_then_what_gains_most() {
        let points = [
            ("method=ideal", 10.0, 8.0),
            ("a", 100.0, 8.0),
            ("b", 50.0, 32.0),
            ("c", 20.0, 60.0),
            ("d", 400.0, 1.0),
            ("e", 110.0, 8.0),
        ]
        .map(|(name, time, error)| point(name, time, 0.0, error));
        let ranks = ranking(&points.each_ref());
        let order: Vec<_> = ranks.iter().map(|(index, _)| &points[*index].settings[..]).collect();
        assert_eq!(
            order,
            ["d", "a", "c", "b", "e", "method=ideal"],
            "gains of 2, 1, ⅔ and ½; ⁸⁄₁₁ is beaten"
        );
        assert_eq!(ranks.iter().filter(|(_, is_best)| *is_best).count(), 4);
    }

    #[test]
    fn a_sentence_tells_what_is_free_and_what_it_costs_to_be_better() {
        let points = [
            point("method=naive", 100.0, 0.0, 8.0),
            point("bvh=quick", 99.5, 0.0, 8.0),
            point("method=atomic", 55.0, 2.5, 9.0),
            point("samples=nine", 300.0, 3.0, 2.0),
        ];
        let said = |points: &[Point]| sentence(&points.iter().collect::<Vec<_>>()).unwrap();
        assert_eq!(
            said(&points),
            "For box on CPU, nothing that leaves every pixel as it is saves time; method=atomic saves 45 % and differs visibly in \
             2.50 % of the pixels; samples=nine costs 200 % and removes 75 % of the error."
        );
        let mut quicker = points;
        quicker[1].milliseconds = 80.0;
        assert!(
            said(&quicker)
                .starts_with("For box on CPU, bvh=quick changes no pixel and saves 20 % of the time; ")
        );
        assert_eq!(sentence(&[]), None);
    }
}
