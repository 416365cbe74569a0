//! Device code of a kernel crate, made when a test asks for it: so it cannot be out of date.

use kernel_compiler::{CrateSource, Options, Profile, compile};
use parallax::backend;
use parallax::backend::gpu::{Module, Modules};

/// The modules of the crate in the folder `directory`, in `profile`; in the fast one with WGSL.
///
/// # Panics
/// When the crate cannot be compiled.
pub fn modules(directory: &str, profile: backend::Profile) -> Modules {
    let (profile, wgsl) = match profile {
        backend::Profile::Strict => (Profile::Strict, false),
        backend::Profile::Fast => (Profile::Fast, true),
    };
    let options = Options { profiles: vec![profile], wgsl, ..Options::default() };
    let compiled = compile(&CrateSource::new(directory), &options)
        .unwrap_or_else(|error| panic!("{directory} cannot be compiled: {error}"));
    let mut modules = Modules::default();
    for entry in compiled.entries {
        let wgsl = entry.wgsl.map(Into::into);
        modules.insert(entry.name, Module { spirv: entry.spirv.into(), wgsl });
    }
    modules
}
