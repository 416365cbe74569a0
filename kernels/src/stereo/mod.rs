//! The second view from the first.

pub mod copy;
pub mod gloss;
pub mod guided;
pub mod inherit;
pub mod light;
pub mod recall;
pub mod scanline;
pub mod scanline_rtl;
pub mod settle;
pub mod shadow_guided;
pub mod shifts;
pub mod slots;
pub mod splat;
pub mod tables;
pub mod trace;
