//! How many rays a frame traces.

use parallax_shared::layout::RayCounts;
use serde::Serialize;
use std::ops::AddAssign;

/// Rays of a picture, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RayTotals {
    /// From the eye.
    pub primary: u64,
    /// To a light.
    pub shadow: u64,
    /// In mirror direction.
    pub reflected: u64,
    /// Through a surface.
    pub refracted: u64,
}

impl RayTotals {
    /// All kinds together.
    pub fn all(&self) -> u64 {
        self.primary + self.shadow + self.reflected + self.refracted
    }
}

impl AddAssign for RayTotals {
    fn add_assign(&mut self, other: Self) {
        self.primary += other.primary;
        self.shadow += other.shadow;
        self.reflected += other.reflected;
        self.refracted += other.refracted;
    }
}

impl AddAssign<&[RayCounts]> for RayTotals {
    fn add_assign(&mut self, pixels: &[RayCounts]) {
        for pixel in pixels {
            self.primary += u64::from(pixel.primary);
            self.shadow += u64::from(pixel.shadow);
            self.reflected += u64::from(pixel.reflected);
            self.refracted += u64::from(pixel.refracted);
        }
    }
}
