//! How the second view of a pair is made.

use clap::ValueEnum;

/// A method of rendering a stereo pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// Both views are fully traced: the reference (Al-Hagri 2012, §4.1).
    #[default]
    Naive,
}

impl Method {
    /// Its name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Naive => "naive",
        }
    }
}
