//! From linear colours to what a screen or a pair of coloured glasses shows.
//!
//! * [`tonemap`]: linear light to 8 bit sRGB, correctly rounded.
//! * [`anaglyph`]: two views in one red/cyan picture.

pub mod anaglyph;
pub mod tonemap;
