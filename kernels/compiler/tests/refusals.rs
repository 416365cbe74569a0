//! Each kernel of `refused-kernels` is refused with its name, the function that is the trouble, the reason, and what to write instead;
//! all of them in one run.

use kernel_compiler::refusal::{Reason, Refusal};
use kernel_compiler::{CompileError, CrateSource, Options, compile};
use std::path::Path;
use std::sync::OnceLock;

/// All problems of the crate.
fn refusals() -> &'static [Refusal] {
    static FOUND: OnceLock<Vec<Refusal>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/refused-kernels");
        match compile(&CrateSource::new(dir), &Options::default()) {
            Err(CompileError::Refused(refusals)) => refusals,
            other => panic!("expected refusals, got {:?}", other.map(|compiled| compiled.entries.len())),
        }
    })
}

/// The lines about a kernel.
fn lines(entry: &str) -> Vec<String> {
    refusals().iter().filter(|refusal| refusal.entry == entry).map(ToString::to_string).collect()
}

/// Asserts that a kernel is refused for exactly one reason, with these words, and for this function if one is named.
fn refused(entry: &str, function: &str, reason: &str, instead: &str) {
    let found: Vec<&Refusal> = refusals().iter().filter(|refusal| refusal.entry == entry).collect();
    let [refusal] = found[..] else { panic!("{:?}", lines(entry)) };
    let text = refusal.to_string();
    assert!(text.starts_with(&format!("kernel `{entry}`")), "{text}");
    assert!(text.ends_with(&format!(": {reason}; instead: {instead}")), "{text}");
    if !function.is_empty() {
        assert_eq!(refusal.function.as_deref(), Some(function), "{text}");
    }
}

/// Asserts that a refusal names the line of the source that holds `code`.
fn points_at(entry: &str, code: &str) {
    let source = include_str!("refused-kernels/src/lib.rs");
    let line = source.lines().position(|line| line.contains(code)).expect("the code") + 1;
    let place =
        refusals().iter().find(|refusal| refusal.entry == entry).and_then(|refusal| refusal.place.clone());
    assert!(
        place.as_ref().is_some_and(|place| place.ends_with(&format!("src/lib.rs:{line}"))),
        "{place:?}, not {line}"
    );
}

const PANIC: &str = "index with `.at()` and `.put()` or `get`, use wrapping or checked arithmetic, and test divisors for zero";

#[test]
fn what_can_panic() {
    for (entry, function) in [
        ("index", "core::panicking::panic_bounds_check"),
        ("division", "core::panicking::panic_const::panic_const_div_by_zero"),
        ("unwrap", "core::option::unwrap_failed"),
        ("expect", "core::option::expect_failed"),
        ("slice", "core::slice::index::slice_index_fail"),
        ("panic", "core::panicking::panic_fmt"),
        ("assertion", "core::panicking::panic"),
    ] {
        refused(entry, function, "it can still panic", PANIC);
    }
    points_at("index", "a[b.at(i) as usize]");
    points_at("unwrap", "a.at(i).checked_sub(b.at(i)).unwrap()");
    // Two ways to panic are two problems.
    let two = lines("signed_division");
    assert!(two.len() == 2 && two[0].contains("div_by_zero") && two[1].contains("div_overflow"), "{two:?}");
}

#[test]
fn what_is_not_inlined() {
    let reason = "the function was not inlined: is it recursive, or #[inline(never)]?";
    let instead = "write a loop for a recursion, and mark the function #[inline] or #[inline(always)]";
    refused("recursion", "refused_kernels::fibonacci", reason, instead);
    refused("not_inlined", "refused_kernels::apart", reason, instead);
}

#[test]
fn what_is_called_through_a_pointer() {
    for entry in ["trait_object", "function_pointer"] {
        let reason = "a function pointer or trait object is called";
        refused(entry, "", reason, "use a generic parameter or a `match`");
    }
}

#[test]
fn what_has_no_body_here() {
    let reason = "the function has no body here: a C function, or one of another crate without #[inline]";
    let instead = "mark the function #[inline] in its crate, or use a function of `core`";
    refused("sine", "tanf", reason, instead);
    let print = lines("print");
    assert!(print[0].contains("`std::io::stdio::_print`") && print[0].contains(reason), "{print:?}");
}

#[test]
fn what_is_allocated() {
    let lines = lines("allocation");
    let wanted = "memory is allocated; instead: use an array of fixed length or `kernel_api::Stack`";
    assert!(lines.iter().any(|line| line.contains("__rust_alloc") && line.ends_with(wanted)), "{lines:?}");
}

#[test]
fn what_devices_do_not_have() {
    refused("double", "", "f64 is used, which devices lack", "use f32");
    let wide = lines("wide");
    assert!(
        wide.len() == 1 && wide[0].contains("is wider than 32 bits, which not all devices have"),
        "{wide:?}"
    );
    assert!(wide[0].ends_with("use u32, and `kernel_api::device::mul_high` for the high half of a product"));
}

#[test]
fn what_other_invocations_would_see() {
    let reason = "8 bits are stored into a buffer or workgroup memory";
    refused("byte_store", "", reason, "store u32: the neighbouring bytes belong to other invocations");
    let reason = "the static `refused_kernels::COUNTER` can be written";
    refused("written_static", "", reason, "use a buffer or workgroup memory");
}

#[test]
fn what_only_some_invocations_reach() {
    let reason = "a barrier stands under a condition that differs between invocations";
    let instead = "reach the barrier on every path, under conditions that are the same for all invocations";
    refused("divergent_barrier", "refused_kernels::divergent_barrier", reason, instead);
    points_at("divergent_barrier", "        barrier!();");
    let reason = "a subgroup operation stands under a condition that differs between invocations";
    refused(
        "divergent_subgroup",
        "",
        reason,
        "call it on every path, and let the others hand in a neutral value",
    );
}

/// No kernel of the crate passes, and every reason says what to do.
#[test]
fn all_of_them_in_one_run() {
    let source = include_str!("refused-kernels/src/lib.rs");
    let in_table = source.lines().filter(|line| line.ends_with(") {") && line.contains("(i, ")).count();
    let in_full = source.lines().filter(|line| line.starts_with("pub fn ")).count();
    let mut entries: Vec<&str> = refusals().iter().map(|refusal| refusal.entry.as_str()).collect();
    entries.sort_unstable();
    entries.dedup();
    assert_eq!(entries.len(), in_table + in_full, "{entries:?}");
    assert!(refusals().iter().all(|refusal| !refusal.reason.instead().is_empty()));
    assert!(refusals().iter().any(|refusal| matches!(refusal.reason, Reason::DivergentBarrier)));
}
