//! ꟻLIP: how different two pictures look when one takes the other's place (Andersson et al. 2020, "FLIP: a difference evaluator for
//! alternating images", for pictures of low dynamic range).
//!
//! Held against the authors' own implementation by a test.

use rayon::prelude::*;
use std::f64::consts::{PI, SQRT_2};

/// Pixels per degree of the authors' display: 0.7 m away, 0.7 m and 3840 pixels wide (eq. (1)).
const PIXELS_PER_DEGREE: f64 = 67.020_645;

/// Gaussians of the contrast sensitivity (table 1): a₁, b₁, a₂, b₂ for the achromatic, the red-green and the blue-yellow channel.
const SENSITIVITY: [[f64; 4]; 3] =
    [[1.0, 0.0047, 0.0, 1e-5], [1.0, 0.0053, 0.0, 1e-5], [34.1, 0.04, 13.5, 0.025]];

/// Width of a feature in degrees (§4.2).
const FEATURE_WIDTH: f64 = 0.082;

/// Linear RGB (sRGB primaries) to XYZ; rows.
const XYZ: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// XYZ to linear RGB; rows.
const RGB: [[f64; 3]; 3] = [
    [3.241_003_275, -1.537_398_934, -0.498_615_861],
    [-0.969_224_334, 1.875_930_071, 0.041_554_224],
    [0.055_639_423, -0.204_011_202, 1.057_148_933],
];

/// XYZ of white.
const WHITE: Colour =
    [XYZ[0][0] + XYZ[0][1] + XYZ[0][2], XYZ[1][0] + XYZ[1][1] + XYZ[1][2], XYZ[2][0] + XYZ[2][1] + XYZ[2][2]];

type Colour = [f64; 3];

/// What a viewer sees of a picture: worked out once, however many others it is held against.
pub struct Perceived {
    colours: Vec<Colour>,
    features: Vec<[f64; 2]>,
}

impl Perceived {
    /// That of a picture in 8-bit sRGB with `width` columns.
    pub fn new(pixels: &[[u8; 3]], width: usize) -> Self {
        let picture = Opponent::new(pixels, width.max(1));
        Self { colours: picture.filtered(), features: picture.features() }
    }

    /// The difference of each pixel from that of a picture of the same size, from 0 to 1.
    pub fn flip(&self, reference: &Self) -> Vec<f64> {
        let colours = colour_differences(&self.colours, &reference.colours);
        let features = feature_differences(&self.features, &reference.features);
        colours.into_iter().zip(features).map(|(colour, feature)| colour.powf(1.0 - feature)).collect()
    }
}

/// A picture in linearised opponent colours (YCxCz).
struct Opponent {
    pixels: Vec<Colour>,
    width: usize,
}

impl Opponent {
    fn new(pixels: &[[u8; 3]], width: usize) -> Self {
        let pixels = pixels.iter().map(|pixel| opponent(pixel.map(linear))).collect();
        Self { pixels, width }
    }

    /// What a viewer sees of it (§4.1.1), as linear RGB that a display can show.
    fn filtered(&self) -> Vec<Colour> {
        let radius = (3.0 * (0.04 / (2.0 * PI * PI)).sqrt() * PIXELS_PER_DEGREE).ceil() as i64;
        let channels: Vec<Vec<f64>> = SENSITIVITY
            .iter()
            .enumerate()
            .map(|(channel, &sensitivity)| self.blurred(channel, sensitivity, radius))
            .collect();
        let pixels = channels[0].iter().zip(&channels[1]).zip(&channels[2]);
        pixels.map(|((y, cx), cz)| from_opponent([*y, *cx, *cz]).map(|value| value.clamp(0.0, 1.0))).collect()
    }

    /// A channel, convolved with the sum of Gaussians, whose weights sum to one.
    fn blurred(&self, channel: usize, [a1, b1, a2, b2]: [f64; 4], radius: i64) -> Vec<f64> {
        let values: Vec<f64> = self.pixels.iter().map(|pixel| pixel[channel]).collect();
        let (mut blurred, mut total) = (vec![0.0; values.len()], 0.0);
        for (a, b) in [(a1, b1), (a2, b2)].into_iter().filter(|(a, _)| *a > 0.0) {
            let weight = |x: i64| (-(PI * x as f64 / PIXELS_PER_DEGREE).powi(2) / b).exp();
            let kernel: Vec<f64> = (-radius..=radius).map(weight).collect();
            let scale = a * (PI / b).sqrt();
            total += scale * kernel.iter().sum::<f64>().powi(2);
            let term = convolved(&values, self.width, &kernel, &kernel);
            blurred.iter_mut().zip(term).for_each(|(sum, value)| *sum += scale * value);
        }
        blurred.iter().map(|sum| sum / total).collect()
    }

    /// How much of an edge and of a point each pixel is (§4.2).
    fn features(&self) -> Vec<[f64; 2]> {
        let luminance: Vec<f64> = self.pixels.iter().map(|pixel| (pixel[0] + 16.0) / 116.0).collect();
        let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
        let radius = (3.0 * deviation).ceil() as i64;
        let of =
            |weight: &dyn Fn(f64) -> f64| (-radius..=radius).map(|x| weight(x as f64)).collect::<Vec<_>>();
        let gauss = |x: f64| (-x * x / (2.0 * deviation * deviation)).exp();
        let smooth = of(&gauss);
        let total: f64 = smooth.iter().sum();
        let smooth: Vec<f64> = smooth.iter().map(|weight| weight / total).collect();
        let edge = balanced(&of(&|x| -x * gauss(x)));
        let point = balanced(&of(&|x| (x * x / (deviation * deviation) - 1.0) * gauss(x)));
        let lengths = |kernel: &[f64]| {
            let across = convolved(&luminance, self.width, kernel, &smooth);
            let down = convolved(&luminance, self.width, &smooth, kernel);
            across.into_iter().zip(down).map(|(x, y)| x.hypot(y)).collect::<Vec<_>>()
        };
        lengths(&edge).into_iter().zip(lengths(&point)).map(|(edge, point)| [edge, point]).collect()
    }
}

/// Weights whose positive ones sum to 1 and whose negative ones to −1.
fn balanced(weights: &[f64]) -> Vec<f64> {
    let sum = |sign: f64| weights.iter().map(|weight| (sign * weight).max(0.0)).sum::<f64>();
    let (positive, negative) = (sum(1.0), sum(-1.0));
    weights.iter().map(|weight| weight / if *weight > 0.0 { positive } else { negative }).collect()
}

/// Convolves rows with `across` and columns with `down`; pixels beyond the frame are the nearest ones within.
fn convolved(values: &[f64], width: usize, across: &[f64], down: &[f64]) -> Vec<f64> {
    let height = values.len() / width;
    let sum = |kernel: &[f64], at: usize, length: usize, value: &dyn Fn(usize) -> f64| {
        let radius = kernel.len() / 2;
        let clamped = |i: usize| (at + i).saturating_sub(radius).min(length - 1);
        kernel.iter().enumerate().map(|(i, weight)| weight * value(clamped(i))).sum::<f64>()
    };
    let pixels = || (0..width * height).into_par_iter();
    let rows: Vec<f64> = pixels()
        .map(|index| {
            let (x, first) = (index % width, index - index % width);
            sum(across, x, width, &|x| values[first + x])
        })
        .collect();
    pixels().map(|index| sum(down, index / width, height, &|y| rows[y * width + index % width])).collect()
}

/// Differences of colours, from 0 to 1 (§4.1.2 and §4.1.3).
fn colour_differences(shown: &[Colour], truth: &[Colour]) -> Vec<f64> {
    let distance = |a: Colour, b: Colour| hyab(hunt(a), hunt(b)).powf(0.7);
    let most = distance([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let (knee, height) = (0.4 * most, 0.95);
    let spread = |distance: f64| match distance < knee {
        true => distance * height / knee,
        false => height + (distance - knee) / (most - knee) * (1.0 - height),
    };
    shown.iter().zip(truth).map(|(a, b)| spread(distance(*a, *b))).collect()
}

/// Differences of features, from 0 to 1 (eq. (9)).
fn feature_differences(shown: &[[f64; 2]], truth: &[[f64; 2]]) -> Vec<f64> {
    let difference = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
    shown.iter().zip(truth).map(|(a, b)| (difference(a, b) / SQRT_2).sqrt()).collect()
}

fn linear(value: u8) -> f64 {
    let value = f64::from(value) / 255.0;
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

fn product(matrix: &[[f64; 3]; 3], [x, y, z]: Colour) -> Colour {
    matrix.map(|[a, b, c]| a * x + b * y + c * z)
}

/// XYZ over that of white.
fn relative_xyz(rgb: Colour) -> Colour {
    let xyz = product(&XYZ, rgb);
    [0, 1, 2].map(|i| xyz[i] / WHITE[i])
}

fn opponent(rgb: Colour) -> Colour {
    let [x, y, z] = relative_xyz(rgb);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn from_opponent([y, cx, cz]: Colour) -> Colour {
    let y = (y + 16.0) / 116.0;
    let relative = [y + cx / 500.0, y, y - cz / 200.0];
    product(&RGB, [0, 1, 2].map(|i| relative[i] * WHITE[i]))
}

/// L*a*b* in which dark colours are less colourful (Hunt).
fn hunt(rgb: Colour) -> Colour {
    let delta = 6.0_f64 / 29.0;
    let curve = |t: f64| match t > delta.powi(3) {
        true => t.cbrt(),
        false => t / (3.0 * delta * delta) + 4.0 / 29.0,
    };
    let [x, y, z] = relative_xyz(rgb).map(curve);
    let lightness = 116.0 * y - 16.0;
    [lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)]
}

fn hyab(a: Colour, b: Colour) -> f64 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flip(picture: &[[u8; 3]], reference: &[[u8; 3]], width: usize) -> Vec<f64> {
        Perceived::new(picture, width).flip(&Perceived::new(reference, width))
    }

    /// A picture with edges, points, gradients and saturated colours, and one like it.
    fn pair(width: usize, height: usize) -> [Vec<[u8; 3]>; 2] {
        let pixel = |x: usize, y: usize, shift: usize| match (x + shift) / 9 % 4 {
            0 => [(x * 5 % 256) as u8, (y * 7 % 256) as u8, 40],
            1 => [220, 30, (x * y % 256) as u8],
            2 if (x + y).is_multiple_of(7) => [255, 255, 255],
            _ => [10, (100 + 2 * shift) as u8, 200],
        };
        [0, 2].map(|shift| {
            (0..width * height).map(|index| pixel(index % width, index / width, shift)).collect()
        })
    }

    #[test]
    fn pictures_differ_as_by_the_authors_implementation() {
        let (width, height) = (70, 50);
        let [shown, truth] = pair(width, height);
        let image = |pixels: &[[u8; 3]]| {
            nv_flip::FlipImageRgb8::with_data(width as u32, height as u32, pixels.as_flattened())
        };
        let theirs = nv_flip::flip(image(&truth), image(&shown), nv_flip::DEFAULT_PIXELS_PER_DEGREE).to_vec();
        let ours = flip(&shown, &truth, width);
        let largest = ours.iter().zip(&theirs).map(|(a, b)| (a - f64::from(*b)).abs()).fold(0.0, f64::max);
        let mean = ours.iter().sum::<f64>() / ours.len() as f64;
        assert!(mean > 0.1, "they do differ: {mean}");
        assert!(largest < 1e-3, "{largest}");
    }

    #[test]
    fn equal_pictures_do_not_differ_and_opposite_ones_do() {
        let [picture, _] = pair(20, 10);
        assert!(flip(&picture, &picture, 20).iter().all(|&value| value == 0.0));
        assert!(flip(&[], &[], 0).is_empty());
        let far = flip(&[[0, 255, 0]; 200], &[[0, 0, 255]; 200], 20);
        assert!(far.iter().all(|value| (value - 1.0).abs() < 1e-3), "{}", far[0]);
    }
}
