use super::{compile, count, kernel, output};
use crate::ir::Op;
use crate::refusal::Reason;

/// `iter().sum()`, as rustc writes it: two pointers walk until they are equal.
#[test]
fn a_pointer_walks_through_a_buffer() {
    let k = kernel(
        "  %n = zext i32 %x to i64
  %end = getelementptr inbounds nuw [12 x i8], ptr %in, i64 %n
  br label %head
head:
  %p = phi ptr [ %in, %start ], [ %next, %head ]
  %sum = phi i32 [ 0, %start ], [ %s, %head ]
  %f = getelementptr inbounds nuw i8, ptr %p, i64 8
  %v = load i32, ptr %f, align 4
  %s = add i32 %sum, %v
  %next = getelementptr inbounds nuw i8, ptr %p, i64 12
  %done = icmp eq ptr %next, %end
  br i1 %done, label %exit, label %head
exit:
  store i32 %s, ptr %out, align 4
  ret void",
    );
    assert_eq!(output(&k, &[2, 0, 10, 0, 0, 30]).0[0], 40);
    assert_eq!(k.wide_values(), []);
}

#[test]
fn a_pointer_into_one_of_two_buffers_can_be_read() {
    let k = kernel(
        "  %odd = trunc i32 %x to i1
  %p = select i1 %odd, ptr %rows, ptr %in
  %q = getelementptr inbounds nuw i32, ptr %p, i64 2
  %v = load i32, ptr %q, align 4
  store i32 %v, ptr %out, align 4
  ret void",
    );
    assert_eq!(output(&k, &[1, 0, 7]).0[0], 102);
    assert_eq!(output(&k, &[2, 0, 7]).0[0], 7);
}

#[test]
fn a_pointer_into_one_of_two_buffers_cannot_be_written() {
    let front = compile(
        "  %odd = trunc i32 %x to i1
  %p = select i1 %odd, ptr %rows, ptr %out
  store i32 1, ptr %p, align 4
  ret void",
    );
    let text = front.refusals[0].to_string();
    assert!(text.contains("buffer at set 0, binding 2") && text.contains("only loads"), "{text}");
}

/// `Option<&u32>`.
#[test]
fn null_is_told_from_the_first_element() {
    let k = kernel(
        "  %some = icmp ult i32 %x, 8
  br i1 %some, label %then, label %join
then:
  %i = zext i32 %x to i64
  %e = getelementptr inbounds nuw i32, ptr %in, i64 %i
  br label %join
join:
  %p = phi ptr [ %e, %then ], [ null, %start ]
  %none = icmp eq ptr %p, null
  br i1 %none, label %exit, label %read
read:
  %v = load i32, ptr %p, align 4
  %v1 = add i32 %v, 100
  br label %exit
exit:
  %r = phi i32 [ %v1, %read ], [ 1, %join ]
  store i32 %r, ptr %out, align 4
  ret void",
    );
    assert_eq!([0, 1, 9].map(|x| output(&k, &[x, 5]).0[0]), [100, 105, 1]);
}

#[test]
fn an_offset_without_a_known_factor_is_divided() {
    let k = kernel(
        "  %b = mul i32 %x, 4
  %i = zext i32 %b to i64
  %far = getelementptr inbounds i8, ptr %in, i64 %i
  %small = icmp ult i32 %x, 2
  %p = select i1 %small, ptr %far, ptr %in
  %v = load i32, ptr %p, align 4
  store i32 %v, ptr %out, align 4
  ret void",
    );
    assert_eq!([1, 2].map(|x| output(&k, &[x, 9, 0]).0[0]), [9, 2]);
    assert_eq!(count(&k, |op| matches!(op, Op::Source(_))), 0);
}

#[test]
fn the_distance_of_pointers_is_a_number() {
    let k = kernel(
        "  %i = zext i32 %x to i64
  %p = getelementptr inbounds nuw [12 x i8], ptr %in, i64 %i
  %a = ptrtoint ptr %p to i64
  %b = ptrtoint ptr %in to i64
  %d = sub nuw i64 %a, %b
  %n = udiv exact i64 %d, 12
  %w = trunc nuw i64 %n to i32
  store i32 %w, ptr %out, align 4
  ret void",
    );
    assert_eq!(output(&k, &[7]).0[0], 7);
}

#[test]
fn pointers_in_memory_are_refused() {
    let front = compile(
        "  %l = alloca [16 x i8], align 8
  store ptr %in, ptr %l, align 8
  %p = load ptr, ptr %l, align 8
  %v = load i32, ptr %p, align 4
  store i32 %v, ptr %out, align 4
  ret void",
    );
    assert_eq!(front.refusals.len(), 2, "the store and the load: {:?}", front.refusals);
    assert!(front.refusals.iter().all(|refusal| matches!(refusal.reason, Reason::Pointer(_))));
}
