//! The CPU backend: what passes see, what is refused, and how a kernel's defects are told.

use kernel_api::Buffer;
use parallax::backend::cpu::instruction_set::InstructionSet;
use parallax::backend::{Backend, BackendError, Cpu};
use parallax_test_kernels::{Collide, Number, Square};

fn error_text(result: Result<(), BackendError>) -> String {
    result.expect_err("this run must be refused").to_string()
}

#[test]
fn data_comes_back_as_it_was() {
    let mut cpu = Cpu::new(1).unwrap();
    let data: Vec<u32> = (0..1000).collect();
    let buffer = cpu.upload("data", &data).unwrap();
    assert_eq!(cpu.read(buffer).unwrap(), data);
    let empty = cpu.upload::<u32>("empty", &[]).unwrap();
    assert!(cpu.read(empty).unwrap().is_empty());
}

#[test]
fn what_no_pass_writes_is_poison() {
    let mut cpu = Cpu::new(1).unwrap();
    let squares = cpu.create::<f32>("squares", 100).unwrap();
    let numbers = cpu.upload("numbers", &[2.0; 100]).unwrap();
    assert!(cpu.read(squares).unwrap().iter().all(|v| v.to_bits() == u32::MAX));
    cpu.run(&Square { numbers, squares }, [10, 1, 1]).unwrap();
    assert_eq!(cpu.read(squares).unwrap()[..64], [4.0; 64], "whole workgroups run");
    assert!(cpu.read(squares).unwrap()[64..].iter().all(|v| v.is_nan()));
}

#[test]
fn every_invocation_of_a_3d_run_runs_once() {
    let extent = [13, 5, 3, 0];
    for threads in [1, 3] {
        let mut cpu = Cpu::new(threads).unwrap();
        assert_eq!(cpu.threads(), threads);
        let numbers = cpu.create("numbers", 13 * 5 * 3).unwrap();
        let count = cpu.upload("count", &[0]).unwrap();
        cpu.run(&Number { extent, offset: 7, numbers, count, step: 2 }, [13, 5, 3]).unwrap();
        let groups = [4, 3, 2];
        assert_eq!(cpu.read(count).unwrap(), [2 * 16 * groups.iter().product::<u32>()]);
        let all = cpu.read(numbers).unwrap();
        for (i, &value) in all.iter().enumerate() {
            let [x, y, z] = [i as u32 % 13, i as u32 / 13 % 5, i as u32 / 65];
            let group = (z / 2 * groups[1] + y / 2) * groups[0] + x / 4;
            let local = (z % 2 * 2 + y % 2) * 4 + x % 4;
            assert_eq!(value, 7 + group * 16 + local, "at {x} {y} {z}");
        }
    }
}

#[test]
fn every_instruction_set_gives_the_same() {
    let values: Vec<f32> = (0..5000).map(|i| (i as f32 * 0.37).sin() * 1e3).collect();
    let expected: Vec<u32> = values.iter().map(|v| (v * v).to_bits()).collect();
    for set in InstructionSet::available() {
        let mut cpu = Cpu::with_instruction_set(2, set).unwrap();
        assert_eq!(cpu.describe(), format!("CPU ({}, 2 threads)", set.name()));
        let numbers = cpu.upload("numbers", &values).unwrap();
        let squares = cpu.create("squares", values.len()).unwrap();
        cpu.run(&Square { numbers, squares }, [5000, 1, 1]).unwrap();
        let bits: Vec<u32> = cpu.read(squares).unwrap().iter().map(|v| v.to_bits()).collect();
        assert_eq!(bits, expected, "{}", set.name());
    }
}

#[test]
fn a_run_of_nothing_does_nothing() {
    let mut cpu = Cpu::new(1).unwrap();
    let numbers = cpu.upload("numbers", &[1.0]).unwrap();
    let squares = cpu.create("squares", 1).unwrap();
    cpu.run(&Square { numbers, squares }, [0, 1, 1]).unwrap();
    assert!(cpu.read(squares).unwrap()[0].is_nan());
}

#[test]
fn a_written_buffer_is_bound_once() {
    let mut cpu = Cpu::new(1).unwrap();
    let numbers = cpu.upload("numbers", &[1.0]).unwrap();
    let text = error_text(cpu.run(&Square { numbers, squares: numbers }, [1, 1, 1]));
    assert_eq!(
        text,
        "pass `square` binds one buffer both as `numbers` and as `squares`, and writes it: use two buffers"
    );
}

#[test]
fn buffers_of_others_and_released_ones_are_refused() {
    let (mut cpu, mut other) = (Cpu::new(1).unwrap(), Cpu::new(1).unwrap());
    let numbers = cpu.upload("numbers", &[1.0]).unwrap();
    let foreign = other.create("squares", 1).unwrap();
    let text = error_text(cpu.run(&Square { numbers, squares: foreign }, [1, 1, 1]));
    assert!(text.starts_with("pass `square`, `squares`: the buffer belongs to another backend"), "{text}");
    assert!(matches!(cpu.read(foreign), Err(BackendError::WrongOwner { .. })));
    cpu.release(foreign);
    assert!(other.read(foreign).is_ok(), "a backend releases its own buffers only");

    let squares = cpu.create("squares", 1).unwrap();
    cpu.release(squares);
    cpu.release(squares);
    let text = error_text(cpu.run(&Square { numbers, squares }, [1, 1, 1]));
    assert_eq!(text, "pass `square`, `squares`: the buffer has been released");
    assert!(matches!(cpu.read(squares), Err(BackendError::StaleBuffer { .. })));
}

#[test]
fn a_forged_handle_is_refused() {
    let mut cpu = Cpu::new(1).unwrap();
    let real = cpu.upload("numbers", &[1.0_f32]).unwrap();
    let longer = Buffer::<f32>::new(real.owner, real.id, 2);
    assert!(matches!(cpu.read(longer), Err(BackendError::StaleBuffer { .. })));
}

#[test]
fn a_panic_in_a_pass_is_an_error() {
    let mut cpu = Cpu::new(2).unwrap();
    let numbers = cpu.upload("numbers", &[1.0]).unwrap();
    let squares = cpu.create("squares", 2).unwrap();
    let text = error_text(cpu.run(&Square { numbers, squares }, [2, 1, 1]));
    assert!(text.starts_with("pass `square` panicked: index out of bounds"), "{text}");
    assert_eq!(cpu.read(numbers).unwrap(), [1.0], "the backend works on");
}

#[cfg(debug_assertions)]
#[test]
fn two_writers_of_an_element_are_found_in_debug_builds() {
    let mut cpu = Cpu::new(1).unwrap();
    let out = cpu.create("out", 8).unwrap();
    let text = error_text(cpu.run(&Collide { out }, [8, 1, 1]));
    assert_eq!(text, "pass `collide` panicked: element 0 is written twice in one pass");
}

#[test]
fn more_than_there_can_be_is_refused() {
    let mut cpu = Cpu::new(1).unwrap();
    let text = cpu.create::<u32>("huge", 1 << 33).err().unwrap().to_string();
    assert_eq!(text, "buffer `huge` would have 8589934592 elements; a buffer holds at most 4294967295");
    let text = cpu.create::<[u64; 4096]>("large", u32::MAX as usize).err().unwrap().to_string();
    assert!(
        text.starts_with("not enough memory on the CPU for buffer `large` of 4294967295 × 32768"),
        "{text}"
    );
    let (numbers, squares) = (cpu.upload("n", &[1.0]).unwrap(), cpu.create("s", 1).unwrap());
    let text = error_text(cpu.run(&Square { numbers, squares }, [u32::MAX, 1, 1]));
    assert_eq!(text, "pass `square` was asked for [4294967295, 1, 1] invocations; run it in bands");
}

#[test]
fn bands_are_whole_rows_of_workgroups() {
    let cpu = Cpu::new(1).unwrap();
    assert_eq!(cpu.suggested_rows(640, 480, 16), 480);
    let rows = cpu.suggested_rows(8192, 8192, 16);
    assert_eq!((rows % 8, rows as u64 * 8192 <= cpu.max_invocations_hint() as u64), (0, true));
    assert_eq!(cpu.suggested_rows(u32::MAX, 100, 16), 1);
    assert_eq!(cpu.suggested_rows(0, 0, 0), 1);
}
