//! What a passing test says: cargo hides what it prints, so it goes to the terminal itself.

use std::io::Write;

/// Writes a line.
pub fn tell(line: &str) {
    // Nothing is lost when the terminal is gone.
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Tells how many cases of a kind were tried, with a `remark` on them.
///
/// # Panics
/// When there were none.
pub fn tried(kind: &str, cases: u64, remark: &str) {
    assert!(cases > 0, "{kind}: nothing was tried");
    tell(&format!("hard case: {kind}: {cases} cases{remark}"));
}
