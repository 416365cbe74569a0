//! Interleaved timing: every contender does a chunk of rays before any does the next.

use super::contender::Contender;
use super::quartiles::quartiles;
use parallax_shared::layout::{Hit, NONE, Ray};
use std::time::Instant;

/// Small enough to be mostly undisturbed; large enough that what a contender finds evicted from the caches at the start of
/// its turn does not count.
const CHUNK: usize = 1 << 18;

/// What was measured of each contender.
pub struct Timings {
    rays: usize,
    /// Seconds, by contender, chunk and repetition.
    seconds: Vec<Vec<Vec<f64>>>,
    /// Rays for which a contender's answer is not the first one's.
    pub other_answers: Vec<usize>,
}

impl Timings {
    /// Rate in Mray/s, and its spread.
    pub fn rate(&self, contender: usize) -> (f64, f64) {
        let rate = |seconds: f64| self.rays as f64 / seconds / 1e6;
        let (least, middle, most) = self.totals(contender);
        (rate(middle), rate(least) - rate(most))
    }

    /// The first contender's speed as a ratio to this one's, and its spread.
    pub fn ratio(&self, contender: usize) -> (f64, f64) {
        let (ours, theirs) = (self.totals(0), self.totals(contender));
        let ratios = [theirs.0 / ours.0, theirs.1 / ours.1, theirs.2 / ours.2];
        let most = ratios.iter().fold(ratios[0], |a, &b| a.max(b));
        (ratios[1], most - ratios.iter().fold(ratios[0], |a, &b| a.min(b)))
    }

    /// Seconds for all rays: of each chunk the lower quartile, the median and the upper quartile over the repetitions. Whatever else
    /// the machine does falls on single chunks, and does not touch the median.
    fn totals(&self, contender: usize) -> (f64, f64, f64) {
        self.seconds[contender].iter().fold((0.0, 0.0, 0.0), |totals, chunk| {
            let [least, middle, most] = quartiles(chunk.iter().copied());
            (totals.0 + least, totals.1 + middle, totals.2 + most)
        })
    }
}

/// Runs all contenders on `rays`; `any`: only whether they hit.
pub fn time(contenders: &[Box<dyn Contender>], rays: &[Ray], any: bool, repetitions: usize) -> Timings {
    let chunks = rays.len().div_ceil(CHUNK);
    let mut seconds = vec![vec![Vec::with_capacity(repetitions); chunks]; contenders.len()];
    let mut other_answers = vec![0; contenders.len()];
    let none = Hit { t: f32::INFINITY, prim_id: NONE };
    let mut hits = vec![vec![none; CHUNK]; contenders.len()];
    for repetition in 0..repetitions.max(1) {
        for (number, chunk) in rays.chunks(CHUNK).enumerate() {
            for (i, contender) in contenders.iter().enumerate() {
                let start = Instant::now();
                contender.trace(chunk, any, &mut hits[i][..chunk.len()]);
                seconds[i][number].push(start.elapsed().as_secs_f64());
            }
            let first_time = repetition == 0;
            for (i, answers) in hits.iter().enumerate().skip(1).filter(|_| first_time) {
                let pairs = answers[..chunk.len()].iter().zip(&hits[0]);
                other_answers[i] += pairs.filter(|(a, b)| differ(a, b, any)).count();
            }
        }
    }
    Timings { rays: rays.len(), seconds, other_answers }
}

/// Whether answers differ by more than rounding: two primitives at nearly the same `t` are one answer.
fn differ(a: &Hit, b: &Hit, any: bool) -> bool {
    let (hit_a, hit_b) = (a.prim_id != NONE, b.prim_id != NONE);
    hit_a != hit_b || (!any && hit_a && a.prim_id != b.prim_id && (a.t - b.t).abs() > 1e-4 * b.t.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers `prim_id` to every ray.
    struct Always(u32);

    impl Contender for Always {
        fn name(&self) -> String {
            "always".into()
        }

        fn instruction_set(&self) -> &'static str {
            "none"
        }

        fn trace(&self, rays: &[Ray], _: bool, hits: &mut [Hit]) {
            for (ray, hit) in rays.iter().zip(hits) {
                *hit = Hit { t: ray.t_min + self.0 as f32, prim_id: self.0 };
            }
        }
    }

    #[test]
    fn other_answers_are_counted_once() {
        let ray = Ray { origin: [0.0; 3], t_min: 0.0, dir: [1.0; 3], t_max: 1.0 };
        let contenders: Vec<Box<dyn Contender>> =
            vec![Box::new(Always(1)), Box::new(Always(1)), Box::new(Always(7))];
        let timings = time(&contenders, &vec![ray; 2 * CHUNK + 1], false, 3);
        assert_eq!(timings.other_answers, [0, 0, 2 * CHUNK + 1]);
        assert_eq!(time(&contenders, &[ray], true, 1).other_answers, [0, 0, 0], "whether, not what");
    }

    #[test]
    fn one_disturbed_chunk_does_not_touch_the_median() {
        let quiet = vec![vec![1.0; 5]; 3];
        let mut disturbed = quiet.clone();
        disturbed[1][4] = 100.0;
        let timings = Timings { rays: 3_000_000, seconds: vec![quiet, disturbed], other_answers: vec![0; 2] };
        assert_eq!((timings.rate(1), timings.ratio(1)), ((1.0, 0.0), (1.0, 0.0)));
    }
}
