//! The two arithmetics in which a crate can be compiled.

use serde::{Deserialize, Serialize};

/// Which freedom a driver has with floating-point operations.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Profile {
    /// Every float operation is decorated `NoContraction`, and `min` and `max` are compare-and-select as on
    /// x86: the CPU's bits.
    Strict,
    /// The driver contracts as it likes and has its own `min` and `max`. The crate's feature `fast`, if it
    /// has one, is on. Has WGSL.
    Fast,
}

impl Profile {
    /// Both, strict first.
    pub const ALL: [Profile; 2] = [Profile::Strict, Profile::Fast];

    /// The name in manifests, on the command line, and of the folder in which the modules lie.
    pub fn name(self) -> &'static str {
        match self {
            Profile::Strict => "strict",
            Profile::Fast => "fast",
        }
    }
}

impl std::fmt::Display for Profile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
