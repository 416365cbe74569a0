use crate::ir::{BinaryOp, Op};
use crate::lower::tests::{count, kernel, output};

#[test]
fn equal_values_are_computed_once_where_one_dominates() {
    let k = kernel(
        "  %a = mul i32 %x, 3
  %c = icmp ult i32 %x, 5
  br i1 %c, label %then, label %else
then:
  %b = mul i32 %x, 3
  %d = mul i32 %x, 7
  br label %join
else:
  %e = mul i32 %x, 7
  br label %join
join:
  %p = phi i32 [ %d, %then ], [ %e, %else ]
  %q = phi i32 [ %b, %then ], [ %a, %else ]
  %r = add i32 %p, %q
  store i32 %r, ptr %out, align 4
  ret void",
    );
    assert_eq!(
        count(&k, |op| matches!(op, Op::Binary(BinaryOp::Mul, ..))),
        3,
        "no side of the branch dominates the other"
    );
    assert_eq!(count(&k, |op| matches!(op, Op::Phi(_))), 1);
    assert_eq!([2, 9].map(|x| output(&k, &[x]).0[0]), [20, 90]);
}

#[test]
fn loads_are_merged_from_buffers_that_are_only_read() {
    let load_twice = |buffer: &str| {
        kernel(&format!(
            "  %a = load i32, ptr {buffer}, align 4
  store i32 9, ptr %out, align 4
  %b = load i32, ptr {buffer}, align 4
  %s = add i32 %a, %b
  %o = getelementptr inbounds nuw i32, ptr %out, i64 1
  store i32 %s, ptr %o, align 4
  ret void"
        ))
    };
    let loads = |op: &Op| matches!(op, Op::LoadWord(..));
    assert_eq!(count(&load_twice("%in"), loads), 1);
    let written = load_twice("%out");
    assert_eq!(count(&written, loads), 2);
    assert_eq!(output(&written, &[0]).0[1], 9);
}

#[test]
fn phis_that_only_use_each_other_go() {
    let k = kernel(
        "  br label %head
head:
  %i = phi i32 [ 0, %start ], [ %n, %head ]
  %dead = phi i32 [ 0, %start ], [ %d, %head ]
  %d = add i32 %dead, %x
  %n = add i32 %i, 1
  %c = icmp ult i32 %n, %x
  br i1 %c, label %head, label %exit
exit:
  store i32 %n, ptr %out, align 4
  ret void",
    );
    assert_eq!(count(&k, |op| matches!(op, Op::Phi(_))), 1);
    assert_eq!(output(&k, &[6]).0[0], 6);
}

#[test]
fn arithmetic_with_constant_zeros_is_spelled_out() {
    type Case = (&'static str, fn(f32) -> f32);
    let cases: [Case; 6] = [
        ("fadd float %f, 0.000000e+00", |x| x + 0.0),
        ("fadd float -0.000000e+00, %f", |x| -0.0 + x),
        ("fsub float %f, 0.000000e+00", |x| x - 0.0),
        ("fsub float 0.000000e+00, %f", |x| 0.0 - x),
        ("fmul float %f, 0.000000e+00", |x| x * 0.0),
        ("fmul float -0.000000e+00, %f", |x| -0.0 * x),
    ];
    for (instruction, expected) in cases {
        let k = kernel(&format!(
            "  %f = bitcast i32 %x to float
  %r = {instruction}
  %b = bitcast float %r to i32
  store i32 %b, ptr %out, align 4
  ret void"
        ));
        let left =
            count(&k, |op| matches!(op, Op::Binary(BinaryOp::FAdd | BinaryOp::FSub | BinaryOp::FMul, ..)));
        assert_eq!(left, 0, "{instruction}");
        for x in [0.0, -0.0, 1.5, -1.5, 1e-40, f32::MAX, f32::INFINITY, -f32::INFINITY, f32::NAN] {
            let (result, expected) = (f32::from_bits(output(&k, &[x.to_bits()]).0[0]), expected(x));
            let same = result.to_bits() == expected.to_bits() || result.is_nan() && expected.is_nan();
            assert!(same, "{instruction} of {x}: {result} instead of {expected}");
        }
    }
}
