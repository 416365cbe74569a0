//! Pictures of how a pair was made, and of how far it is from the truth.

use super::{Batch, OutputError, png};
use crate::metrics::{squared_distance, srgb8};
use crate::render::stereo::maps::PixelMaps;
use crate::render::{StereoImages, ViewImages};
use parallax_shared::stereo::source;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What became of a pixel and how it is shown: Okabe and Ito's colours, which colour-blind people tell apart.
pub const KINDS: [(u32, &str, [u8; 3]); 8] = [
    (source::REUSED, "reused", [60, 60, 60]),
    (source::VERIFIED, "verified", [0, 114, 178]),
    (source::HOLE, "hole", [230, 159, 0]),
    (source::GAP, "gap", [240, 228, 66]),
    (source::BAD, "bad", [213, 94, 0]),
    (source::GUIDED, "guided", [86, 180, 233]),
    (source::UNGUIDED, "unguided", [0, 158, 115]),
    (source::UNSAMPLED, "unsampled", [0, 0, 0]),
];

/// By what distances of 8-bit colours are multiplied in the picture of errors: 001's figure 9 shows 0 to 10 as 0 to 255.
const ERROR_SCALE: f64 = 25.5;

/// What there is to show of a pair.
#[derive(Clone, Copy)]
pub struct Diagnostics<'a> {
    /// The pair.
    pub images: &'a StereoImages,
    /// How it was made.
    pub maps: &'a PixelMaps,
    /// Which view was made from the other one: 0 left, 1 right.
    pub second: usize,
    /// Seconds that each pixel of that view took.
    pub seconds: Option<&'a [f32]>,
    /// The truth.
    pub reference: Option<&'a StereoImages>,
}

/// What black and white mean in the pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Scales {
    /// Disparity that is fully coloured: blue behind the zero-parallax plane, red in front of it; white on it.
    pub disparity_px: f32,
    /// Rays of a white pixel.
    pub rays: u32,
    /// Microseconds of a white pixel; all but one in a thousand are darker.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_us: Option<f32>,
}

/// Writes NAME_map.png (if the second view was made from the first), NAME_disparity.png, NAME_rays.png and, where there is what they
/// show, NAME_time.png and NAME_error.png, all of the second view.
///
/// # Errors
/// When a file cannot be written; then none has been changed.
pub fn write_maps(
    shown: &Diagnostics<'_>,
    folder: &Path,
    name: &str,
) -> Result<(Vec<PathBuf>, Scales), OutputError> {
    let mut batch = Batch::new(folder)?;
    let size = [shown.images.width, shown.images.height];
    let view = &shown.images.views[shown.second];
    let mut write =
        |what, pixels: &[[u8; 3]]| png::write(&mut batch, &format!("{name}_{what}.png"), size, pixels);
    if !shown.maps.kinds.is_empty() {
        write("map", &shown.maps.kinds.iter().map(|&kind| colour_of(kind)).collect::<Vec<_>>())?;
    }
    let largest = view.disparity.iter().map(|d| d.abs()).filter(|d| d.is_finite()).fold(0.0, f32::max);
    write("disparity", &view.disparity.iter().map(|&d| diverging(d, largest)).collect::<Vec<_>>())?;
    let rays = &shown.maps.rays[1];
    let most = rays.iter().copied().max().unwrap_or(0);
    write("rays", &rays.iter().map(|&rays| grey(rays as f32, most as f32)).collect::<Vec<_>>())?;
    let mut scales = Scales { disparity_px: largest, rays: most, time_us: None };
    if let Some(seconds) = shown.seconds {
        let white = all_but_a_thousandth(seconds);
        scales.time_us = Some(white * 1e6);
        write("time", &seconds.iter().map(|&seconds| grey(seconds, white)).collect::<Vec<_>>())?;
    }
    if let Some(reference) = shown.reference {
        write("error", &errors(view, &reference.views[shown.second]))?;
    }
    Ok((batch.commit()?, scales))
}

fn colour_of(kind: u32) -> [u8; 3] {
    KINDS.iter().find(|(of, ..)| *of == kind).map_or([255; 3], |(.., colour)| *colour)
}

/// White at 0, blue at `largest` and red at −`largest`.
fn diverging(value: f32, largest: f32) -> [u8; 3] {
    let share = if largest > 0.0 { (value / largest).clamp(-1.0, 1.0) } else { 0.0 };
    let end = if share < 0.0 { [178.0, 24.0, 43.0] } else { [33.0, 102.0, 172.0] };
    end.map(|end: f32| (255.0 + (end - 255.0) * share.abs()).round() as u8)
}

fn grey(value: f32, white: f32) -> [u8; 3] {
    [if white > 0.0 { (255.0 * value / white).round().min(255.0) as u8 } else { 0 }; 3]
}

/// The value that all but the largest thousandth do not exceed.
fn all_but_a_thousandth(values: &[f32]) -> f32 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f32::total_cmp);
    sorted.get((sorted.len().max(1) - 1) * 999 / 1000).copied().unwrap_or(0.0)
}

fn errors(view: &ViewImages, truth: &ViewImages) -> Vec<[u8; 3]> {
    let (shown, truth) = (srgb8(&view.colour), srgb8(&truth.colour));
    let distances = shown.iter().zip(&truth).map(|(a, b)| squared_distance(a, b).sqrt());
    distances.map(|distance| [(distance * ERROR_SCALE).round().min(255.0) as u8; 3]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_a_colour_of_its_own() {
        let mut colours = KINDS.map(|(.., colour)| colour).to_vec();
        colours.sort();
        colours.dedup();
        assert_eq!(colours.len(), KINDS.len());
        assert_eq!(colour_of(source::GAP), [240, 228, 66]);
    }

    #[test]
    fn disparities_diverge_from_white() {
        assert_eq!(diverging(0.0, 7.0), [255; 3]);
        assert_eq!((diverging(7.0, 7.0), diverging(-7.0, 7.0)), ([33, 102, 172], [178, 24, 43]));
        assert_eq!(diverging(f32::NEG_INFINITY, 7.0), [178, 24, 43]);
        assert_eq!(diverging(0.0, 0.0), [255; 3]);
    }

    #[test]
    fn errors_of_ten_are_white() {
        let view = |colour: [f32; 3]| ViewImages { colour: vec![colour], ..ViewImages::default() };
        assert_eq!(errors(&view([0.2; 3]), &view([0.2; 3])), [[0; 3]]);
        assert_eq!(errors(&view([0.2; 3]), &view([0.9; 3])), [[255; 3]]);
    }

    #[test]
    fn a_few_slow_pixels_do_not_darken_the_rest() {
        let mut seconds = vec![1.0; 2000];
        seconds[7] = 1000.0;
        assert_eq!(all_but_a_thousandth(&seconds), 1.0);
        assert_eq!((all_but_a_thousandth(&[]), grey(3.0, 0.0)), (0.0, [0; 3]));
    }
}
