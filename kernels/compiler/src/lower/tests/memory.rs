use super::{compile, count, kernel, output};
use crate::ir::{AtomicOp, Op};
use crate::refusal::Reason;

#[test]
fn a_record_is_loaded_and_stored_at_once() {
    let k = kernel(
        "  %i = zext i32 %x to i64
  %a = getelementptr inbounds nuw [16 x i8], ptr %rows, i64 %i
  %a1 = getelementptr inbounds nuw i8, ptr %a, i64 4
  %a3 = getelementptr inbounds nuw i8, ptr %a, i64 12
  %u = load i32, ptr %a1, align 4
  %v = load i32, ptr %a3, align 4
  %b = getelementptr inbounds nuw i8, ptr %a, i64 16
  store i32 %u, ptr %b, align 4
  %b1 = getelementptr inbounds nuw i8, ptr %b, i64 4
  store i32 %v, ptr %b1, align 4
  %b2 = getelementptr inbounds nuw i8, ptr %b, i64 8
  store i64 81604378625, ptr %b2, align 8
  ret void",
    );
    assert_eq!(count(&k, |op| matches!(op, Op::StoreVec4(..))), 1);
    assert_eq!(count(&k, |op| matches!(op, Op::StoreComponent(..))), 0);
    assert_eq!(output(&k, &[1]).1[4..12], [104, 105, 106, 107, 105, 107, 1, 19]);
}

#[test]
fn bytes_are_shifted_out_of_words() {
    let k = kernel(
        "  %i = zext i32 %x to i64
  %p = getelementptr inbounds nuw i8, ptr %in, i64 %i
  %b = load i8, ptr %p, align 1
  %s = sext i8 %b to i32
  store i32 %s, ptr %out, align 4
  %q = getelementptr inbounds nuw i8, ptr %in, i64 6
  %h = load i16, ptr %q, align 2
  %z = zext i16 %h to i32
  %o = getelementptr inbounds nuw i32, ptr %out, i64 1
  store i32 %z, ptr %o, align 4
  %w = load i32, ptr %p, align 1
  %o2 = getelementptr inbounds nuw i32, ptr %out, i64 2
  store i32 %w, ptr %o2, align 4
  ret void",
    );
    let out = output(&k, &[5, 0x8877_66f5, 0xccbb_aa99]).0;
    assert_eq!(out[..3], [0x66, 0x8877, 0x9988_7766], "the last one lies across two words");
    assert_eq!(output(&k, &[4, 0x8877_66f5, 0]).0[0], 0xffff_fff5);
}

#[test]
fn bytes_are_stored_into_own_memory_only() {
    let store = |to: &str| {
        format!(
            "  %l = alloca [8 x i8], align 4
  call void @llvm.memset.p0.i64(ptr %l, i8 -1, i64 8, i1 false)
  %i = zext i32 %x to i64
  %p = getelementptr inbounds nuw i8, ptr {to}, i64 %i
  store i8 17, ptr %p, align 1
  %w = load i32, ptr %l, align 4
  store i32 %w, ptr %out, align 4
  ret void"
        )
    };
    assert_eq!(output(&kernel(&store("%l")), &[2]).0[0], 0xff11_ffff);
    let refusals = compile(&store("%out")).refusals;
    assert_eq!(refusals.len(), 1);
    assert_eq!(refusals[0].reason, Reason::NarrowStore { bits: 8 });
}

#[test]
fn memory_is_copied_and_filled() {
    let k = kernel(
        "  %l = alloca [12 x i8], align 4
  call void @llvm.memset.p0.i64(ptr align 4 %l, i8 1, i64 12, i1 false)
  %from = getelementptr inbounds nuw i8, ptr %in, i64 1
  %to = getelementptr inbounds nuw i8, ptr %l, i64 2
  call void @llvm.memcpy.p0.p0.i64(ptr %to, ptr %from, i64 7, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr align 4 %out, ptr align 4 %l, i64 12, i1 false)
  ret void",
    );
    let out = output(&k, &[0x0403_0201, 0x0807_0605]).0;
    assert_eq!(out[..4], [0x0302_0101, 0x0706_0504, 0x0101_0108, 0]);
}

#[test]
fn atomics_are_of_words_and_keep_their_sign() {
    let k = kernel(
        "  %old = atomicrmw min ptr %out, i32 %x monotonic, align 4
  %p = getelementptr inbounds nuw i32, ptr %out, i64 1
  %r = atomicrmw umax ptr %p, i32 %x monotonic, align 4
  %pair = cmpxchg ptr %p, i32 %x, i32 9 monotonic monotonic, align 4
  %same = extractvalue { i32, i1 } %pair, 1
  %w = zext i1 %same to i32
  %q = getelementptr inbounds nuw i32, ptr %out, i64 2
  store atomic i32 %w, ptr %q monotonic, align 4
  ret void",
    );
    assert_eq!(count(&k, |op| matches!(op, Op::AtomicWord(AtomicOp::SMin, ..))), 1);
    let root = k.roots.iter().find(|root| root.atomic).expect("an atomic buffer");
    assert!(root.written && !root.vec4);
    assert_eq!(output(&k, &[u32::MAX]).0[..3], [u32::MAX, 9, 1]);
}

#[test]
fn tables_are_words() {
    let k = kernel(
        "  %i = zext i32 %x to i64
  %p = getelementptr inbounds nuw i32, ptr @table, i64 %i
  %v = load i32, ptr %p, align 4
  store i32 %v, ptr %out, align 4
  %w = load i32, ptr getelementptr inbounds (i8, ptr @table, i64 8), align 4
  %o = getelementptr inbounds nuw i32, ptr %out, i64 1
  store i32 %w, ptr %o, align 4
  ret void",
    );
    assert_eq!(output(&k, &[1]).0[..2], [6, 7]);
}

#[test]
fn stores_are_not_merged_across_a_load_of_the_same_buffer() {
    let k = kernel(
        "  store i64 4294967297, ptr %rows, align 8
  %i = zext i32 %x to i64
  %a = getelementptr inbounds nuw [16 x i8], ptr %rows, i64 %i
  %v = load i32, ptr %a, align 4
  store i32 %v, ptr %out, align 4
  %b2 = getelementptr inbounds nuw i8, ptr %rows, i64 8
  store i64 4294967297, ptr %b2, align 8
  ret void",
    );
    assert_eq!(count(&k, |op| matches!(op, Op::StoreVec4(..))), 0);
    assert_eq!(output(&k, &[0]).0[0], 1);
}

#[test]
fn arrays_are_compared_word_by_word() {
    let k = kernel(
        "  %p = getelementptr inbounds nuw i32, ptr %in, i64 1
  %q = getelementptr inbounds nuw i32, ptr %in, i64 4
  %c = tail call i32 @bcmp(ptr noundef nonnull %p, ptr noundef nonnull %q, i64 10)
  %z = icmp eq i32 %c, 0
  %r = zext i1 %z to i32
  store i32 %r, ptr %out, align 4
  ret void",
    );
    let same = |b: [u32; 3]| output(&k, &[0, 1, 2, 3, b[0], b[1], b[2]]).0[0];
    assert_eq!([same([1, 2, 3]), same([1, 2, 0x8_0003]), same([1, 2, 4]), same([0, 2, 3])], [1, 1, 0, 0]);
}
