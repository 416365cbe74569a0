//! Whether a ray hits anything, with a guess of what that could be.

use super::ray::Prepared;
use super::rows::{self, KIND, LEAF, STACK};
use super::rules::Exact;
use super::walk::Entry;
use super::{arrays, lanes, round};
use crate::layout::{Hit, NONE, Ray, Row};
use kernel_api::Stack;
use kernel_api::device::ON_DEVICE;

/// The link of a pack of which the ray hits something; [`NONE`] exactly where [`super::occluded`] says no. `expected`, the link of any
/// pack or [`NONE`], is tried first: the right one saves the walk.
#[inline(always)]
pub fn occluder(rows: &[Row], given: &Ray, extent: f32, expected: u32) -> u32 {
    let ray = Prepared::new::<Exact>(given, extent);
    if !ray.is_proper() {
        return NONE;
    }
    let mut memory = Stack::<Entry, STACK>::new();
    let stack = &mut memory.open();
    let mut link = 0;
    if expected != NONE {
        stack.push(Entry { link, enter: 0 });
        link = expected;
    }
    loop {
        if link & LEAF != 0 {
            if is_hit(rows, link, &ray, given, extent) {
                return link;
            }
        } else {
            let next = if ON_DEVICE {
                lanes::visit(rows::node(rows, link), &ray, given.t_max, stack)
            } else {
                arrays::visit::<true>(rows, link, &ray, given.t_max, stack)
            };
            if let Some(next) = next {
                link = next;
                continue;
            }
        }
        let Some(entry) = stack.pop() else { return NONE };
        link = entry.link;
    }
}

/// Whether the ray hits anything in a pack.
#[inline(always)]
fn is_hit(rows: &[Row], link: u32, ray: &Prepared, given: &Ray, extent: f32) -> bool {
    let mut best = Hit { t: given.t_max, prim_id: 0 };
    if link & KIND != 0 {
        let after = round::pack::<Exact>(rows, link, *given, extent, best);
        after.t != best.t || after.prim_id != best.prim_id
    } else if ON_DEVICE {
        lanes::triangles::<Exact>(rows::triangles(rows, link), ray, &mut best)
    } else {
        arrays::triangles::<Exact>(rows::triangles(rows, link), ray, &mut best)
    }
}
