//! Pictures: textures (PNG, JPEG, TGA, BMP) and skies (Radiance HDR), decoded to linear light.

use std::io::Cursor;
use std::path::Path;
use std::sync::LazyLock;

use image::{DynamicImage, ImageDecoder, ImageReader};

use super::{Picture, SceneError, files};

/// The largest file that is read: 256 MiB.
const MAX_BYTES: u64 = 1 << 28;

/// The most texels of a picture: 32 Mi, 512 MiB once decoded.
const MAX_TEXELS: u64 = 1 << 25;

/// The largest value of a texel; what is brighter in a sky is cut to it, so that no sum of weighted texels
/// overflows.
const MAX_VALUE: f32 = 1e6;

impl Picture {
    /// Reads a picture. Values of up to 16 bits are taken for sRGB, floating-point ones for linear; the
    /// format is told by the content, and by the suffix where the content does not tell (TGA).
    ///
    /// # Errors
    /// When the file cannot be read, is in no known format, is cut short, or holds more than 32 Mi texels
    /// (said before anything of that size is allocated).
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let bytes = files::read(path, MAX_BYTES)?;
        let wrong = |message: String| SceneError::Picture { path: path.into(), message };
        let mut reader = ImageReader::new(Cursor::new(&bytes));
        if let Ok(format) = image::ImageFormat::from_path(path) {
            reader.set_format(format);
        }
        let reader = reader.with_guessed_format().map_err(|e| wrong(e.to_string()))?;
        let decoder = reader.into_decoder().map_err(|e| wrong(e.to_string()))?;
        let (width, height) = decoder.dimensions();
        let texels = u64::from(width) * u64::from(height);
        if texels == 0 || texels > MAX_TEXELS {
            return Err(wrong(format!("{width}×{height} texels; between 1 and {MAX_TEXELS} are accepted")));
        }
        let decoded = DynamicImage::from_decoder(decoder).map_err(|e| wrong(e.to_string()))?;
        Ok(Self { width, height, texels: linear(decoded) })
    }
}

fn linear(picture: DynamicImage) -> Vec<[f32; 4]> {
    match picture {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let value = |x: f32| if x.is_finite() { x.clamp(0.0, MAX_VALUE) } else { 0.0 };
            picture.into_rgba32f().pixels().map(|p| p.0.map(value)).collect()
        }
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            let value = |x: u16| srgb_to_linear(f64::from(x) / 65535.0);
            let texel = |[r, g, b, a]: [u16; 4]| [value(r), value(g), value(b), f32::from(a) / 65535.0];
            picture.into_rgba16().pixels().map(|p| texel(p.0)).collect()
        }
        _ => {
            let value = |x: u8| SRGB[usize::from(x)];
            let texel = |[r, g, b, a]: [u8; 4]| [value(r), value(g), value(b), f32::from(a) / 255.0];
            picture.into_rgba8().pixels().map(|p| texel(p.0)).collect()
        }
    }
}

/// Linear values of the 256 sRGB values.
static SRGB: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|i| srgb_to_linear(i as f64 / 255.0)));

/// The transfer function of IEC 61966-2-1, in f64 and then rounded.
fn srgb_to_linear(value: f64) -> f32 {
    let linear = if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
    linear as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_the_transfer_function() {
        assert_eq!((SRGB[0], SRGB[255]), (0.0, 1.0));
        assert_eq!(SRGB[10], (10.0 / 255.0 / 12.92) as f32);
        assert!((SRGB[188] - 0.502_886_4).abs() < 1e-6);
        assert!(SRGB.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn eight_and_sixteen_bits_agree() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("a.png");
        image::RgbImage::from_pixel(2, 3, image::Rgb([255, 188, 10])).save(&path).unwrap();
        let eight = Picture::load(&path).unwrap();
        image::ImageBuffer::from_pixel(2, 3, image::Rgb([65535_u16, 188 * 257, 10 * 257]))
            .save(&path)
            .unwrap();
        let sixteen = Picture::load(&path).unwrap();
        assert_eq!(eight, sixteen);
        assert_eq!((eight.width, eight.height, eight.texels.len()), (2, 3, 6));
        assert_eq!(eight.texels[0], [1.0, SRGB[188], SRGB[10], 1.0]);
    }

    #[test]
    fn a_size_that_lies_is_refused_before_it_is_allocated() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("a.hdr");
        std::fs::write(&path, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n").unwrap();
        let error = Picture::load(&path).unwrap_err().to_string();
        assert!(error.contains("2000000000×2000000000 texels"), "{error}");
    }
}
