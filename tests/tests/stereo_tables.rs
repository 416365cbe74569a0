//! What every way of making the tables of a second view makes: what 001's algorithm does when it is followed word by word, for both
//! orders of the eyes, with sources that leave the picture on both sides, in front of and behind the zero-parallax plane.

use parallax::backend::{Backend, Cpu, Profile};
use parallax::render::band::Band;
use parallax::render::stereo::overlap::{Overlap, lemma_bound};
use parallax::render::{Renderer, SceneData};
use parallax_kernels::stereo::slots::{ShiftRange, Slots};
use parallax_kernels::stereo::tables::Clear;
use parallax_shared::layout::{Hit, Reprojection};
use parallax_shared::stereo::run::{RUN, Run};
use parallax_shared::stereo::{slots, splat};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::scenes;
use parallax_tests::tables::{Producer, Tables, literal, reprojection};
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z >> 32) as u32
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.next() >> 8) as f32 / 16_777_216.0
    }
}

/// Runs of columns at the depth of objects, of slopes, of the sky, and now and then of anything.
fn depths(random: &mut Random, count: usize) -> Vec<Hit> {
    let mut hits = Vec::new();
    while hits.len() < count {
        let (length, kind) = (1 + random.next() % 12, random.next() % 6);
        let (start, slope) = (random.between(0.3, 4.0), random.between(-0.02, 0.05));
        for i in 0..length {
            let t = match kind {
                0 => f32::INFINITY,
                1 => random.between(0.01, 30.0),
                2 => start + slope * i as f32,
                3 => [0.0, f32::MIN_POSITIVE, f32::from_bits(1), f32::MAX][random.next() as usize % 4],
                _ => start,
            };
            hits.push(Hit { t, prim_id: 0 });
        }
    }
    hits.truncate(count);
    hits
}

/// Bands of every width up to three runs and some wider ones, in both orders, with interaxials from nothing to several widths.
fn bands() -> impl Iterator<Item = (Reprojection, Vec<Hit>)> {
    let mut random = Random(1);
    let widths = (1..=25).chain([64, 100, 131]);
    widths.flat_map(|width| [0.0, 0.3, 2.5, 15.0, 50.0, 700.0].map(|e| (width, e))).flat_map(
        move |(width, e)| {
            let hits = depths(&mut random, 3 * width as usize);
            [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(mirrored, inclusive)| {
                (Reprojection { mirrored, inclusive, ..reprojection(width, 3, e) }, hits.clone())
            })
        },
    )
}

fn assert_makes_what_001_does(producers: impl Fn(&Reprojection) -> Vec<Producer>) {
    let mut cpu = Cpu::new(2).unwrap();
    for (p, hits) in bands() {
        let expected = literal(&p, &hits).tables;
        for producer in producers(&p) {
            let tables = producer.run(&mut cpu, p, &hits).unwrap();
            assert_eq!(tables, expected, "{producer:?} {p:?} {hits:?}");
        }
    }
}

#[test]
fn maxima_make_what_the_sequential_algorithm_does() {
    assert_makes_what_001_does(|_| vec![Producer::Splat, Producer::Shifts]);
}

#[test]
fn walks_in_both_directions_make_what_the_sequential_algorithm_does() {
    assert_makes_what_001_does(|_| vec![Producer::Scanline, Producer::Lines, Producer::RightToLeft]);
}

#[test]
fn slots_make_what_the_sequential_algorithm_does() {
    assert_makes_what_001_does(|p| {
        vec![Producer::Slots(1, false), Producer::Slots(3, false), Producer::Slots(p.width, true)]
    });
}

/// The tables decide what the sequential algorithm leaves in the picture.
#[test]
fn a_pixel_is_reused_where_its_candidate_exceeds_its_gap() {
    let mut seen = [0; 3];
    for (p, hits) in bands() {
        let literal = literal(&p, &hits);
        let Tables { candidates, gaps } = literal.tables;
        for (pixel, source) in literal.picture.iter().enumerate() {
            let decided = (candidates[pixel] > gaps[pixel]).then(|| candidates[pixel] - 1);
            assert_eq!(decided, *source, "pixel {pixel}, {p:?}");
            seen[usize::from(source.is_none()) + usize::from(source.is_none() && candidates[pixel] == 0)] +=
                1;
        }
    }
    assert!(seen.iter().all(|&count| count > 1000), "reused, gap, hole: {seen:?}");
}

/// How many slots are filled, of `depth` slots per pixel that are taken to be enough.
fn filled(p: Reprojection, depth: u32, source: &[Hit]) -> u64 {
    let mut cpu = Cpu::new(1).unwrap();
    let p = Reprojection { depth, exclusive: 1, ..p };
    let hits = cpu.upload("hits", source).unwrap();
    let slots = cpu.create("slots", source.len() * depth as usize).unwrap();
    let gaps = cpu.create("gaps", source.len()).unwrap();
    cpu.run(&Clear { table: slots }, [slots.len.div_ceil(8), 1, 1]).unwrap();
    cpu.run(&Clear { table: gaps }, [gaps.len.div_ceil(8), 1, 1]).unwrap();
    cpu.run(&Slots { p, hits, slots, gaps }, [p.width.div_ceil(8), p.rows, 1]).unwrap();
    cpu.read(slots).unwrap().iter().filter(|&&key| key != 0).count() as u64
}

/// So many slots that the rows' shifts differ by less.
fn adaptive_depth(p: Reprojection, source: &[Hit]) -> u32 {
    let mut cpu = Cpu::new(1).unwrap();
    let hits = cpu.upload("hits", source).unwrap();
    let ranges = cpu.create("ranges", p.rows as usize).unwrap();
    cpu.run(&ShiftRange { p, hits, ranges }, [p.rows, 1, 1]).unwrap();
    let depths = cpu.read(ranges).unwrap().into_iter().map(|[low, high]: [i32; 2]| high - low + 1);
    depths.max().unwrap().max(1) as u32
}

fn nearest(hits: &[Hit]) -> Option<f32> {
    hits.iter().map(|hit| hit.t).filter(|t| t.is_finite()).min_by(f32::total_cmp)
}

/// A row whose columns from `first` on all land on one pixel: the farther right, the nearer, from infinity to the zero-parallax plane
/// (r = 1), with the disparities e, e − 1 … 0.
fn ramp(e: u32, first: u32, width: u32) -> Vec<Hit> {
    let t = |x: u32| match x.checked_sub(first) {
        // Far outside of the picture.
        None => 1e-6,
        Some(step) if step <= e => e as f32 / step as f32,
        Some(_) => 1e-6,
    };
    (0..width).map(|x| Hit { t: t(x), prim_id: 0 }).collect()
}

/// 000 fig. 12, and why the lemma needs one more: rounding puts r·e + 1 sources on one pixel, and r·e slots would lose one of them.
#[test]
fn a_ramp_reaches_the_bound_and_one_slot_less_loses_a_source() {
    for e in [1, 4, 15, 50] {
        let width = 2 * e + 7;
        let p = reprojection(width, 1, e as f32);
        let hits = ramp(e, 3, width);
        let overlap = Overlap::of_band(&p, &hits);
        assert_eq!((overlap.largest, overlap.landed, overlap.overlapped), (e + 1, u64::from(e) + 1, 1));
        assert_eq!(filled(p, e + 1, &hits), overlap.landed);
        assert_eq!(filled(p, e, &hits), overlap.landed - 1, "two sources share a slot");
        assert_eq!(adaptive_depth(p, &hits), e + 1);
    }
}

/// What a band of the source sees, and how it is reprojected.
fn source_of(data: &SceneData, mirrored: bool) -> (Reprojection, Vec<Hit>) {
    let mut cpu = Cpu::new(2).unwrap();
    let view = data.views[usize::from(mirrored)];
    let mut renderer = Renderer::new(&mut cpu, data).unwrap();
    let band = Band { first_row: 0, rows: view.height };
    let hits = renderer.band(usize::from(mirrored), band).unwrap().hits;
    let p = reprojection(view.width, view.height, view.interaxial_px);
    (Reprojection { mirrored: mirrored.into(), ..p }, hits)
}

#[test]
fn no_scene_exceeds_the_bound_and_no_slot_is_shared() {
    let mut overlapped = 0;
    for path in scenes::shipped() {
        let Some(data) = scenes::data_at(&path, [80, 60]) else { continue };
        for mirrored in [false, true] {
            let (p, hits) = source_of(&data, mirrored);
            // Ten times as far apart, so that small pictures have overlaps.
            let p = Reprojection { interaxial_px: 10.0 * p.interaxial_px, ..p };
            let overlap = Overlap::of_band(&p, &hits);
            let depths = [lemma_bound(p.interaxial_px, nearest(&hits)), adaptive_depth(p, &hits)];
            for depth in depths.map(|depth| depth.min(p.width)) {
                assert!(overlap.largest <= depth, "{} {overlap:?} {depth}", scenes::name(&path));
                assert_eq!(filled(p, depth, &hits), overlap.landed, "{} {depth}", scenes::name(&path));
            }
            overlapped += overlap.overlapped;
        }
    }
    assert!(overlapped > 1000, "{overlapped} overlaps are too few to tell");
}

/// Every way of making the tables, in bands that have everything: wide jumps, overlaps, both sides left.
fn cases() -> Vec<(Producer, Reprojection, Vec<Hit>)> {
    let mut random = Random(7);
    let producers = [
        Producer::Splat,
        Producer::Shifts,
        Producer::Slots(64, true),
        Producer::Slots(1, false),
        Producer::Slots(3, false),
        Producer::Scanline,
        Producer::Lines,
        Producer::RightToLeft,
    ];
    let cases = producers.into_iter().flat_map(|producer| [0, 1].map(|mirrored| (producer, mirrored)));
    cases
        .map(|(producer, mirrored)| {
            let p = Reprojection { mirrored, inclusive: mirrored, ..reprojection(61, 23, 9.0) };
            (producer, p, depths(&mut random, 61 * 23))
        })
        .collect()
}

/// Runs of columns from the last to the first, which no backend would choose by itself.
#[test]
fn runs_may_come_in_any_order() {
    for (p, hits) in bands() {
        let empty = |len: usize| (0..len).map(|_| AtomicU32::new(0)).collect::<Vec<_>>();
        let words = |table: &[AtomicU32]| table.iter().map(|word| word.load(Relaxed)).collect::<Vec<_>>();
        let p = Reprojection { depth: 2, ..p };
        let [candidates, gaps, gaps_by_slots] = [(); 3].map(|()| empty(hits.len()));
        let slots = empty(2 * hits.len());
        for row in 0..p.rows {
            for number in (0..p.width.div_ceil(RUN)).rev() {
                let run = Run::new(&p, number, row);
                splat::splat(&run, &hits, &candidates, &gaps);
                slots::put(&run, &hits, &slots, &gaps_by_slots);
            }
        }
        let expected = literal(&p, &hits).tables;
        assert_eq!(Tables { candidates: words(&candidates), gaps: words(&gaps) }, expected, "{p:?}");
        let slots = words(&slots);
        let nearest = (0..hits.len() as u32).map(|pixel| slots::nearest(&slots, pixel, 2)).collect();
        assert_eq!(Tables { candidates: nearest, gaps: words(&gaps_by_slots) }, expected, "{p:?}");
    }
}

/// The largest key wins whoever comes first: 20 runs with each number of threads.
#[test]
fn threads_make_no_difference() {
    for (producer, p, hits) in cases() {
        let expected = literal(&p, &hits).tables;
        for threads in [1, 2, 3] {
            let mut cpu = Cpu::new(threads).unwrap();
            for _ in 0..20 {
                assert_eq!(producer.run(&mut cpu, p, &hits).unwrap(), expected, "{producer:?}");
            }
        }
    }
}

fn assert_device_makes_the_same(driver: Driver) {
    let Some(mut gpu) = open(driver, Profile::Strict) else { return };
    for (producer, p, hits) in cases() {
        let expected = literal(&p, &hits).tables;
        for run in 0..20 {
            assert_eq!(producer.run(&mut gpu, p, &hits).unwrap(), expected, "{producer:?}, run {run}");
        }
    }
}

#[test]
fn lavapipe_makes_the_same_run_after_run() {
    assert_device_makes_the_same(Driver::Lavapipe);
}

#[test]
fn swiftshader_makes_the_same_run_after_run() {
    assert_device_makes_the_same(Driver::SwiftShader);
}
