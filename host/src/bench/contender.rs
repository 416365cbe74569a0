//! Who takes part: our traversal and obvhs' two, each over its best structure.

use crate::backend::cpu::instruction_set::{InstructionSet, Task};
use crate::backend::cpu::memory::Storage;
use crate::bench::{BenchError, Case};
use crate::build::{Quality, build};
use obvhs::bvh2::Bvh2;
use obvhs::cwbvh::CwBvh;
use obvhs::ray::{Ray as ObvhsRay, RayHit};
use obvhs::triangle::Triangle as ObvhsTriangle;
use obvhs::{BvhBuildParams, bvh2, cwbvh};
use parallax_shared::layout::{Hit, NONE, Ray, Row, Triangle};
use parallax_shared::traversal::{closest_hit, occluded};
use std::time::Duration;

/// A structure with its traversal.
pub trait Contender {
    /// Its name, for reports.
    fn name(&self) -> String;
    /// What it was compiled for.
    fn instruction_set(&self) -> &'static str;
    /// Answers all `rays`; `any`: `prim_id` only tells whether there is a hit.
    fn trace(&self, rays: &[Ray], any: bool, hits: &mut [Hit]);
}

/// Our own, in the memory that the CPU backend would give it.
pub struct Parallax {
    rows: Storage,
    extent: f32,
}

impl Parallax {
    /// Builds the structure.
    ///
    /// # Errors
    /// Those of the builder, or when there is too little memory.
    pub fn new(case: &Case) -> Result<Self, BenchError> {
        let name = || case.name.clone();
        let bvh = build(&case.triangles, &[], &[], Quality::Full)
            .map_err(|error| BenchError::Build { case: name(), error })?;
        let rows = Storage::holding(bytemuck::cast_slice(&bvh.rows));
        let rows = rows.ok_or_else(|| BenchError::OutOfMemory(name()))?;
        Ok(Self { rows, extent: bvh.extent })
    }
}

impl Contender for Parallax {
    fn name(&self) -> String {
        "parallax".into()
    }

    fn instruction_set(&self) -> &'static str {
        InstructionSet::best().name()
    }

    fn trace(&self, rays: &[Ray], any: bool, hits: &mut [Hit]) {
        let rows = bytemuck::cast_slice(self.rows.bytes());
        InstructionSet::best().run(Trace { rows, extent: self.extent, rays, any, hits });
    }
}

struct Trace<'a> {
    rows: &'a [Row],
    extent: f32,
    rays: &'a [Ray],
    any: bool,
    hits: &'a mut [Hit],
}

impl Task for Trace<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { rows, extent, .. } = self;
        let pairs = self.rays.iter().zip(self.hits);
        // Loops, not `for_each`: its body stays a call, which is compiled for the baseline.
        if self.any {
            for (ray, hit) in pairs {
                *hit = either(occluded(rows, ray, extent));
            }
        } else {
            for (ray, hit) in pairs {
                *hit = closest_hit(rows, ray, extent);
            }
        }
    }
}

/// A hit of which nothing is known but that there is one, or none.
#[inline(always)]
pub(super) fn either(occluded: bool) -> Hit {
    if occluded { Hit { t: 0.0, prim_id: 0 } } else { Hit { t: f32::INFINITY, prim_id: NONE } }
}

fn obvhs_triangles(triangles: &[Triangle]) -> Vec<ObvhsTriangle> {
    let convert = |triangle: &Triangle| {
        let [v0, v1, v2] = triangle.vertices.map(Into::into);
        ObvhsTriangle { v0, v1, v2 }
    };
    triangles.iter().map(convert).collect()
}

/// obvhs over one of its structures, the triangles in the structure's order, intersected as its documentation does.
macro_rules! obvhs {
    ($(#[$doc:meta])* $type:ident, $bvh:ty, $name:literal, $build:path) => {
        $(#[$doc])*
        pub struct $type {
            bvh: $bvh,
            triangles: Vec<ObvhsTriangle>,
        }

        impl $type {
            /// Builds it at its best quality.
            pub fn new(triangles: &[Triangle]) -> Self {
                let triangles = obvhs_triangles(triangles);
                let bvh = $build(&triangles, BvhBuildParams::very_slow_build(), &mut Duration::default());
                let triangles = bvh.primitive_indices.iter().map(|&i| triangles[i as usize]).collect();
                Self { bvh, triangles }
            }
        }

        impl Contender for $type {
            fn name(&self) -> String {
                $name.into()
            }

            fn instruction_set(&self) -> &'static str {
                InstructionSet::BASELINE.name()
            }

            fn trace(&self, rays: &[Ray], any: bool, hits: &mut [Hit]) {
                for (ray, hit) in rays.iter().zip(hits) {
                    let ray = ObvhsRay::new(ray.origin.into(), ray.dir.into(), ray.t_min, ray.t_max);
                    let test = |ray: &ObvhsRay, i: usize| self.triangles[i].intersect(ray);
                    if any {
                        *hit = either(!self.bvh.ray_traverse_miss(ray, test));
                        continue;
                    }
                    let mut found = RayHit::none();
                    self.bvh.ray_traverse(ray, &mut found, test);
                    *hit = match self.bvh.primitive_indices.get(found.primitive_id as usize) {
                        Some(&prim_id) => Hit { t: found.t, prim_id },
                        None => either(false),
                    };
                }
            }
        }
    };
}

obvhs! {
    /// Compressed wide BVH.
    ObvhsCwbvh, CwBvh, "obvhs CWBVH", cwbvh::builder::build_cwbvh_from_tris
}
obvhs! {
    /// Binary BVH.
    ObvhsBvh2, Bvh2, "obvhs BVH2", bvh2::builder::build_bvh2_from_tris
}
