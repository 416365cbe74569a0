//! How many rays a pixel has.

use super::Grid;
use crate::render::RenderError;
use std::fmt;
use std::str::FromStr;

/// By how much colours differ that ask for more rays, where nobody says otherwise: of what a screen can show, linear.
pub const TOLERANCE: f32 = 1.0 / 16.0;

/// Most points of a pixel in a row of its own.
const MOST_JITTERED: u32 = 8;

/// Most levels of adaptive sampling: 17 × 17 points.
const MOST_LEVELS: u32 = 4;

/// The rays of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Samples {
    /// One, through its centre.
    #[default]
    One,
    /// Nine: corners, middles of edges, and the centre, whose ray aims (001, "Extending to multiple rays per pixel").
    Nine,
    /// n × n, each jittered in its part of the pixel and reprojected on its own row (001, "Reflection and refraction with multiple rays
    /// per pixel").
    Jittered(u32),
    /// The corners, and up to (2ᵏ + 1)² where they differ (001, fig. 11).
    Adaptive {
        /// k. 001 counts the corners as a level and says one more.
        levels: u32,
        /// By how much colours in [0, 1] differ that ask for more.
        tolerance: f32,
    },
}

impl Samples {
    /// The places of the rays; none for a single one.
    pub fn grid(self) -> Option<Grid> {
        let (per_pixel, shares_edges, aims, levels) = match self {
            Self::One => return None,
            Self::Nine => (2, true, true, 0),
            Self::Jittered(n) => (n, false, false, 0),
            Self::Adaptive { levels, .. } => (1 << levels, true, false, levels),
        };
        Some(Grid { per_pixel, shares_edges, aims, levels })
    }

    /// By how much colours differ that ask for more rays.
    pub(in crate::render) fn tolerance(self) -> f32 {
        if let Self::Adaptive { tolerance, .. } = self { tolerance } else { 0.0 }
    }

    /// Whether there can be so many.
    ///
    /// # Errors
    /// When not.
    pub fn check(self) -> Result<(), RenderError> {
        let possible = match self {
            Self::One | Self::Nine => true,
            Self::Jittered(n) => (1..=MOST_JITTERED).contains(&n),
            Self::Adaptive { levels, tolerance } => (1..=MOST_LEVELS).contains(&levels) && tolerance >= 0.0,
        };
        if possible { Ok(()) } else { Err(RenderError::Samples { samples: self.to_string() }) }
    }
}

impl FromStr for Samples {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse().ok();
        let jittered = || {
            let (columns, rows) = text.split_once('x')?;
            number(columns).filter(|n| number(rows) == Some(*n)).map(Self::Jittered)
        };
        let adaptive = || {
            let levels = number(text.strip_prefix("adaptive-")?)?;
            Some(Self::Adaptive { levels, tolerance: TOLERANCE })
        };
        let samples = match text {
            "1" => Some(Self::One),
            "nine" => Some(Self::Nine),
            _ => jittered().or_else(adaptive),
        };
        let expected = || {
            format!(
                "expected 1, nine, 2x2 to {MOST_JITTERED}x{MOST_JITTERED}, or adaptive-1 to adaptive-{MOST_LEVELS}"
            )
        };
        samples.filter(|samples| samples.check().is_ok()).ok_or_else(expected)
    }
}

impl fmt::Display for Samples {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::One => write!(f, "1"),
            Self::Nine => write!(f, "nine"),
            Self::Jittered(n) => write!(f, "{n}x{n}"),
            Self::Adaptive { levels, tolerance } => {
                write!(f, "adaptive-{levels}")?;
                if *tolerance == TOLERANCE { Ok(()) } else { write!(f, " within {tolerance}") }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_read_as_they_are_told() {
        let adaptive = Samples::Adaptive { levels: 2, tolerance: TOLERANCE };
        for samples in [Samples::One, Samples::Nine, Samples::Jittered(3), adaptive] {
            assert_eq!(samples.to_string().parse(), Ok(samples));
        }
        for wrong in ["", "0", "2", "3x4", "0x0", "9x9", "x", "adaptive", "adaptive-0", "adaptive-5", "Nine"]
        {
            assert!(wrong.parse::<Samples>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn tolerances_are_told_and_must_be_numbers() {
        let within = |tolerance| Samples::Adaptive { levels: 1, tolerance };
        assert_eq!(within(0.5).to_string(), "adaptive-1 within 0.5");
        assert!(within(0.0).check().is_ok());
        let told = within(f32::NAN).check().unwrap_err().to_string();
        assert!(told.contains("adaptive-1 within NaN"), "{told}");
    }
}
