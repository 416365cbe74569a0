//! What a second view was made of: rows whose every pixel is known, worked out by hand, and what must add up in all others.

use parallax::backend::Cpu;
use parallax::build::Quality;
use parallax::render::band::Band;
use parallax::render::stereo::Plan;
use parallax::render::stereo::overlap::Overlap;
use parallax::render::stereo::statistics::{StereoReport, StereoStatistics};
use parallax::render::{First, Method, Renderer, SceneData, Verify};
use parallax_tests::scenes;
use parallax_tests::stereo::{pair, verified};

/// A pixel of the zero-parallax plane, a world unit in front of the eyes, is 1/8 wide, and 8 of them lie between the eyes. A wall at
/// twice that distance moves 4 columns to the right.
const WALL: &str = r#"
[camera]
eye = [0.0, 0.0, 1.0]
target = [0.0, 0.0, 0.0]
vertical_fov_deg = 53.13010235415598
width = 32
height = 8
interaxial_px = 8
[sky]
zenith = [0.1, 0.2, 0.7]
horizon = [0.8, 0.8, 0.9]
[[light]]
position = [0.0, 0.0, 9.0]
colour = [0.5, 0.5, 0.5]
[material.grey]
colour = [0.5, 0.5, 0.5]
[[object]]
material = "grey"
quad = { corner = [-20.0, -20.0, -1.0], u = [40.0, 0.0, 0.0], v = [0.0, 40.0, 0.0] }
"#;

/// Half as far away as the plane, in columns 10 to 14 of the left view: it moves 8 columns to the left.
const PILLAR: &str = r#"
[[object]]
material = "grey"
quad = { corner = [-0.625, -9.0, 0.5], u = [0.3125, 0.0, 0.0], v = [0.0, 18.0, 0.0] }
"#;

/// On the plane, in columns 10 to 14 of both views: the left eye does not see it behind the pillar.
const HIDDEN: &str = r#"
[[object]]
material = "grey"
quad = { corner = [-0.75, -9.0, 0.0], u = [0.625, 0.0, 0.0], v = [0.0, 18.0, 0.0] }
"#;

const ROWS: u64 = 8;

fn scene(objects: &[&str]) -> SceneData {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), objects.concat()).unwrap();
    SceneData::new(&parallax::scene::load(file.path()).unwrap(), Quality::Full).unwrap()
}

fn statistics(data: &SceneData, verify: Verify) -> StereoStatistics {
    StereoStatistics::of_band(&pair(data, &verified(Method::Atomic, verify, First::Left))).unwrap()
}

/// Kept (reused or verified), holes, gaps and bad pixels of a row.
fn kinds(statistics: &StereoStatistics) -> [u64; 4] {
    let StereoStatistics { reused, verified, holes, gaps, bad, .. } = *statistics;
    [reused + verified, holes, gaps, bad].map(|count| {
        assert_eq!(count % ROWS, 0, "all rows are the same: {statistics:?}");
        count / ROWS
    })
}

#[test]
fn a_wall_leaves_a_strip_of_its_disparity() {
    let statistics = statistics(&scene(&[WALL]), Verify::None);
    assert_eq!(kinds(&statistics), [28, 4, 0, 0]);
    assert_eq!(statistics.verified, 0, "nothing is in front of the plane");
    assert_eq!(statistics.overlap, Overlap { landed: 28 * ROWS, overlapped: 0, largest: 1 });
    assert_eq!((statistics.traced(), statistics.m()), (4 * ROWS, 0.125));
    assert!((statistics.nearest_t.unwrap() - 2.0).abs() < 1e-5);
}

/// The wall's columns 0 to 9 land on 4 to 13, the pillar's on 2 to 6, and from column 15 on the wall lands on 19 and more. Nothing
/// lands on 0, 1 and 14 to 18; 7 to 13 lie between the pillar and the wall that follow each other.
#[test]
fn a_pillar_leaves_holes_and_gaps() {
    let data = scene(&[WALL, PILLAR]);
    let none = statistics(&data, Verify::None);
    assert_eq!(kinds(&none), [18, 7, 7, 0]);
    assert_eq!(none.overlap, Overlap { landed: 28 * ROWS, overlapped: 3 * ROWS, largest: 2 });
    let all = statistics(&data, Verify::All);
    assert_eq!(kinds(&all), [25, 7, 0, 0], "behind the pillar there is only the wall");
    assert_eq!((all.reused, all.verification_rays()), (0, 25 * ROWS));
    let edges = statistics(&data, Verify::Edges);
    assert_eq!(kinds(&edges), [25, 7, 0, 0]);
    assert!((7 * ROWS..25 * ROWS).contains(&edges.verified), "{edges:?}");
}

/// Columns 10 to 13 have a candidate, the wall, that the hidden pillar hides; nothing lands on 14.
#[test]
fn what_the_first_view_hides_makes_bad_pixels() {
    let data = scene(&[WALL, PILLAR, HIDDEN]);
    assert_eq!(kinds(&statistics(&data, Verify::None)), [18, 7, 7, 0]);
    let all = statistics(&data, Verify::All);
    assert_eq!(kinds(&all), [21, 7, 0, 4]);
    assert_eq!(all.verification_rays(), 25 * ROWS);
    assert_eq!(all.second_rays.primary, 32 * ROWS, "each pixel was looked at by one ray");
    assert_eq!(all.second_rays.shadow, 11 * ROWS, "and the light from traced ones alone");
    assert_eq!(all.first_rays.shadow, 32 * ROWS);
}

/// Whatever the scene: each pixel is of one kind, and has a ray unless it is reused.
#[test]
fn counts_add_up_in_every_scene() {
    let mut bad = 0;
    for path in scenes::shipped() {
        let Some(data) = scenes::data_at(&path, [48, 36]) else { continue };
        for (method, verify) in [Method::EsIsler, Method::Buffer]
            .into_iter()
            .flat_map(|method| [Verify::None, Verify::Edges, Verify::All].map(|verify| (method, verify)))
        {
            let options = verified(method, verify, First::Left);
            let s = StereoStatistics::of_band(&pair(&data, &options)).unwrap();
            let what = format!("{} {method:?} {verify:?} {s:?}", scenes::name(&path));
            assert_eq!(s.pixels, 48 * 36, "{what}");
            assert_eq!(s.reused + s.verified + s.holes + s.gaps + s.bad, s.pixels, "{what}");
            assert_eq!(s.second_rays.primary, s.pixels - s.reused, "{what}");
            assert!(verify == Verify::None || s.gaps == 0, "gaps are verified: {what}");
            assert!(verify != Verify::All || s.reused == 0, "all are verified: {what}");
            let report = StereoReport::new(&data, &Plan::new(&data, &options, true).unwrap(), &s);
            assert!(report.largest_overlap <= report.lemma_bound, "{what}");
            assert_eq!(report.rays_saved.primary, s.reused as i64, "{what}");
            assert!(report.saved_percent < 100.0, "{what}");
            bad += s.bad;
        }
    }
    assert!(bad > 0, "no scene has a bad pixel");
}

/// Counts of bands make up those of the picture, and a second view that was not inferred has none.
#[test]
fn bands_add_up_and_traced_views_have_no_counts() {
    let data = scene(&[WALL, PILLAR, HIDDEN]);
    let mut cpu = Cpu::new(1).unwrap();
    let plan = Plan::new(&data, &Method::Atomic.into(), true).unwrap();
    let mut renderer = Renderer::new(&mut cpu, &data).unwrap();
    let mut sum = StereoStatistics::default();
    for band in Band::of_picture(ROWS as u32, 3) {
        sum += StereoStatistics::of_band(&renderer.pair(&plan, band).unwrap()).unwrap();
    }
    assert_eq!(sum, statistics(&data, Verify::All));
    for method in [Method::Naive, Method::Ideal] {
        let pair = pair(&data, &method.into());
        assert!(pair.inferred.is_none());
        assert_eq!(StereoStatistics::of_band(&pair), None);
    }
}
