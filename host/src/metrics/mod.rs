//! How far a picture is from another one.

mod flip;

pub use flip::Perceived;

use crate::render::ViewImages;
use parallax_shared::camera::disparity_px;
use parallax_shared::layout::Hit;
use parallax_shared::output::tonemap::srgb8_colour;
use rayon::prelude::*;
use serde::Serialize;

/// Linear colours (three or four components, of which the first three count) as 8-bit sRGB, as PNG files have them: what the errors
/// below are of.
pub fn srgb8<const N: usize>(colours: &[[f32; N]]) -> Vec<[u8; 3]> {
    colours.par_iter().map(|colour| srgb8_colour([colour[0], colour[1], colour[2]])).collect()
}

/// Mean squared error of 8-bit sRGB components, as Al-Hagri 2012 §4.5.2 has it: Σ‖c − c̄‖² / (3 · pixels). 0 without pixels.
pub fn mse(picture: &[[u8; 3]], reference: &[[u8; 3]]) -> f64 {
    let squares: f64 = picture.iter().zip(reference).map(|(a, b)| squared_distance(a, b)).sum();
    if picture.is_empty() { 0.0 } else { squares / (3.0 * picture.len() as f64) }
}

/// Peak signal to noise ratio in dB of an [`mse`]; +∞ for equal pictures.
pub fn psnr(mse: f64) -> f64 {
    10.0 * (255.0 * 255.0 / mse).log10()
}

/// Relative mean squared error of linear colours: Σ‖c − c̄‖² / (3 · pixels · (ȳ² + 0.01)) with the truth's mean component ȳ of each
/// pixel, so that an error in the dark counts as one in the light does. 0 without pixels.
pub fn rel_mse(picture: &[[f32; 3]], reference: &[[f32; 3]]) -> f64 {
    let relative = |(a, b): (&[f32; 3], &[f32; 3])| {
        let square: f64 = a.iter().zip(b).map(|(a, b)| (f64::from(*a) - f64::from(*b)).powi(2)).sum();
        let mean = b.iter().map(|&component| f64::from(component)).sum::<f64>() / 3.0;
        square / (mean * mean + 0.01)
    };
    let squares: f64 = picture.iter().zip(reference).map(relative).sum();
    if picture.is_empty() { 0.0 } else { squares / (3.0 * picture.len() as f64) }
}

/// Of the pixels whose colours differ: their share, and their mean distance in units of 8-bit sRGB (Adelson and Hodges 1993, §5).
pub fn differing(picture: &[[u8; 3]], reference: &[[u8; 3]]) -> (f64, f64) {
    let distances = picture.iter().zip(reference).map(|(a, b)| squared_distance(a, b).sqrt());
    let differing: Vec<f64> = distances.filter(|distance| *distance > 0.0).collect();
    if differing.is_empty() {
        return (0.0, 0.0);
    }
    let count = differing.len() as f64;
    (count / picture.len() as f64, differing.iter().sum::<f64>() / count)
}

/// The share of pixels that show another depth than the reference by more than rounding to whole pixels explains: their disparities
/// are more than one pixel apart.
pub fn wrong_depth(interaxial_px: f32, shown: &[Hit], reference: &[Hit]) -> f64 {
    let wrong = shown.iter().zip(reference).filter(|(a, b)| is_wrong(interaxial_px, a, b)).count();
    if shown.is_empty() { 0.0 } else { wrong as f64 / shown.len() as f64 }
}

/// Shares of the squared error by what pixels show instead of the reference: the same depth, up to rounding to whole pixels; something
/// nearer, as silhouettes do that rounding has moved; something farther, which the reference's surface hides. 0 without any error.
/// Pictures are colours and hits.
pub fn error_shares(
    interaxial_px: f32,
    picture: (&[[u8; 3]], &[Hit]),
    reference: (&[[u8; 3]], &[Hit]),
) -> [f64; 3] {
    let mut errors = [0.0; 3];
    let pixels = picture.0.iter().zip(picture.1).zip(reference.0.iter().zip(reference.1));
    for ((colour, shown), (true_colour, truth)) in pixels {
        let kind = match is_wrong(interaxial_px, shown, truth) {
            false => 0,
            true if shown.t < truth.t => 1,
            true => 2,
        };
        errors[kind] += squared_distance(colour, true_colour);
    }
    let all: f64 = errors.iter().sum();
    if all > 0.0 { errors.map(|error| error / all) } else { errors }
}

/// How far apart disparities may be that rounding to whole pixels explains: the bounded ray's own rounding is allowed for.
const TOLERATED_PX: f32 = 1.001;

fn is_wrong(interaxial_px: f32, shown: &Hit, truth: &Hit) -> bool {
    let disparity = |hit: &Hit| disparity_px(interaxial_px, hit.t);
    disparity_error(disparity(shown), disparity(truth)) > TOLERATED_PX
}

/// How far a view is from the truth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ViewError {
    /// See [`mse`].
    pub mse: f64,
    /// See [`psnr`]; +∞ (in JSON: null) for equal pictures.
    pub psnr_db: f64,
    /// Percentage of the pixels whose colours differ.
    pub differing_percent: f64,
    /// Their mean distance in units of 8-bit sRGB.
    pub distance: f64,
    /// Percentage of the pixels whose disparity is wrong by more than a pixel.
    pub wrong_depth_percent: f64,
    /// The largest error of a disparity, in pixels.
    pub largest_disparity_error_px: f32,
}

impl ViewError {
    /// That of `shown`, which has as many pixels as the truth.
    pub fn new(shown: &ViewImages, truth: &ViewImages) -> Self {
        let (picture, reference) = (srgb8(&shown.colour), srgb8(&truth.colour));
        let mse = mse(&picture, &reference);
        let (share, distance) = differing(&picture, &reference);
        let errors = || shown.disparity.iter().zip(&truth.disparity).map(|(a, b)| disparity_error(*a, *b));
        let wrong = errors().filter(|error| *error > TOLERATED_PX).count();
        Self {
            mse,
            psnr_db: psnr(mse),
            differing_percent: 100.0 * share,
            distance,
            wrong_depth_percent: 100.0 * wrong as f64 / shown.disparity.len().max(1) as f64,
            largest_disparity_error_px: errors().fold(0.0, f32::max),
        }
    }
}

/// Of equal infinities there is none.
fn disparity_error(a: f32, b: f32) -> f32 {
    if a == b { 0.0 } else { (a - b).abs() }
}

/// The square of the distance of two colours.
pub(crate) fn squared_distance(a: &[u8; 3], b: &[u8; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (f64::from(*a) - f64::from(*b)).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLACK: [u8; 3] = [0, 0, 0];
    const RED: [u8; 3] = [255, 0, 0];

    #[test]
    fn colours_are_compared_as_files_have_them() {
        assert_eq!(srgb8(&[[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0]]), [BLACK, RED]);
        assert_eq!(srgb8(&[[0.5, 0.5, 0.5, 0.0]]), [[188; 3]]);
    }

    #[test]
    fn equal_pictures_have_no_error() {
        assert_eq!((mse(&[RED; 3], &[RED; 3]), mse(&[], &[])), (0.0, 0.0));
        assert_eq!(psnr(0.0), f64::INFINITY);
        assert_eq!(differing(&[RED; 3], &[RED; 3]), (0.0, 0.0));
    }

    #[test]
    fn relative_errors_weigh_more_in_the_dark() {
        assert_eq!((rel_mse(&[], &[]), rel_mse(&[[0.5; 3]], &[[0.5; 3]])), (0.0, 0.0));
        assert!((rel_mse(&[[0.1, 0.0, 0.0]], &[[0.0; 3]]) - 1.0 / 3.0).abs() < 1e-6);
        assert!((rel_mse(&[[1.1, 1.0, 1.0]], &[[1.0; 3]]) - 0.01 / 3.0 / 1.01).abs() < 1e-6);
    }

    #[test]
    fn one_component_of_one_pixel_counts_by_its_square() {
        let (picture, reference) = ([RED, BLACK], [BLACK, BLACK]);
        assert_eq!(mse(&picture, &reference), 255.0 * 255.0 / 6.0);
        assert!((psnr(255.0 * 255.0 / 6.0) - 10.0 * 6.0_f64.log10()).abs() < 1e-12);
        assert_eq!(differing(&picture, &reference), (0.5, 255.0));
    }

    #[test]
    fn depths_a_pixel_of_disparity_apart_are_wrong() {
        let hit = |t| Hit { t, prim_id: 0 };
        // Disparities 5 and 4.95; 5 and 10; 5 and 5.
        let (shown, truth) = ([hit(2.0), hit(2.0), hit(2.0)], [hit(1.98), hit(f32::INFINITY), hit(2.0)]);
        assert_eq!(wrong_depth(10.0, &shown, &truth), 1.0 / 3.0);
        assert_eq!(wrong_depth(10.0, &[], &[]), 0.0);
    }

    #[test]
    fn a_view_has_all_its_errors() {
        let view = |colour, disparity| ViewImages { colour, disparity, ..ViewImages::default() };
        let truth = view(vec![[0.0; 3], [1.0; 3]], vec![2.0, f32::INFINITY]);
        let same = ViewError::new(&truth, &truth);
        assert_eq!((same.mse, same.psnr_db, same.largest_disparity_error_px), (0.0, f64::INFINITY, 0.0));
        let error = ViewError::new(&view(vec![[1.0, 0.0, 0.0], [1.0; 3]], vec![4.5, f32::INFINITY]), &truth);
        assert_eq!((error.mse, error.differing_percent, error.distance), (255.0 * 255.0 / 6.0, 50.0, 255.0));
        assert_eq!((error.wrong_depth_percent, error.largest_disparity_error_px), (50.0, 2.5));
    }

    #[test]
    fn errors_are_told_apart_by_depth() {
        let hit = |t| Hit { t, prim_id: 0 };
        // The same up to rounding, nearer than the truth, farther.
        let (shown, truth) = ([2.0, 1.0, f32::INFINITY].map(hit), [1.98, f32::INFINITY, 2.0].map(hit));
        let shares = |a: &[[u8; 3]], b: &[[u8; 3]]| error_shares(10.0, (a, &shown), (b, &truth));
        let black = [BLACK; 3];
        assert_eq!(shares(&[RED, BLACK, BLACK], &black), [1.0, 0.0, 0.0]);
        assert_eq!(shares(&[BLACK, RED, BLACK], &black), [0.0, 1.0, 0.0]);
        assert_eq!(shares(&[RED, BLACK, RED], &black), [0.5, 0.0, 0.5]);
        assert_eq!(shares(&black, &black), [0.0; 3]);
    }
}
