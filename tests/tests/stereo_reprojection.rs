//! Where a point of one view lies in the other: rounded to the nearest pixel, half a pixel up, against f64.

use parallax_shared::camera::disparity_px;
use parallax_shared::stereo::reprojection::{nearer_by_a_pixel, shift_px, target};
use parallax_tests::tables::reprojection;

/// Beyond this many pixels all disparities are one.
const FARTHEST: f64 = 1_048_576.0;

const INTERAXIALS: [f32; 7] = [0.3, 1.0, 2.5, 15.0, 50.0, 1234.56, 10_000.0];

/// Whether the shift of `t` is farther than half a pixel from e (t − 1) / t, the roundings of three operations granted.
fn too_far(t: f32, e: f32, shift: impl Fn(f32) -> i32) -> bool {
    let exact = f64::from(e) * (f64::from(t) - 1.0) / f64::from(t);
    let exact = exact.clamp(-FARTHEST, FARTHEST);
    let bound = 0.5 + 3.0 * 2f64.powi(-24) * exact.abs();
    (f64::from(shift(disparity_px(e, t))) - exact).abs() > bound
}

#[test]
fn a_shift_is_within_half_a_pixel_of_the_disparity() {
    // A stride that is coprime to 2³¹ visits numbers of every exponent, the infinite one last.
    let mut bits = 0_u32;
    for i in 0..10_000_000_u32 {
        bits = bits.wrapping_add(0x9E37_79B1);
        let t = f32::from_bits((bits >> 1).min(f32::INFINITY.to_bits()).max(1));
        let e = INTERAXIALS[i as usize % INTERAXIALS.len()];
        if t < f32::INFINITY {
            assert!(!too_far(t, e, shift_px), "t {t} e {e}");
        } else {
            assert_eq!(f64::from(shift_px(disparity_px(e, t))), (f64::from(e) + 0.5).floor());
        }
    }
}

/// Disparities that f32 holds exactly, halves among them.
#[test]
fn halves_go_to_the_right() {
    let mut ties = 0;
    for quarters in -4000..4000 {
        for power in -6..7 {
            let (e, t) = (quarters as f32 / 4.0, 2f32.powi(power));
            let exact = f64::from(e) * (f64::from(t) - 1.0) / f64::from(t);
            assert_eq!(f64::from(shift_px(disparity_px(e, t))), (exact + 0.5).floor(), "t {t} e {e}");
            ties += u32::from((exact + 0.5).fract() == 0.0);
        }
    }
    assert!(ties > 10_000, "{ties}");
}

/// ⌊D + ½⌋ rounds the sum first, and is one too large just below a half.
#[test]
fn just_below_a_half_is_below_it() {
    let below = f32::from_bits(0.5_f32.to_bits() - 1);
    assert_eq!((shift_px(below), shift_px(0.5), (below + 0.5).floor()), (0, 1, 1.0));
    assert_eq!((shift_px(-0.5), shift_px(f32::from_bits((-0.5_f32).to_bits() + 1))), (0, -1));
    assert_eq!((shift_px(-below), shift_px(f32::from_bits(1)), shift_px(-f32::from_bits(1))), (0, 0, 0));
    for far in [8_388_607.5, 3e9, f32::INFINITY] {
        assert_eq!(
            [shift_px(-far), shift_px(far)],
            [-1_048_576, 1_048_576],
            "clamped before it is converted"
        );
    }
}

#[test]
fn what_has_no_disparity_is_outside() {
    let p = |e| reprojection(100, 1, e);
    for x in [0, 50, 99] {
        assert_eq!(target(&p(15.0), 0.0, x), -1);
        assert_eq!(target(&p(0.0), 0.0, x), -1, "0 · ∞");
        assert_eq!(target(&p(15.0), f32::from_bits(1), x), -1);
        assert_eq!(target(&p(1e4), f32::INFINITY, x), 100);
        assert_eq!(target(&p(0.0), f32::INFINITY, x), x as i32);
        assert_eq!(target(&p(15.0), 1.0, x), x as i32);
    }
    assert_eq!(target(&p(15.0), f32::INFINITY, 84), 99);
    assert_eq!(target(&p(15.0), f32::INFINITY, 85), 100);
    assert_eq!(target(&p(15.0), 0.5, 15), 0);
    assert_eq!(target(&p(15.0), 0.5, 14), -1);
}

/// The largest `t` of a surface that hides one at `t` and lies a pixel farther left.
#[test]
fn nearer_by_a_pixel_is_a_pixel_of_disparity() {
    for e in INTERAXIALS {
        for t in [1e-3, 0.1, 0.5, 1.0, 3.0, 100.0, 1e6_f32] {
            let nearer = f64::from(nearer_by_a_pixel(e, t));
            let disparity = |t: f64| f64::from(e) * (t - 1.0) / t;
            let between = disparity(f64::from(t)) - disparity(nearer);
            assert!((between - 1.0).abs() < 1e-5 * (1.0 + f64::from(e / t)), "t {t} e {e}: {between}");
        }
        assert_eq!(nearer_by_a_pixel(e, f32::INFINITY), f32::INFINITY, "anything is nearer than the sky");
    }
    for t in [0.0, 3.0, f32::INFINITY] {
        assert_eq!(nearer_by_a_pixel(0.0, t), 0.0, "without a second eye nothing is");
    }
    assert_eq!(nearer_by_a_pixel(15.0, 0.0), 0.0);
}
