//! Exact hits (DESIGN §3.1): rays at the edges and vertices of closed meshes never slip through and have one owner, and `t` and
//! number are those of brute force in every structure, driver, instruction set and backend. Each rule that this rests on is taken
//! away in turn, and must be missed.

use parallax::backend::cpu::instruction_set::{InstructionSet, Task};
use parallax::backend::{Cpu, Profile};
use parallax::build::{Bvh, Quality, build};
use parallax::verify::suite::trace;
use parallax_shared::layout::{Hit, NONE, Ray};
use parallax_shared::traversal::rules::{Exact, Rules};
use parallax_shared::traversal::walk::walk;
use parallax_tests::gpu::{Driver, open};
use parallax_tests::meshes::{Mesh, cube, icosphere, rays_from_inside, rays_from_outside};
use parallax_tests::reference::Reference;
use rayon::prelude::*;
use std::marker::PhantomData;

/// How many rays of each mesh go through the slower variants too, those by lanes above all: with ten meshes a million in all.
const SCANNED: usize = 100_000;

const FAR_OFF: [f32; 3] = [148_376.0, 1234.0, -223_423.0];

/// Walks all rays; `ANY`: only whether they hit, `SCAN`: lane after lane.
struct Walk<'a, R, const ANY: bool, const SCAN: bool>(&'a Bvh, &'a [Ray], PhantomData<R>);

impl<R: Rules, const ANY: bool, const SCAN: bool> Task for Walk<'_, R, ANY, SCAN> {
    type Output = Vec<Hit>;

    #[inline(always)]
    fn run(self) -> Vec<Hit> {
        let mut hits = Vec::with_capacity(self.1.len());
        for ray in self.1 {
            hits.push(walk::<R, ANY, SCAN>(&self.0.rows, ray, self.0.extent));
        }
        hits
    }
}

fn hits<R: Rules, const ANY: bool, const SCAN: bool>(
    set: InstructionSet,
    bvh: &Bvh,
    rays: &[Ray],
) -> Vec<Hit> {
    let chunk = |rays: &[Ray]| set.run(Walk::<R, ANY, SCAN>(bvh, rays, PhantomData));
    rays.par_chunks(4096).flat_map_iter(chunk).collect()
}

fn structures(mesh: &Mesh) -> [Bvh; 2] {
    [Quality::Full, Quality::Quick].map(|quality| build(&mesh.triangles, &[], &[], quality).unwrap())
}

/// +0 and −0 are one `t`.
fn same(a: &Hit, b: &Hit) -> bool {
    a.prim_id == b.prim_id && (a.t + 0.0).to_bits() == (b.t + 0.0).to_bits()
}

fn count(faulty: impl Iterator<Item = bool>) -> usize {
    faulty.filter(|&fault| fault).count()
}

#[derive(Debug, Default, PartialEq)]
struct Faults {
    missed: usize,
    differ_between_structures: usize,
    any_differs_from_nearest: usize,
    differ_from_brute_force: usize,
    owners_not_one: usize,
}

/// Everything that can go wrong on `rays`, under the rules `R`, in every structure, driver and instruction set.
fn faults<R: Rules>(mesh: &Mesh, rays: &[Ray]) -> Faults {
    let mut faults = Faults::default();
    let structures = structures(mesh);
    let expected = hits::<R, false, false>(InstructionSet::BASELINE, &structures[0], rays);
    for bvh in &structures {
        for set in InstructionSet::available() {
            let some = &rays[..rays.len().min(SCANNED)];
            for hits in [hits::<R, false, false>(set, bvh, rays), hits::<R, false, true>(set, bvh, some)] {
                let differs = hits.iter().zip(&expected).map(|(a, b)| !same(a, b));
                faults.differ_between_structures += count(differs);
            }
        }
        let some = &rays[..rays.len().min(SCANNED)];
        for any in [
            hits::<R, true, false>(InstructionSet::best(), bvh, rays),
            hits::<R, true, false>(InstructionSet::BASELINE, bvh, some),
            hits::<R, true, true>(InstructionSet::BASELINE, bvh, some),
        ] {
            let differs = any.iter().zip(&expected).map(|(a, b)| (a.prim_id == NONE) != (b.prim_id == NONE));
            faults.any_differs_from_nearest += count(differs);
        }
    }
    faults.missed = count(expected.iter().map(|hit| hit.prim_id == NONE));
    let step = (rays.len() * mesh.triangles.len() / 60_000_000).max(20);
    let brute: Vec<_> = (rays.par_iter().zip(&expected).step_by(step))
        .map(|(ray, hit)| {
            let (nearest, owners) = Reference::new(*ray, structures[0].extent).brute_force(&mesh.triangles);
            (!same(&nearest, hit), owners != 1)
        })
        .collect();
    faults.differ_from_brute_force = count(brute.iter().map(|b| b.0));
    faults.owners_not_one = count(brute.iter().map(|b| b.1));
    faults
}

fn closed_meshes() -> Vec<Mesh> {
    let mut meshes = vec![
        icosphere(5, 1.0, [0.0; 3]),
        icosphere(2, 1.0, FAR_OFF),
        icosphere(4, 100.0, FAR_OFF),
        icosphere(4, 1e6, [1.0, 2.0, 3.0]),
        icosphere(6, 1.0, [10.0, -10.0, 5.0]),
        cube(1.0, [0.0; 3]),
        cube(0.5, [1000.25, -333.5, 77.125]),
    ];
    let sizes = [1e-15, 1e-6, 1e15];
    meshes.extend(sizes.map(|radius| icosphere(4, radius, [0.0; 3])));
    meshes.into_iter().map(Mesh::scaled).collect()
}

#[test]
fn ten_million_rays_at_edges_and_vertices_find_one_owner_each() {
    let meshes = closed_meshes();
    for (number, mesh) in meshes.iter().enumerate() {
        let rays = rays_from_inside(mesh, 1_000_000, number as u64);
        assert_eq!(faults::<Exact>(mesh, &rays), Faults::default(), "{}", mesh.name);
    }
    assert_eq!(meshes.len(), 10, "ten times a million rays");
}

#[test]
fn rays_from_outside_hit_what_brute_force_hits() {
    let tied = icosphere(3, 1.0, [0.0; 3]).repeated(20).scaled();
    for mesh in closed_meshes().iter().chain([&tied]) {
        let rays = rays_from_outside(mesh, 100_000, 11);
        let found = faults::<Exact>(mesh, &rays);
        let Faults { missed, owners_not_one, .. } = found;
        let expected = Faults { missed, owners_not_one, ..Faults::default() };
        assert_eq!(found, expected, "{}", mesh.name);
        assert!(
            missed > 1000 && owners_not_one > 100,
            "{}: these rays are to see holes and depth",
            mesh.name
        );
    }
}

/// Triangles 10⁵ times as long as high.
fn slivers() -> Mesh {
    let mut mesh = icosphere(1, 1.0, [0.0; 3]);
    for triangle in &mut mesh.triangles {
        let [a, b, c] = &mut triangle.vertices;
        *c = [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * 0.4 + c[k] * 1e-5);
    }
    Mesh { name: "slivers".into(), ..mesh }
}

/// Where `t` is moved to the near side of a triangle's own box, the box of another pack with a copy of it is entered at that very `t`:
/// it must still be opened, for its copy may be the first.
#[test]
fn slivers_on_slivers_belong_to_the_first() {
    let mesh = slivers().repeated(20).scaled();
    let rays = rays_from_outside(&mesh, 30_000, 3);
    let found = faults::<Exact>(&mesh, &rays);
    let Faults { missed, owners_not_one, .. } = found;
    assert_eq!(found, Faults { missed, owners_not_one, ..Faults::default() });
    assert!(missed < rays.len() - 1000, "{missed} of the rays miss");
}

/// Boxes as they are.
struct NoPadding;

impl Rules for NoPadding {
    const PADDING: f32 = 0.0;
}

/// Of two hits at the same `t` whichever is found first.
struct NoTieRule;

impl Rules for NoTieRule {
    const SMALLER_ID: bool = false;
}

/// A point of an edge belongs to both triangles.
struct NoShift;

impl Rules for NoShift {
    const SHIFT: bool = false;
}

#[test]
fn without_padding_rays_slip_through() {
    let mesh = icosphere(4, 1.0, FAR_OFF).scaled();
    let faults = faults::<NoPadding>(&mesh, &rays_from_inside(&mesh, 100_000, 1));
    assert!(faults.missed > 100, "{faults:?}");
}

#[test]
fn without_the_tie_rule_structures_disagree() {
    let mesh = icosphere(3, 1.0, [0.0; 3]).repeated(20).scaled();
    let faults = faults::<NoTieRule>(&mesh, &rays_from_inside(&mesh, 20_000, 1));
    assert!(faults.differ_between_structures > 100, "{faults:?}");
}

#[test]
fn without_the_shift_points_of_edges_have_other_owners() {
    let mesh = icosphere(5, 1.0, [0.0; 3]).scaled();
    let faults = faults::<NoShift>(&mesh, &rays_from_inside(&mesh, 200_000, 1));
    assert!(faults.differ_from_brute_force > 10, "{faults:?}");
}

#[test]
fn both_backends_give_the_same_bits() {
    for mesh in [icosphere(4, 100.0, FAR_OFF).scaled(), cube(1.0, [0.0; 3]).scaled()] {
        let mut rays = rays_from_inside(&mesh, 10_000, 5);
        rays.extend(rays_from_outside(&mesh, 10_000, 6));
        for bvh in structures(&mesh) {
            let cpu = trace(&mut Cpu::new(0).unwrap(), &bvh, &rays).unwrap();
            let direct = hits::<Exact, false, true>(InstructionSet::BASELINE, &bvh, &rays);
            assert!(cpu.0.iter().zip(&direct).all(|(a, b)| same(a, b)), "{}", mesh.name);
            for driver in Driver::SOFTWARE {
                let Some(mut gpu) = open(driver, Profile::Strict) else { continue };
                let gpu = trace(&mut gpu, &bvh, &rays).unwrap();
                let bits = |hit: &Hit| (hit.t.to_bits(), hit.prim_id);
                let differ = count(gpu.0.iter().zip(&cpu.0).map(|(a, b)| bits(a) != bits(b)));
                assert_eq!(differ, 0, "{} on {driver:?}", mesh.name);
                assert_eq!(gpu.1, cpu.1, "{} on {driver:?}", mesh.name);
            }
        }
    }
}
