//! Links Embree where the feature asks for it, and lists the committed kernel modules as `include_bytes!` for `backend::gpu::modules`.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    // What `parallax bench traversal` compares with (Debian: libembree-dev).
    if env::var_os("CARGO_FEATURE_EMBREE").is_some() {
        println!("cargo::rustc-link-lib=dylib=embree3");
    }
    embed_modules()
}

/// Writes `modules.rs`: every `spirv/PROFILE/NAME.spv` of the kernels, with its WGSL text where there is one.
fn embed_modules() -> io::Result<()> {
    let directory = Path::new(&environment("CARGO_MANIFEST_DIR")).join("../kernels/spirv");
    println!("cargo::rerun-if-changed={}", directory.display());
    let mut table = String::from("static EMBEDDED: &[Embedded] = &[\n");
    for profile in ["strict", "fast"] {
        for module in modules(&directory.join(profile))? {
            println!("cargo::rerun-if-changed={}", module.display());
            write_entry(&mut table, profile, &module);
        }
    }
    table.push_str("];\n");
    fs::write(Path::new(&environment("OUT_DIR")).join("modules.rs"), table)
}

fn write_entry(table: &mut String, profile: &str, module: &Path) {
    let wgsl = module.with_extension("wgsl");
    let wgsl = if wgsl.exists() { format!("Some(include_str!({wgsl:?}))") } else { "None".into() };
    let name = module.file_stem().unwrap_or_default();
    let profile = if profile == "strict" { "Strict" } else { "Fast" };
    // Writing to a string cannot fail.
    let _ = writeln!(
        table,
        "    Embedded {{ profile: Profile::{profile}, name: {name:?}, spirv: include_bytes!({module:?}), wgsl: {wgsl} }},"
    );
}

/// The `.spv` files of a directory, in order; none if there is no directory.
fn modules(directory: &Path) -> io::Result<Vec<PathBuf>> {
    if !directory.exists() {
        return Ok(Vec::new());
    }
    let paths = fs::read_dir(directory)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    let mut modules: Vec<_> =
        paths.into_iter().filter(|path| path.extension().is_some_and(|e| e == "spv")).collect();
    modules.sort();
    Ok(modules)
}

/// A variable that cargo sets for every build script.
fn environment(name: &str) -> String {
    env::var(name).unwrap_or_default()
}
