//! The GPU backend on the software drivers: what passes see, what is refused and how it is told.

use kernel_api::Access;
use parallax::backend::gpu::{Module, Modules, RawBinding, specialise};
use parallax::backend::{Backend, BackendError, Cpu, Gpu, Profile};
use parallax_test_kernels::{Number, Square};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::kernels::modules;
use std::sync::OnceLock;

/// The test kernels, compiled once.
fn compiled(profile: Profile) -> &'static Modules {
    static MODULES: [OnceLock<Modules>; 2] = [const { OnceLock::new() }; 2];
    MODULES[profile as usize].get_or_init(|| modules(parallax_test_kernels::SOURCE, profile))
}

/// The SPIR-V of a test kernel.
fn words(entry: &str) -> Vec<u32> {
    compiled(Profile::Strict).get(entry).expect("a kernel of this name").spirv.to_vec()
}

/// The WGSL of a test kernel.
fn wgsl(entry: &str) -> String {
    let module = compiled(Profile::Fast).get(entry).expect("a kernel of this name");
    module.wgsl.as_deref().expect("WGSL was asked for").to_string()
}

fn wgsl_alone() -> Modules {
    let mut modules = Modules::default();
    for name in compiled(Profile::Fast).names() {
        modules.insert(name, Module { wgsl: Some(wgsl(name).into()), ..Module::default() });
    }
    modules
}

/// The software drivers that there are, each with our SPIR-V in the strict profile and with WGSL in the fast
/// one.
fn each(test: impl Fn(Gpu)) {
    for driver in Driver::SOFTWARE {
        let Some(gpu) = open(driver, Profile::Strict) else { continue };
        test(gpu.with_modules(compiled(Profile::Strict).clone()));
        let Some(gpu) = open(driver, Profile::Fast) else { continue };
        test(gpu.with_modules(wgsl_alone()));
    }
}

/// A driver in the strict profile.
fn strict() -> Option<Gpu> {
    Some(open(Driver::Lavapipe, Profile::Strict)?.with_modules(compiled(Profile::Strict).clone()))
}

fn error_text<T>(result: Result<T, BackendError>) -> String {
    result.err().expect("this must be refused").to_string()
}

/// Numbers on any backend: the elements and the count.
fn numbers_of(backend: &mut impl Backend, step: u32) -> Result<(Vec<u32>, u32), BackendError> {
    let numbers = backend.create("numbers", 13 * 5 * 3)?;
    let count = backend.upload("count", &[0])?;
    backend.run(&Number { extent: [13, 5, 3, 0], offset: 7, numbers, count, step }, [13, 5, 3])?;
    Ok((backend.read(numbers)?, backend.read(count)?[0]))
}

/// The most bytes at once: of two buffers, of what is left of them, and of a third one beside that.
fn peaks(backend: &mut impl Backend) -> Result<[u64; 3], BackendError> {
    backend.take_peak_bytes();
    let (three, five) = (backend.upload("three", &[1, 2, 3])?, backend.create::<[f32; 4]>("five", 5)?);
    let both = backend.take_peak_bytes();
    backend.release(five);
    backend.release(five);
    backend.create::<f32>("nothing", 0)?;
    let left = [backend.take_peak_bytes(), backend.take_peak_bytes()];
    assert_eq!(left, [both, 12], "what was there when it was asked, and what is there now");
    backend.create::<u32>("two", 2)?;
    backend.release(three);
    Ok([both, left[1], backend.take_peak_bytes()])
}

#[test]
fn the_most_bytes_at_once_are_the_same_on_every_backend() {
    let expected = [12 + 80, 12, 12 + 8];
    assert_eq!(peaks(&mut Cpu::new(1).unwrap()).unwrap(), expected);
    each(|mut gpu| assert_eq!(peaks(&mut gpu).unwrap(), expected));
}

#[test]
fn data_comes_back_as_it_was() {
    each(|mut gpu| {
        let data: Vec<u32> = (0..100_000).collect();
        let buffer = gpu.upload("data", &data).unwrap();
        assert_eq!(gpu.read(buffer).unwrap(), data);
        let empty = gpu.upload::<u32>("empty", &[]).unwrap();
        assert!(gpu.read(empty).unwrap().is_empty());
    });
}

#[test]
fn what_no_pass_writes_is_poison() {
    each(|mut gpu| {
        let len = (1 << 20) + 3;
        let numbers = gpu.upload("numbers", &vec![2.0; len]).unwrap();
        let squares = gpu.create::<f32>("squares", len).unwrap();
        gpu.run(&Square { numbers, squares }, [10, 1, 1]).unwrap();
        let all = gpu.read(squares).unwrap();
        assert_eq!(all[..64], [4.0; 64], "whole workgroups run");
        assert!(all[64..].iter().all(|v| v.to_bits() == u32::MAX));
    });
}

#[test]
fn a_chain_of_passes_gives_the_bits_of_the_cpu() {
    let values: Vec<f32> = (0..5000).map(|i| (i as f32 * 0.37).sin() * 3.0).collect();
    let chain = |backend: &mut dyn FnMut(&[f32]) -> Vec<f32>| {
        backend(&values).iter().map(|v| v.to_bits()).collect::<Vec<_>>()
    };
    fn run(backend: &mut impl Backend, values: &[f32]) -> Vec<f32> {
        let mut numbers = backend.upload("numbers", values).unwrap();
        for _ in 0..3 {
            let squares = backend.create("squares", values.len()).unwrap();
            backend.run(&Square { numbers, squares }, [values.len() as u32, 1, 1]).unwrap();
            backend.release(numbers);
            numbers = squares;
        }
        backend.read(numbers).unwrap()
    }
    let mut cpu = Cpu::new(1).unwrap();
    let expected = chain(&mut |values| run(&mut cpu, values));
    each(|mut gpu| assert_eq!(chain(&mut |values| run(&mut gpu, values)), expected, "{}", gpu.describe()));
}

#[test]
fn everything_that_can_be_bound_arrives() {
    let expected = numbers_of(&mut Cpu::new(1).unwrap(), 2).unwrap();
    assert_eq!(expected.1, 2 * 16 * 4 * 3 * 2);
    each(|mut gpu| assert_eq!(numbers_of(&mut gpu, 2).unwrap(), expected, "{}", gpu.describe()));
}

#[test]
fn each_value_of_a_constant_has_its_pipeline() {
    each(|mut gpu| {
        for step in [1, 5, 1, 0] {
            assert_eq!(numbers_of(&mut gpu, step).unwrap().1, step * 384);
        }
    });
}

#[test]
fn a_run_of_nothing_does_nothing() {
    let Some(mut gpu) = strict() else { return };
    let (numbers, squares) = (gpu.upload("n", &[1.0]).unwrap(), gpu.create("s", 1).unwrap());
    gpu.run(&Square { numbers, squares }, [0, 1, 1]).unwrap();
    gpu.finish().unwrap();
    assert!(gpu.read(squares).unwrap()[0].is_nan());
}

#[test]
fn another_module_is_run_in_its_place() {
    let Some(gpu) = strict() else { return };
    let mut words = words("number");
    // The multiplication by 16 is a shift by the constant 4.
    let constant = words.windows(4).position(|w| w[0] == 4 << 16 | 43 && w[3] == 4).expect("the constant 4");
    words[constant + 3] = 5;
    let mut modules = compiled(Profile::Strict).clone();
    modules.insert("number", Module { spirv: words.into(), wgsl: None });
    let expected = numbers_of(&mut Cpu::new(1).unwrap(), 1).unwrap();
    assert_ne!(numbers_of(&mut gpu.with_modules(modules), 1).unwrap(), expected);
}

#[test]
fn handles_are_checked() {
    let (Some(mut gpu), Some(mut other)) = (strict(), strict()) else { return };
    let numbers = gpu.upload("numbers", &[1.0]).unwrap();
    let text = error_text(gpu.run(&Square { numbers, squares: numbers }, [1, 1, 1]));
    assert!(text.contains("binds one buffer both as `numbers` and as `squares`"), "{text}");
    let foreign = other.create("squares", 1).unwrap();
    let text = error_text(gpu.run(&Square { numbers, squares: foreign }, [1, 1, 1]));
    assert!(text.contains("belongs to another backend"), "{text}");
    let squares = gpu.create("squares", 1).unwrap();
    gpu.release(squares);
    let text = error_text(gpu.run(&Square { numbers, squares }, [1, 1, 1]));
    assert_eq!(text, "pass `square`, `squares`: the buffer has been released");
    assert!(matches!(gpu.read(squares), Err(BackendError::StaleBuffer { .. })));
}

#[test]
fn a_missing_or_wrong_module_is_told() {
    let Some(gpu) = open(Driver::Lavapipe, Profile::Strict) else { return };
    let mut gpu = gpu.with_modules(Modules::default());
    let text = error_text(numbers_of(&mut gpu, 1));
    assert!(text.starts_with("there is no strict module of `number`: compile its crate"), "{text}");

    let with = |gpu: Gpu, words: &[u32]| {
        let mut modules = Modules::default();
        modules.insert("number", Module { spirv: words.to_vec().into(), wgsl: None });
        gpu.with_modules(modules)
    };
    gpu = with(gpu, &words("square"));
    let text = error_text(numbers_of(&mut gpu, 1));
    assert_eq!(
        text,
        "the module of `number` does not fit its declaration (it has no such entry point): compile the kernels again"
    );
    gpu = with(gpu, &words("square")[..10]);
    let text = error_text(numbers_of(&mut gpu, 1));
    assert!(
        text.starts_with("the module of `number` cannot be read: the SPIR-V module is damaged"),
        "{text}"
    );
    let mut resized = words("number");
    let at = resized.windows(3).position(|size| size == [4, 2, 2]).expect("its workgroup size");
    resized[at] = 2;
    gpu = with(gpu, &resized);
    let text = error_text(numbers_of(&mut gpu, 1));
    assert!(text.contains("its workgroups are [2, 2, 2] and not [4, 2, 2]"), "{text}");
}

#[test]
fn what_the_adapter_does_not_have_is_refused() {
    let Some(mut gpu) = strict() else { return };
    let too_long = (gpu.max_buffer_bytes() / 4096 + 1) as usize;
    let text = error_text(gpu.create::<[u32; 1024]>("large", too_long));
    assert!(text.starts_with("buffer `large` of") && text.contains("is more than the"), "{text}");
    let (numbers, squares) = (gpu.upload("n", &[1.0]).unwrap(), gpu.create("s", 1).unwrap());
    let text =
        error_text(gpu.run(&Square { numbers, squares }, [64 * gpu.report().max_workgroups + 1, 1, 1]));
    assert!(text.starts_with("workgroups of `square` along an axis: 65536 is more than the 65535"), "{text}");
}

#[test]
fn a_lost_device_is_told_by_every_call() {
    each(|mut gpu| {
        let data = gpu.upload("data", &[1u32]).unwrap();
        gpu.device().destroy();
        let lost = |result: Result<(), BackendError>| {
            let text = error_text(result);
            assert!(text.contains("was lost (Destroyed") && text.contains("smaller bands"), "{text}");
        };
        lost(gpu.finish());
        lost(gpu.read(data).map(drop));
        lost(gpu.upload("more", &[1u32]).map(drop));
        lost(numbers_of(&mut gpu, 1).map(drop));
    });
}

#[test]
fn any_module_runs_over_plain_words() {
    for driver in Driver::SOFTWARE {
        let Some(gpu) = open(driver, Profile::Fast) else { continue };
        let bind =
            |binding, access, words: &[u32]| RawBinding { set: 0, binding, access, words: words.to_vec() };
        let number = |bindings: &mut Vec<RawBinding>| {
            *bindings = vec![
                bind(0, Access::Uniform, &[4, 2, 2, 0]),
                bind(1, Access::Write, &[9; 20]),
                RawBinding { set: 1, binding: 0, access: Access::Atomic, words: vec![1] },
            ];
        };
        let expected: Vec<u32> = (7..7 + 16).chain([9; 4]).collect();
        let (mut bindings, push) = (Vec::new(), 7u32.to_le_bytes());

        number(&mut bindings);
        let words = specialise(&words("number"), &[(1, 3)]).unwrap();
        gpu.run_module(&words, "number", [4, 2, 2], [1, 1, 1], &mut bindings, &push).unwrap();
        assert_eq!((&bindings[1].words, &bindings[2].words), (&expected, &vec![1 + 3 * 16]));

        number(&mut bindings);
        gpu.run_wgsl(&wgsl("number"), "number", &[(1, 3)], [1, 1, 1], &mut bindings, &push).unwrap();
        assert_eq!((&bindings[1].words, &bindings[2].words), (&expected, &vec![1 + 3 * 16]));

        let text = error_text(gpu.run_wgsl("fn f( {", "number", &[], [1, 1, 1], &mut bindings, &push));
        assert!(text.starts_with("the pipeline of `number` was refused by the device:"), "{text}");
    }
}
