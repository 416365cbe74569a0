//! How many sources land on one pixel, and how many can at most (Lemma 1 of 000 §3.1.2.1).

use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::reprojection::{is_sampled, target};
use serde::Serialize;
use std::ops::AddAssign;

/// What lands where, of one band or of several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Overlap {
    /// Sources that land in the picture.
    pub landed: u64,
    /// Pixels on which more than one source lands.
    pub overlapped: u64,
    /// The most sources on one pixel.
    pub largest: u32,
}

impl Overlap {
    /// Counts the sources of a band by the function that reprojects them, so that no pass pays for it.
    pub fn of_band(p: &Reprojection, hits: &[Hit]) -> Self {
        let mut overlap = Self::default();
        let mut sources = vec![0_u32; p.width as usize];
        for row in hits.chunks_exact(p.width as usize) {
            sources.fill(0);
            for x in 0..p.width {
                let column = if p.mirrored == 0 { x } else { p.width - 1 - x };
                let t = row[column as usize].t;
                if p.sparse != 0 && !is_sampled(t) {
                    continue;
                }
                let landing = target(p, t, x);
                if let Some(sources) = usize::try_from(landing).ok().and_then(|x| sources.get_mut(x)) {
                    *sources += 1;
                    overlap.landed += 1;
                }
            }
            overlap.overlapped += sources.iter().filter(|&&sources| sources > 1).count() as u64;
            overlap.largest = sources.iter().fold(overlap.largest, |largest, &sources| largest.max(sources));
        }
        overlap
    }
}

impl AddAssign for Overlap {
    fn add_assign(&mut self, other: Self) {
        self.landed += other.landed;
        self.overlapped += other.overlapped;
        self.largest = self.largest.max(other.largest);
    }
}

/// The most sources that one pixel can have when no surface is nearer than `nearest_t` (1 / r of the lemma): ⌈r·e⌉ + 1, one more than
/// 000 says, as shifts are rounded. As many slots are free of collisions.
///
/// The roundings of the disparity in f32 are granted: they can move a shift across a half. 1 without a surface, `u32::MAX` when there
/// is no bound.
pub fn lemma_bound(interaxial_px: f32, nearest_t: Option<f32>) -> u32 {
    /// Three roundings at each end of the interval of disparities.
    const ROUNDING: f64 = 6.0 / 16_777_216.0;
    let Some(nearest_t) = nearest_t else { return 1 };
    let e = f64::from(interaxial_px);
    let length = e / f64::from(nearest_t);
    ((length + ROUNDING * (e + length)).ceil() as u32).saturating_add(1)
}

#[cfg(test)]
mod tests {
    use super::{Overlap, lemma_bound};
    use bytemuck::Zeroable;
    use parallax_shared::layout::{Hit, Reprojection};

    fn hits(depths: &[f32]) -> Vec<Hit> {
        depths.iter().map(|&t| Hit { t, prim_id: 0 }).collect()
    }

    #[test]
    fn sources_are_counted_where_they_land() {
        let p = Reprojection { width: 4, rows: 2, interaxial_px: 2.0, ..Zeroable::zeroed() };
        // Shifts 2, 1, 0, 0; then 1, −2, −2, −2.
        let hits = hits(&[f32::INFINITY, 2.0, 1.0, 1.0, 2.0, 0.5, 0.5, 0.5]);
        let overlap = Overlap::of_band(&p, &hits);
        // Targets 2, 2, 2, 3; then 1, −1, 0, 1.
        assert_eq!(overlap, Overlap { landed: 7, overlapped: 2, largest: 3 });
        let mut twice = overlap;
        twice += overlap;
        assert_eq!(twice, Overlap { landed: 14, overlapped: 4, largest: 3 });
        // In mirrored columns the depths come in the other order: targets 0, 1, 3, 5; then −2, −1, 0, 4.
        let mirrored = Reprojection { mirrored: 1, ..p };
        assert_eq!(Overlap::of_band(&mirrored, &hits), Overlap { landed: 4, overlapped: 0, largest: 1 });
    }

    #[test]
    fn the_bound_is_the_lemmas_and_one_more() {
        assert_eq!(lemma_bound(15.0, Some(1.01)), 16);
        assert_eq!(lemma_bound(15.0, Some(2.1)), 9);
        assert_eq!(lemma_bound(0.3, Some(1.0)), 2);
        assert_eq!((lemma_bound(0.0, Some(1.0)), lemma_bound(15.0, None)), (1, 1));
        assert_eq!(lemma_bound(15.0, Some(0.0)), u32::MAX);
        assert_eq!(lemma_bound(15.0, Some(1.0)), 17, "a shift may be rounded across a half");
    }
}
