//! Runs of the kernels whose invocations work together: they cannot run natively, so plain host code says what they must write.

use super::{Case, Numbers};
use kernel_api::Access;
use parallax::backend::gpu::RawBinding;

/// All of them.
pub fn cases() -> Vec<Case> {
    let words = Numbers::new(8).words(640);
    let mut cases = vec![
        case("reduction", [64, 1, 1], 10, &words, vec![u32::MAX; 50], reduced(&words)),
        case("running_sum", [128, 1, 1], 5, &words, vec![u32::MAX; 640], summed(&words)),
        case("exchange_halves", [64, 1, 1], 10, &words, vec![u32::MAX; 640], exchanged(&words)),
        transposed(&mut Numbers::new(9)),
    ];
    let cells = [0, u32::MAX, 0, 0, 0, 0, 0, 0].repeat(10);
    cases.push(case("subgroup_operations", [64, 1, 1], 10, &words, cells, combined(&words)));
    cases.push(case("subgroup_convergence", [64, 1, 1], 10, &words, vec![0, 0], converged(&words)));
    for case in &mut cases[4..] {
        case.bindings[1].access = Access::Atomic;
    }
    cases
}

/// A kernel from words at binding 0 to words at binding 1, in one dimension.
fn case(
    entry: &str,
    threads: [u32; 3],
    groups: u32,
    words: &[u32],
    before: Vec<u32>,
    after: Vec<u32>,
) -> Case {
    let binding = |binding, access, words| RawBinding { set: 0, binding, access, words };
    Case {
        name: entry.into(),
        entry: entry.into(),
        threads,
        groups: [groups, 1, 1],
        bindings: vec![binding(0, Access::Read, words.to_vec()), binding(1, Access::Write, before)],
        push: Vec::new(),
        constants: Vec::new(),
        expected: vec![words.to_vec(), after],
    }
}

fn sum(words: &[u32]) -> u32 {
    words.iter().fold(0, |sum, word| sum.wrapping_add(*word))
}

fn reduced(words: &[u32]) -> Vec<u32> {
    let count = |group: &[u32], rest| group.iter().filter(|&&word| word & 3 == rest).count() as u32;
    let group =
        |group: &[u32]| [sum(group), count(group, 0), count(group, 1), count(group, 2), count(group, 3)];
    words.chunks(64).flat_map(group).collect()
}

fn summed(words: &[u32]) -> Vec<u32> {
    words.chunks(128).flat_map(|group| (1..=128).map(|end| sum(&group[..end]))).collect()
}

fn exchanged(words: &[u32]) -> Vec<u32> {
    let weighted = |group: &[u32], lane: usize| group[lane].wrapping_mul(if lane >= 32 { 1 } else { 2 });
    words
        .chunks(64)
        .flat_map(|group| (0..64).map(move |lane| weighted(group, lane ^ 32) ^ lane as u32))
        .collect()
}

/// A matrix of 24 × 24 pairs.
fn transposed(numbers: &mut Numbers) -> Case {
    let size = 24;
    let from: Vec<[u32; 2]> =
        (0..size * size).map(|_| [numbers.small().to_bits(), numbers.small().to_bits()]).collect();
    let to: Vec<u32> = (0..size * size).flat_map(|at| from[at % size * size + at / size]).collect();
    let poison = vec![u32::MAX; 2 * size * size];
    let mut case = case("transpose", [8, 8, 1], 3, bytemuck::cast_slice(&from), poison, to);
    case.groups = [3, 3, 1];
    case
}

fn combined(words: &[u32]) -> Vec<u32> {
    let group = |group: &[u32]| {
        let any = group.iter().any(|word| word & 63 == 5);
        let all = group.iter().all(|word| word & 0xff00_0000 != 0);
        let odd = group.iter().filter(|&&word| word & 1 == 1).count() as u32;
        let mixed = group.iter().fold(0, |mixed, word| mixed ^ word);
        let (least, most) = (group.iter().copied().min(), group.iter().copied().max());
        let flags = any as u32 | (!all as u32) << 1;
        [sum(group), least.unwrap_or(0), most.unwrap_or(0), odd, flags, mixed, 64, 64]
    };
    words.chunks(64).flat_map(group).collect()
}

fn converged(words: &[u32]) -> Vec<u32> {
    let kinds = words.iter().map(|word| if word & 1 == 0 { 1 } else { 2 }).sum();
    let even: Vec<u32> = words.iter().copied().filter(|word| word & 1 == 0).collect();
    vec![kinds, sum(&even)]
}
