//! The comparator passes what is equal, and fails for every reason for which it should.

use parallax::backend::Profile;
use parallax::compare::{Bound, Kind, Stage, StageReport, compare};

const WIDTH: usize = 16;
const HEIGHT: usize = 8;

fn stage(kind: Kind, components: usize) -> Stage<'static> {
    Stage { view: "left", stage: "test", kind, components, bound: Bound::EXACT }
}

/// A picture of three floats per pixel, no two of which are equal.
fn picture() -> Vec<u32> {
    (0..WIDTH * HEIGHT * 3).map(|i| (i as f32 * 0.123 - 7.0).to_bits()).collect()
}

/// What is reported after `change` to the right side.
fn after(change: impl FnOnce(&mut Vec<u32>)) -> StageReport {
    let (left, mut right) = (picture(), picture());
    change(&mut right);
    compare(&stage(Kind::Float, 3), &left, &right)
}

fn fast(kind: Kind) -> Stage<'static> {
    Stage { bound: Bound::of(Profile::Fast, kind), ..stage(kind, 1) }
}

#[test]
fn identical_sides_pass() {
    let report = after(|_| ());
    assert!(report.equal, "{report:?}");
    assert_eq!((report.elements, report.differing, report.first_differing), (WIDTH * HEIGHT, 0, None));
    assert_eq!((report.max_ulps, report.max_absolute, report.mean_squared_error), (0, 0.0, 0.0));
}

#[test]
fn one_flipped_bit_fails() {
    for bit in 0..32 {
        let report = after(|right| right[100] ^= 1 << bit);
        assert!(!report.equal, "bit {bit}");
        let first = report.first_differing.unwrap();
        assert_eq!((report.differing, first.index, first.component), (1, 33, 1));
        assert!(first.left.starts_with("5.3"), "{}", first.left);
    }
}

#[test]
fn one_nan_fails_even_on_both_sides() {
    let nan = f32::NAN.to_bits();
    let report = after(|right| right[5] = nan);
    assert_eq!((report.equal, report.differing, report.not_finite), (false, 1, 1));
    let (mut left, mut right) = (picture(), picture());
    (left[5], right[5]) = (nan, nan);
    let report = compare(&stage(Kind::Float, 3), &left, &right);
    assert_eq!((report.equal, report.differing, report.not_finite), (false, 1, 1));
}

#[test]
fn an_infinity_passes_only_where_one_is_due() {
    let [infinity, minus] = [f32::INFINITY, f32::NEG_INFINITY].map(f32::to_bits);
    let both = |kind, word| compare(&stage(kind, 1), &[0, word], &[0, word]);
    assert!(!both(Kind::Float, infinity).equal);
    assert!(both(Kind::FloatOrInfinity, infinity).equal);
    assert!(!both(Kind::FloatOrInfinity, minus).equal);
    let report = compare(&fast(Kind::FloatOrInfinity), &[infinity], &[f32::MAX.to_bits()]);
    assert_eq!((report.equal, report.differing), (false, 1), "one ULP apart, and nothing alike");
}

#[test]
fn one_shifted_row_fails() {
    let report = after(|right| right[3 * WIDTH * 3..4 * WIDTH * 3].rotate_right(3));
    assert_eq!((report.equal, report.differing), (false, WIDTH));
    assert_eq!(report.first_differing.unwrap().index, 3 * WIDTH);
}

#[test]
fn an_unwritten_element_fails_even_on_both_sides() {
    // Vectors, as equal constants may be the same memory.
    let both = |kind| {
        let side = vec![1, u32::MAX];
        compare(&stage(kind, 1), &side, &side.clone())
    };
    for kind in [Kind::Word, Kind::Float, Kind::FloatOrInfinity] {
        let report = both(kind);
        assert_eq!((report.equal, report.unwritten, report.differing), (false, 1, 1), "{kind:?}");
        assert_eq!(report.first_differing.unwrap().right, "unwritten");
    }
    assert!(both(Kind::AnyWord).equal);
}

#[test]
fn sides_that_cannot_be_compared_fail() {
    let problem = |left: &[u32], right: &[u32]| {
        let report = compare(&stage(Kind::Word, 2), left, right);
        assert!(!report.equal);
        report.problem.unwrap()
    };
    let three = vec![1, 2, 3];
    assert_eq!(problem(&[1, 2, 3, 4], &[1, 2]), "the sides have 4 and 2 words");
    assert_eq!(problem(&[], &[]), "there is nothing to compare");
    assert_eq!(problem(&three, &three.clone()), "3 words are no whole elements of 2");
    let own = [1, 2];
    assert_eq!(problem(&own, &own), "both sides are the same memory");
    assert!(!compare(&stage(Kind::Word, 0), &three, &three.clone()).equal);
}

#[test]
fn the_zeros_differ_in_the_strict_profile_alone() {
    let zeros = [[0.0_f32.to_bits()], [(-0.0_f32).to_bits()]];
    assert!(!compare(&stage(Kind::Float, 1), &zeros[0], &zeros[1]).equal);
    assert!(compare(&fast(Kind::Float), &zeros[0], &zeros[1]).equal);
}

#[test]
fn the_fast_profile_has_bounds() {
    let one = |ulps: i32| {
        let right = [(1000.0_f32.to_bits() as i32 + ulps) as u32];
        compare(&fast(Kind::Float), &[1000.0_f32.to_bits()], &right)
    };
    assert!(one(256).equal && one(-256).equal);
    assert_eq!((one(-3).max_ulps, one(257).equal, one(-257).equal), (3, false, false));
    let near_zero = |value: f32| compare(&fast(Kind::Float), &[0], &[value.to_bits()]).equal;
    assert!(near_zero(1e-4) && near_zero(-1e-4) && !near_zero(1.01e-4));
    assert!(!compare(&fast(Kind::Word), &[7], &[8]).equal);
}

#[test]
fn the_fast_profile_tolerates_a_share_of_elements() {
    let left = vec![1u32; 1000];
    let report = |count: usize| {
        let mut right = left.clone();
        right[..count].fill(2);
        compare(&fast(Kind::AnyWord), &left, &right)
    };
    assert_eq!((report(2).equal, report(2).differing), (true, 2));
    assert!(!report(3).equal);
    let mut right = vec![1.0_f32.to_bits(); 1000];
    let left = right.clone();
    right[0] = f32::NAN.to_bits();
    assert!(!compare(&fast(Kind::Float), &left, &right).equal, "a NaN is never tolerated");
}

#[test]
fn errors_are_measured() {
    let bits = |values: [f32; 2]| values.map(f32::to_bits);
    let report = compare(&fast(Kind::Float), &bits([1.0, 2.0]), &bits([1.5, 2.0]));
    assert_eq!((report.max_absolute, report.mean_squared_error, report.max_ulps), (0.5, 0.125, 1 << 22));
    assert_eq!(report.first_differing.unwrap().right, "1.5e0 (0x3fc00000)");
}
