use super::compile;
use crate::refusal::Reason;

/// The reasons why the body is refused.
fn reasons(body: &str) -> Vec<Reason> {
    let front = compile(&format!("{body}\n  ret void"));
    assert!(front.kernels.is_empty());
    assert!(front.refusals.iter().all(|refusal| refusal.entry == "t"));
    front.refusals.into_iter().map(|refusal| refusal.reason).collect()
}

#[test]
fn each_problem_has_its_reason() {
    let cases = [
        ("  call void @_ZN1k4loop17h0000000000000000E(i32 %x)", Reason::NotInlined),
        ("  %y = call float @tanf(float 1.0)", Reason::NoBody),
        ("  %y = call ptr @__rust_alloc(i64 8, i64 8)", Reason::Allocation),
        ("  %f = inttoptr i64 9 to ptr\n  call void %f(i32 1)", Reason::IndirectCall),
        ("  %y = uitofp i32 %x to double", Reason::Double),
        ("  store i8 1, ptr %out, align 4", Reason::NarrowStore { bits: 8 }),
        ("  %y = load i32, ptr @counter, align 4", Reason::MutableStatic("counter".into())),
        ("  %y = atomicrmw add ptr %out, i64 1 monotonic, align 8", Reason::WideAtomic),
        ("  %y = atomicrmw add ptr %out, i8 1 monotonic, align 1", Reason::WideAtomic),
    ];
    for (body, reason) in cases {
        assert!(reasons(body).contains(&reason), "{body}: {:?}", reasons(body));
    }
}

#[test]
fn what_is_not_known_is_named() {
    let cases = [
        ("  %y = call i32 @llvm.sdiv.fix.i32(i32 %x, i32 %x, i32 2)", "llvm.sdiv.fix.i32"),
        ("  %y = call float @llvm.fmuladd.f32(float 1.0, float 1.0, float 1.0)", "llvm.fmuladd.f32"),
        ("  call void @__k_new(i32 %x)", "__k_new"),
        ("  %y = call i32 @__k_builtin(i32 9, i32 0)", "builtin 9"),
        ("  %y = call i32 @__k_spec(i32 %x, i32 0)", "__k_spec"),
        ("  %y = atomicrmw fadd ptr %out, float 1.0 monotonic, align 4", "fadd"),
        ("  %y = atomicrmw add ptr %out, i32 1 seq_cst, align 4", "seq_cst"),
        ("  call void @llvm.memcpy.p0.p0.i64(ptr %out, ptr %in, i64 5000, i1 false)", "5000 bytes"),
    ];
    for (body, name) in cases {
        let reasons = reasons(body);
        assert!(reasons.iter().any(|reason| reason.to_string().contains(name)), "{body}: {reasons:?}");
    }
}

#[test]
fn panics_are_counted_by_function() {
    let panic =
        "  call void @_ZN4core9panicking18panic_bounds_check17h0000000000000000E(i64 1, i64 2, ptr null)\n";
    let front = compile(&format!("{panic}{panic}  call void @abort()\n  ret void"));
    let text: Vec<String> = front.refusals.iter().map(ToString::to_string).collect();
    assert_eq!(text.len(), 2);
    assert!(
        text[0].starts_with(
            "kernel `t`, `core::panicking::panic_bounds_check`: it can still panic, in 2 places"
        )
    );
}

#[test]
fn all_problems_come_at_once() {
    let body = "  %y = call float @tanf(float 1.0)
  %z = fpext float %y to double
  store i8 1, ptr %out, align 4
  store i16 1, ptr %out, align 4
  %w = load i32, ptr @counter, align 4";
    assert_eq!(reasons(body).len(), 5);
}
