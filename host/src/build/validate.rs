//! Whether rows are a structure that the traversal may walk through, judged from the rows alone.

use super::Bvh;
use super::boxes::Primitives;
use super::write::pack_rows;
use glam::Vec3A;
use obvhs::aabb::Aabb;
use parallax_shared::layout::{Ellipsoid, NONE, Row, Sphere, Triangle};
use parallax_shared::traversal::rows::{KIND, Kind, LANES, LEAF, LINKS, NODE_ROWS, ROW, STACK};

/// What is wrong with a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Defect {
    /// A link to nowhere, or of no kind.
    #[error("the link {0:#x} leads nowhere")]
    Link(u32),
    /// Two ways lead to a node, or one in a circle.
    #[error("row {0} is reached twice")]
    ReachedTwice(u32),
    /// A ray could miss what is inside.
    #[error("something at row {0} sticks out of its box")]
    Box(u32),
    /// A number that is not of the pack's kind.
    #[error("the pack at row {0} holds primitive {1}")]
    Number(u32, u32),
    /// A primitive that is in no pack, or in several.
    #[error("primitive {0} is in {1} packs")]
    Packs(u32, u32),
    /// A ray could lose what does not fit the stack.
    #[error("a ray may need {0} stack entries")]
    Stack(usize),
}

/// A link, the box that everything behind it must be in, and the stack entries that may be in use on the way to it.
type Visit = (u32, Aabb, usize);

impl Bvh {
    /// Checks that every primitive is in exactly one pack of its kind, that every box is in the one above it, that links lead to
    /// nodes and packs and to each once, and that the stack suffices.
    ///
    /// # Errors
    /// The first [`Defect`] that is found.
    pub fn validate(
        &self,
        triangles: &[Triangle],
        spheres: &[Sphere],
        ellipsoids: &[Ellipsoid],
    ) -> Result<(), Defect> {
        let primitives = Primitives { triangles, spheres, ellipsoids };
        let boxes: Vec<Aabb> = primitives.all_boxes().collect();
        let check = Check { rows: &self.rows, primitives, boxes };
        let mut packs = vec![0u32; check.boxes.len()];
        let mut reached = vec![false; self.rows.len()];
        let mut todo: Vec<Visit> = vec![(0, Aabb::LARGEST, 0)];
        while let Some((link, bounds, stack)) = todo.pop() {
            let row = link & ROW;
            if std::mem::replace(reached.get_mut(row as usize).ok_or(Defect::Link(link))?, true) {
                return Err(Defect::ReachedTwice(row));
            }
            if link & LEAF == 0 {
                check.node(link, bounds, stack, &mut todo)?;
            } else {
                check.pack(link, bounds, &mut packs)?;
            }
        }
        match packs.iter().position(|&times| times != 1) {
            Some(number) => Err(Defect::Packs(number as u32, packs[number])),
            None => Ok(()),
        }
    }
}

struct Check<'a> {
    rows: &'a [Row],
    primitives: Primitives<'a>,
    boxes: Vec<Aabb>,
}

impl Check<'_> {
    fn slice(&self, link: u32, rows: usize) -> Result<&[Row], Defect> {
        let row = (link & ROW) as usize;
        self.rows.get(row..row + rows).ok_or(Defect::Link(link))
    }

    fn node(&self, link: u32, bounds: Aabb, stack: usize, todo: &mut Vec<Visit>) -> Result<(), Defect> {
        let node = self.slice(link, NODE_ROWS)?;
        let at = |row: usize, lane: usize| f32::from_bits(node[row].0[lane]);
        let corner =
            |first: usize, lane: usize| Vec3A::from_array([0, 1, 2].map(|axis| at(first + axis, lane)));
        let lanes: Vec<_> = (0..LANES)
            .map(|lane| (node[LINKS].0[lane], Aabb { min: corner(0, lane), max: corner(3, lane) }))
            .filter(|(_, child)| child.min.cmple(child.max).all())
            .collect();
        // All children but one may wait, and that one too while they are sorted.
        let stack = stack + lanes.len().saturating_sub(1);
        if stack + 1 > STACK {
            return Err(Defect::Stack(stack + 1));
        }
        for (child, child_box) in lanes {
            if !encloses(&bounds, &child_box) {
                return Err(Defect::Box(link));
            }
            todo.push((child, child_box, stack));
        }
        Ok(())
    }

    fn pack(&self, link: u32, bounds: Aabb, packs: &mut [u32]) -> Result<(), Defect> {
        let kinds = [Kind::Triangles, Kind::Spheres, Kind::Ellipsoids];
        let kind = kinds.into_iter().find(|&kind| kind as u32 == link & KIND).ok_or(Defect::Link(link))?;
        let pack = self.slice(link, pack_rows(kind))?;
        for &number in pack.iter().last().iter().flat_map(|row| &row.0).filter(|&&number| number != NONE) {
            let known = self.boxes.get(number as usize).filter(|_| self.primitives.kind(number) == kind);
            let own = known.ok_or(Defect::Number(link & ROW, number))?;
            if !encloses(&bounds, own) {
                return Err(Defect::Box(link & ROW));
            }
            packs[number as usize] += 1;
        }
        Ok(())
    }
}

fn encloses(outer: &Aabb, inner: &Aabb) -> bool {
    outer.min.cmple(inner.min).all() && outer.max.cmpge(inner.max).all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{Quality, build};
    use bytemuck::Zeroable;

    fn triangles() -> Vec<Triangle> {
        let at = |i: usize| {
            let [x, y] = [(i % 20) as f32, (i / 20) as f32];
            Triangle { vertices: [[x, y, 0.0], [x + 1.0, y, 0.5], [x, y + 1.0, 0.25]], ..Zeroable::zeroed() }
        };
        (0..400).map(at).collect()
    }

    /// The defect that is found when `change` has been made to the rows.
    fn after(change: impl FnOnce(&mut Vec<Row>)) -> Option<Defect> {
        let triangles = triangles();
        let mut bvh = build(&triangles, &[], &[], Quality::Full).unwrap();
        change(&mut bvh.rows);
        bvh.validate(&triangles, &[], &[]).err()
    }

    #[test]
    fn what_the_builder_makes_is_valid() {
        let triangles = triangles();
        for quality in [Quality::Quick, Quality::Full] {
            for count in [0, 1, 7, 8, 9, 400] {
                let some = &triangles[..count];
                let bvh = build(some, &[], &[], quality).unwrap();
                assert_eq!(bvh.validate(some, &[], &[]), Ok(()), "{quality:?} {count}");
            }
        }
    }

    #[test]
    fn every_defect_is_found() {
        assert_eq!(after(|_| ()), None);
        assert!(matches!(after(|rows| rows[LINKS].0[0] = 1 << 28), Some(Defect::Link(_))));
        let of_no_kind = after(|rows| {
            rows.push(Row([NONE; LANES]));
            rows[LINKS].0[0] = LEAF | KIND | (rows.len() as u32 - 1);
        });
        assert!(matches!(of_no_kind, Some(Defect::Link(_))), "{of_no_kind:?}");
        assert!(matches!(after(|rows| rows[LINKS].0[0] = rows[LINKS].0[1]), Some(Defect::ReachedTwice(_))));
        assert!(matches!(after(|rows| rows[LINKS].0[0] = 0), Some(Defect::ReachedTwice(0))));
        assert!(matches!(after(|rows| rows[3].0[0] = rows[0].0[0]), Some(Defect::Box(_))));
        let last = |rows: &Vec<Row>| rows.len() - 1;
        assert!(matches!(
            after(|rows| {
                let at = last(rows);
                rows[at].0[0] = 400
            }),
            Some(Defect::Number(..))
        ));
        assert!(matches!(
            after(|rows| {
                let at = last(rows);
                rows[at].0[0] = NONE
            }),
            Some(Defect::Packs(_, 0))
        ));
        assert!(after(|rows| rows.truncate(rows.len() - 1)).is_some());
    }
}
