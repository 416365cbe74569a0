//! The second view from the first.

pub mod copy;
pub mod scanline;
pub mod scanline_rtl;
pub mod shifts;
pub mod slots;
pub mod splat;
pub mod tables;
