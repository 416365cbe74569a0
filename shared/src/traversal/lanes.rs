//! The driver for devices: lane after lane, with no local array but the stack.

use super::ray::Prepared;
use super::rows::{LANES, LINKS, Node, STACK, Triangles};
use super::rules::Rules;
use super::slab;
use super::walk::Entry;
use crate::geom::triangle;
use crate::layout::{Hit, NONE};
use kernel_api::{At, OpenStack};

/// The child to go to next, the nearest of those that are hit; the others go onto the stack, in no order.
#[inline(always)]
pub(super) fn visit(
    node: &Node,
    ray: &Prepared,
    limit: f32,
    stack: &mut OpenStack<Entry, STACK>,
) -> Option<u32> {
    let mut nearest = Entry { link: NONE, enter: u32::MAX };
    for lane in 0..LANES {
        let (enter, leave) = slab::child(node, lane, ray, limit);
        if enter <= leave {
            let entry = Entry { link: node.at(LINKS * LANES + lane), enter: enter.to_bits() };
            let first = entry.enter < nearest.enter;
            let later = if first { nearest } else { entry };
            nearest = if first { entry } else { nearest };
            if later.link != NONE {
                stack.push(later);
            }
        }
    }
    (nearest.link != NONE).then_some(nearest.link)
}

/// Tests a pack of triangles; returns whether the best hit came closer.
#[inline(always)]
pub(super) fn triangles<R: Rules>(pack: &Triangles, ray: &Prepared, best: &mut Hit) -> bool {
    let mut closer = false;
    for lane in 0..LANES {
        let edges = triangle::edges(pack, lane, ray);
        if edges.inside >= 0.0 {
            closer |= triangle::accept::<R>(pack, lane, edges, ray, best);
        }
    }
    closer
}
