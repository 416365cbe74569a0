//! What strict arithmetic costs: a row of its own for each backend.

use super::Point;
use serde::Serialize;
use std::fmt;

/// The price of the strict profile (correctly rounded division and square root, without contraction) for the traced pair of a scene on
/// a backend.
///
/// On a CPU there is none to measure: the processor's own division and square root are correctly rounded and nothing is contracted, so
/// that both profiles are the same machine code, which takes the same time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StrictPrice {
    /// Which scene.
    pub scene: String,
    /// Where it ran.
    pub backend: String,
    /// Whether both profiles are the same code. Then the price is 0 by construction, and `fast_ms` is none.
    pub same_code: bool,
    /// Median time of the passes of both views, strict.
    pub strict_ms: f64,
    /// Distance of the quartiles.
    pub strict_spread: f64,
    /// The same, fast.
    pub fast_ms: Option<f64>,
    /// Distance of the quartiles; 0 without a measurement.
    pub fast_spread: f64,
    /// By how many percent strict takes longer than fast; below 0 where it is quicker.
    pub price_percent: f64,
    /// Percentage of the second view's pixels that have another colour in the fast profile.
    pub differing_percent: f64,
    /// Mean ꟻLIP of the fast picture against the strict one.
    pub flip: f64,
}

impl StrictPrice {
    /// That of a scene on a backend, of whose `points` the first is the traced pair; none where the fast profile was not studied.
    pub fn new(points: &[&Point], same_code: bool) -> Option<Self> {
        let strict = *points.first()?;
        let fast = points.iter().find(|point| point.settings == "profile=fast").filter(|_| !same_code);
        if fast.is_none() && !same_code {
            return None;
        }
        Some(Self {
            scene: strict.scene.clone(),
            backend: strict.backend.clone(),
            same_code,
            strict_ms: strict.milliseconds,
            strict_spread: strict.spread,
            fast_ms: fast.map(|fast| fast.milliseconds),
            fast_spread: fast.map_or(0.0, |fast| fast.spread),
            price_percent: fast.map_or(0.0, |fast| 100.0 * (strict.milliseconds / fast.milliseconds - 1.0)),
            differing_percent: fast.map_or(0.0, |fast| fast.to_traced.view.differing_percent),
            flip: fast.map_or(0.0, |fast| fast.to_traced.flip),
        })
    }
}

impl fmt::Display for StrictPrice {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { scene, backend, strict_ms, price_percent, differing_percent, .. } = self;
        write!(f, "Strict arithmetic for {scene} on {backend}: ")?;
        match self.fast_ms {
            None => write!(f, "the same code as the fast profile, so it costs nothing."),
            Some(fast_ms) => write!(
                f,
                "{strict_ms:.2} ms against {fast_ms:.2} ms, {price_percent:+.1} %; {differing_percent:.2} % of the pixels differ."
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::findings::tests::point;
    use super::*;

    #[test]
    fn the_price_is_that_of_the_traced_pair() {
        let points = [point("method=naive", 12.0, 0.0, 8.0), point("profile=fast", 10.0, 0.25, 8.0)];
        let price = StrictPrice::new(&points.each_ref(), false).unwrap();
        assert!((price.price_percent - 20.0).abs() < 1e-9);
        assert_eq!((price.strict_ms, price.fast_ms, price.differing_percent), (12.0, Some(10.0), 0.25));
        let told = "Strict arithmetic for box on CPU: 12.00 ms against 10.00 ms, +20.0 %; 0.25 % of the pixels differ.";
        assert_eq!(price.to_string(), told);
    }

    #[test]
    fn what_was_not_measured_is_not_told() {
        let naive = point("method=naive", 12.0, 0.0, 8.0);
        assert_eq!(StrictPrice::new(&[&naive], false), None);
        assert_eq!(StrictPrice::new(&[], true), None);
        let same = StrictPrice::new(&[&naive], true).unwrap();
        assert_eq!((same.fast_ms, same.price_percent, same.same_code), (None, 0.0, true));
        assert!(same.to_string().ends_with("the same code as the fast profile, so it costs nothing."));
    }
}
