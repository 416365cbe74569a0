//! Traces a fixed set of rays, lets the pixels of a fixed view land in another one, or makes the pixels of a picture that see neither
//! its 17th light nor its mirror, for one instruction set, in one function that an instruction counter can be pointed at:
//! `instructions SSE2|AVX2 nearest|any|splat|plain|light|mirror`. Says how many rays or pixels, or that the machine lacks the
//! instruction set.

use parallax::backend::cpu::instruction_set::{InstructionSet, Task};
use parallax::build::{Bvh, Quality, build};
use parallax_shared::camera::primary_ray;
use parallax_shared::layout::{Hit, Ray, Reprojection, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::bounce::{is_whole, light_from, marked};
use parallax_shared::shading::shadow;
use parallax_shared::shading::surface::reconstruct;
use parallax_shared::stereo::run::{RUN, Run};
use parallax_shared::stereo::splat::splat;
use parallax_shared::traversal::{closest_hit, occluded};
use parallax_tests::far_things;
use parallax_tests::meshes::{icosphere, rays_from_inside, rays_from_outside};
use parallax_tests::small_scenes::render;
use parallax_tests::stage::Stage;
use parallax_tests::tables::reprojection;
use std::hint::black_box;
use std::sync::atomic::AtomicU32;

struct Nearest<'a>(&'a Bvh, &'a [Ray]);
struct Any<'a>(&'a Bvh, &'a [Ray]);

impl Task for Nearest<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for ray in self.1 {
            black_box(closest_hit(&self.0.rows, ray, self.0.extent));
        }
    }
}

impl Task for Any<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for ray in self.1 {
            black_box(occluded(&self.0.rows, ray, self.0.extent));
        }
    }
}

struct Splat<'a>(&'a Reprojection, &'a [Hit], &'a [AtomicU32], &'a [AtomicU32]);

impl Task for Splat<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self(p, hits, candidates, gaps) = self;
        for row in 0..p.rows {
            for number in 0..p.width.div_ceil(RUN) {
                splat(&Run::new(p, number, row), hits, candidates, gaps);
            }
        }
    }
}

/// What all passes do for some pixels of a picture.
struct Pixels<'a>(&'a View, SceneView<'a>, &'a [u32]);

impl Task for Pixels<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self(view, scene, pixels) = self;
        for &pixel in pixels {
            let ray = primary_ray(view, pixel % view.width, pixel / view.width);
            let hit = closest_hit(scene.rows, &ray, scene.info.extent);
            let (surface, dir) = (reconstruct(&scene, &ray, hit, view.interaxial_px), ray.dir.into());
            let mut seen = 0;
            black_box(shadow::trace(&scene, &surface, |_, bits| seen = bits));
            let colour = marked(&scene, &surface, shadow::shade(&scene, &surface, dir, |_| seen));
            if !is_whole(&black_box(colour)) {
                black_box(light_from(&scene, &surface, dir));
            }
        }
    }
}

/// What is counted.
#[inline(never)]
fn counted_task<T: Task>(set: InstructionSet, task: T) -> T::Output {
    set.run(task)
}

/// Traces rays from outside and inside of a sphere; returns how many.
fn trace(set: InstructionSet, any: bool) -> usize {
    let mesh = icosphere(5, 1.0, [0.0; 3]);
    let bvh = build(&mesh.triangles, &[], &[], Quality::Full).expect("a sphere can be built");
    let mut rays = rays_from_outside(&mesh, 10_000, 1);
    rays.extend(rays_from_inside(&mesh, 10_000, 2));
    if any {
        counted_task(set, Any(&bvh, &rays))
    } else {
        counted_task(set, Nearest(&bvh, &rays))
    }
    rays.len()
}

/// Lets the pixels of a disc before a floor and the sky land; returns how many.
fn reproject(set: InstructionSet) -> usize {
    let (width, rows) = (600, 100);
    let t = |x: u32, row: u32| match (x.abs_diff(300), row) {
        (0..150, _) => 0.8 + x.abs_diff(300) as f32 * 0.001,
        (_, 0..50) => f32::INFINITY,
        _ => 1.0 + 300.0 / row as f32,
    };
    let hits: Vec<Hit> =
        (0..width * rows).map(|pixel| Hit { t: t(pixel % width, pixel / width), prim_id: 0 }).collect();
    let table = || hits.iter().map(|_| AtomicU32::new(0)).collect::<Vec<_>>();
    counted_task(set, Splat(&reprojection(width, rows, 15.0), &hits, &table(), &table()));
    hits.len()
}

/// Makes the pixels of the floor, which face no light from below and see no mirror; returns how many.
fn make_floor(set: InstructionSet, stage: &Stage) -> usize {
    let hits = render(&far_things::with_mirror()).hits;
    let pixels: Vec<u32> =
        (0u32..).zip(&hits).filter(|(_, hit)| hit.prim_id < 2).map(|(pixel, _)| pixel).collect();
    let bvh = build(&stage.triangles, &stage.spheres, &[], Quality::Full).expect("a small scene");
    let (info, records) = (stage.info(bvh.extent), stage.records());
    let (rows, triangles, effects) = (&bvh.rows[..], &stage.triangles[..], stage.effects());
    let scene = SceneView { info: &info, rows, triangles, records: &records, texels: &[], effects };
    counted_task(set, Pixels(&stage.view, scene, &pixels));
    pixels.len()
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [set, query] = arguments.as_slice() else {
        eprintln!("usage: instructions SSE2|AVX2 nearest|any|splat|plain|light|mirror");
        std::process::exit(2);
    };
    let Some(set) = InstructionSet::available().into_iter().find(|available| available.name() == set) else {
        println!("unavailable");
        return;
    };
    let count = match query.as_str() {
        "splat" => reproject(set),
        "plain" => make_floor(set, &far_things::plain()),
        "light" => make_floor(set, &far_things::with_light()),
        "mirror" => make_floor(set, &far_things::with_mirror()),
        _ => trace(set, query == "any"),
    };
    println!("count {count}");
}
