//! What `parallax verify` would find: each probe and each case fails on a driver that computes something else, which is made by changing
//! the device code.

use parallax::backend::gpu::{Module, Modules};
use parallax::backend::{Cpu, Gpu, Profile};
use parallax::verify::{self, CASES, Case, CaseReport, Gpus, probes};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::words::instructions;

/// Instructions of SPIR-V with the same operands.
const SUM: u32 = 129;
const DIFFERENCE: u32 = 131;
const PRODUCT: u32 = 133;
const QUOTIENT: u32 = 136;
const BELOW: u32 = 176;
const AT_LEAST: u32 = 174;
const SHIFT_LEFT: u32 = 196;
const SHIFT_RIGHT: u32 = 194;

/// An instruction of the extended set GLSL.std.450, and two of these with one operand, in the fifth word.
const EXTENDED: u32 = 12;
const ROOT: u32 = 31;
const INVERSE_ROOT: u32 = 32;

/// The module with every instruction `from` replaced by `to`.
fn replaced(module: &Module, from: u32, to: u32) -> Module {
    let mut words = module.spirv.to_vec();
    for (at, _) in instructions(&module.spirv).filter(|(_, instruction)| instruction[0] & 0xffff == from) {
        words[at] = (words[at] & 0xffff_0000) | to;
    }
    Module { spirv: words.into(), wgsl: None }
}

/// The module with 1/√ in the place of √.
fn with_inverse_roots(module: &Module) -> Module {
    let mut words = module.spirv.to_vec();
    let extended = instructions(&module.spirv).filter(|(_, instruction)| instruction[0] & 0xffff == EXTENDED);
    for (at, _) in extended.filter(|(_, instruction)| instruction[4] == ROOT) {
        words[at + 4] = INVERSE_ROOT;
    }
    Module { spirv: words.into(), wgsl: None }
}

/// Lavapipe, on which these passes have `to` where they have `from`.
fn wrong(profile: Profile, passes: &[&str], from: u32, to: u32) -> Option<Gpu> {
    changed(profile, passes, |module| replaced(module, from, to))
}

/// Lavapipe with other modules for these passes.
fn changed(profile: Profile, passes: &[&str], change: impl Fn(&Module) -> Module) -> Option<Gpu> {
    let gpu = open(Driver::Lavapipe, profile)?;
    let mut modules = Modules::embedded(profile);
    for pass in passes {
        let changed = change(modules.get(pass).expect("a pass"));
        assert_ne!(Some(&changed), modules.get(pass), "{pass} has no such instruction");
        modules.insert(*pass, changed);
    }
    Some(gpu.with_modules(modules))
}

fn run(case: &Case, gpu: &mut Gpu) -> CaseReport {
    verify::run(case, &mut Cpu::new(0).unwrap(), Some(gpu), false, &mut |_, _| {})
}

#[test]
fn probes_tell_wrong_arithmetic() {
    for (from, to, fails) in [
        (PRODUCT, SUM, &["contraction", "signs of zeros"][..]),
        (SUM, DIFFERENCE, &["rounding of sums", "signs of zeros"]),
        (QUOTIENT, PRODUCT, &["division"]),
    ] {
        let Some(mut gpu) = wrong(Profile::Strict, &["arithmetic"], from, to) else { return };
        let answers = probes::probe(&mut gpu, "strict").unwrap();
        for (name, answer) in answers.named().into_iter().filter(|(name, _)| fails.contains(name)) {
            assert!(!answer.strict_can_do, "{from} as {to}: {name}: {}", answer.says);
        }
    }
    let Some(mut gpu) = changed(Profile::Strict, &["arithmetic"], with_inverse_roots) else { return };
    let answer = probes::probe(&mut gpu, "strict").unwrap().square_root;
    assert!(!answer.strict_can_do, "{}", answer.says);
    let Some(mut gpu) = open(Driver::Lavapipe, Profile::Strict) else { return };
    let answers = probes::probe(&mut gpu, "strict").unwrap();
    assert!(answers.named().iter().all(|(_, answer)| answer.strict_can_do), "{answers:?}");
}

/// SwiftShader flushes denormals, lavapipe and the processor keep them; a processor fuses, they do not.
#[test]
fn probes_tell_drivers_apart() {
    let [Some(mut lavapipe), Some(mut swiftshader)] =
        Driver::SOFTWARE.map(|driver| open(driver, Profile::Strict))
    else {
        return;
    };
    if std::env::var_os("PARALLAX_ADAPTER").is_some() {
        return;
    }
    let cpu = probes::probe(&mut Cpu::new(1).unwrap(), "CPU").unwrap();
    let [kept, flushed] = [&mut lavapipe, &mut swiftshader].map(|gpu| probes::probe(gpu, "strict").unwrap());
    assert_eq!([&cpu.denormals.says, &kept.denormals.says], ["kept"; 2]);
    assert_eq!(flushed.denormals.says, "flushed to zero");
    assert_eq!(cpu.fma.says, "fused");
    assert_ne!(kept.fma.says, "fused");
}

/// Cases that need no pictures, on the second driver, which has no denormals.
#[test]
fn the_second_driver_has_the_same_arithmetic() {
    let Some(mut gpu) = open(Driver::SwiftShader, Profile::Strict) else { return };
    let groups = ["arithmetic", "boxes", "quadrics"];
    for case in CASES.iter().filter(|case| groups.contains(&case.group)) {
        let report = run(case, &mut gpu);
        assert_eq!(report.failures, 0, "{}: {:?}", case.name, report.first_failure);
        assert!(report.on_device && report.cases > 0);
    }
}

/// Every case that runs on a device tells one that computes something else.
#[test]
fn every_case_can_fail_on_a_device() {
    let passes = ["arithmetic", "trace_rays", "shade"];
    let Some(mut gpu) = wrong(Profile::Strict, &passes, PRODUCT, SUM) else { return };
    // What is no ray is so by comparisons of its bits, whatever the arithmetic; pixels are numbered by shifts.
    let Some(mut lax) = wrong(Profile::Strict, &["trace_rays"], BELOW, AT_LEAST) else { return };
    let Some(mut displaced) = wrong(Profile::Strict, &["arithmetic"], SHIFT_LEFT, SHIFT_RIGHT) else {
        return;
    };
    let mut found = 0;
    for case in CASES {
        let gpu = match case.name {
            "what_is_no_ray_misses_in_the_time_of_a_ray" => &mut lax,
            "large_pictures_are_addressed_without_overflow" => &mut displaced,
            _ => &mut gpu,
        };
        let report = run(case, gpu);
        assert_eq!(report.on_device, report.failures > 0, "{}: {:?}", case.name, report.first_failure);
        found += u32::from(report.on_device);
    }
    assert!(found > 20, "{found} cases run on a device");
}

/// A backend that fails is a case that does not hold, and the others are tried all the same.
#[test]
fn a_backend_that_fails_is_a_failure() {
    let Some(gpu) = open(Driver::Lavapipe, Profile::Strict) else { return };
    let report = run(&CASES[0], &mut gpu.with_modules(Modules::default()));
    assert_eq!(report.failures, 1);
    let failure = report.first_failure.unwrap();
    assert!(failure.contains("no strict module of `arithmetic`"), "{failure}");
}

/// The whole of it, on a device whose fast profile shades wrongly and whose strict one is right.
#[test]
fn verdicts_are_of_each_profile() {
    let Some(strict) = open(Driver::Lavapipe, Profile::Strict) else { return };
    let Some(fast) = wrong(Profile::Fast, &["shade"], PRODUCT, SUM) else { return };
    let mut gpus = Gpus { strict, fast };
    let mut told = Vec::new();
    let mut tell = |what: &str, done, total| told.push((what.to_owned(), done, total));
    let verification = verify::verify(&mut Cpu::new(0).unwrap(), Some(&mut gpus), false, &mut tell).unwrap();
    assert!(verification.strict.is_safe, "{}", verification.strict.why);
    let fast = verification.fast.expect("a device was verified");
    assert!(!fast.is_safe && fast.why.contains("beyond the stated bounds"), "{}", fast.why);
    assert_eq!(verification.probes.len(), 3);
    assert!(told.len() >= CASES.len());
}
