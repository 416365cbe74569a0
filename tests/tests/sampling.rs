//! Several rays for each pixel: what a pixel is made of, and pairs whose points are reprojected.

use parallax::backend::{Cpu, Profile};
use parallax::diff;
use parallax::metrics::{mse, srgb8};
use parallax::render::band::{Band, Pair};
use parallax::render::stereo::statistics::StereoStatistics;
use parallax::render::{First, Method, Samples, SceneData, StereoOptions, Verify, render};
use parallax::scene::Sky;
use parallax_shared::effects::Effects;
use parallax_shared::stereo::source::{self, is_reused};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::scenes::{data_at, file, load_at};
use parallax_tests::stereo::{ORDERS, REPROJECTING, inferred, naive, pair, pair_on, verified};

const SIZE: [u32; 2] = [60, 40];

const ADAPTIVE: Samples = Samples::Adaptive { levels: 2, tolerance: 0.05 };
const ALL: [Samples; 3] = [Samples::Nine, Samples::Jittered(3), ADAPTIVE];

fn scene_at(name: &str, size: [u32; 2]) -> SceneData {
    data_at(&file(name), size).expect("a scene that ships whole")
}

fn scene(name: &str) -> SceneData {
    scene_at(name, SIZE)
}

fn with(samples: Samples, options: StereoOptions) -> StereoOptions {
    StereoOptions { samples, ..options }
}

fn sampled(data: &SceneData, samples: Samples) -> Pair {
    pair(data, &with(samples, Method::Naive.into()))
}

/// The colours of all points of both views, traced like the pixels of a picture.
fn points(data: &SceneData, samples: Samples) -> SceneData {
    let grid = samples.grid().expect("several rays");
    let views = data.views.map(|view| grid.view(&view, grid.levels));
    SceneData { views, ..data.clone() }
}

fn bits(colours: &[[f32; 4]]) -> Vec<[u32; 4]> {
    colours.iter().map(|colour| colour.map(f32::to_bits)).collect()
}

/// The mean of some points, `[x, y, weight]` from a pixel's first one, in f64.
fn mean(colours: &[[f32; 4]], width: usize, first: [usize; 2], points: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|channel| {
        let value = |&[x, y, weight]: &[f64; 3]| {
            let at = (first[1] + y as usize) * width + first[0] + x as usize;
            weight * f64::from(colours[at][channel])
        };
        points.iter().map(value).sum()
    })
}

fn assert_means(data: &SceneData, samples: Samples, per_pixel: usize, weights: &[[f64; 3]]) {
    let of_points = points(data, samples);
    let width = of_points.views[0].width as usize;
    let want = pair(&of_points, &StereoOptions::default());
    let got = sampled(data, samples);
    for (got, want) in [(&got.source, &want.source), (&got.second, &want.second)] {
        for (i, colour) in got.colour().iter().enumerate() {
            let first = [i % SIZE[0] as usize, i / SIZE[0] as usize].map(|place| place * per_pixel);
            let mean = mean(want.colour(), width, first, weights);
            let wrong = (0..3).find(|&c| (f64::from(colour[c]) - mean[c]).abs() > 1e-6);
            assert_eq!(wrong, None, "{samples}, pixel {i}: {colour:?} instead of {mean:?}");
        }
    }
}

#[test]
fn pixels_are_the_means_of_points_as_one_ray_sees_them() {
    for name in ["default", "spheres", "whitted"] {
        let data = scene(name);
        let weight = |i: i32| if i == 1 { 0.5 } else { 0.25 };
        let square = |n: i32| (0..n).flat_map(move |y| (0..n).map(move |x| (x, y)));
        let nine: Vec<_> =
            square(3).map(|(x, y)| [f64::from(x), f64::from(y), weight(x) * weight(y)]).collect();
        assert_means(&data, Samples::Nine, 2, &nine);
        let jittered: Vec<_> = square(3).map(|(x, y)| [f64::from(x), f64::from(y), 1.0 / 9.0]).collect();
        assert_means(&data, Samples::Jittered(3), 3, &jittered);
        let corners = [[0.0, 0.0, 0.25], [4.0, 0.0, 0.25], [0.0, 4.0, 0.25], [4.0, 4.0, 0.25]];
        assert_means(&data, Samples::Adaptive { levels: 2, tolerance: 2.0 }, 4, &corners);
    }
}

#[test]
fn points_of_a_common_edge_are_traced_once() {
    let data = scene("spheres");
    let [width, height] = SIZE.map(u64::from);
    let primary = |samples| -> u64 {
        sampled(&data, samples).source.rays().flatten().map(|rays| u64::from(rays.primary)).sum()
    };
    assert_eq!(primary(Samples::Nine), (2 * width + 1) * (2 * height + 1));
    assert_eq!(primary(Samples::Jittered(2)), 4 * width * height);
    let coarsest = (width + 1) * (height + 1);
    let adaptive = |tolerance| primary(Samples::Adaptive { levels: 2, tolerance });
    assert_eq!(adaptive(2.0), coarsest, "nothing differs so much");
    let (loose, tight) = (adaptive(0.2), adaptive(0.02));
    let all = (4 * width + 1) * (4 * height + 1);
    assert!(coarsest < loose && loose < tight && tight < all, "{loose} and {tight} of {all}");
}

/// More rays are nearer to the truth, and adaptive sampling needs few for it.
#[test]
fn more_rays_smooth_edges() {
    let data = scene("default");
    let truth = srgb8(sampled(&data, Samples::Jittered(8)).source.colour());
    let error = |samples| mse(&srgb8(sampled(&data, samples).source.colour()), &truth);
    let [one, nine, jittered, adaptive] =
        [Samples::One, Samples::Nine, Samples::Jittered(3), ADAPTIVE].map(error);
    assert!(
        nine < 0.5 * one && jittered < 0.5 * one && adaptive < 0.5 * one,
        "{one} {nine} {jittered} {adaptive}"
    );
}

#[test]
fn all_methods_give_the_same_pair() {
    for samples in ALL {
        for (name, first) in ["default", "spheres"].into_iter().zip(ORDERS) {
            let data = scene(name);
            for verify in [Verify::None, Verify::All] {
                let shown = |method| pair(&data, &with(samples, verified(method, verify, first)));
                let one = inferred(shown(Method::Scanline));
                for method in REPROJECTING {
                    let other = inferred(shown(method));
                    let what = format!("{samples}, {name}, {verify:?}, {}", method.name());
                    assert_eq!(one.inferred, other.inferred, "{what}");
                    assert_eq!(bits(one.colour()), bits(other.colour()), "{what}");
                }
            }
        }
    }
}

#[test]
fn without_a_distance_between_the_eyes_both_views_are_one() {
    for name in ["default", "spheres"] {
        let mut scene = load_at(&file(name), SIZE).expect("a scene");
        scene.rig.interaxial_px = 0.0;
        let data = SceneData::new(&scene, Default::default()).expect("a scene that renders");
        for samples in ALL {
            let options = with(samples, verified(Method::Atomic, Verify::All, First::Left));
            let made = pair(&data, &options);
            assert_eq!(bits(made.source.colour()), bits(made.second.colour()), "{name}, {samples}");
            let words = inferred(made).inferred.source;
            let traced = words.iter().filter(|word| source::is_traced(**word)).count();
            assert_eq!(traced, 0, "{name}, {samples}");
            assert!(words.iter().any(|word| is_reused(*word)));
        }
    }
}

/// 001: "greatly rectified by a multiple rays per pixel technique using multiplied rows and columns or stereoscopic adaptive
/// super-sampling". What rounding to columns does to a pixel shrinks with the columns.
#[test]
fn finer_columns_move_points_less_than_half_a_pixel() {
    let data = scene("default");
    let error = |samples| {
        let shown = pair(&data, &with(samples, verified(Method::Atomic, Verify::All, First::Left)));
        mse(&srgb8(shown.second.colour()), &srgb8(sampled(&data, samples).second.colour()))
    };
    let [one, jittered, adaptive] = [Samples::One, Samples::Jittered(4), ADAPTIVE].map(error);
    assert!(jittered < 0.5 * one && adaptive < 0.5 * one, "{one} {jittered} {adaptive}");
}

/// Fully verified, traced and reused points together show what there is: against a picture of traced points nothing is far off.
#[test]
fn no_bad_point_survives_full_verification() {
    let mut found = 0;
    for samples in [Samples::Jittered(2), ADAPTIVE] {
        let data = scene("spheres");
        let of_points = points(&data, samples);
        let truth = naive(&of_points, First::Left);
        let shown = inferred(pair(&data, &with(samples, verified(Method::Atomic, Verify::All, First::Left))));
        let source = naive_source(&of_points);
        let e = of_points.views[0].interaxial_px;
        let width = of_points.views[0].width as usize;
        let disparity = |t| parallax_shared::camera::disparity_px(e, t);
        for (i, &word) in shown.inferred.source.iter().enumerate().filter(|(_, word)| is_reused(**word)) {
            let t = source[i - i % width + source::column(word) as usize];
            assert!(disparity(truth.hits[i].t) > disparity(t) - 1.001, "{samples}, point {i}");
            found += 1;
        }
    }
    assert!(found > 1000, "{found}");
}

fn naive_source(data: &SceneData) -> Vec<f32> {
    pair(data, &StereoOptions::default()).source.hits.iter().map(|hit| hit.t).collect()
}

/// 001's remedy for ghosts traces the right end of each gap too: about a tenth more than one ray does.
#[test]
fn nine_rays_trace_the_ends_of_gaps() {
    let data = scene("spheres");
    let traced = |samples| {
        let options = with(samples, verified(Method::Scanline, Verify::None, First::Left));
        StereoStatistics::of_band(&pair(&data, &options)).expect("an inferred view").gaps
    };
    let [one, nine] = [Samples::One, Samples::Nine].map(traced);
    assert!(nine > one, "{nine} with nine rays, {one} with one");
}

#[test]
fn the_lower_bound_copies() {
    for samples in ALL {
        let pair = pair(&scene("default"), &with(samples, Method::Ideal.into()));
        assert_eq!(bits(pair.source.colour()), bits(pair.second.colour()));
        assert!(pair.second.rays().flatten().all(|rays| rays.primary + rays.shadow + rays.reflected == 0));
    }
}

/// Pictures are made band by band; the bands are the same on every backend, and their pixels those of the pairs of bands.
#[test]
fn frames_are_made_of_bands_of_sixteen_rows() {
    let data = scene("default");
    let options = with(ADAPTIVE, Method::Atomic.into());
    let frame = render(&mut Cpu::new(2).unwrap(), &data, &options, &mut |_, _| {}).unwrap();
    let mut cpu = Cpu::new(1).unwrap();
    let plan = parallax::render::stereo::Plan::new(&data, &options, true).unwrap();
    let mut renderer = parallax::render::Renderer::new(&mut cpu, &data).unwrap();
    assert_eq!(renderer.suggested_rows(&plan), 16);
    let mut colours = Vec::new();
    for band in Band::of_picture(SIZE[1], 16) {
        let pair = renderer.pair(&plan, band).unwrap();
        colours.extend(pair.second.colour().iter().map(|&[r, g, b, _]| [r, g, b].map(f32::to_bits)));
    }
    let shown: Vec<_> = frame.images.views[1].colour.iter().map(|colour| colour.map(f32::to_bits)).collect();
    assert!(colours == shown);
}

fn assert_equal(driver: Driver, runs: usize) {
    let Some(mut gpu) = open(driver, Profile::Strict) else { return };
    for name in ["default", "spheres"] {
        let data = scene_at(name, [18, 13]);
        for (samples, method) in ALL.into_iter().zip([Method::Buffer, Method::Atomic, Method::Gather2]) {
            let options = with(samples, method.into());
            let mut cpu = Cpu::new(0).unwrap();
            let once = diff::against_gpu(&mut cpu, &mut gpu, &data, &options, &mut |_, _| {}).unwrap();
            assert!(once.equal, "{driver:?}, {name}, {options:?}: {once}");
            let first = pair_on(&mut gpu, &data, &options);
            for _ in 1..runs {
                assert!(pair_on(&mut gpu, &data, &options) == first, "{driver:?}, {name}, {options:?}");
            }
        }
    }
}

/// In a matt scene with mirrors the points that reflect nothing are carried over: to the same colours and rays as when the scene is said
/// to have highlights, so that every point is shaded for its eye.
#[test]
fn carried_points_beside_mirrors_look_as_if_they_were_shaded() {
    let mut scene = load_at(&file("default"), [18, 13]).expect("a scene");
    scene.materials.iter_mut().for_each(|material| material.specular = 0.0);
    // The directions of both eyes into the sky are the same but for rounding.
    scene.sky = Sky::Gradient { zenith: [0.0; 3], horizon: [0.0; 3] };
    let matt = SceneData::new(&scene, Default::default()).expect("a scene that renders");
    assert!(matt.effects.has(Effects::REFLECTION) && !matt.effects.has(Effects::SPECULAR));
    let shining = SceneData { effects: matt.effects.with(Effects::SPECULAR), ..matt.clone() };
    let mut gpu = open(Driver::Lavapipe, Profile::Strict);
    for samples in ALL {
        let options = with(samples, Method::Gather1.into());
        let shaded = pair(&shining, &options).second;
        let on_gpu = gpu.as_mut().map(|gpu| pair_on(gpu, &matt, &options));
        for carried in [Some(pair(&matt, &options)), on_gpu].into_iter().flatten().map(|pair| pair.second) {
            let pixels = bits(&carried.local).into_iter().zip(bits(&shaded.local));
            assert_eq!(pixels.filter(|(carried, shaded)| carried != shaded).count(), 0, "{samples:?}");
            assert!(carried.primary_rays == shaded.primary_rays, "{samples:?}");
        }
    }
}

#[test]
fn points_have_the_cpus_bits_on_lavapipe_in_each_of_twenty_runs() {
    assert_equal(Driver::Lavapipe, 20);
}

#[test]
fn points_have_the_cpus_bits_on_swiftshader() {
    assert_equal(Driver::SwiftShader, 2);
}
