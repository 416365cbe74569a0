//! The library API and the command, on small crates without dependencies that are written here.

use kernel_compiler::interpret::{Arguments, run};
use kernel_compiler::{CompileError, Compiled, CrateSource, Manifest, Options, Profile, compile};
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

const MANIFEST: &str = "\
[package]
name = \"tiny\"
edition = \"2024\"
[features]
device = []
fast = []
[profile.kernel]
inherits = \"release\"
panic = \"abort\"
codegen-units = 1
[workspace]
";

/// What `kernel-api`'s attribute would write.
const SHIM: &str = "\
#![no_std]
unsafe extern \"C\" {
    fn __k_threads(x: u32, y: u32, z: u32);
    fn __k_builtin(kind: u32, component: u32) -> u32;
    fn __k_root(kind: u32, set: u32, binding: u32, size: u32, align: u32) -> *mut u8;
}
";

/// `out[i] = in[i] * factor`, where the factor depends on the profile.
const SCALE: &str = "\
#[unsafe(no_mangle)]
pub extern \"C\" fn __kernel_scale() {
    unsafe {
        __k_threads(8, 1, 1);
        let (input, output) = (__k_root(0, 0, 0, 4, 4) as *const u32, __k_root(1, 0, 1, 4, 4) as *mut u32);
        let i = __k_builtin(0, 0) as usize;
        *output.add(i) = (*input.add(i)).wrapping_mul(if cfg!(feature = \"fast\") { 3 } else { 5 });
    }
}
";

/// Kernels with f64, and with a function that is not inlined.
const REFUSED: &str = "\
#[inline(never)]
fn collatz(n: u32) -> u32 { if n < 2 { 0 } else { 1 + collatz(if n % 2 == 0 { n / 2 } else { 3 * n + 1 }) + collatz(n / 2) } }
#[unsafe(no_mangle)]
pub extern \"C\" fn __kernel_double() {
    unsafe {
        __k_threads(1, 1, 1);
        let output = __k_root(1, 0, 0, 4, 4) as *mut u32;
        let x = *output;
        *output.add(1) = (x as f64 * 0.3) as u32;
    }
}
#[unsafe(no_mangle)]
pub extern \"C\" fn __kernel_recursive() {
    unsafe {
        __k_threads(1, 1, 1);
        let output = __k_root(1, 0, 0, 4, 4) as *mut u32;
        *output.add(1) = collatz(*output);
    }
}
";

fn made_crate(source: &str) -> TempDir {
    let dir = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).expect("a file");
    std::fs::create_dir(dir.path().join("src")).expect("a folder");
    write("Cargo.toml", MANIFEST);
    write("src/lib.rs", &format!("{SHIM}{source}"));
    dir
}

fn compiled(dir: &Path) -> Compiled {
    let options = Options { profiles: Profile::ALL.to_vec(), wgsl: true, ..Options::default() };
    compile(&CrateSource::new(dir), &options).expect("the crate compiles")
}

fn command(source: &Path, out: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kernel-compiler"));
    command.arg(source).arg("--out").arg(out).args(more).output().expect("the command runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn another_folder_gives_the_same_bytes() {
    let (one, other) = (made_crate(SCALE), made_crate(SCALE));
    let (one, other) = (compiled(one.path()), compiled(other.path()));
    assert_eq!(one.files(), other.files());
    let names: Vec<_> = one.files().keys().map(|path| path.display().to_string()).collect();
    assert_eq!(names, ["fast/scale.spv", "fast/scale.wgsl", "manifest.json", "strict/scale.spv"]);
}

#[test]
fn each_profile_computes_what_its_feature_says() {
    let dir = made_crate(SCALE);
    for entry in compiled(dir.path()).entries {
        let mut arguments = Arguments::default();
        arguments.buffers.insert((0, 0), (0..16).collect());
        arguments.buffers.insert((0, 1), vec![0; 16]);
        run(&entry.kernel, [2, 1, 1], &mut arguments).expect("the kernel runs");
        let factor = if entry.profile == Profile::Fast { 3 } else { 5 };
        let expected: Vec<u32> = (0..16).map(|i| i * factor).collect();
        assert_eq!(arguments.buffers[&(0, 1)], expected, "{}", entry.profile);
    }
}

#[test]
fn check_names_what_differs_and_writes_nothing() {
    let (dir, out) = (made_crate(SCALE), tempfile::tempdir().expect("a temporary folder"));
    let out = out.path();
    let missing = command(dir.path(), out, &["--check"]);
    assert_eq!(missing.status.code(), Some(1), "{}", said(&missing));
    assert!(said(&missing).contains("manifest.json is missing") && !out.join("manifest.json").exists());

    let written = command(dir.path(), out, &["--wgsl"]);
    assert_eq!(written.status.code(), Some(0), "{}", said(&written));
    let manifest = std::fs::read_to_string(out.join("manifest.json")).expect("a manifest");
    let manifest = Manifest::from_json(&manifest).expect("a manifest that can be read");
    assert_eq!(manifest.entries.len(), 2);
    let fresh = command(dir.path(), out, &["--wgsl", "--check"]);
    assert_eq!(fresh.status.code(), Some(0), "{}", said(&fresh));

    let module = out.join("strict/scale.spv");
    let mut bytes = std::fs::read(&module).expect("a module");
    bytes[40] ^= 1;
    std::fs::write(&module, &bytes).expect("a file");
    let differs = command(dir.path(), out, &["--wgsl", "--check"]);
    assert_eq!(differs.status.code(), Some(1), "{}", said(&differs));
    let message = said(&differs);
    assert!(message.contains("strict/scale.spv differs") && !message.contains("fast/scale.spv differs"));
    assert_eq!(std::fs::read(&module).expect("a module"), bytes);
}

#[test]
fn all_problems_of_a_crate_come_together() {
    let (dir, out) = (made_crate(REFUSED), tempfile::tempdir().expect("a temporary folder"));
    let error = compile(&CrateSource::new(dir.path()), &Options::default()).expect_err("refusals");
    let CompileError::Refused(refusals) = &error else { panic!("{error}") };
    let of = |name: &str| refusals.iter().find(|refusal| refusal.entry == name);
    assert!(of("double").is_some() && of("recursive").is_some(), "{error}");
    let output = command(dir.path(), out.path(), &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("kernel `double`") && said(&output).contains("kernel `recursive`"));
    assert!(std::fs::read_dir(out.path()).expect("a folder").next().is_none(), "nothing is written");
}

#[test]
fn bad_usage_has_a_status_of_its_own() {
    let (dir, out) = (made_crate(SCALE), tempfile::tempdir().expect("a temporary folder"));
    let status = |source: &Path, more: &[&str]| command(source, out.path(), more).status.code();
    assert_eq!(status(out.path(), &[]), Some(2), "no crate");
    assert_eq!(status(dir.path(), &["--profile", "strict", "--wgsl"]), Some(2), "no WGSL in strict");
    assert_eq!(status(dir.path(), &["--only", "scale,other"]), Some(2), "no such kernel");
    assert_eq!(status(dir.path(), &["--fancy"]), Some(2), "no such option");
}
