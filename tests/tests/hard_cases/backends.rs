//! What every case needs: rays through a structure on both backends, and a line that says how many there were.

use parallax::backend::{Backend, Cpu, Profile};
use parallax::build::{Bvh, Quality, build};
use parallax_kernels::rays::{OccludedRays, TraceRays};
use parallax_shared::layout::{Ellipsoid, Hit, NONE, Ray, Sphere, Triangle};
use parallax_tests::gpu::{Driver, open};
use parallax_tests::reference::Reference;
use parallax_tests::stage::{Stage, Stages};
use std::io::Write;

/// Tells how many cases of a kind were tried. To the terminal itself, since cargo hides what a passing test prints.
pub fn tried(kind: &str, cases: usize) {
    assert!(cases > 0, "{kind}: nothing was tried");
    // Nothing is lost when the terminal is gone.
    let _ = writeln!(std::io::stderr(), "hard case: {kind}: {cases} cases");
}

/// A structure over primitives.
pub fn structure(triangles: &[Triangle], spheres: &[Sphere], ellipsoids: &[Ellipsoid]) -> Bvh {
    build(triangles, spheres, ellipsoids, Quality::Full).expect("a small scene")
}

fn on_backend(backend: &mut impl Backend, bvh: &Bvh, rays: &[Ray]) -> (Vec<Hit>, Vec<u32>) {
    let given = backend.upload("rays", rays).unwrap();
    let rows = backend.upload("rows", &bvh.rows).unwrap();
    let hits = backend.create("hits", rays.len()).unwrap();
    let occluded = backend.create("occluded", rays.len()).unwrap();
    let (extent, groups) = (bvh.extent, [rays.len() as u32, 1, 1]);
    backend.run(&TraceRays { rays: given, rows, extent, hits }, groups).unwrap();
    backend.run(&OccludedRays { rays: given, rows, extent, occluded }, groups).unwrap();
    backend.finish().unwrap();
    (backend.read(hits).unwrap(), backend.read(occluded).unwrap())
}

/// The nearest hits, which are the same bits on both backends, and agree with what is occluded.
pub fn hits(bvh: &Bvh, rays: &[Ray]) -> Vec<Hit> {
    let (hits, occluded) = on_backend(&mut Cpu::new(0).unwrap(), bvh, rays);
    for ((hit, hidden), ray) in hits.iter().zip(&occluded).zip(rays) {
        assert_eq!(hit.prim_id != NONE, *hidden == 1, "{ray:?}: {hit:?}");
    }
    if let Some(mut gpu) = open(Driver::Lavapipe, Profile::Strict) {
        let (other, hidden) = on_backend(&mut gpu, bvh, rays);
        for ((a, b), ray) in hits.iter().zip(&other).zip(rays) {
            assert_eq!((a.t.to_bits(), a.prim_id), (b.t.to_bits(), b.prim_id), "CPU and GPU: {ray:?}");
        }
        assert_eq!(occluded, hidden, "occlusion on CPU and GPU");
    }
    hits
}

/// Compares with brute force, whose edge signs are exact; +0 and −0 are one `t`. Returns the hits.
pub fn assert_brute_force(triangles: &[Triangle], rays: &[Ray]) -> Vec<Hit> {
    let bvh = structure(triangles, &[], &[]);
    let found = hits(&bvh, rays);
    for (ray, hit) in rays.iter().zip(&found) {
        let expected = Reference::new(*ray, bvh.extent).brute_force(triangles).0;
        let bits = |hit: &Hit| ((hit.t + 0.0).to_bits(), hit.prim_id);
        assert_eq!(bits(hit), bits(&expected), "{ray:?}: {hit:?}, not {expected:?}");
    }
    found
}

/// What the passes make of a stage: the same bits on both backends.
pub fn stages(stage: &Stage) -> Stages {
    let made = stage.render(&mut Cpu::new(0).unwrap()).unwrap();
    if let Some(mut gpu) = open(Driver::Lavapipe, Profile::Strict) {
        let other = stage.render(&mut gpu).unwrap();
        let words = |colours: &[[f32; 4]]| bytemuck::cast_slice::<_, u32>(colours).to_vec();
        assert!(words(&made.colours) == words(&other.colours), "colours on CPU and GPU");
        assert!(made.hits == other.hits && made.seen == other.seen, "hits and lights on CPU and GPU");
        assert!(made.surfaces == other.surfaces && made.counts == other.counts, "surfaces on CPU and GPU");
    }
    made
}
