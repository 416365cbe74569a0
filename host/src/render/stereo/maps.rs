//! What became of each pixel: for pictures that show where a method works.

use super::Plan;
use crate::render::band::Pair;
use parallax_shared::layout::RayCounts;
use parallax_shared::stereo::source::{UNSAMPLED, kind};

/// One element per pixel, of the bands so far.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PixelMaps {
    /// What was done for each pixel of the second view (the kinds of [`parallax_shared::stereo::source`]); of a pixel with several points
    /// the one that was the most work. Empty if that view was not made from the first.
    pub kinds: Vec<u32>,
    /// Rays of all kinds that each pixel took: of the source, and of the second view.
    pub rays: [Vec<u32>; 2],
}

impl PixelMaps {
    /// Adds a band, which lies below.
    pub(in crate::render) fn append(&mut self, plan: &Plan, pair: &Pair) {
        for (rays, values) in self.rays.iter_mut().zip([&pair.source, &pair.second]) {
            let first = rays.len();
            for stage in values.rays() {
                rays.resize(first + stage.len(), 0);
                rays[first..].iter_mut().zip(stage).for_each(|(sum, counts)| *sum += all(counts));
            }
        }
        let Some(inferred) = &pair.inferred else { return };
        match plan.grid {
            Some(grid) if !grid.aims => {
                let columns = plan.of_picture().width as usize;
                let (n, shared) = (grid.per_pixel as usize, usize::from(grid.shares_edges));
                let (width, rows) = ((columns - shared) / n, (inferred.source.len() / columns - shared) / n);
                let pixels = (0..rows).flat_map(|y| (0..width).map(move |x| (x, y)));
                self.kinds.extend(pixels.map(|(x, y)| most(&inferred.source, columns, n, x, y)));
            }
            _ => self.kinds.extend(inferred.source.iter().map(|&word| kind(word))),
        }
    }
}

fn all(counts: &RayCounts) -> u32 {
    counts.primary + counts.shadow + counts.reflected + counts.refracted
}

/// The largest kind of the sampled points of pixel (`x`, `y`): kinds have the order of their work.
fn most(words: &[u32], columns: usize, n: usize, x: usize, y: usize) -> u32 {
    let rows = (y * n..(y + 1) * n).map(|row| &words[row * columns + x * n..][..n]);
    let kinds = rows.flatten().map(|&word| kind(word)).filter(|&kind| kind != UNSAMPLED);
    kinds.max().unwrap_or(UNSAMPLED)
}

#[cfg(test)]
mod tests {
    use super::*;
    use parallax_shared::stereo::source::{BAD, HOLE, from_column, traced};

    #[test]
    fn a_pixel_is_what_its_hardest_point_was() {
        let (none, reused) = (traced(UNSAMPLED), from_column(0, 3));
        // Two pixels of 2 × 2 points, and the edge.
        let words = [reused, none, reused, none, traced(BAD), traced(HOLE), none, none, none, none];
        assert_eq!([most(&words, 5, 2, 0, 0), most(&words, 5, 2, 1, 0)], [HOLE, 0]);
        assert_eq!(most(&[none; 4], 2, 2, 0, 0), UNSAMPLED);
    }
}
