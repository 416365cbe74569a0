//! The arithmetic of `shared::math`: division and square root corrected from approximations that are off, and what functions decide where
//! their arguments are special. Their accuracy is a hard case (`parallax::verify::cases::arithmetic`).

use parallax_shared::math::{self, vector};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z >> 32) as u32
    }

    /// Uniform in `low .. high`.
    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.next() >> 8) as f32 / 16_777_216.0
    }
}

fn nudge(x: f32, ulps: i32) -> f32 {
    f32::from_bits((x.to_bits() as i32 + ulps) as u32)
}

fn same(a: f32, b: f32) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Every kind of operand that has a rule of its own in IEEE 754.
const HOSTILE: [u32; 24] = [
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x8000_0001,
    0x0000_0002,
    0x0000_0003,
    0x007f_ffff,
    0x807f_ffff,
    0x0080_0000,
    0x0080_0001,
    0x00ff_ffff,
    0x3f7f_ffff,
    0x3f80_0000,
    0xbf80_0000,
    0x3f80_0001,
    0x4000_0000,
    0x4040_0000,
    0x7e80_0000,
    0x7f7f_ffff,
    0xff7f_ffff,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0x4b80_0001,
];

/// Pairs of four kinds: any bits; denormal or tiny dividends; quotients at the edge of the denormals; few
/// significant bits (ties).
fn hostile_pair(random: &mut Random, kind: u64) -> (f32, f32) {
    let (mut a, mut b) = (random.next(), random.next());
    match kind % 4 {
        1 => a &= 0x807f_ffff | (random.next() & 0x0180_0000),
        2 => {
            b = (b & 0x007f_ffff) | 0x3f80_0000;
            a = (a & 0x007f_ffff) | ((random.next() % 30) << 23);
        }
        3 => {
            a = (a & 0xff80_0000) | (a & 7) | 0x7f_fff8;
            b &= 0xff80_0007;
        }
        _ => {}
    }
    (f32::from_bits(a), f32::from_bits(b))
}

#[test]
fn corrected_division_is_the_hardwares_from_approximations_off_by_ten_ulps() {
    let mut random = Random(1);
    let check = |a: f32, b: f32, error: i32| {
        let got = math::div_from(a, b, |n, d| nudge(n / d, error));
        assert!(
            same(got, a / b),
            "{:08x} / {:08x} = {:08x} (error {error})",
            a.to_bits(),
            b.to_bits(),
            got.to_bits()
        );
    };
    for a in HOSTILE {
        for b in HOSTILE {
            (-10..=10).for_each(|error| check(f32::from_bits(a), f32::from_bits(b), error));
        }
    }
    for i in 0..4_000_000 {
        let (a, b) = hostile_pair(&mut random, i);
        check(a, b, (i % 21) as i32 - 10);
        assert!(same(math::div_corrected(a, b), a / b));
        assert!(same(math::div(a, b), a / b));
    }
}

#[test]
fn corrected_square_root_is_the_hardwares_from_approximations_off_by_ten_ulps() {
    // A stride that is coprime to 2³² visits inputs of every exponent and sign.
    let mut bits = 0u32;
    for i in 0..4_000_000 {
        bits = bits.wrapping_add(0x9E37_79B1);
        let a = f32::from_bits(HOSTILE.get(i).copied().unwrap_or(bits));
        let error = (i % 21) as i32 - 10;
        let got = math::sqrt_from(a, |n| nudge(n.sqrt(), error));
        assert!(same(got, a.sqrt()), "sqrt {:08x} = {:08x} (error {error})", a.to_bits(), got.to_bits());
        assert!(same(math::sqrt(a), a.sqrt()));
    }
}

#[test]
fn square_roots_next_to_perfect_squares_round_correctly() {
    for root in (1 << 11)..(1 << 12) {
        for step in -2..=2 {
            let a = nudge((root * root) as f32, step);
            assert!(same(math::sqrt_corrected(a), a.sqrt()), "{a}");
        }
    }
}

/// The comparison above can fail: an approximation outside of the stated margin is not always corrected.
#[test]
fn an_approximation_off_by_sixty_ulps_is_not_corrected() {
    let mut random = Random(3);
    let wrong = (0..10_000).filter(|_| {
        let (a, b) = (random.between(1.0, 2.0), random.between(1.0, 2.0));
        !same(math::div_from(a, b, |n, d| nudge(n / d, 60)), a / b)
    });
    assert!(wrong.count() > 0);
}

#[test]
fn minimum_maximum_and_clamp_have_the_stated_zeros_and_nans() {
    let nan = f32::NAN;
    assert!(same(math::min(0.0, -0.0), -0.0) && same(math::min(-0.0, 0.0), 0.0));
    assert!(same(math::max(0.0, -0.0), -0.0) && same(math::max(-0.0, 0.0), 0.0));
    assert!(same(math::min(nan, 1.0), 1.0) && same(math::min(1.0, nan), nan));
    assert!(same(math::max(nan, 1.0), 1.0) && same(math::max(1.0, nan), nan));
    assert!(same(math::clamp(nan, 2.0, 3.0), 2.0) && same(math::clamp(9.0, 2.0, 3.0), 3.0));
    assert!(math::is_nan(nan) && math::is_nan(-nan) && !math::is_nan(f32::INFINITY));
    assert!(math::is_finite(f32::MAX) && !math::is_finite(f32::INFINITY) && !math::is_finite(nan));
    assert!(same(math::abs(-0.0), 0.0) && same(math::copysign(-2.0, 1.0), 2.0));
}

#[test]
fn floor_is_exact_and_never_minus_zero() {
    let mut random = Random(4);
    for _ in 0..200_000 {
        let x = f32::from_bits(random.next());
        if x.is_nan() {
            continue;
        }
        let want = if x.abs() < 8_388_608.0 && x.floor() == 0.0 { 0.0 } else { x.floor() };
        assert!(same(math::floor(x), want), "{x}");
        if x.abs() < 2e9 {
            assert_eq!(math::floor_to_int(x), want as i32);
        }
    }
    assert!(math::floor(f32::NAN).is_nan());
}

#[test]
fn exp2_decides_its_edge_cases() {
    (-126..128).for_each(|n| assert_eq!(math::exp2(n as f32), 2f64.powi(n) as f32));
    assert_eq!(math::exp2(128.0), f32::INFINITY);
    assert_eq!(math::exp2(-126.5), 0.0);
    assert_eq!(math::exp2(f32::NEG_INFINITY), 0.0);
    assert!(math::exp2(f32::NAN).is_nan());
}

#[test]
fn log2_decides_its_edge_cases() {
    assert_eq!(math::log2(1.0), 0.0);
    assert_eq!(math::log2(f32::from_bits(1)), -149.0);
    assert_eq!(math::log2(-0.0), f32::NEG_INFINITY);
    assert_eq!(math::log2(f32::INFINITY), f32::INFINITY);
    assert!(
        math::log2(-1.0).is_nan() && math::log2(f32::NAN).is_nan() && math::log2(f32::NEG_INFINITY).is_nan()
    );
}

#[test]
fn powers_decide_their_edge_cases() {
    assert_eq!(math::pow(0.0, 0.0), 1.0);
    assert_eq!(math::pow(0.0, 0.5), 0.0);
    assert_eq!(math::pow(0.0, -0.5), f32::INFINITY);
    assert_eq!(math::pow(0.5, 100.0), 0.0, "what would become denormal on the way ends at zero");
    assert_eq!(math::pow(0.5, 200.5), 0.0);
    assert_eq!(math::pow(1.0, 65_536.0), 1.0);
    assert_eq!(math::powi(-2.0, 3), -8.0);
    assert!(math::pow(-1.0, 0.5).is_nan());
}

#[test]
fn atan2_decides_its_edge_cases() {
    assert!(same(math::atan2(0.0, -0.0), 0.0) && same(math::atan2(-0.0, 0.0), -0.0));
    assert_eq!(math::atan2(0.0, -1.0), math::PI);
    assert_eq!(math::atan2(-0.0, -1.0), -math::PI);
    assert_eq!(math::atan2(1.0, 0.0), 0.5 * math::PI);
    assert_eq!(math::atan2(1.0, f32::INFINITY), 0.0);
    assert_eq!(math::atan2(1e-40, 1.0), 0.0);
    assert!(math::atan2(f32::NAN, 1.0).is_nan() && math::atan2(1.0, f32::NAN).is_nan());
    assert!(math::atan2(f32::INFINITY, f32::INFINITY).is_nan());
}

#[test]
fn normalised_vectors_have_unit_length() {
    use glam::Vec3;
    let mut random = Random(9);
    for _ in 0..100_000 {
        let scale = math::exp2(random.between(-50.0, 60.0));
        let v = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0))
            * scale;
        let n = vector::normalize(v);
        let square = n.to_array().iter().map(|&c| c as f64 * c as f64).sum::<f64>();
        assert!((square.sqrt() - 1.0).abs() <= 2.0 * f32::EPSILON as f64, "{v}");
    }
    assert_eq!(vector::normalize(Vec3::ZERO), Vec3::ZERO);
    assert_eq!(vector::reflect(Vec3::new(1.0, -1.0, 0.0), Vec3::Y), Vec3::new(1.0, 1.0, 0.0));
}
