//! Many kernels in one crate: written, run natively, and compiled once.

use super::kernel;
use crate::machines::{Case, Numbers, workspace};
use anyhow::Context;
use kernel_api::Access;
use kernel_compiler::{CrateSource, Entry, Options};
use parallax::backend::gpu::RawBinding;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Words of the table that each kernel reads.
const WORDS: usize = 256;
/// Atomic cells: four for each of five operations.
const CELLS: usize = 20;
/// Results of each kernel, four words each; not a multiple of a workgroup's.
const RESULTS: usize = 100;
/// Workgroups of each run.
const GROUPS: u32 = 2;

/// What every generated crate begins with.
const PRELUDE: &str = "//! Random kernels.
#![allow(warnings)]

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::device::mul_high;
use kernel_api::{At, Out, spirv};

/// The bits, without the sign of a zero.
#[inline(always)]
fn bits(x: f32) -> u32 {
    if x.to_bits() << 1 == 0 { 0 } else { x.to_bits() }
}

/// Keeps a number away from all that is special.
#[inline(always)]
fn tame(x: f32) -> f32 {
    let size = x.abs();
    if size == 0.0 || (size > 0.001 && size < 1000.0) { x } else { 1.0 }
}

";

/// A crate of random kernels on disk.
pub struct Batch {
    seeds: Range<u32>,
    dir: PathBuf,
}

/// A crate of random kernels, compiled, and what each must write.
pub struct Compiled {
    /// The kernels in the order of their seeds: the run with the native results, and the module.
    pub kernels: Vec<(u32, Case, Entry)>,
    /// The source of all of them.
    pub source: PathBuf,
}

impl Batch {
    /// Writes the crate of these seeds to the folder `name` of the workspace's target folder, over what is there.
    ///
    /// # Errors
    /// When the files cannot be written.
    pub fn write(name: &str, seeds: Range<u32>) -> anyhow::Result<Self> {
        let root = workspace("").canonicalize()?;
        let batch = Self { seeds, dir: root.join("target/random-kernels").join(name) };
        fs::create_dir_all(batch.dir.join("src"))?;
        batch.put("Cargo.toml", &manifest(&root))?;
        batch.put(
            "src/lib.rs",
            &(PRELUDE.to_string() + &batch.seeds.clone().map(kernel).collect::<String>()),
        )?;
        batch.put("src/main.rs", &native_program(batch.seeds.clone()))?;
        // The same versions as everywhere, and no look into a registry.
        for file in ["Cargo.lock", "rust-toolchain.toml"] {
            fs::copy(root.join(file), batch.dir.join(file))?;
        }
        Ok(batch)
    }

    /// Writes a file if it is not there already, so that cargo sees what has changed.
    fn put(&self, path: &str, text: &str) -> std::io::Result<()> {
        let path = self.dir.join(path);
        match fs::read_to_string(&path) {
            Ok(present) if present == text => Ok(()),
            _ => fs::write(path, text),
        }
    }

    /// Compiles the kernels and runs them natively.
    ///
    /// # Errors
    /// When one is refused, or does not compile, or panics.
    pub fn compile(&self) -> anyhow::Result<Compiled> {
        let options = Options { target_dir: Some(self.dir.join("target")), ..Options::default() };
        let compiled = kernel_compiler::compile(&CrateSource::new(&self.dir), &options)
            .with_context(|| format!("the source is {}", self.source().display()))?;
        let cases = self.native()?;
        let find = |case: Case, seed| {
            let entry = compiled.entries.iter().find(|entry| entry.name == case.entry).cloned();
            Ok((seed, entry.with_context(|| format!("no module of {}", case.entry))?, case))
        };
        let found = cases.into_iter().zip(self.seeds.clone()).map(|(case, seed)| find(case, seed));
        let kernels = found.map(|kernel| kernel.map(|(seed, entry, case)| (seed, case, entry)));
        Ok(Compiled { kernels: kernels.collect::<anyhow::Result<_>>()?, source: self.source() })
    }

    fn source(&self) -> PathBuf {
        self.dir.join("src/lib.rs")
    }

    /// Builds and runs the native program.
    fn native(&self) -> anyhow::Result<Vec<Case>> {
        let words = Numbers::new(1).words(WORDS);
        let (table, results) = (self.dir.join("words.bin"), self.dir.join("results.bin"));
        fs::write(&table, bytemuck::cast_slice(&words))?;
        let mut cargo = Command::new("cargo");
        cargo
            .args(["run", "--quiet", "--offline", "--release", "--"])
            .args([&table, &results])
            .current_dir(&self.dir);
        let run = cargo.output().context("cargo cannot be run")?;
        let text = String::from_utf8_lossy(&run.stderr);
        anyhow::ensure!(run.status.success(), "{} does not run natively:\n{text}", self.source().display());
        let results: Vec<u32> = bytemuck::pod_collect_to_vec(&fs::read(results)?);
        let each = results.chunks_exact(CELLS + 4 * RESULTS);
        Ok(self.seeds.clone().zip(each).map(|(seed, written)| case(seed, &words, written)).collect())
    }
}

/// The run of a kernel that wrote these words natively.
fn case(seed: u32, words: &[u32], written: &[u32]) -> Case {
    let (cells, results) = written.split_at(CELLS);
    let binding = |binding, access, words| RawBinding { set: 0, binding, access, words };
    Case {
        name: format!("random kernel {seed}"),
        entry: format!("k_{seed}"),
        threads: [64, 1, 1],
        groups: [GROUPS, 1, 1],
        bindings: vec![
            binding(0, Access::Read, words.to_vec()),
            binding(1, Access::Atomic, vec![0; CELLS]),
            binding(2, Access::Write, vec![u32::MAX; 4 * RESULTS]),
        ],
        push: Vec::new(),
        constants: Vec::new(),
        expected: vec![words.to_vec(), cells.to_vec(), results.to_vec()],
    }
}

fn manifest(root: &Path) -> String {
    format!(
        "[package]
name = \"random-kernels\"
version = \"0.1.0\"
edition = \"2024\"

[workspace]

[features]
device = [\"kernel-api/device\"]

[dependencies]
kernel-api = {{ path = {:?} }}
glam = {{ version = \"0.34\", default-features = false, features = [\"scalar-math\", \"i32\", \"u32\", \"libm\", \"bytemuck\"] }}

# Not what the modules are compiled with: a mistake of an optimisation must show.
[profile.release]
opt-level = 1
overflow-checks = false
",
        root.join("kernels/api")
    )
}

/// The program that runs each kernel and writes what it has written.
fn native_program(seeds: Range<u32>) -> String {
    let runs: String =
        seeds.map(|seed| format!("    run(\"k_{seed}\", k_{seed}, &words, &mut results);\n")).collect();
    format!(
        "//! Runs the kernels natively: table of words in, results out.
use core::sync::atomic::AtomicU32;
use glam::UVec3;
use kernel_api::Out;
use random_kernels::*;

type Kernel = fn(UVec3, &[u32], &[AtomicU32], Out<[u32; 4]>);

fn run(name: &str, kernel: Kernel, words: &[u32], results: &mut Vec<u32>) {{
    eprintln!(\"{{name}}\");
    let cells: Vec<AtomicU32> = (0..{CELLS}).map(|_| AtomicU32::new(0)).collect();
    let mut out = vec![[u32::MAX; 4]; {RESULTS}];
    for x in 0..{GROUPS} * 64 {{
        // SAFETY: one thread.
        kernel(UVec3::new(x, 0, 0), words, &cells, unsafe {{ Out::new(&mut out, &[]) }});
    }}
    results.extend(cells.into_iter().map(AtomicU32::into_inner));
    results.extend(out.into_iter().flatten());
}}

fn main() {{
    let paths: Vec<String> = std::env::args().collect();
    let bytes = std::fs::read(&paths[1]).expect(\"the table\");
    let words: Vec<u32> = bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    let mut results = Vec::new();
{runs}    let bytes: Vec<u8> = results.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write(&paths[2], bytes).expect(\"the results\");
}}
"
    )
}
