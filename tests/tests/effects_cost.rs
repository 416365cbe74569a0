//! What a pixel pays for what it does not see: no ray for a light that it does not face or for a mirror that does not show there, and
//! not a bit of its colour. What looking costs is counted by `instructions`: effects are those of a scene, so that one mirror lets the
//! pass `bounce` run over all pixels, which reads a surface and a material and writes a colour for each.

use glam::Vec3;
use parallax_shared::layout::NONE;
use parallax_tests::far_things::{LIGHTS, plain, with_light, with_mirror};
use parallax_tests::small_scenes::render;
use parallax_tests::stage::Stages;

/// Whether a pixel took the same rays and has the same colour, bit for bit.
fn is_untouched(before: &Stages, after: &Stages, pixel: usize) -> bool {
    let rays = |stages: &Stages| stages.counts.clone().map(|counts| counts[pixel]);
    let bits = |stages: &Stages| stages.colours[pixel].map(f32::to_bits);
    rays(before) == rays(after) && bits(before) == bits(after) && before.seen[pixel] == after.seen[pixel]
}

/// A pixel that faces the 17th light takes one ray more, any other one none.
#[test]
fn a_light_that_a_pixel_does_not_face_costs_it_no_ray() {
    let (before, stage) = (render(&plain()), with_light());
    let (after, place) = (render(&stage), Vec3::from(stage.lights[LIGHTS].position));
    let mut facing = 0;
    for (pixel, surface) in after.surfaces.iter().enumerate() {
        let towards = place - Vec3::from(surface.position);
        if surface.prim_id == NONE || Vec3::from(surface.normal).dot(towards) <= 0.0 {
            assert!(is_untouched(&before, &after, pixel), "{surface:?}");
        } else {
            assert_eq!(after.counts[1][pixel].shadow, before.counts[1][pixel].shadow + 1, "{surface:?}");
            facing += 1;
        }
    }
    assert!(facing > 20 && 5 * facing < after.hits.len(), "{facing} pixels face the light");
}

/// A pixel that sees the mirror takes one ray more at least, any other one none.
#[test]
fn a_mirror_that_a_pixel_does_not_see_costs_it_no_ray() {
    let (plain, stage) = (plain(), with_mirror());
    let (before, after) = (render(&plain), render(&stage));
    let mirror = plain.triangles.len() as u32..stage.triangles.len() as u32;
    // Spheres are numbered behind the triangles.
    let same = |before: u32, after: u32| {
        after == before || (before != NONE && after == before + mirror.len() as u32)
    };
    let mut seeing = 0;
    for (pixel, (hit, other)) in after.hits.iter().zip(&before.hits).enumerate() {
        if mirror.contains(&hit.prim_id) {
            assert!(after.counts[2][pixel].reflected > 0, "pixel {pixel}");
            seeing += 1;
        } else {
            assert!(same(other.prim_id, hit.prim_id) && other.t.to_bits() == hit.t.to_bits(), "{hit:?}");
            assert!(is_untouched(&before, &after, pixel), "pixel {pixel}");
        }
    }
    assert!(seeing > 10 && 5 * seeing < after.hits.len(), "{seeing} pixels see the mirror");
}

/// The comparison can fail: of the pixels that do see it, some are touched.
#[test]
fn what_is_seen_is_told_apart() {
    let before = render(&plain());
    for after in [render(&with_light()), render(&with_mirror())] {
        let touched = (0..before.hits.len()).filter(|&pixel| !is_untouched(&before, &after, pixel)).count();
        assert!(touched > 10, "{touched}");
    }
}
