//! How the second view of a pair is made.

use super::sampling::Samples;
use super::{RenderError, SceneData};
use clap::ValueEnum;
use parallax_shared::effects::Effects;
use std::num::NonZeroU32;
use std::str::FromStr;

/// A method of rendering a stereo pair: one view, the source, is traced, and the other one made from it.
///
/// All but the first two trace what the source does not tell. They differ in how they find, for each pixel, the
/// source's column that shows the same point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Both views are fully traced: the reference (Al-Hagri 2012, §4.1).
    #[default]
    Naive,
    /// The source is copied: an imaginary lower bound of the time (Al-Hagri 2012, §4.1).
    Ideal,
    /// Each scan line from left to right, one after the other (Adelson and Hodges 1993).
    Scanline,
    /// Each scan line from right to left, where the first write stays (Adelson and Hodges 1993).
    ScanlineRtl,
    /// All scan lines at once (Es and İşler 2007; Al-Hagri 2012, §4.1).
    EsIsler,
    /// A gather table in one pass (Es 2008, §5.4.3).
    #[value(name = "gather-1")]
    Gather1,
    /// A scatter table, then the gather table (Es 2008, §5.4.2).
    #[value(name = "gather-2")]
    Gather2,
    /// A 3D buffer with a slot for each source that may land on a pixel (Al-Hagri 2012, §3.1.2.1).
    Buffer,
    /// An atomic maximum per pixel (Al-Hagri 2012, §3.1.2.2).
    Atomic,
    /// Everything is traced, with what the source shows as a hint: the pictures of `naive`, bit for bit.
    Guided,
}

/// Which candidates a ray of bounded length verifies: a nearer surface that the source does not show may hide them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Verify {
    /// None. Pixels in gaps are traced instead, as Adelson and Hodges do.
    None,
    /// Those in gaps and beside steps of depth.
    Edges,
    /// All.
    All,
}

/// How the second view knows which lights a point sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Shadows {
    /// The source's answer is reused.
    #[default]
    Reuse,
    /// Rays are traced for each pixel.
    Trace,
    /// The answers of `trace`, bit for bit, with fewer rays: none where nothing can hide a light from a whole tile, and what hides it
    /// from the source is tried first. For `naive` and `guided`, whose first view is made so, too.
    Prove,
}

/// Which view is the source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum First {
    /// The left one.
    #[default]
    Left,
    /// The right one.
    Right,
}

impl First {
    /// The eyes (0 left, 1 right): that of the source, and the other one.
    pub const fn eyes(self) -> [usize; 2] {
        match self {
            Self::Left => [0, 1],
            Self::Right => [1, 0],
        }
    }
}

/// How many slots a pixel has in the method `buffer`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Depth {
    /// As many as Lemma 1 asks for (Al-Hagri 2012, §3.1.2.1), by the nearest surface of the scene.
    #[default]
    Lemma,
    /// As many as the source's hits ask for.
    Adaptive,
    /// So many. The nearest of the sources that share a slot stays.
    Fixed(NonZeroU32),
}

impl FromStr for Depth {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "lemma" => Ok(Self::Lemma),
            "adaptive" => Ok(Self::Adaptive),
            number => number
                .parse()
                .map(Self::Fixed)
                .map_err(|_| "expected `lemma`, `adaptive` or a number of slots".into()),
        }
    }
}

/// Where the second view's reflections and refractions come from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Reflections {
    /// From rays of its own, behind the first level, which is reprojected (Adelson and Hodges 1993).
    #[default]
    Trace,
    /// From the source, where the rays of both eyes are at most so many degrees apart; else from rays (Es 2008, §5.5.2).
    Within(f32),
}

impl FromStr for Reflections {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let degrees = |text: &str| text.parse().ok().filter(|degrees| (0.0..=180.0).contains(degrees));
        match text {
            "trace" => Ok(Self::Trace),
            angle => degrees(angle).map(Self::Within).ok_or("expected `trace` or an angle in degrees".into()),
        }
    }
}

/// How a pair is rendered.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StereoOptions {
    /// The method.
    pub method: Method,
    /// What is verified; the method's own choice if it is not given.
    pub verify: Option<Verify>,
    /// How lights are looked for.
    pub shadows: Shadows,
    /// Which view is the source.
    pub first: First,
    /// Slots of a 3D buffer.
    pub depth: Depth,
    /// Where reflections come from.
    pub reflections: Reflections,
    /// Rays per pixel.
    pub samples: Samples,
}

/// What a value is called on the command line.
pub fn value_name(value: &impl ValueEnum) -> String {
    value.to_possible_value().map_or_else(String::new, |value| value.get_name().into())
}

impl From<Method> for StereoOptions {
    fn from(method: Method) -> Self {
        Self { method, ..Self::default() }
    }
}

impl Method {
    /// Its name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Naive => "naive",
            Self::Ideal => "ideal",
            Self::Scanline => "scanline",
            Self::ScanlineRtl => "scanline-rtl",
            Self::EsIsler => "es-isler",
            Self::Gather1 => "gather-1",
            Self::Gather2 => "gather-2",
            Self::Buffer => "buffer",
            Self::Atomic => "atomic",
            Self::Guided => "guided",
        }
    }

    /// Whether the second view has points of the first one.
    pub const fn reuses(self) -> bool {
        !matches!(self, Self::Naive | Self::Ideal | Self::Guided)
    }

    /// What the papers verify with it: Al-Hagri everything, the others nothing.
    const fn usual_verification(self) -> Verify {
        match self {
            Self::Buffer | Self::Atomic => Verify::All,
            _ => Verify::None,
        }
    }
}

impl StereoOptions {
    /// What is verified.
    pub fn verify(&self) -> Verify {
        self.verify.unwrap_or(self.method.usual_verification())
    }

    /// Whether the second view's colours are the source's where it shows the same point: not where they depend on the
    /// viewer.
    pub(super) fn copies_colours(&self, data: &SceneData) -> bool {
        self.shadows == Shadows::Reuse && !data.effects.has(Effects::SPECULAR)
    }

    /// Whether the options go together.
    ///
    /// # Errors
    /// When they do not.
    pub fn check(&self) -> Result<(), RenderError> {
        let wrong = |what| Err(RenderError::Options { method: self.method.name(), what });
        match self.method {
            method if !method.reuses() && self.verify.is_some() => {
                wrong("has no candidates that could be verified")
            }
            Method::Ideal if self.shadows != Shadows::Reuse => wrong("traces nothing in the second view"),
            method if self.shadows == Shadows::Prove && !matches!(method, Method::Naive | Method::Guided) => {
                wrong("has no proofs of shadows; `naive` and `guided` have")
            }
            method if !method.reuses() && self.reflections != Reflections::Trace => {
                wrong("reuses no reflections")
            }
            method if method != Method::Buffer && self.depth != Depth::default() => wrong("has no slots"),
            _ if self.samples == Samples::One => Ok(()),
            Method::Guided => wrong("has one ray per pixel"),
            _ if self.shadows != Shadows::Reuse => {
                wrong("reuses the shadows of points where a pixel has several")
            }
            _ if self.reflections != Reflections::Trace => {
                wrong("traces the reflections of points where a pixel has several")
            }
            _ => self.samples.check(),
        }
    }

    /// Whether pictures of `data` can have so many points.
    ///
    /// # Errors
    /// When they cannot.
    pub fn check_size(&self, data: &SceneData) -> Result<(), RenderError> {
        self.samples.grid().map_or(Ok(()), |grid| grid.checked_view(&data.views[0]).map(|_| ()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_command_line() {
        for method in Method::value_variants() {
            assert_eq!(method.to_possible_value().unwrap().get_name(), method.name());
        }
    }

    #[test]
    fn depths_are_words_or_numbers() {
        assert_eq!("lemma".parse(), Ok(Depth::Lemma));
        assert_eq!("3".parse(), Ok(Depth::Fixed(NonZeroU32::new(3).unwrap())));
        for wrong in ["", "0", "-1", "deep"] {
            assert!(wrong.parse::<Depth>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn reflections_are_traced_or_within_an_angle() {
        assert_eq!("trace".parse(), Ok(Reflections::Trace));
        assert_eq!("0.5".parse(), Ok(Reflections::Within(0.5)));
        for wrong in ["", "-1", "181", "NaN", "all"] {
            assert!(wrong.parse::<Reflections>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn options_that_mean_nothing_are_refused() {
        let refused = |options: StereoOptions| options.check().unwrap_err().to_string();
        let naive = StereoOptions::default();
        assert!(naive.check().is_ok());
        let told = refused(StereoOptions { verify: Some(Verify::All), ..naive });
        assert_eq!(told, "the method `naive` has no candidates that could be verified");
        let told = refused(StereoOptions { depth: Depth::Adaptive, ..Method::Atomic.into() });
        assert_eq!(told, "the method `atomic` has no slots");
        assert!(StereoOptions { depth: Depth::Adaptive, ..Method::Buffer.into() }.check().is_ok());
        let nine = |method: Method| StereoOptions { samples: Samples::Nine, ..method.into() };
        assert!(nine(Method::Naive).check().is_ok() && nine(Method::Atomic).check().is_ok());
        assert_eq!(refused(nine(Method::Guided)), "the method `guided` has one ray per pixel");
        let traced = StereoOptions { shadows: Shadows::Trace, ..nine(Method::Atomic) };
        assert!(refused(traced).contains("reuses the shadows"));
        let proving = |method: Method| StereoOptions { shadows: Shadows::Prove, ..method.into() };
        let told = refused(proving(Method::Atomic));
        assert_eq!(told, "the method `atomic` has no proofs of shadows; `naive` and `guided` have");
        assert!(proving(Method::Naive).check().is_ok() && proving(Method::Guided).check().is_ok());
        let sampled = StereoOptions { samples: Samples::Nine, ..proving(Method::Naive) };
        assert!(refused(sampled).contains("reuses the shadows"));
    }
}
