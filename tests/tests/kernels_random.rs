//! A fixed set of random kernels, on every machine; and that a wrong module would be found.

use parallax::backend::Profile;
use parallax_tests::gpu::{self, Driver};
use parallax_tests::machines::{Case, Machine, Trouble, check_spirv, dispatch};
use parallax_tests::random_kernels::{Batch, Compiled, check};
use parallax_tests::words::instructions;
use std::sync::OnceLock;

/// The fixed set, compiled once.
fn batch() -> &'static Compiled {
    static BATCH: OnceLock<Compiled> = OnceLock::new();
    BATCH.get_or_init(|| {
        let batch = Batch::write("fixed", 0..200).and_then(|batch| batch.compile());
        batch.unwrap_or_else(|error| panic!("{error:?}"))
    })
}

fn all_agree(machine: Machine) {
    let failures: Vec<String> = check(batch(), &[machine]).iter().map(ToString::to_string).collect();
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn the_interpreter_agrees_with_the_native_program() {
    all_agree(Machine::Interpreter(0));
}

#[test]
fn lavapipe_agrees_with_the_native_program() {
    Machine::open(Driver::Lavapipe).into_iter().for_each(all_agree);
}

#[test]
fn swiftshader_agrees_with_the_native_program() {
    Machine::open(Driver::SwiftShader).into_iter().for_each(all_agree);
}

#[test]
fn every_module_is_valid() {
    for (_, case, entry) in &batch().kernels {
        check_spirv(&case.name, &entry.spirv).unwrap();
    }
}

/// The results depend on what is computed: not all kernels leave at once, and no two write the same.
#[test]
fn the_kernels_compute_something() {
    let results = |case: &Case| case.expected[2].clone();
    let distinct: std::collections::BTreeSet<Vec<u32>> =
        batch().kernels.iter().map(|k| results(&k.1)).collect();
    assert!(distinct.len() > batch().kernels.len() * 4 / 5, "{} distinct results", distinct.len());
}

/// Where a module's constants of 32 bits and more than 16 digits are: numbers that are added, multiplied or compared, not bounds of loops.
fn large_constants(words: &[u32]) -> Vec<usize> {
    const CONSTANT: u32 = 4 << 16 | 43;
    let constants = instructions(words).filter(|(_, instruction)| instruction[0] == CONSTANT);
    let large = constants.filter(|(_, constant)| (0x0001_0000..0xffff_0000).contains(&constant[3]));
    large.map(|(at, _)| at + 3).collect()
}

/// One constant changed in a module is told as a difference, with the seed.
#[test]
fn a_wrong_module_is_found() {
    let Some(gpu) = gpu::open(Driver::Lavapipe, Profile::Strict) else { return };
    let mut found = 0;
    for (_, case, entry) in batch().kernels.iter().take(12) {
        for at in large_constants(&entry.spirv).into_iter().take(3) {
            let mut words = entry.spirv.clone();
            words[at] ^= 1;
            found += matches!(dispatch(&gpu, case, &words), Err(Trouble::Difference(_))) as u32;
        }
    }
    // Some constants stand where no invocation comes by.
    assert!(found >= 6, "only {found} changed modules were found");
}
