//! The parallel methods on devices: the CPU's bits, run after run, however its work is shared out.

use parallax::backend::{Cpu, Profile};
use parallax::diff;
use parallax::render::{First, Method, Reflections, SceneData, Shadows, StereoOptions, Verify};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::scenes::{data_at, file};
use parallax_tests::stereo::{REPROJECTING, pair_on, verified};

/// How often each method runs; not fewer, since scheduling shows by luck.
const RUNS: usize = 20;

fn scene(name: &str) -> SceneData {
    data_at(&file(name), [56, 32]).expect("a scene that ships whole")
}

fn options() -> impl Iterator<Item = StereoOptions> {
    let verify = [Verify::All, Verify::Edges, Verify::None];
    let first = [First::Left, First::Right];
    REPROJECTING
        .into_iter()
        .zip(verify.into_iter().cycle())
        .zip(first.into_iter().cycle())
        .map(|((method, verify), first)| verified(method, verify, first))
}

fn recalling() -> StereoOptions {
    StereoOptions { reflections: Reflections::Within(1.0), ..Method::Atomic.into() }
}

fn proving(method: Method) -> StereoOptions {
    StereoOptions { shadows: Shadows::Prove, ..method.into() }
}

#[test]
fn every_method_gives_the_same_bits_on_any_number_of_threads() {
    let data = scene("default");
    for options in options() {
        let want = pair_on(&mut Cpu::new(1).unwrap(), &data, &options);
        for threads in [2, 3] {
            let mut cpu = Cpu::new(threads).unwrap();
            for _ in 0..RUNS {
                assert!(pair_on(&mut cpu, &data, &options) == want, "{options:?}, {threads} threads");
            }
        }
    }
}

fn assert_equal(driver: Driver, runs: usize) {
    let Some(mut gpu) = open(driver, Profile::Strict) else { return };
    for name in ["default", "spheres"] {
        let data = scene(name);
        let exact = [Method::Guided.into(), proving(Method::Guided), proving(Method::Naive)];
        for options in options().chain([Method::Ideal.into(), recalling()]).chain(exact) {
            let once =
                diff::against_gpu(&mut Cpu::new(0).unwrap(), &mut gpu, &data, &options, &mut |_, _| {})
                    .unwrap();
            assert!(once.equal, "{driver:?}, {name}, {options:?}: {once}");
            let first = pair_on(&mut gpu, &data, &options);
            for _ in 1..runs {
                assert!(pair_on(&mut gpu, &data, &options) == first, "{driver:?}, {name}, {options:?}");
            }
        }
    }
}

#[test]
fn every_method_has_the_cpus_bits_on_lavapipe_in_each_of_twenty_runs() {
    assert_equal(Driver::Lavapipe, RUNS);
}

#[test]
fn every_method_has_the_cpus_bits_on_swiftshader() {
    assert_equal(Driver::SwiftShader, 3);
}
