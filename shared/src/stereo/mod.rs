//! The second view from the first.

pub mod guided;
pub mod recall;
pub mod reprojection;
pub mod run;
pub mod scanline;
pub mod scanline_rtl;
pub mod settle;
pub mod shifts;
pub mod slots;
pub mod source;
pub mod splat;
