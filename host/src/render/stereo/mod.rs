//! The second view from the first.

pub mod overlap;
pub mod savings;
