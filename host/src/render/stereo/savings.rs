//! How many of a second view's rays reprojection saves at least (001, "worst case analysis").
//!
//! 001 gives a formula for each kind of scene. They are one: of the rays behind a pixel, those of the first surface need not be traced
//! for a pixel that is reused. In print the exponents of (1 + S)v and (1 + S)L are damaged, "(1 + S)^v"; the closed forms for L = 5
//! (20 and 3.226 per cent) only follow from the products.

use serde::Serialize;

/// What rays do at the surfaces of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Surfaces {
    /// There are none, or they only scatter light.
    #[serde(rename = "diffuse")]
    Diffuse,
    /// They also reflect, or also transmit.
    #[serde(rename = "diffuse and reflective or refractive")]
    DiffuseWithOne,
    /// They also reflect and transmit.
    #[serde(rename = "diffuse, reflective and refractive")]
    DiffuseWithBoth,
    /// They only reflect, or only transmit.
    #[serde(rename = "reflective or refractive")]
    One,
    /// They reflect and transmit, and scatter nothing.
    #[serde(rename = "reflective and refractive")]
    Both,
}

impl Surfaces {
    /// All kinds, in the order of 001.
    pub const ALL: [Self; 5] =
        [Self::Diffuse, Self::DiffuseWithOne, Self::DiffuseWithBoth, Self::One, Self::Both];

    /// Rays that go on from a surface.
    const fn branches(self) -> u32 {
        match self {
            Self::Diffuse => 0,
            Self::DiffuseWithOne | Self::One => 1,
            Self::DiffuseWithBoth | Self::Both => 2,
        }
    }

    /// Rays to lights from a surface: their answers are worth something where light is scattered.
    const fn to_lights(self, lights: u32) -> u32 {
        match self {
            Self::Diffuse | Self::DiffuseWithOne | Self::DiffuseWithBoth => lights,
            Self::One | Self::Both => 0,
        }
    }

    /// Percentage of the rays of a second view that reprojection saves when every ray meets surfaces of this kind at the first
    /// `reached` (v) of at most `levels` (L) levels, with so many `lights` (S), and the fraction `traced` (M) of its pixels is traced.
    ///
    /// Without a reflected or transmitted ray there is one level. With v = 0 every ray misses, with v = L none does: the worst case.
    pub fn saved_percent(self, traced: f64, lights: u32, levels: u32, reached: u32) -> f64 {
        let per_surface = f64::from(1 + self.to_lights(lights));
        let (levels, reached) =
            if self.branches() == 0 { (1, reached.min(1)) } else { (levels, reached.min(levels)) };
        let rays_of_level = |level: u32| f64::from(self.branches()).powi(level as i32);
        let surfaces: f64 = (0..reached).map(rays_of_level).sum();
        let misses = if reached < levels { rays_of_level(reached) } else { 0.0 };
        let reusable = if reached == 0 { 1.0 } else { per_surface };
        100.0 * (1.0 - traced) * reusable / (surfaces * per_surface + misses)
    }

    /// [`saved_percent`](Self::saved_percent) when no ray misses.
    pub fn worst_case_percent(self, traced: f64, lights: u32, levels: u32) -> f64 {
        self.saved_percent(traced, lights, levels, levels)
    }
}

#[cfg(test)]
mod tests {
    use super::Surfaces;

    fn assert_near(actual: f64, expected: f64) {
        assert!((actual - expected).abs() < 1e-9, "{actual} instead of {expected}");
    }

    /// The table that 001 prints for L = 5.
    #[test]
    fn five_levels_save_what_001_prints() {
        let percents = Surfaces::ALL.map(|surfaces| surfaces.worst_case_percent(0.0, 3, 5));
        let printed = [100.0, 20.0, 3.226, 20.0, 3.226];
        assert_eq!(percents.map(|percent| (percent * 1000.0).round() / 1000.0), printed);
        for surfaces in Surfaces::ALL {
            assert_near(
                surfaces.worst_case_percent(0.25, 3, 5),
                0.75 * surfaces.worst_case_percent(0.0, 7, 5),
            );
        }
    }

    /// 001's formulas for v < L, term by term.
    #[test]
    fn rays_that_miss_save_what_001_derives() {
        let (traced, levels) = (0.1, 6);
        for lights in [0, 1, 4] {
            let s = f64::from(lights);
            for reached in 1..levels {
                let saved = |surfaces: Surfaces| surfaces.saved_percent(traced, lights, levels, reached);
                let (v, two) = (f64::from(reached), 2_f64.powi(reached as i32));
                assert_near(saved(Surfaces::DiffuseWithOne), 90.0 * (1.0 + s) / ((1.0 + s) * v + 1.0));
                assert_near(
                    saved(Surfaces::DiffuseWithBoth),
                    90.0 * (1.0 + s) / ((two - 1.0) * (1.0 + s) + two),
                );
                assert_near(saved(Surfaces::One), 90.0 * (1.0 - v / (v + 1.0)));
                assert_near(saved(Surfaces::Both), 90.0 / (2.0 * two - 1.0));
                assert_near(saved(Surfaces::Diffuse), 90.0);
            }
            for surfaces in Surfaces::ALL {
                assert_near(surfaces.saved_percent(traced, lights, levels, 0), 90.0);
            }
        }
    }
}
