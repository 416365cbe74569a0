//! What a pixel pays for what it does not see: no ray for a light that it does not face or for a mirror that does not show there, and
//! not a bit of its colour. What looking costs is counted by `instructions`: effects are those of a scene, so that one mirror lets the
//! passes `bounce` and, in second views, `inherit` run over all pixels; they write where a colour is not whole, and read nothing but
//! that of the others.

use glam::Vec3;
use parallax::backend::{Backend, Cpu, Profile};
use parallax::render::SceneBuffers;
use parallax_kernels::{bounce::Bounce, stereo::inherit::Inherit};
use parallax_shared::layout::{NONE, Surface};
use parallax_shared::shading::bounce::is_whole;
use parallax_shared::stereo::source;
use parallax_tests::far_things::{LIGHTS, plain, with_light, with_mirror};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::small_scenes::{everything, render};
use parallax_tests::stage::{Stage, Stages};

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

/// What the passes `inherit` and `bounce` leave in new buffers: surfaces and colours, of a second view that is the first one, with every
/// other pixel reused. And what those buffers had before.
fn left_behind<B: Backend>(backend: &mut B, stage: &Stage, stages: &Stages, all: u32) -> [Vec<u32>; 4] {
    let (info, scene) = stage.upload(backend).unwrap();
    let SceneBuffers { rows, triangles, records, texels } = scene;
    let (view, effects) = (stage.view, stage.effects().0);
    let word = |pixel: u32| match pixel % 2 {
        0 => source::from_column(source::REUSED, pixel % view.width),
        _ => source::traced(source::HOLE),
    };
    let pixels = stages.hits.len();
    let words: Vec<u32> = (0..pixels as u32).map(word).collect();
    let source = backend.upload("source", &words).unwrap();
    let source_surfaces = backend.upload("source surfaces", &stages.surfaces).unwrap();
    let hits = backend.upload("hits", &stages.hits).unwrap();
    let local = backend.upload("local", &stages.local).unwrap();
    let surfaces = backend.create::<Surface>("surfaces", pixels).unwrap();
    let colours = backend.create::<[f32; 4]>("colours", pixels).unwrap();
    let counts = backend.create("counts", pixels).unwrap();
    let before = (backend.read(surfaces).unwrap(), backend.read(colours).unwrap());
    let inherit = Inherit {
        view,
        info,
        all,
        triangles,
        records,
        source,
        source_surfaces,
        hits,
        colours: local,
        surfaces,
        effects,
    };
    let bounce =
        Bounce { view, info, rows, triangles, records, texels, surfaces, local, colours, counts, effects };
    backend.run(&inherit, [view.width, view.rows, 1]).unwrap();
    backend.run(&bounce, [view.width, view.rows, 1]).unwrap();
    let after = (backend.read(surfaces).unwrap(), backend.read(colours).unwrap());
    [words_of(&before.0), words_of(&before.1), words_of(&after.0), words_of(&after.1)]
}

fn words_of<T: bytemuck::Pod>(values: &[T]) -> Vec<u32> {
    bytemuck::cast_slice(values).to_vec()
}

fn assert_left<B: Backend>(backend: &mut B) {
    let stage = everything();
    let stages = render(&stage);
    let (surfaces, colours) = (words_of(&stages.surfaces), words_of(&stages.colours));
    let partial = stages.local.iter().filter(|own| !is_whole(own)).count();
    assert!(partial > 50 && stages.local.len() - partial > 50, "{partial} of {}", stages.local.len());
    for all in [0, 1] {
        let [surfaces_before, colours_before, surfaces_after, colours_after] =
            left_behind(backend, &stage, &stages, all);
        for (pixel, own) in stages.local.iter().enumerate() {
            let (of_surface, of_colour) = (16 * pixel..16 * pixel + 16, 4 * pixel..4 * pixel + 4);
            let inherited = if is_whole(own) && all == 0 { &surfaces_before } else { &surfaces };
            let bounced = if is_whole(own) { &colours_before } else { &colours };
            assert_eq!(surfaces_after[of_surface.clone()], inherited[of_surface], "pixel {pixel}");
            assert_eq!(colours_after[of_colour.clone()], bounced[of_colour], "pixel {pixel}");
        }
    }
}

/// Where a colour is whole, nothing is written; elsewhere surfaces and colours are those of the passes of one view.
#[test]
fn passes_write_where_they_have_something_to_add() {
    assert_left(&mut Cpu::new(0).unwrap());
    for driver in Driver::SOFTWARE {
        let Some(mut gpu) = open(driver, Profile::Strict) else { continue };
        assert_left(&mut gpu);
    }
}
