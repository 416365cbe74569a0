//! Another engine uses the traversal, the backends and the comparator, without a scene, a camera or a light
//! of Parallax.
//!
//! The engine has a level of boxes and asks how much of the sky each cell of its ground sees. Its two kernels
//! live in a crate of their own (`embed-kernels`), written once. The CPU calls them as they are; for the GPU
//! `kernel-compiler` makes SPIR-V of that crate. Then both results are compared, bit by bit.
//!
//! `cargo run --release --example embed`

use anyhow::{Context, Result, ensure};
use embed_kernels::{CountByExposure, Ground, SkyExposure};
use kernel_compiler::{CrateSource, Options, compile};
use parallax::backend::gpu::{Module, Modules};
use parallax::backend::{Backend, BackendError, Cpu, Gpu, Profile};
use parallax::build::{Bvh, Quality, build};
use parallax::compare::{Bound, Kind, Stage, StageReport, compare};
use parallax_shared::layout::Triangle;

/// Cells of the ground along x and along z.
const CELLS: u32 = 64;
const CELL_METRES: f32 = 0.75;
const HISTOGRAM_STEPS: usize = 9;
/// Directions in which the sky is looked at.
const DIRECTIONS: u32 = 64;

/// What the engine wants to know.
#[derive(Debug, PartialEq)]
pub struct Answer {
    /// By cell, 0 to 1.
    pub exposure: Vec<f32>,
    /// Cells by exposure.
    pub histogram: Vec<u32>,
}

/// Asks the CPU and, if there is one, a GPU.
pub fn main() -> Result<()> {
    let structure = build(&level(), &[], &[], Quality::Full)?;
    let mut cpu = Cpu::new(0)?;
    let expected = ask(&mut cpu, &structure)?;
    println!("{}: cells by open sky: {:?}", cpu.describe(), expected.histogram);
    match Gpu::open(Profile::Strict, None) {
        Ok(gpu) => {
            let report = check(gpu, &structure, &expected)?;
            println!("{} cells, {} differ", report.elements, report.differing);
            ensure!(report.equal, "the backends differ: {report:?}");
            Ok(())
        }
        Err(BackendError::NoAdapter { reason }) => {
            println!("not compared with a GPU: {reason}");
            Ok(())
        }
        Err(error) => Err(error.into()),
    }
}

/// Asks `gpu` too, and compares.
pub fn check(gpu: Gpu, structure: &Bvh, expected: &Answer) -> Result<StageReport> {
    let mut gpu = gpu.with_modules(modules()?);
    let found = ask(&mut gpu, structure)?;
    println!("{}: cells by open sky: {:?}", gpu.describe(), found.histogram);
    ensure!(found.histogram == expected.histogram, "the counts differ");
    let stage =
        Stage { view: "level", stage: "exposure", kind: Kind::Float, components: 1, bound: Bound::EXACT };
    Ok(compare(&stage, bytemuck::cast_slice(&expected.exposure), bytemuck::cast_slice(&found.exposure)))
}

/// The two passes, on any backend: what the first one makes never leaves it before the second has read it.
pub fn ask(backend: &mut impl Backend, structure: &Bvh) -> Result<Answer, BackendError> {
    let rows = backend.upload("acceleration structure", &structure.rows)?;
    let directions = backend.upload("directions", &directions())?;
    let exposure = backend.create("exposure", (CELLS * CELLS) as usize)?;
    let histogram = backend.upload("histogram", &[0; HISTOGRAM_STEPS])?;
    let first = -0.5 * CELL_METRES * (CELLS - 1) as f32;
    let ground = Ground {
        first: [first, 0.0, first],
        cells: CELLS,
        step: CELL_METRES,
        extent: structure.extent,
        padding: [0; 2],
    };
    backend.run(&SkyExposure { ground, rows, directions, exposure }, [CELLS, CELLS, 1])?;
    backend.run(&CountByExposure { exposure, histogram }, [CELLS * CELLS, 1, 1])?;
    Ok(Answer { exposure: backend.read(exposure)?, histogram: backend.read(histogram)? })
}

/// Device code of the engine's kernels. An engine would do this once, and ship what it gets.
fn modules() -> Result<Modules> {
    let source = CrateSource::new(embed_kernels::SOURCE);
    let compiled = compile(&source, &Options::default()).context("compiling the kernels")?;
    let mut modules = Modules::default();
    for entry in compiled.entries {
        modules.insert(entry.name, Module { spirv: entry.spirv.into(), wgsl: None });
    }
    Ok(modules)
}

/// Boxes on a grid, each of another height.
pub fn level() -> Vec<Triangle> {
    let tower = |number: u32| {
        let (column, row) = (number % 5, number / 5);
        let centre = [column as f32 * 8.0 - 16.0, row as f32 * 8.0 - 16.0];
        cuboid(centre, 2.0, 1.0 + (number * 7 % 11) as f32)
    };
    (0..25).flat_map(tower).collect()
}

/// The triangles of a box that stands on the ground.
fn cuboid([x, z]: [f32; 2], half_width: f32, height: f32) -> Vec<Triangle> {
    let corner = |i: usize| {
        let sign = |bit: usize| if i >> bit & 1 == 1 { half_width } else { -half_width };
        [x + sign(0), if i >> 2 & 1 == 1 { height } else { 0.0 }, z + sign(1)]
    };
    let faces = [[0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6], [4, 5, 7, 6], [0, 2, 3, 1]];
    let halves = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    halves.map(|corners| Triangle { vertices: corners.map(corner), ..bytemuck::Zeroable::zeroed() }).collect()
}

/// Directions over the upper half of the sphere, as even as a golden spiral makes them.
fn directions() -> Vec<[f32; 4]> {
    let golden = std::f32::consts::PI * (3.0 - 5.0_f32.sqrt());
    let direction = |i: u32| {
        let y = (i as f32 + 0.5) / DIRECTIONS as f32;
        let (sin, cos) = (i as f32 * golden).sin_cos();
        let radius = (1.0 - y * y).sqrt();
        [radius * cos, y, radius * sin, 0.0]
    };
    (0..DIRECTIONS).map(direction).collect()
}
