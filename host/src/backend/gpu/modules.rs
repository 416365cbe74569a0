//! The device code of each entry point. That of `parallax-kernels` is part of the host's binary.

use crate::backend::Profile;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// An entry point's module as `build.rs` lists it.
struct Embedded {
    profile: Profile,
    name: &'static str,
    spirv: &'static [u8],
    wgsl: Option<&'static str>,
}

include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// The code of one entry point, whose name in the code is that of the pass.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Module {
    /// SPIR-V, handed to the driver as it is. Empty if there is only WGSL.
    pub spirv: Cow<'static, [u32]>,
    /// WGSL, for adapters that take no SPIR-V, in the fast profile alone.
    pub wgsl: Option<Cow<'static, str>>,
}

impl Module {
    /// The module in the file contents `bytes` (little-endian words, as `kernel-compiler` writes them).
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let words =
            bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
        Self { spirv: words.collect(), wgsl: None }
    }
}

/// Modules by entry point.
#[derive(Clone, Debug, Default)]
pub struct Modules(BTreeMap<String, Module>);

impl Modules {
    /// The modules of `parallax-kernels` for `profile`.
    pub fn embedded(profile: Profile) -> Self {
        let modules = EMBEDDED.iter().filter(|embedded| embedded.profile == profile).map(|embedded| {
            let wgsl = embedded.wgsl.map(Cow::Borrowed);
            (embedded.name.to_string(), Module { wgsl, ..Module::from_bytes(embedded.spirv) })
        });
        Self(modules.collect())
    }

    /// Adds the code of `entry`, or puts it in the place of what is there.
    pub fn insert(&mut self, entry: impl Into<String>, module: Module) {
        self.0.insert(entry.into(), module);
    }

    /// The code of `entry`.
    pub fn get(&self, entry: &str) -> Option<&Module> {
        self.0.get(entry)
    }

    /// Names of the entry points.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
