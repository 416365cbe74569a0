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

/// A hash of 64 bits that is masked to an index is no `usize`: its comparison needs all bits.
#[test]
fn a_masked_hash_stays_wide() {
    let front = compile(
        "  %w = zext i32 %x to i64
  %h = mul i64 %w, 11400714819323198485
  %i = and i64 %h, 3
  %p = getelementptr inbounds nuw i32, ptr %in, i64 %i
  %v = load i32, ptr %p, align 4
  %big = icmp ugt i64 %h, 1099511627776
  %b = zext i1 %big to i32
  %r = add i32 %v, %b
  store i32 %r, ptr %out, align 4
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
