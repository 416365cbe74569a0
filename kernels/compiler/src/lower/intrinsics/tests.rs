//! Each intrinsic against Rust's own function, on hostile operands.

use crate::lower::tests::{kernel, output};

const WORDS: [u32; 13] =
    [0, 1, 2, 31, 32, 127, 128, 255, 0x7fff, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX];

/// Runs `body`, which makes the word `%r` of the words `%x` and `%y`, on all pairs, and compares with `expected`.
fn check(body: &str, words: &[u32], expected: impl Fn(u32, u32) -> u32) {
    let body = format!(
        "  %second = getelementptr inbounds nuw i32, ptr %in, i64 1
  %y = load i32, ptr %second, align 4
{body}
  store i32 %r, ptr %out, align 4
  ret void"
    );
    let kernel = kernel(&body);
    for &x in words {
        for &y in words {
            let result = output(&kernel, &[x, y]).0[0];
            assert_eq!(result, expected(x, y), "of {x:#x} and {y:#x}: {body}");
        }
    }
}

fn call(name: &str) -> String {
    format!("  %r = call i32 @llvm.{name}.i32(i32 %x, i32 %y)")
}

#[test]
fn words() {
    check(&call("umin"), &WORDS, u32::min);
    check(&call("smax"), &WORDS, |x, y| (x as i32).max(y as i32) as u32);
    check(&call("uadd.sat"), &WORDS, u32::saturating_add);
    check(&call("usub.sat"), &WORDS, u32::saturating_sub);
    check(&call("sadd.sat"), &WORDS, |x, y| (x as i32).saturating_add(y as i32) as u32);
    check(&call("ssub.sat"), &WORDS, |x, y| (x as i32).saturating_sub(y as i32) as u32);
    check("  %r = call i32 @llvm.fshl.i32(i32 %x, i32 %x, i32 %y)", &WORDS, |x, y| x.rotate_left(y & 31));
    check("  %r = call i32 @llvm.fshr.i32(i32 %x, i32 %x, i32 %y)", &WORDS, |x, y| x.rotate_right(y & 31));
    check("  %r = call i32 @llvm.fshl.i32(i32 %x, i32 %y, i32 40)", &WORDS, |x, y| x << 8 | y >> 24);
    check("  %r = call i32 @llvm.bswap.i32(i32 %x)", &WORDS, |x, _| x.swap_bytes());
    check("  %r = call i32 @llvm.abs.i32(i32 %x, i1 false)", &WORDS, |x, _| (x as i32).wrapping_abs() as u32);
    check("  %r = call i32 @llvm.ctlz.i32(i32 %x, i1 false)", &WORDS, |x, _| x.leading_zeros());
    check("  %r = call i32 @llvm.cttz.i32(i32 %x, i1 false)", &WORDS, |x, _| x.trailing_zeros());
}

#[test]
fn overflow() {
    let flagged = |name: &str| {
        format!(
            "  %p = call {{ i32, i1 }} @llvm.{name}.with.overflow.i32(i32 %x, i32 %y)
  %v = extractvalue {{ i32, i1 }} %p, 0
  %o = extractvalue {{ i32, i1 }} %p, 1
  %r = select i1 %o, i32 -559038737, i32 %v"
        )
    };
    let or_dead = |(value, overflow): (u32, bool)| if overflow { 0xdead_beef } else { value };
    let signed = |(value, overflow): (i32, bool)| (value as u32, overflow);
    check(&flagged("uadd"), &WORDS, |x, y| or_dead(x.overflowing_add(y)));
    check(&flagged("usub"), &WORDS, |x, y| or_dead(x.overflowing_sub(y)));
    check(&flagged("umul"), &WORDS, |x, y| or_dead(x.overflowing_mul(y)));
    check(&flagged("sadd"), &WORDS, |x, y| or_dead(signed((x as i32).overflowing_add(y as i32))));
    check(&flagged("ssub"), &WORDS, |x, y| or_dead(signed((x as i32).overflowing_sub(y as i32))));
    check(&flagged("smul"), &WORDS, |x, y| or_dead(signed((x as i32).overflowing_mul(y as i32))));
}

/// Through `i8` and `i16`, which live in words.
#[test]
fn odd_widths() {
    let bytes = |call: &str| {
        format!(
            "  %a = trunc i32 %x to i8
  %b = trunc i32 %y to i8
{call}
  %r = zext i8 %q to i32"
        )
    };
    let byte = |name: &str| bytes(&format!("  %q = call i8 @llvm.{name}.i8(i8 %a, i8 %b)"));
    check(&byte("usub.sat"), &WORDS, |x, y| (x as u8).saturating_sub(y as u8).into());
    check(&byte("smin"), &WORDS, |x, y| u32::from((x as i8).min(y as i8) as u8));
    check(&bytes("  %q = call i8 @llvm.fshl.i8(i8 %a, i8 %a, i8 3)"), &WORDS, |x, _| {
        (x as u8).rotate_left(3).into()
    });
    check(&bytes("  %q = call i8 @llvm.ctlz.i8(i8 %a, i1 false)"), &WORDS, |x, _| (x as u8).leading_zeros());
    check(&bytes("  %q = call i8 @llvm.cttz.i8(i8 %a, i1 false)"), &WORDS, |x, _| (x as u8).trailing_zeros());
    check(&bytes("  %q = ashr i8 %a, 2"), &WORDS, |x, _| u32::from((x as i8 >> 2) as u8));
    check(&bytes("  %q = call i8 @llvm.scmp.i8.i32(i32 %x, i32 %y)"), &WORDS, |x, y| {
        u32::from((x as i32).cmp(&(y as i32)) as i8 as u8)
    });
    let product = "  %a = trunc i32 %x to i16
  %b = trunc i32 %y to i16
  %p = call { i16, i1 } @llvm.umul.with.overflow.i16(i16 %a, i16 %b)
  %o = extractvalue { i16, i1 } %p, 1
  %r = zext i1 %o to i32";
    check(product, &WORDS, |x, y| (x as u16).overflowing_mul(y as u16).1.into());
}

const FLOATS: [f32; 15] = [
    0.0,
    -0.0,
    0.5,
    -0.5,
    1.5,
    -2.5,
    255.5,
    -129.0,
    1e-40,
    8_388_609.0,
    2147483648.0,
    4294967296.0,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

/// As [`check`], for a body that makes the float `%f` of the floats `%a` and `%b`.
fn check_floats(body: &str, expected: impl Fn(f32, f32) -> u32) {
    let body = format!("  %a = bitcast i32 %x to float\n  %b = bitcast i32 %y to float\n{body}");
    check(&body, &FLOATS.map(f32::to_bits), |x, y| expected(f32::from_bits(x), f32::from_bits(y)));
}

#[test]
fn floats() {
    let float = |call: &str| format!("  %f = call float @llvm.{call}\n  %r = bitcast float %f to i32");
    check_floats(&float("copysign.f32(float %a, float %b)"), |a, b| a.copysign(b).to_bits());
    check_floats(
        &float("round.f32(float %a)"),
        |a, _| if a.is_nan() { a.to_bits() } else { a.round().to_bits() },
    );
    check_floats(&float("floor.f32(float %a)"), |a, _| a.floor().to_bits());
    check_floats("  %r = call i32 @llvm.fptoui.sat.i32.f32(float %a)", |a, _| a as u32);
    check_floats("  %r = call i32 @llvm.fptosi.sat.i32.f32(float %a)", |a, _| a as i32 as u32);
    check_floats("  %q = call i8 @llvm.fptosi.sat.i8.f32(float %a)\n  %r = sext i8 %q to i32", |a, _| {
        a as i8 as i32 as u32
    });
}

/// The first operand when the two are equal, zeros of either sign too; the number when one is a NaN.
#[test]
fn extremes_have_one_answer() {
    let float = |call: &str| format!("  %f = call float @llvm.{call}\n  %r = bitcast float %f to i32");
    let number = |a: f32, b: f32, chosen: f32| if a.is_nan() { b } else { chosen };
    check_floats(&float("minnum.f32(float %a, float %b)"), |a, b| {
        number(a, b, if b < a { b } else { a }).to_bits()
    });
    check_floats(&float("maxnum.f32(float %a, float %b)"), |a, b| {
        number(a, b, if b > a { b } else { a }).to_bits()
    });
}

#[test]
fn classes() {
    use std::num::FpCategory::*;
    let classes = |mask: u32| {
        format!("  %c = call i1 @llvm.is.fpclass.f32(float %a, i32 {mask})\n  %r = zext i1 %c to i32")
    };
    check_floats(&classes(3), |a, _| a.is_nan().into());
    check_floats(&classes(0b1000), |a, _| (a.classify() == Normal && a < 0.0).into());
    check_floats(&classes(0b00_1001_0000), |a, _| (a.classify() == Subnormal).into());
    check_floats(&classes(0b00_0110_0000), |a, _| (a == 0.0).into());
    check_floats(&classes(0b10_0000_0100), |a, _| a.is_infinite().into());
}
