//! Instructions per ray and per reprojected pixel, counted by valgrind: a figure that a busy machine cannot disturb, where times tell
//! little. It is held to the committed ones, so that a change that costs speed is seen when it is made.

use std::process::Command;

/// Instruction set, query, and instructions per ray or pixel of the release build. To be replaced by what a failure reports, when the
/// change is meant and times agree.
const FIGURES: [(&str, &str, f64); 6] = [
    ("SSE2", "nearest", 1999.7),
    ("SSE2", "any", 1612.7),
    ("AVX2", "nearest", 1490.5),
    ("AVX2", "any", 1212.9),
    ("SSE2", "splat", 72.6),
    ("AVX2", "splat", 64.2),
];

/// How far a count may be from its figure.
const TOLERANCE: f64 = 0.03;

/// What a pixel pays at most for what it does not see, in instructions: of 11,913 that all passes take for it under sixteen lights, 53
/// more are counted for a light (0.4 %), 30 for a mirror (0.25 %).
const UNSEEN: [(&str, f64); 2] = [("light", 70.0), ("mirror", 45.0)];

/// What is wrong with a count.
fn complaint(what: &str, counted: f64, figure: f64) -> Option<String> {
    let change = counted / figure - 1.0;
    let (verdict, advice) = if change > TOLERANCE {
        ("more", "find what costs them, or commit the new figure")
    } else if change < -TOLERANCE {
        ("fewer", "commit the new figure, so that they stay saved")
    } else {
        return None;
    };
    let percent = 100.0 * change.abs();
    Some(format!(
        "{what}: {counted:.1} instructions per item, {percent:.1} % {verdict} than {figure}: {advice}"
    ))
}

/// Instructions per ray or pixel; none where the machine, as valgrind shows it, lacks the instruction set.
fn count(set: &str, query: &str) -> Option<f64> {
    let directory = tempfile::tempdir().unwrap();
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--collect-atstart=no", "--toggle-collect=*counted_task*"])
        .arg(format!("--callgrind-out-file={}", directory.path().join("counts").display()))
        .arg(env!("CARGO_BIN_EXE_instructions"))
        .args([set, query])
        .output()
        .unwrap();
    let (said, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{said}{log}");
    if said.trim() == "unavailable" {
        return None;
    }
    let number = |text: &str, label: &str| {
        let number = text.split(label).nth(1).and_then(|rest| rest.split_whitespace().next()?.parse().ok());
        number.unwrap_or_else(|| panic!("no {label:?} in {text}"))
    };
    let (items, instructions): (f64, f64) = (number(&said, "count "), number(&log, "Collected : "));
    assert!(
        instructions > 10.0 * items,
        "{instructions} instructions for {items} items: nothing was counted"
    );
    Some(instructions / items)
}

fn valgrind_is_there() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Whether instructions can be counted here; a line that says why not.
fn is_countable() -> bool {
    if cfg!(debug_assertions) || !cfg!(target_arch = "x86_64") {
        println!(
            "SKIPPED: instructions are those of a release build for x86-64 (cargo test --release --test instructions)"
        );
        return false;
    }
    if !valgrind_is_there() {
        println!("SKIPPED: no valgrind to count instructions with");
        return false;
    }
    true
}

#[test]
fn rays_and_pixels_cost_the_instructions_that_they_did() {
    if !is_countable() {
        return;
    }
    let mut complaints = Vec::new();
    for (set, query, figure) in FIGURES {
        match count(set, query) {
            Some(counted) => complaints.extend(complaint(&format!("{set}, {query}"), counted, figure)),
            None => println!("SKIPPED: valgrind shows no {set} here"),
        }
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// A 17th light costs a pixel that does not face it the test of its direction. A mirror costs a pixel that does not see it its box in the
/// structure and the question whether its colour is whole: effects are those of a scene, not of a pixel.
#[test]
fn what_a_pixel_does_not_see_costs_it_little() {
    if !is_countable() {
        return;
    }
    let Some(plain) = count("SSE2", "plain") else { return };
    for (what, most) in UNSEEN {
        let more = count("SSE2", what).expect("the set is there") - plain;
        println!("{what}: {more:.1} instructions more than {plain:.0} a pixel");
        assert!(more < most, "{what}: {more:.1} instructions more than {plain:.0} a pixel, not {most}");
    }
}

#[test]
fn a_doctored_figure_is_told_apart() {
    assert_eq!(complaint("x", 1000.0, 1000.0), None);
    assert_eq!(complaint("x", 1029.0, 1000.0), None);
    for (counted, verdict) in [(1031.0, "more"), (969.0, "fewer"), (f64::INFINITY, "more")] {
        let complaint = complaint("x", counted, 1000.0).unwrap();
        assert!(complaint.contains(verdict), "{complaint}");
    }
}
