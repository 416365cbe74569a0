//! In which pack each primitive is.

use super::Bvh;
use super::write::pack_rows;
use parallax_shared::layout::NONE;
use parallax_shared::traversal::rows::{KIND, Kind, LEAF, LINKS, ROOT, ROW};

impl Bvh {
    /// The link to the pack of each primitive, by its number: where a walk may begin that expects to hit it.
    pub fn leaves(&self) -> Vec<u32> {
        let mut leaves = Vec::new();
        let mut todo = vec![ROOT];
        while let Some(node) = todo.pop() {
            for link in self.rows[node as usize + LINKS].0 {
                match link & LEAF {
                    0 => todo.push(link),
                    _ => enter(&mut leaves, self.numbers(link), link),
                }
            }
        }
        leaves
    }

    /// The numbers in a pack; none for the link of a lane without a child.
    fn numbers(&self, link: u32) -> &[u32] {
        let kind = match link & KIND {
            k if k == Kind::Spheres as u32 => Kind::Spheres,
            k if k == Kind::Ellipsoids as u32 => Kind::Ellipsoids,
            _ => Kind::Triangles,
        };
        let last = (link & ROW) as usize + pack_rows(kind) - 1;
        if link == LEAF { &[] } else { &self.rows[last].0 }
    }
}

/// Enters `link` for each of `numbers` that is one.
fn enter(leaves: &mut Vec<u32>, numbers: &[u32], link: u32) {
    for &number in numbers.iter().filter(|&&number| number != NONE) {
        let number = number as usize;
        if leaves.len() <= number {
            leaves.resize(number + 1, ROOT);
        }
        leaves[number] = link;
    }
}

#[cfg(test)]
mod tests {
    use crate::build::{Quality, build};
    use bytemuck::Zeroable;
    use parallax_shared::layout::{Ray, Sphere, Triangle};
    use parallax_shared::traversal::rows::LEAF;
    use parallax_shared::traversal::{closest_hit, closest_hit_from};

    #[test]
    fn every_primitive_has_its_pack_and_any_pack_is_a_beginning() {
        let triangle = |i: usize| {
            let [x, y] = [i as f32 * 2.0, 0.5];
            Triangle { vertices: [[x, y, 0.0], [x + 1.0, y, 0.0], [x, y + 1.0, 0.0]], ..Zeroable::zeroed() }
        };
        let triangles: Vec<_> = (0..40).map(triangle).collect();
        let sphere = Sphere { centre: [3.0, 1.0, 2.0], radius: 0.5, ..Zeroable::zeroed() };
        let bvh = build(&triangles, &[sphere; 9], &[], Quality::Full).unwrap();
        let leaves = bvh.leaves();
        assert_eq!(leaves.len(), 49);
        assert!(leaves.iter().all(|link| link & LEAF != 0));
        for i in 0..40 {
            let origin = [i as f32 * 2.0 + 0.25, 0.75, 5.0];
            let ray = Ray { origin, t_min: 0.0, dir: [0.0, 0.0, -1.0], t_max: f32::INFINITY };
            let hit = closest_hit(&bvh.rows, &ray, bvh.extent);
            assert_eq!(hit.prim_id, i);
            for start in [leaves[i as usize], leaves[(i as usize + 7) % 40], leaves[45], 0] {
                assert_eq!(closest_hit_from(&bvh.rows, &ray, bvh.extent, start), hit);
            }
        }
    }

    #[test]
    fn nothing_has_no_leaves() {
        assert!(build(&[], &[], &[], Quality::Full).unwrap().leaves().is_empty());
    }
}
