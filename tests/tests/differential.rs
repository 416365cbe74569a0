//! The differential contract (DESIGN §4): strict profile, every stage of both views, bit by bit, on every
//! scene that ships and on the models that do not.
//!
//! Pictures are small, as a software driver is slower than one thread of the processor that it runs on.

use parallax::backend::gpu::{Module, Modules};
use parallax::backend::{Cpu, Gpu, Profile};
use parallax::diff::{self, Differential};
use parallax::render::band::{Band, Values};
use parallax::render::{Renderer, SceneData, StereoOptions};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::scenes;
use parallax_tests::words::instructions;

/// No multiple of a workgroup's 8 × 8, and more than one of them either way.
const SIZE: [u32; 2] = [61, 43];

/// Scenes that together call for every effect, for the second driver.
const FEW: [&str; 4] = ["default", "whitted", "ellipsoids_20", "cornell"];

fn compare(gpu: &mut Gpu, data: &SceneData) -> Differential {
    diff::against_gpu(&mut Cpu::new(0).unwrap(), gpu, data, &StereoOptions::default(), &mut |_, _| {})
        .unwrap()
}

/// Compares the scenes of which `wanted` holds and names those that differ.
fn assert_equal(driver: Driver, wanted: impl Fn(&str) -> bool) {
    let Some(mut gpu) = open(driver, Profile::Strict) else { return };
    let mut different = Vec::new();
    let mut compared = 0;
    for path in scenes::shipped().iter().filter(|path| wanted(scenes::name(path))) {
        let Some(data) = scenes::data_at(path, SIZE) else { continue };
        let differential = compare(&mut gpu, &data);
        assert_eq!(differential.stages.len(), 2 * stages_of(&data), "a stage is missing");
        if !differential.equal {
            different.push(format!("{}\n{differential}", scenes::name(path)));
        }
        compared += 1;
    }
    assert!(compared > 0, "nothing was compared");
    assert!(different.is_empty(), "{}", different.join("\n"));
}

/// Stages of a view.
fn stages_of(data: &SceneData) -> usize {
    if data.effect_names().contains(&"reflection") { 17 } else { 16 }
}

#[test]
fn every_shipped_scene_is_the_same_on_lavapipe() {
    assert_equal(Driver::Lavapipe, |_| true);
}

#[test]
fn a_few_scenes_are_the_same_on_swiftshader() {
    assert_equal(Driver::SwiftShader, |name| FEW.contains(&name));
}

fn default_scene(size: [u32; 2]) -> SceneData {
    scenes::data_at(&scenes::file("default"), size).expect("the default scene needs no models")
}

/// The rows of `whole` that belong to `band`.
fn rows_of<T: Copy>(whole: &[T], band: Band, per_row: usize) -> Vec<T> {
    whole[band.first_row as usize * per_row..][..band.rows as usize * per_row].to_vec()
}

#[test]
fn how_a_picture_is_cut_into_bands_does_not_matter() {
    let data = default_scene(SIZE);
    let [width, height] = SIZE;
    let mut cpu = Cpu::new(0).unwrap();
    let mut renderer = Renderer::new(&mut cpu, &data).unwrap();
    let whole = renderer.band(1, Band { first_row: 0, rows: height }).unwrap();
    for rows in [1, 8, 13] {
        for band in Band::of_picture(height, rows) {
            let Values { hits, shadow, .. } = renderer.band(1, band).unwrap();
            assert_eq!(hits, rows_of(&whole.hits, band, width as usize));
            assert_eq!(shadow, rows_of(&whole.shadow, band, width as usize * whole.shadow_words));
        }
    }
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let data = default_scene(SIZE);
    let [mut one, mut three] = [1, 3].map(|threads| Cpu::new(threads).unwrap());
    let reports =
        diff::stages(&mut one, &mut three, &data, &StereoOptions::default(), Profile::Strict, &mut |_, _| {})
            .unwrap();
    assert!(reports.iter().all(|report| report.equal), "{reports:#?}");
}

/// The module with its `nth` constant of type float and magnitude over 10⁻⁷ made half as large again.
fn mutated(words: &[u32], nth: usize) -> Option<Vec<u32>> {
    const OP_TYPE_FLOAT: u32 = 22;
    const OP_CONSTANT: u32 = 43;
    let (mut floats, mut seen) = (Vec::new(), 0);
    for (at, instruction) in instructions(words) {
        let operation = instruction[0] & 0xffff;
        if operation == OP_TYPE_FLOAT {
            floats.push(words[at + 1]);
        }
        let value = f32::from_bits(*words.get(at + 3)?);
        if operation == OP_CONSTANT
            && floats.contains(&words[at + 1])
            && value.is_finite()
            && value.abs() > 1e-7
        {
            if seen == nth {
                let mut words = words.to_vec();
                words[at + 3] = (value * 1.5).to_bits();
                return Some(words);
            }
            seen += 1;
        }
    }
    None
}

#[test]
fn one_changed_constant_of_a_kernel_is_found() {
    let data = default_scene([24, 16]);
    for kernel in ["primary", "surface", "shadow", "shade", "bounce"] {
        let module = Modules::embedded(Profile::Strict).get(kernel).expect("a committed module").clone();
        let found = (0..40).map_while(|nth| mutated(&module.spirv, nth)).any(|words| {
            let Some(gpu) = open(Driver::Lavapipe, Profile::Strict) else { return true };
            let mut modules = Modules::embedded(Profile::Strict);
            modules.insert(kernel, Module { spirv: words.into(), wgsl: None });
            !compare(&mut gpu.with_modules(modules), &data).equal
        });
        assert!(found, "no changed constant of `{kernel}` makes a difference");
    }
}
