//! Hard cases. Each says which guard in the code it holds; `tests/guards.toml` lists the guards, and `tests/guards.sh` takes each out
//! and sees its test fail.

pub mod arithmetic;
pub mod boxes;
pub mod long_runs;
pub mod pictures;
pub mod quadrics;
pub mod refraction;
pub mod secondary_rays;
pub mod stereo;
pub mod triangles;

use super::Outcome;
use super::suite::Suite;

/// A hard case.
#[derive(Clone, Copy)]
pub struct Case {
    /// What it is about.
    pub group: &'static str,
    /// What it shows.
    pub name: &'static str,
    /// Tries it.
    pub run: fn(&mut Suite) -> Outcome,
}

/// Calls the macro `$each` with the groups of all hard cases and their names: `group: case, case,; …`. The suite makes its list of it,
/// and the tests make a test of each.
#[macro_export]
macro_rules! hard_cases {
    ($each:ident) => {
        $each! {
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
    };
}

macro_rules! list {
    ($($group:ident: $($case:ident,)*;)*) => {
        /// All hard cases.
        pub const CASES: &[Case] = &[$($(
            Case { group: stringify!($group), name: stringify!($case), run: $group::$case },
        )*)*];
    };
}

hard_cases!(list);
