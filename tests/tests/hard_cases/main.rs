//! Hard cases that stay numerically stable: each of `parallax::verify`, which users run on their own machines, on the processor and on
//! lavapipe. Which guard a case holds stands in its documentation; `tests/guards.toml` lists the guards, `tests/guards.sh` takes each
//! out and sees its test fail, and `tests/verify.rs` shows that each comparison of the suite can fail.
//!
//! Cases that other files hold: offsets and scales of closed meshes (`hits`), random rays and boxes (`rays`), t clamped to the own box
//! and small spheres far away (`oracle`), division from approximations that are off (`math`), shadow acne by hand-made lights and the
//! closed furnace of spheres (`shading`), ties at half pixels (`stereo_reprojection`), e = 0 and huge e (`stereo_methods`), what one eye
//! sees (`stereo_unseen`, `stereo_counts`), frame edges (`stereo_tables`).

mod guards;

use parallax::backend::{Cpu, Profile};
use parallax::verify::{self, CASES};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::terminal::tried;

/// Runs the case of this name on both backends.
fn assert_holds(group: &str, name: &str) {
    let case =
        CASES.iter().find(|case| case.group == group && case.name == name).expect("a case of this name");
    let mut gpu = open(Driver::Lavapipe, Profile::Strict);
    let report = verify::run(case, &mut Cpu::new(0).unwrap(), gpu.as_mut(), false, &mut |_, _| {});
    assert_eq!(report.failures, 0, "{}", report.first_failure.unwrap_or_default());
    // What is to be compared with a device, and nothing else, is not tried without one.
    if gpu.is_some() || report.cases > 0 {
        tried(&format!("{group}/{}", report.name), report.cases, "");
    }
}

macro_rules! cases {
    ($($group:ident: $($case:ident,)*;)*) => {
        $(mod $group {
            $(#[test] fn $case() { super::assert_holds(stringify!($group), stringify!($case)) })*
        })*

        /// No case is left out.
        #[test]
        fn every_case_has_a_test() {
            let tested = [$($((stringify!($group), stringify!($case)),)*)*];
            assert!(tested.into_iter().eq(CASES.iter().map(|case| (case.group, case.name))));
        }
    };
}

parallax::hard_cases!(cases);
