//! Every feature of the kernel compiler, on every machine: the interpreter and two drivers must write what the native run writes.

use kernel_compiler::{Compiled, CrateSource, Entry, Options, Profile, compile};
use parallax_tests::machines::{Case, Machine, check_spirv, check_wgsl, features, workspace};
use std::sync::OnceLock;

/// The crate, compiled once in both profiles.
fn compiled() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| {
        let source = CrateSource::new(workspace("kernels/compiler/tests/feature-kernels"));
        let options = Options { profiles: Profile::ALL.to_vec(), wgsl: true, ..Options::default() };
        compile(&source, &options).unwrap_or_else(|error| panic!("{error}"))
    })
}

fn entries(profile: Profile) -> impl Iterator<Item = &'static Entry> {
    compiled().entries.iter().filter(move |entry| entry.profile == profile)
}

fn entry(case: &Case, profile: Profile) -> &'static Entry {
    let found = entries(profile).find(|entry| entry.name == case.entry);
    found.unwrap_or_else(|| panic!("no module of `{}`", case.entry))
}

/// Runs all cases on a machine, and panics with everything that differs.
fn all_agree(machine: &Machine) {
    let cases = features::cases().unwrap();
    let check = |case: &Case| machine.check(case, entry(case, Profile::Strict));
    let troubles: Vec<String> = cases
        .iter()
        .filter_map(|case| check(case).err().map(|trouble| format!("{}: {trouble}", case.name)))
        .collect();
    assert!(
        troubles.is_empty(),
        "on {machine}, {} of {}:\n{}",
        troubles.len(),
        cases.len(),
        troubles.join("\n")
    );
}

#[test]
fn the_interpreter_agrees_with_the_native_run() {
    all_agree(&Machine::Interpreter(0));
}

#[test]
fn the_size_of_a_subgroup_changes_nothing() {
    for size in [1, 4, 32] {
        all_agree(&Machine::Interpreter(size));
    }
}

#[test]
fn lavapipe_agrees_with_the_native_run() {
    Machine::open(parallax_tests::gpu::Driver::Lavapipe).iter().for_each(all_agree);
}

#[test]
fn swiftshader_agrees_with_the_native_run() {
    Machine::open(parallax_tests::gpu::Driver::SwiftShader).iter().for_each(all_agree);
}

/// The kernels whose results do not depend on contraction agree in WGSL too.
#[test]
fn wgsl_agrees_where_no_floats_are() {
    let cases = features::cases().unwrap();
    for machine in parallax_tests::gpu::Driver::SOFTWARE.into_iter().filter_map(Machine::open) {
        for case in cases.iter().filter(|case| features::is_of_integers(case)) {
            let text = entry(case, Profile::Fast).wgsl.as_ref().expect("no WGSL");
            let run = machine.check_wgsl(case, text);
            run.unwrap_or_else(|trouble| panic!("{} on {machine}: {trouble}", case.name));
        }
    }
}

#[test]
fn every_kernel_has_a_case() {
    let cases = features::cases().unwrap();
    let without = |entry: &&Entry| cases.iter().all(|case| case.entry != entry.name);
    let names: Vec<_> = entries(Profile::Strict).filter(without).map(|entry| &entry.name).collect();
    assert!(names.is_empty(), "not run: {names:?}");
}

#[test]
fn every_module_and_every_text_is_valid() {
    for entry in &compiled().entries {
        check_spirv(&entry.name, &entry.spirv).unwrap();
        if let Some(text) = &entry.wgsl {
            check_wgsl(&entry.name, text).unwrap();
        }
    }
    assert!(entries(Profile::Fast).all(|entry| entry.wgsl.is_some()));
}
