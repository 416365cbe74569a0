//! Values of a scene file that know their range: what lies outside is an error at its place in the file.

use serde::de::{Deserialize, Deserializer, Error};

/// Declares a type around a number, or a triple of numbers, each of which must pass a test.
macro_rules! ranged {
    ($($(#[$doc:meta])* $name:ident($kind:ty), $expected:literal, $test:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name(pub $kind);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let value = <$kind>::deserialize(deserializer)?;
                let test: fn($kind) -> bool = $test;
                if test(value) { Ok(Self(value)) } else {
                    Err(D::Error::custom(format!(concat!("expected ", $expected, ", found {:?}"), value)))
                }
            }
        }
    )*};
}

/// The largest coordinate or length of a scene file, world units.
const MAX: f32 = 1e12;

ranged! {
    /// A length greater than zero.
    Length(f32), "a length between 1e-12 and 1e12", |x| (1.0 / MAX..=MAX).contains(&x);
    /// A factor greater than zero.
    Factor(f32), "a factor between 1e-6 and 1e6", |x| (1e-6..=1e6).contains(&x);
    /// A weight or fraction.
    Weight(f32), "a number between 0 and 1", |x| (0.0..=1.0).contains(&x);
    /// A Phong exponent.
    Shininess(f32), "an exponent between 0 and 10000", |x| (0.0..=10_000.0).contains(&x);
    /// A ratio of indices of refraction.
    Eta(f32), "an index of refraction between 0.1 and 10", |x| (0.1..=10.0).contains(&x);
    /// An angle of view, degrees.
    Fov(f32), "an angle between 1 and 170 degrees", |x| (1.0..=170.0).contains(&x);
    /// An angle between faces, degrees.
    Crease(f32), "an angle between 0 and 180 degrees", |x| (0.0..=180.0).contains(&x);
    /// An angle, degrees.
    Angle(f32), "an angle between -36000 and 36000 degrees", |x| x.abs() <= 36_000.0;
    /// Squares of a checkerboard per world unit.
    Frequency(f32), "a number between 0 and 1e6", |x| (0.0..=1e6).contains(&x);
    /// Pixels between the eyes.
    Interaxial(f32), "a number of pixels between 0 and 10000", |x| (0.0..=10_000.0).contains(&x);
    /// Rows or columns of a picture.
    Pixels(u32), "a number of pixels between 1 and 16384", |x| (1..=16_384).contains(&x);
    /// Levels of reflection and refraction.
    Depth(u32), "a depth between 0 and 16", |x| x <= 16;
    /// Flat sides of what is round.
    Segments(u32), "a number of segments between 3 and 1024", |x| (3..=1024).contains(&x);
    /// A point or direction, world units.
    Point([f32; 3]), "three numbers between -1e12 and 1e12", |v| v.iter().all(|x| x.abs() <= MAX);
    /// Angles about x, y and z, degrees.
    Angles([f32; 3]), "three angles between -36000 and 36000 degrees", |v| v.iter().all(|x| x.abs() <= 36_000.0);
    /// Three lengths greater than zero.
    Lengths([f32; 3]), "three lengths between 1e-12 and 1e12", |v| v.iter().all(|x| (1.0 / MAX..=MAX).contains(x));
    /// A linear colour of a surface.
    Colour([f32; 3]), "a colour: three numbers between 0 and 1", |v| v.iter().all(|x| (0.0..=1.0).contains(x));
    /// A linear colour of light.
    Radiance([f32; 3]), "a colour of light: three numbers between 0 and 1e6",
        |v| v.iter().all(|x| (0.0..=1e6).contains(x));
    /// Texture coordinates.
    Uv([f32; 2]), "two numbers between -1e6 and 1e6", |v| v.iter().all(|x| x.abs() <= 1e6);
    /// Smallest and largest length.
    Range([f32; 2]), "two lengths between 1e-12 and 1e12, the smaller one first",
        |[low, high]| 1.0 / MAX <= low && low <= high && high <= MAX;
}
