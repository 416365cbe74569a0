use super::{compile, count, kernel, output};
use crate::ir::{BinaryOp, Op};
use crate::refusal::Reason;

/// `for i in 0..n { sum += a[i] }` with a counter of 64 bits.
#[test]
fn a_counter_is_a_word() {
    let k = kernel(
        "  %n = zext i32 %x to i64
  br label %head
head:
  %i = phi i64 [ 1, %start ], [ %next, %head ]
  %sum = phi i32 [ 0, %start ], [ %s, %head ]
  %p = getelementptr inbounds nuw i32, ptr %in, i64 %i
  %v = load i32, ptr %p, align 4
  %s = add i32 %sum, %v
  %next = add nuw nsw i64 %i, 1
  %more = icmp ule i64 %next, %n
  br i1 %more, label %head, label %exit
exit:
  store i32 %s, ptr %out, align 4
  ret void",
    );
    assert_eq!(k.wide_values(), []);
    assert_eq!(output(&k, &[3, 1, 2, 4, 8]).0[0], 7);
}

/// An index into records costs no multiplication: the factor meets the size of the record.
#[test]
fn factors_meet() {
    let k = kernel(
        "  %i = zext i32 %x to i64
  %b = mul nuw nsw i64 %i, 16
  %p = getelementptr inbounds nuw i8, ptr %rows, i64 %b
  %f = getelementptr inbounds nuw i8, ptr %p, i64 4
  %v = load i32, ptr %f, align 4
  store i32 %v, ptr %out, align 4
  ret void",
    );
    assert_eq!(count(&k, |op| matches!(op, Op::Binary(BinaryOp::Mul, ..))), 0);
    assert_eq!(output(&k, &[2]).0[0], 109);
}

/// A product that wraps is an index all the same, and must not be divided as if it had not.
#[test]
fn a_wrapping_product_keeps_its_bits() {
    let k = kernel(
        "  %h = mul i32 %x, 8
  %i = zext i32 %h to i64
  %p = getelementptr inbounds nuw i8, ptr %in, i64 %i
  %v = load i32, ptr %p, align 4
  store i32 %v, ptr %out, align 4
  ret void",
    );
    assert_eq!(output(&k, &[0x2000_0001, 1, 77]).0[0], 77);
}

/// A hash of 64 bits that is masked to an index is no `usize`: its comparison needs both halves.
#[test]
fn a_masked_hash_is_compared_whole() {
    let k = kernel(
        "  %w = zext i32 %x to i64
  %h = mul i64 %w, -7046029254386353131
  %i = and i64 %h, 3
  %p = getelementptr inbounds nuw i32, ptr %in, i64 %i
  %v = load i32, ptr %p, align 4
  %big = icmp ugt i64 %h, 9223372036854775808
  %b = zext i1 %big to i32
  %r = add i32 %v, %b
  store i32 %r, ptr %out, align 4
  ret void",
    );
    assert_eq!(k.wide_values(), []);
    for x in [1, 2, 3, 77, u32::MAX] {
        let hash = u64::from(x).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let input = [x, 10, 20, 30];
        let expected = input[hash as usize & 3].wrapping_add(u32::from(hash > 1 << 63));
        assert_eq!(output(&k, &input).0[0], expected);
    }
}

/// An operation on the `i64`s `%a` and `%b`, and what Rust makes of them.
type Case = (&'static str, fn(u64, u64) -> u64);

/// All that two words can do, against `u64` and `i64`.
#[test]
fn halves_do_what_wide_integers_do() {
    let cases: [Case; 9] = [
        ("%r = add i64 %a, %b", u64::wrapping_add),
        ("%r = sub i64 %a, %b", u64::wrapping_sub),
        ("%r = mul i64 %a, %b", u64::wrapping_mul),
        ("%r = shl i64 %a, 7", |a, _| a << 7),
        ("%r = shl i64 %a, 45", |a, _| a << 45),
        ("%r = lshr i64 %a, 7", |a, _| a >> 7),
        ("%r = lshr i64 %a, 45", |a, _| a >> 45),
        ("%r = ashr i64 %a, 33", |a, _| (a as i64 >> 33) as u64),
        ("%c = icmp slt i64 %a, %b\n  %r = select i1 %c, i64 %a, i64 %b", |a, b| {
            (a as i64).min(b as i64) as u64
        }),
    ];
    let values = [0, 1, 0xffff_ffff, 0x1_0000_0000, 0x8000_0000_0000_0000, 0x1234_5678_9abc_def0, u64::MAX];
    for (op, expected) in cases {
        let k = kernel(&format!(
            "  %a = load i64, ptr %in, align 4
  %q = getelementptr inbounds nuw i8, ptr %in, i64 8
  %b = load i64, ptr %q, align 4
  {op}
  store i64 %r, ptr %out, align 4
  ret void"
        ));
        assert_eq!(k.wide_values(), [], "{op}");
        for (a, b) in values.iter().flat_map(|a| values.iter().map(move |b| (*a, *b))) {
            let words = [a as u32, (a >> 32) as u32, b as u32, (b >> 32) as u32];
            let out = output(&k, &words).0;
            assert_eq!(
                u64::from(out[0]) | u64::from(out[1]) << 32,
                expected(a, b),
                "{op} of {a:#x} and {b:#x}"
            );
        }
    }
}

#[test]
fn a_wide_division_is_refused() {
    let front = compile(
        "  %a = load i64, ptr %in, align 4
  %r = udiv i64 %a, 10000000000
  store i64 %r, ptr %out, align 4
  ret void",
    );
    assert!(matches!(&front.refusals[..], [refusal] if matches!(refusal.reason, Reason::Wide(_))));
}

#[test]
fn a_comparison_beyond_words_is_known() {
    let k = kernel(
        "  %w = zext i32 %x to i64
  %below = icmp ult i64 %w, 4294967296
  %not = icmp eq i64 %w, -1
  %a = zext i1 %below to i32
  %b = zext i1 %not to i32
  %s = shl i32 %b, 1
  %r = or i32 %a, %s
  store i32 %r, ptr %out, align 4
  ret void",
    );
    assert_eq!(output(&k, &[u32::MAX]).0[0], 1);
}

/// A number that is proven to fit is not negative, although its low word may look so.
#[test]
fn a_signed_comparison_of_what_fits_is_unsigned() {
    let k = kernel(
        "  %w = zext i32 %x to i64
  %more = icmp sgt i64 %w, 5
  %r = zext i1 %more to i32
  store i32 %r, ptr %out, align 4
  ret void",
    );
    assert_eq!([0x8000_0000, 6, 5].map(|x| output(&k, &[x]).0[0]), [1, 1, 0]);
}

/// A word less a constant, as an `i64`, is negative if the word is small.
#[test]
fn a_difference_with_a_sign_is_no_length() {
    let k = kernel(
        "  %y = getelementptr inbounds nuw i32, ptr %in, i64 1
  %b = load i32, ptr %y, align 4
  %a = zext i32 %x to i64
  %c = zext i32 %b to i64
  %d = add nsw i64 %a, -5
  %more = icmp sgt i64 %d, %c
  %r = zext i1 %more to i32
  store i32 %r, ptr %out, align 4
  ret void",
    );
    let more = |a, b| output(&k, &[a, b]).0[0];
    assert_eq!([more(3, 9), more(20, 9), more(u32::MAX, 9), more(3, u32::MAX)], [0, 1, 1, 0]);
    let float = compile(
        "  %a = zext i32 %x to i64
  %d = add nsw i64 %a, -5
  %f = sitofp i64 %d to float
  store float %f, ptr %out, align 4
  ret void",
    );
    assert!(matches!(float.refusals[0].reason, Reason::Wide(_)), "{:?}", float.refusals);
}
