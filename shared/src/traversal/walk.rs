//! The way of a ray through the nodes, the nearest first, for both drivers.

use super::ray::Prepared;
use super::rows::{self, KIND, LEAF, STACK};
use super::rules::Rules;
use super::{arrays, lanes, round};
use crate::layout::{Hit, NONE, Ray, Row};
use kernel_api::Stack;

/// A link and the bits of the distance at which its box is entered. Distances are +0 or more, so their bits have their order.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    pub(super) link: u32,
    pub(super) enter: u32,
}

/// `ANY`: the first hit found, to be asked only whether there is one. `SCAN`: driven lane after lane instead of by arrays and masks.
/// The hits do not depend on `SCAN`.
#[inline(always)]
pub fn walk<R: Rules, const ANY: bool, const SCAN: bool>(rows: &[Row], given: &Ray, extent: f32) -> Hit {
    let ray = Prepared::new::<R>(given, extent);
    let mut best = Hit { t: given.t_max, prim_id: 0 };
    if !ray.is_proper() {
        return miss();
    }
    let mut memory = Stack::<Entry, STACK>::new();
    let stack = &mut memory.open();
    let mut limit = best.t;
    let mut link = 0;
    loop {
        if link & LEAF == 0 {
            let next = if SCAN {
                lanes::visit(rows::node(rows, link), &ray, limit, stack)
            } else {
                arrays::visit::<ANY>(rows, link, &ray, limit, stack)
            };
            if let Some(next) = next {
                link = next;
                continue;
            }
        } else {
            let closer = if link & KIND != 0 {
                let before = best;
                best = round::pack::<R>(rows, link, *given, extent, before);
                best.t != before.t || best.prim_id != before.prim_id
            } else if SCAN {
                lanes::triangles::<R>(rows::triangles(rows, link), &ray, &mut best)
            } else {
                arrays::triangles::<R>(rows::triangles(rows, link), &ray, &mut best)
            };
            if closer {
                if ANY {
                    return best;
                }
                limit = best.t;
            }
        }
        loop {
            let Some(entry) = stack.pop() else {
                return if best.t < given.t_max { best } else { miss() };
            };
            if ANY || entry.enter <= limit.to_bits() {
                link = entry.link;
                break;
            }
        }
    }
}

#[inline(always)]
fn miss() -> Hit {
    Hit { t: f32::INFINITY, prim_id: NONE }
}
