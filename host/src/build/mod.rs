//! The acceleration structure: a wide BVH in the rows that `parallax_shared::traversal` walks through.
//!
//! A binary tree by binned SAH ([`binned`], or obvhs' PLOC for a quick one), improved by obvhs' reinsertion, collapsed to nodes of
//! eight children by dynamic programming ([`collapse`]), written as rows ([`mod@write`]); [`validate`](Bvh::validate) checks the rows
//! without knowing how they came about.

pub mod binned;
pub mod boxes;
pub mod collapse;
pub mod validate;
pub mod write;

use boxes::Primitives;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use parallax_shared::layout::{Ellipsoid, Row, Sphere, Triangle};

/// How much time a build may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// PLOC, not improved: for geometry that changes with each frame.
    Quick,
    /// Binned SAH, improved by reinsertion: for everything that is rendered more than once.
    #[default]
    Full,
}

/// Why nothing was built.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum BuildError {
    /// A coordinate of a primitive's box is NaN or infinite.
    #[error("primitive {0} has a coordinate that is not finite")]
    NotFinite(u32),
    /// More than rows or numbers can address.
    #[error("{0} primitives are too many for one structure")]
    TooMany(usize),
    /// The traversal's stack is bounded.
    #[error("the structure needs a stack of {needed} entries, the traversal has {available}")]
    TooDeep {
        /// What the worst ray needs.
        needed: usize,
        /// What `shared` has.
        available: usize,
    },
}

/// What a structure is like.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Stats {
    /// Nodes, of up to eight children.
    pub nodes: usize,
    /// Packs, of up to eight primitives.
    pub packs: usize,
    /// Share of the packs' lanes that hold a primitive.
    pub fill: f32,
    /// Nodes on the longest way down.
    pub depth: usize,
    /// Stack entries that the worst ray needs.
    pub stack: usize,
    /// Size of the rows.
    pub bytes: usize,
    /// Expected nodes and packs that a ray through the root's box visits (surface area heuristic, both at cost 1).
    pub sah_cost: f32,
}

/// A structure that is ready to be walked through or uploaded.
#[derive(Clone, Debug)]
pub struct Bvh {
    /// Nodes, then packs; never empty.
    pub rows: Vec<Row>,
    /// Largest absolute coordinate of any primitive's box: the traversal pads boxes by it.
    pub extent: f32,
    /// What it is like.
    pub stats: Stats,
}

/// Builds a structure over triangles, spheres and ellipsoids, numbered in this order. None of anything gives a structure that no ray
/// hits.
///
/// # Errors
/// See [`BuildError`]; degenerate primitives and boxes are none.
pub fn build(
    triangles: &[Triangle],
    spheres: &[Sphere],
    ellipsoids: &[Ellipsoid],
    quality: Quality,
) -> Result<Bvh, BuildError> {
    let primitives = Primitives { triangles, spheres, ellipsoids };
    let boxes = primitives.boxes()?;
    if boxes.is_empty() {
        return Ok(write::empty());
    }
    let tree = binary_tree(&primitives, &boxes, quality);
    let rows = |tree: &Bvh2| write::rows(&primitives, &boxes, &collapse::collapse(tree, &primitives));
    match rows(&tree) {
        // Boxes whose sizes fall off exponentially make a tree as deep as it has leaves; a balanced one never is.
        Err(BuildError::TooDeep { .. }) => rows(&binned::build(&boxes, |number| primitives.kind(number), 0)),
        result => result,
    }
}

/// The binary tree, whose leaves hold primitives of one kind.
fn binary_tree(primitives: &Primitives, boxes: &[obvhs::aabb::Aabb], quality: Quality) -> Bvh2 {
    match quality {
        Quality::Quick => {
            let numbers = (0..boxes.len() as u32).collect();
            PlocBuilder::new().build(PlocSearchDistance::VeryLow, boxes, numbers, SortPrecision::U64, 0)
        }
        Quality::Full => {
            let mut tree = binned::build(boxes, |number| primitives.kind(number), usize::MAX);
            ReinsertionOptimizer::default().run(&mut tree, 1.0, None);
            tree
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use parallax_shared::layout::Ray;
    use parallax_shared::traversal::{closest_hit, occluded};

    fn triangle(at: [f32; 3]) -> Triangle {
        let [x, y, z] = at;
        Triangle { vertices: [at, [x + 1.0, y, z], [x, y + 1.0, z]], ..Zeroable::zeroed() }
    }

    fn along_z(x: f32, y: f32) -> Ray {
        Ray { origin: [x, y, -5.0], t_min: 0.0, dir: [0.0, -0.0, 1.0], t_max: f32::INFINITY }
    }

    #[test]
    fn nothing_gives_a_structure_that_no_ray_hits() {
        let bvh = build(&[], &[], &[], Quality::Full).unwrap();
        assert_eq!(closest_hit(&bvh.rows, &along_z(0.0, 0.0), bvh.extent).prim_id, u32::MAX);
        assert!(!occluded(&bvh.rows, &along_z(0.0, 0.0), bvh.extent));
    }

    #[test]
    fn triangles_in_a_row_are_found_by_number() {
        for quality in [Quality::Quick, Quality::Full] {
            let triangles: Vec<_> = (0..1000).map(|i| triangle([2.0 * i as f32, 0.0, 0.0])).collect();
            let bvh = build(&triangles, &[], &[], quality).unwrap();
            for i in 0..1000 {
                let hit = closest_hit(&bvh.rows, &along_z(2.0 * i as f32 + 0.25, 0.25), bvh.extent);
                assert_eq!((hit.t, hit.prim_id), (5.0, i), "{quality:?}");
            }
        }
    }

    #[test]
    fn kinds_are_numbered_through_and_never_share_a_pack() {
        let triangles = [triangle([0.0; 3]), triangle([4.0, 0.0, 0.0])];
        let spheres = [Sphere { centre: [8.5, 0.5, 0.0], radius: 0.5, ..Zeroable::zeroed() }];
        let world_to_unit = [[2.0, 0.0, 0.0, 0.5], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 0.5, 2.0]];
        let ellipsoids = [Ellipsoid { centre: [12.5, 0.5, 0.0], material: 0, world_to_unit }];
        for quality in [Quality::Quick, Quality::Full] {
            let bvh = build(&triangles, &spheres, &ellipsoids, quality).unwrap();
            let hits = [0.25, 4.25, 8.5, 12.5].map(|x| closest_hit(&bvh.rows, &along_z(x, 0.5), bvh.extent));
            assert_eq!(hits.map(|hit| hit.prim_id), [0, 1, 2, 3]);
            assert_eq!(hits.map(|hit| hit.t), [5.0, 5.0, 4.5, 3.0]);
            assert!(bvh.stats.packs >= 3);
            assert!(occluded(&bvh.rows, &along_z(12.5, 0.5), bvh.extent));
        }
    }

    #[test]
    fn a_thousand_equal_boxes_end() {
        let triangles = vec![triangle([1.0, 2.0, 3.0]); 1000];
        let bvh = build(&triangles, &[], &[], Quality::Full).unwrap();
        assert_eq!(closest_hit(&bvh.rows, &along_z(1.25, 2.25), bvh.extent).prim_id, 0);
    }

    #[test]
    fn what_is_not_finite_is_refused_by_number() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let triangles = [triangle([0.0; 3]), triangle([0.0, bad, 0.0])];
            assert_eq!(build(&triangles, &[], &[], Quality::Full).unwrap_err(), BuildError::NotFinite(1));
        }
    }

    #[test]
    fn sizes_that_fall_off_exponentially_fit_the_stack() {
        let triangles: Vec<_> = (0..4000)
            .map(|i| {
                let s = 0.97f32.powi(i);
                Triangle { vertices: [[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]], ..Zeroable::zeroed() }
            })
            .collect();
        let bvh = build(&triangles, &[], &[], Quality::Full).unwrap();
        assert!(bvh.stats.stack <= parallax_shared::traversal::rows::STACK);
    }
}
