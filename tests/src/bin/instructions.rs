//! Traces a fixed set of rays for one instruction set, in one function that an instruction counter can be pointed at:
//! `instructions SSE2|AVX2 nearest|any`. Says how many rays, or that the machine lacks the instruction set.

use parallax::backend::cpu::instruction_set::{InstructionSet, Task};
use parallax::build::{Bvh, Quality, build};
use parallax_shared::layout::Ray;
use parallax_shared::traversal::{closest_hit, occluded};
use parallax_tests::meshes::{icosphere, rays_from_inside, rays_from_outside};
use std::hint::black_box;

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

/// What is counted.
#[inline(never)]
fn counted_traversal(set: InstructionSet, any: bool, bvh: &Bvh, rays: &[Ray]) {
    if any { set.run(Any(bvh, rays)) } else { set.run(Nearest(bvh, rays)) }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [set, query] = arguments.as_slice() else {
        eprintln!("usage: instructions SSE2|AVX2 nearest|any");
        std::process::exit(2);
    };
    let Some(set) = InstructionSet::available().into_iter().find(|available| available.name() == set) else {
        println!("unavailable");
        return;
    };
    let mesh = icosphere(5, 1.0, [0.0; 3]);
    let bvh = build(&mesh.triangles, &[], &[], Quality::Full).expect("a sphere can be built");
    let mut rays = rays_from_outside(&mesh, 10_000, 1);
    rays.extend(rays_from_inside(&mesh, 10_000, 2));
    counted_traversal(set, query == "any", &bvh, &rays);
    println!("rays {}", rays.len());
}
