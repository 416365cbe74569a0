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
use std::io::Write;

/// Tells how many cases of a kind were tried. To the terminal itself, since cargo hides what a passing test prints.
fn tried(kind: &str, cases: u64) {
    assert!(cases > 0, "{kind}: nothing was tried");
    // Nothing is lost when the terminal is gone.
    let _ = writeln!(std::io::stderr(), "hard case: {kind}: {cases} cases");
}

/// Runs the case of this name on both backends.
fn assert_holds(group: &str, name: &str) {
    let case =
        CASES.iter().find(|case| case.group == group && case.name == name).expect("a case of this name");
    let mut gpu = open(Driver::Lavapipe, Profile::Strict);
    let report = verify::run(case, &mut Cpu::new(0).unwrap(), gpu.as_mut(), false, &mut |_, _| {});
    assert_eq!(report.failures, 0, "{}", report.first_failure.unwrap_or_default());
    // What is to be compared with a device, and nothing else, is not tried without one.
    if gpu.is_some() || report.cases > 0 {
        tried(&format!("{group}/{}", report.name), report.cases);
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

cases! {
    arithmetic:
        divisions_are_correctly_rounded,
        square_roots_are_correctly_rounded,
        elementary_functions_keep_their_bounds,
        sums_products_and_choices_have_the_same_bits,;
    triangles:
        closed_meshes_have_no_holes,
        slivers_are_hit_where_they_are,
        zero_area_is_no_hit,
        coincident_faces_have_the_first_as_their_owner,
        scales_and_offsets_change_nothing_but_rounding,
        a_range_is_decided_to_the_last_bit,;
    quadrics:
        small_spheres_far_away_are_hit_where_they_are,
        from_inside_the_far_side_is_met,
        tangents_are_decided,
        flat_ellipsoids_are_hit_where_they_are,;
    boxes:
        directions_without_a_component_meet_what_they_should,
        rays_along_edges_meet_what_they_should,
        what_is_no_ray_misses_in_the_time_of_a_ray,;
    secondary_rays:
        rooms_have_no_acne_and_no_leak,;
    refraction:
        fresnels_share_is_a_share,
        nested_media_in_a_furnace_make_no_light,;
    stereo:
        pairs_hide_nothing_that_is_nearer,
        pairs_have_the_same_bits,
        reprojected_positions_are_within_half_a_pixel,;
    pictures:
        every_effect_has_the_same_bits,;
    long_runs:
        ten_thousand_frames_do_not_drift,
        four_thousand_lights_have_a_bit_each,
        large_pictures_are_addressed_without_overflow,;
}
