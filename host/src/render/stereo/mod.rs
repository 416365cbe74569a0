//! The second view from the first.

pub mod overlap;
