//! The second view from the first.

pub mod reprojection;
pub mod run;
pub mod scanline;
pub mod scanline_rtl;
pub mod shifts;
pub mod slots;
pub mod splat;
