//! The methods that make the second view from the first, as wholes: they agree, and what they show is what there is.

use parallax::metrics;
use parallax::render::{Depth, First, Method, Reflections, SceneData, Shadows, StereoOptions, Verify};
use parallax_shared::camera::disparity_px;
use parallax_shared::layout::{Hit, RayCounts};
use parallax_shared::stereo::source::{self, BAD, GAP, HOLE, is_reused};
use parallax_tests::scenes::{data_at, file, load_at, name, shipped};
use parallax_tests::stereo::{ORDERS, REPROJECTING, Shown, inferred, naive, pair, verified};

const SIZE: [u32; 2] = [120, 80];

fn scene(name: &str) -> SceneData {
    data_at(&file(name), SIZE).expect("a scene that ships whole")
}

/// The scene with its eyes so many pixels apart.
fn apart(name: &str, interaxial_px: f32) -> SceneData {
    let path = file(name);
    let mut scene = load_at(&path, SIZE).expect("a scene that ships whole");
    scene.rig.interaxial_px = interaxial_px;
    SceneData::new(&scene, Default::default()).expect("a scene that renders")
}

fn words<T: bytemuck::Pod>(values: &[T]) -> &[u32] {
    bytemuck::cast_slice(values)
}

fn assert_same(a: &Shown, b: &Shown, what: &str) {
    assert_eq!(a.inferred, b.inferred, "{what}");
    assert!(words(&a.hits) == words(&b.hits) && words(&a.surfaces) == words(&b.surfaces), "{what}");
    assert!(words(a.colour()) == words(b.colour()), "{what}");
}

#[test]
fn all_methods_give_the_same_pair() {
    for name in ["default", "spheres", "whitted", "cornell", "tree"] {
        let data = scene(name);
        for (first, verify) in ORDERS.into_iter().zip([Verify::None, Verify::Edges]) {
            let one = inferred(pair(&data, &verified(Method::Scanline, verify, first)));
            for method in REPROJECTING {
                let other = inferred(pair(&data, &verified(method, verify, first)));
                assert_same(&one, &other, &format!("{name}, {first:?}, {verify:?}, {}", method.name()));
            }
            for depth in [Depth::Adaptive, Depth::Fixed(3.try_into().unwrap())] {
                let options = StereoOptions { depth, ..verified(Method::Buffer, verify, first) };
                assert_same(&one, &inferred(pair(&data, &options)), &format!("{name}, {depth:?}"));
            }
        }
    }
}

/// How many pixels hide something that is nearer by more than a pixel of disparity.
fn bad_pixels(data: &SceneData, shown: &[Hit], naive: &[Hit]) -> usize {
    let disparity = |hit: &Hit| disparity_px(data.views[0].interaxial_px, hit.t);
    shown.iter().zip(naive).filter(|(shown, naive)| disparity(naive) < disparity(shown) - 1.001).count()
}

/// The exact method: every hit and every colour of every scene is that of naive rays.
#[test]
fn guided_rays_find_what_naive_rays_find() {
    let mut guided = 0;
    for path in shipped() {
        let Some(data) = data_at(&path, SIZE) else { continue };
        for first in ORDERS {
            let truth = naive(&data, first);
            let shown = inferred(pair(&data, &StereoOptions { first, ..Method::Guided.into() }));
            let what = format!("{}, {first:?}", name(&path));
            assert!(words(&shown.hits) == words(&truth.hits), "{what}");
            assert!(words(&shown.surfaces) == words(&truth.surfaces), "{what}");
            assert!(words(shown.colour()) == words(truth.colour()), "{what}");
            assert_eq!(shown.shadow_rays, truth.shadow_rays, "{what}");
            guided +=
                shown.inferred.source.iter().filter(|&&word| source::kind(word) == source::GUIDED).count();
        }
    }
    assert!(guided > 10_000, "only {guided} rays had anything to begin with");
}

/// Proofs save rays and change nothing: both views of both exact methods are those of naive rays. The last tiles of the picture are cut.
#[test]
fn proven_shadows_are_traced_ones() {
    let rays = |rays: &[RayCounts]| rays.iter().map(|rays| u64::from(rays.shadow)).sum::<u64>();
    let (mut traced, mut by_tiles, mut by_source) = (0, 0, 0);
    for path in shipped() {
        let Some(data) = data_at(&path, [117, 77]) else { continue };
        for first in ORDERS {
            let what = format!("{}, {first:?}", name(&path));
            let truth = pair(&data, &StereoOptions { first, ..Method::Naive.into() });
            let proving = |method: Method| StereoOptions { first, shadows: Shadows::Prove, ..method.into() };
            let naive = pair(&data, &proving(Method::Naive));
            let guided = pair(&data, &proving(Method::Guided));
            for made in [&naive, &guided] {
                assert!(words(made.source.colour()) == words(truth.source.colour()), "{what}");
                assert_eq!(made.source.shadow, truth.source.shadow, "{what}");
                assert!(words(made.second.colour()) == words(truth.second.colour()), "{what}");
                assert!(words(&made.second.hits) == words(&truth.second.hits), "{what}");
                assert!(words(&made.second.surfaces) == words(&truth.second.surfaces), "{what}");
                assert_eq!(made.second.shadow, truth.second.shadow, "{what}");
            }
            traced += rays(&truth.second.shadow_rays);
            by_tiles += rays(&naive.second.shadow_rays);
            by_source += rays(&guided.second.shadow_rays);
        }
    }
    assert!(10 * by_tiles < 9 * traced && 10 * by_source < 9 * traced, "{traced} {by_tiles} {by_source}");
    println!(
        "rays to lights: {traced} traced, {by_tiles} with each view's proofs, {by_source} with the source's"
    );
}

#[test]
fn full_verification_leaves_no_bad_pixel_and_without_there_are_some() {
    let (mut without, mut edges) = (0, 0);
    for path in shipped() {
        let Some(data) = data_at(&path, SIZE) else { continue };
        for first in ORDERS {
            let truth = naive(&data, first);
            let bad = |verify| {
                let shown = inferred(pair(&data, &verified(Method::Atomic, verify, first)));
                bad_pixels(&data, &shown.hits, &truth.hits)
            };
            assert_eq!(bad(Verify::All), 0, "{}, {first:?}", name(&path));
            without += bad(Verify::None);
            edges += bad(Verify::Edges);
        }
    }
    assert!(without > 0, "nothing is hidden by nearer things: this test cannot fail");
    println!("bad pixels: {without} without verification, {edges} with that of edges");
}

#[test]
fn traced_pixels_are_those_of_the_naive_method() {
    let mut kinds = [0; 5];
    for name in ["default", "spheres", "whitted", "lattice"] {
        let data = scene(name);
        for first in ORDERS {
            let truth = naive(&data, first);
            for verify in [Verify::None, Verify::All] {
                let shown = inferred(pair(&data, &verified(Method::Atomic, verify, first)));
                for (i, &word) in shown.inferred.source.iter().enumerate() {
                    kinds[source::kind(word) as usize] += 1;
                    if !is_reused(word) {
                        assert_eq!(words(&shown.hits[i..=i]), words(&truth.hits[i..=i]), "{name}, pixel {i}");
                        assert_eq!(words(&shown.surfaces[i..=i]), words(&truth.surfaces[i..=i]));
                        assert_eq!(
                            words(&shown.local[i..=i]),
                            words(&truth.local[i..=i]),
                            "{name}, pixel {i}"
                        );
                        assert_eq!(shown.shadow_rays[i], truth.shadow_rays[i]);
                    }
                }
            }
        }
    }
    assert!(kinds.iter().all(|&count| count > 0), "a kind of pixel that is not looked at: {kinds:?}");
}

#[test]
fn without_a_distance_between_the_eyes_both_views_are_one() {
    for name in ["default", "whitted", "spheres"] {
        let data = apart(name, 0.0);
        let truth = naive(&data, First::Left);
        for (method, shadows) in
            REPROJECTING.into_iter().zip([Shadows::Reuse, Shadows::Trace].into_iter().cycle())
        {
            let options = StereoOptions { shadows, ..verified(method, Verify::All, First::Left) };
            let shown = inferred(pair(&data, &options));
            assert!(
                shown.inferred.source.iter().all(|&word| is_reused(word)),
                "{name}: something was traced"
            );
            assert!(words(shown.colour()) == words(truth.colour()), "{name}, {}", method.name());
        }
    }
}

#[test]
fn a_distance_wider_than_the_picture_leaves_little_to_reuse() {
    let data = apart("spheres", 5.0 * SIZE[0] as f32);
    for verify in [Verify::None, Verify::All] {
        let shown = inferred(pair(&data, &verified(Method::Atomic, verify, First::Left)));
        let traced = shown.inferred.source.iter().filter(|&&word| !is_reused(word)).count();
        assert!(2 * traced > shown.inferred.source.len(), "{traced}");
        let truth = naive(&data, First::Left);
        let limit = if verify == Verify::All { 0 } else { shown.inferred.source.len() / 50 };
        assert!(bad_pixels(&data, &shown.hits, &truth.hits) <= limit);
    }
}

/// A wall that shines: copying its highlight would put it where the first eye sees it.
#[test]
fn highlights_are_those_of_the_second_eye() {
    let data = scene("default");
    let truth = naive(&data, First::Left);
    let made = pair(&data, &verified(Method::Atomic, Verify::All, First::Left));
    let first = made.source.local.clone();
    let shown = inferred(made);
    let (mut own, mut copied) = (0.0, 0.0);
    for (i, &word) in shown.inferred.source.iter().enumerate().filter(|(_, word)| is_reused(**word)) {
        let row = i - i % SIZE[0] as usize;
        // Where the rounding to pixels chose the very same primitive at nearly the same place.
        if shown.hits[i].prim_id == truth.hits[i].prim_id {
            let error = |colour: &[f32; 4]| {
                (0..3).map(|c| f64::from(colour[c] - truth.local[i][c]).powi(2)).sum::<f64>()
            };
            own += error(&shown.local[i]);
            copied += error(&first[row + source::column(word) as usize]);
        }
    }
    assert!(own < copied, "squared error {own} of shading anew, {copied} of copying");
}

#[test]
fn tracing_the_shadows_of_a_reused_point_gives_what_reusing_gives() {
    for name in ["spheres", "default"] {
        let data = scene(name);
        let reused = inferred(pair(&data, &verified(Method::Atomic, Verify::Edges, First::Right)));
        let options = StereoOptions {
            shadows: Shadows::Trace,
            ..verified(Method::Atomic, Verify::Edges, First::Right)
        };
        let traced = inferred(pair(&data, &options));
        assert_same(&reused, &traced, name);
        let rays = |shown: &Shown| shown.shadow_rays.iter().map(|rays| u64::from(rays.shadow)).sum::<u64>();
        assert!(rays(&traced) > 3 * rays(&reused), "{name}");
    }
}

/// The wider the angle, the fewer reflected rays, and the farther from the truth.
#[test]
fn reflections_of_the_first_eye_serve_the_second_within_an_angle() {
    let data = scene("whitted");
    let truth = naive(&data, First::Left);
    let seen = |reflections| {
        let options = StereoOptions { reflections, ..verified(Method::Atomic, Verify::All, First::Left) };
        let shown = inferred(pair(&data, &options));
        let rays = shown.bounced.as_ref().expect("a scene with mirrors").rays.iter();
        let rays: u64 = rays.map(|rays| u64::from(rays.reflected + rays.refracted)).sum();
        (rays, metrics::mse(&metrics::srgb8(shown.colour()), &metrics::srgb8(truth.colour())))
    };
    let traced = seen(Reflections::Trace);
    let (narrow, wide) = (seen(Reflections::Within(1.6)), seen(Reflections::Within(180.0)));
    assert!(traced.0 > narrow.0 && narrow.0 > wide.0, "rays: {traced:?}, {narrow:?}, {wide:?}");
    assert!(traced.1 < wide.1 && narrow.1 < wide.1, "errors: {traced:?}, {narrow:?}, {wide:?}");
    // What is left belongs to pixels that were traced.
    assert!(10 * wide.0 < traced.0, "{wide:?} of {traced:?}");
}

#[test]
fn the_lower_bound_copies() {
    let data = scene("whitted");
    let pair = pair(&data, &Method::Ideal.into());
    assert!(words(pair.second.colour()) == words(pair.source.colour()));
    assert!(pair.second.rays().all(|stage| stage.iter().all(|r| r.primary + r.shadow + r.reflected == 0)));
}

#[test]
fn kinds_of_traced_pixels_need_their_verification() {
    let data = scene("default");
    let kinds = |verify| {
        let shown = inferred(pair(&data, &verified(Method::Atomic, verify, First::Left)));
        [HOLE, GAP, BAD]
            .map(|kind| shown.inferred.source.iter().filter(|&&word| source::kind(word) == kind).count())
    };
    let [holes, gaps, bad] = kinds(Verify::None);
    assert!(holes > 0 && gaps > 0, "{holes} holes, {gaps} gaps");
    let [same_holes, no_gaps, found] = kinds(Verify::All);
    assert_eq!((same_holes, no_gaps), (holes, 0));
    assert!(found > bad && found <= gaps + bad + 40, "{found} found, {gaps} gaps");
}
