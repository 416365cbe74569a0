//! PNG, 8 bit sRGB.

use super::{Batch, OutputError};
use crate::metrics::srgb8;
use crate::render::StereoImages;
use image::ImageEncoder;
use image::codecs::png::PngEncoder;
use parallax_shared::output::{anaglyph, tonemap};
use rayon::prelude::*;

/// Both views in one picture for red/cyan glasses.
pub fn anaglyph(images: &StereoImages) -> Vec<[u8; 3]> {
    let [left, right] = &images.views;
    let pairs = left.colour.par_iter().zip(&right.colour);
    pairs.map(|(left, right)| tonemap::srgb8_colour(anaglyph::red_cyan(*left, *right))).collect()
}

/// Both views beside each other, the left one on the left.
pub fn side_by_side(images: &StereoImages) -> Vec<[u8; 3]> {
    let [left, right] = images.views.each_ref().map(|view| srgb8(&view.colour));
    let width = images.width as usize;
    left.chunks(width).zip(right.chunks(width)).flat_map(|(left, right)| [left, right].concat()).collect()
}

/// Writes the file `name`; `pixels` has `width · height` elements.
pub fn write(
    batch: &mut Batch,
    name: &str,
    [width, height]: [u32; 2],
    pixels: &[[u8; 3]],
) -> Result<(), OutputError> {
    batch.write(name, |file, path| {
        PngEncoder::new(file)
            .write_image(pixels.as_flattened(), width, height, image::ExtendedColorType::Rgb8)
            .map_err(|source| OutputError::Png { path: path.to_owned(), source })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::ViewImages;

    fn pair(left: [[f32; 3]; 2], right: [[f32; 3]; 2]) -> StereoImages {
        let view = |colour: [[f32; 3]; 2]| ViewImages { colour: colour.to_vec(), ..ViewImages::default() };
        StereoImages { width: 1, height: 2, views: [view(left), view(right)] }
    }

    #[test]
    fn views_stand_beside_each_other_row_by_row() {
        let images = pair([[0.0; 3], [0.2; 3]], [[0.5; 3], [1.0; 3]]);
        assert_eq!(side_by_side(&images), [0, 188, 124, 255].map(|value| [value; 3]));
    }

    #[test]
    fn the_left_view_is_red() {
        let images = pair([[1.0; 3], [0.0; 3]], [[0.0; 3], [1.0; 3]]);
        let [first, second] = anaglyph(&images)[..] else { panic!("two pixels") };
        assert!(first[0] > 250 && first[1] == 0 && first[2] == 0, "{first:?}");
        assert!(second[0] == 0 && second[1] > 250 && second[2] > 250, "{second:?}");
    }
}
