//! A run of each kernel of `feature-kernels`.

use super::{Case, Native, Numbers, workgroups};
use feature_kernels::{
    arrays, atomics, bindings, constants, control, floats, ids, integers, loops, pointers, records,
};
use glam::{Mat3, Vec3, Vec4};

/// Words that the kernels read.
const WORDS: usize = 1024;
/// Words that they write: not a multiple of a workgroup's, so that the last one must guard.
const RESULTS: usize = 1000;

/// Everything, with the expected words from a native run or, where there is none, from plain host code.
///
/// # Errors
/// When a kernel panics on the CPU.
pub fn cases() -> anyhow::Result<Vec<Case>> {
    let mut native = Native::new()?;
    let mut cases = words(&mut native)?;
    cases.extend(invocations(&mut native)?);
    cases.extend(sources(&mut native)?);
    cases.extend(specialised(&mut native)?);
    cases.extend(shared(&mut native)?);
    cases.extend(structures(&mut native)?);
    cases.extend(workgroups::cases());
    Ok(cases)
}

/// Whether a case's kernel has no float arithmetic, so that contraction changes nothing in it.
pub fn is_of_integers(case: &Case) -> bool {
    const FLOATS: [&str; 22] = [
        "comparisons",
        "signs",
        "selection",
        "whole_numbers",
        "conversions",
        "sums",
        "quotients",
        "strict",
        "classes",
        "enumerations",
        "generics",
        "local_arrays",
        "tables",
        "large_records",
        "uniform_buffer",
        "push_constant",
        "outputs",
        "specialised",
        "aligned_records",
        "record_fields",
        "matrices",
        "packed_records",
    ];
    !FLOATS.contains(&case.entry.as_str())
}

/// Words as the kernels' table has them: any bits, some small, some special.
pub fn table(seed: u32) -> Vec<u32> {
    let mut numbers = Numbers::new(seed);
    let words = (0..WORDS).map(|k| match k % 16 {
        3 => numbers.below(16),
        7 => [0, 1, u32::MAX, 0x8000_0000, 0x7fff_ffff][k / 16 % 5],
        _ => numbers.word(),
    });
    words.collect()
}

/// The kernels from a table of words to one word for each invocation.
fn words(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let words = native.upload(&table(1))?;
    let groups = [WORDS as u32 / 64, 1, 1];
    macro_rules! run {
        ($($module:ident: $($pass:ident)*;)*) => {
            vec![$($({
                let out = native.create(RESULTS)?;
                native.case(&$module::$pass { words, out }, groups)?
            }),*),*]
        };
    }
    Ok(run! {
        control: Switches DenseSwitch DenseSwitchAgain StateMachine LabelledBlocks EarlyReturns ShortCircuits Enumerations Generics;
        loops: NestedLoops LoopExits LoopValues StackLoop Ranges UnevenRounds CarriedValues FixedPoint;
        integers: Shifts Rotations Bits Saturating Checked Wide ConstantDivisors VariableDivisors Order Narrow Powers Sorting;
        floats: Comparisons Signs Selection WholeNumbers Conversions Sums Quotients Strict Classes;
        arrays: LocalArrays Tables LargeRecords NestedArrays StaticTable WholeArrays Ring Registers;
        pointers: Split Chunks Windows OptionalReferences SlicePatterns Iterators ChosenReferences Tails Searches;
    })
}

/// Ids in one to three dimensions.
fn invocations(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let (line, plane, space) =
        (native.create(5 * 64)?, native.create(3 * 8 * 5 * 4)?, native.create(24 * 2 * 3 * 2)?);
    Ok(vec![
        native.case(&ids::Ids1d { out: line }, [5, 1, 1])?,
        native.case(&ids::Ids2d { out: plane }, [3, 5, 1])?,
        native.case(&ids::Ids3d { out: space }, [2, 3, 2])?,
    ])
}

/// Uniforms, push constants, several outputs, lengths.
fn sources(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let words = native.upload(&table(2))?;
    let direction = Vec3::new(0.5, -3.25, 8.0);
    let shared = bindings::Shared { count: 900, step: 37, scale: 0.375, unused: 0, direction, unused_too: 0 };
    let (first, second) = (native.create(300)?, native.create(300)?);
    let (sums, products) = (native.create(100)?, native.create(70)?);
    let (records, out) = (native.upload(&[[0.0f32; 3]; 11])?, native.create(4)?);
    Ok(vec![
        native.case(&bindings::UniformBuffer { shared, words, out: first }, [5, 1, 1])?,
        native.case(&bindings::PushConstant { shared, words, out: second }, [5, 1, 1])?,
        native.case(&bindings::Outputs { sums, words, products }, [4, 1, 1])?,
        native.case(&bindings::Lengths { words, records, out }, [1, 1, 1])?,
    ])
}

/// The same kernel with two sets of constants.
fn specialised(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let mut numbers = Numbers::new(3);
    let numbers = native.upload(&(0..128).map(|_| numbers.small()).collect::<Vec<f32>>())?;
    let mut cases = Vec::new();
    for (rounds, factor, add_id) in [(3, -0.5, true), (5, 0.25, false), (0, 2.0, true)] {
        let out = native.create(128)?;
        let pass = constants::Specialised { rounds, factor, add_id, numbers, out };
        let mut case = native.case(&pass, [2, 1, 1])?;
        case.name = format!("specialised({rounds}, {factor}, {add_id})");
        cases.push(case);
    }
    // As the first, but with what the module itself says.
    let mut defaults = cases[0].clone();
    defaults.name = "specialised by default".into();
    defaults.constants.clear();
    cases.push(defaults);
    Ok(cases)
}

/// Atomic operations.
fn shared(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let numbers: Vec<u32> = Numbers::new(4).words(256);
    let signed: Vec<i32> = numbers.iter().map(|&word| word as i32).collect();
    let (words, numbers) = (native.upload(&numbers)?, native.upload(&signed)?);
    let mut start = vec![0u32; 16 + 256 + 256];
    (start[2], start[4]) = (u32::MAX, u32::MAX);
    let mut start_signed = vec![0i32; 8 + 256];
    (start_signed[2], start_signed[3], start_signed[4]) = (i32::MAX, i32::MIN, -1);
    let (cells, cells_signed) = (native.upload(&start)?, native.upload(&start_signed)?);
    Ok(vec![
        native.case(&atomics::AtomicsU32 { words, cells }, [4, 1, 1])?,
        native.case(&atomics::AtomicsI32 { numbers, cells: cells_signed }, [4, 1, 1])?,
    ])
}

/// Records of several shapes.
fn structures(native: &mut Native) -> anyhow::Result<Vec<Case>> {
    let mut numbers = Numbers::new(5);
    let mut vector = || Vec3::new(numbers.small(), numbers.small(), numbers.small());
    let nodes: Vec<records::Node> = (0..128u32)
        .map(|k| records::Node {
            low: vector(),
            first: k * 77 + 5,
            high: vector(),
            count: k.wrapping_mul(0x9e37_79b1) >> 7,
        })
        .collect();
    let matrices: Vec<Mat3> = (0..4).map(|_| Mat3::from_cols(vector(), vector(), vector())).collect();
    let vectors: Vec<Vec4> = (0..100).map(|k| vector().extend(k as f32)).collect();
    let packed: Vec<records::Packed> = (0..90u16)
        .map(|k| records::Packed {
            bytes: [k as u8, 255 - k as u8, 3, (k * 7) as u8],
            halves: [k * 600, k],
            numbers: std::array::from_fn(|i| k as f32 + i as f32 / 8.0),
        })
        .collect();
    let (from, to, out) = (native.upload(&nodes)?, native.create(100)?, native.create(200)?);
    let (matrices, vectors, moved) =
        (native.upload(&matrices)?, native.upload(&vectors)?, native.create(100)?);
    let (packed, parts) = (native.upload(&packed)?, native.create(90)?);
    let (left, right, chosen) =
        (native.upload(&table(6))?, native.upload(&table(7))?, native.create(RESULTS)?);
    Ok(vec![
        native.case(&records::AlignedRecords { from, to }, [2, 1, 1])?,
        native.case(&records::RecordFields { nodes: from, out }, [4, 1, 1])?,
        native.case(&records::PackedRecords { from: packed, out: parts }, [2, 1, 1])?,
        native.case(&records::Matrices { matrices, vectors, out: moved }, [2, 1, 1])?,
        native.case(&pointers::ChosenBuffer { left, right, out: chosen }, [16, 1, 1])?,
    ])
}
