//! The driver for CPUs: fixed-count loops over arrays that LLVM turns into vector code, masks of lanes, and few dependent steps from a
//! node to the next.

use super::ray::Prepared;
use super::rows::{self, LANES, LINKS, STACK, Triangles};
use super::rules::Rules;
use super::slab::{self, Lanes};
use super::walk::Entry;
use crate::geom::triangle::{self, Edges};
use crate::layout::{Hit, Row};
use kernel_api::{At, OpenStack};

/// Entry distance above the link: what children are sorted by, and not by the distance alone, so that equal distances have an order.
#[inline(always)]
fn key(enter: f32, link: u32) -> u64 {
    ((enter.to_bits() as u64) << 32) | link as u64
}

#[inline(always)]
fn entry(key: u64) -> Entry {
    Entry { link: key as u32, enter: (key >> 32) as u32 }
}

#[inline(always)]
fn in_order(a: u64, b: u64) -> (u64, u64) {
    if a < b { (a, b) } else { (b, a) }
}

/// The key of the next child. A function: a closure that is used several times may stay one, compiled without vector instructions.
#[inline(always)]
fn next(hit: &mut Lanes, enter: &[f32; LANES], links: &[u32; LANES]) -> u64 {
    let lane = hit.take();
    key(enter[lane], links[lane])
}

/// The child of the node at `link` to go to next; the others that are hit go onto the stack. `ANY`: in the order of lanes, else the nearest first.
#[inline(always)]
pub(super) fn visit<const ANY: bool>(
    rows: &[Row],
    link: u32,
    ray: &Prepared,
    limit: f32,
    stack: &mut OpenStack<Entry, STACK>,
) -> Option<u32> {
    let node = rows::node(rows, link);
    let (enter, hit) = slab::children(node, ray, limit);
    let links = node.window::<LANES>((LINKS * LANES) as u32);
    let mut hit = Lanes::of(&hit);
    if hit.is_empty() {
        return None;
    }
    let lane = hit.take();
    let first = links[lane];
    if hit.is_empty() {
        return Some(first);
    }
    if ANY {
        while !hit.is_empty() {
            stack.push(Entry { link: links[hit.take()], enter: 0 });
        }
        return Some(first);
    }
    let first = key(enter[lane], first);
    let second = next(&mut hit, &enter, links);
    let (near, far) = in_order(first, second);
    rows::prefetch(rows, far as u32);
    if hit.is_empty() {
        stack.push(entry(far));
        return Some(near as u32);
    }
    let third = next(&mut hit, &enter, links);
    let (middle, far) = in_order(far, third);
    rows::prefetch(rows, far as u32);
    let (near, middle) = in_order(near, middle);
    stack.push(entry(far));
    stack.push(entry(middle));
    if hit.is_empty() {
        return Some(near as u32);
    }
    // Four or more are rare: insertion into the stack, the farthest lowest.
    let base = stack.len() - 2;
    stack.push(entry(near));
    while !hit.is_empty() {
        let key = next(&mut hit, &enter, links);
        stack.insert(base, entry(key), |above, new| above.enter < new.enter);
    }
    stack.pop().map(|entry| entry.link)
}

/// Tests a pack of triangles; returns whether the best hit came closer.
#[inline(always)]
pub(super) fn triangles<R: Rules>(pack: &Triangles, ray: &Prepared, best: &mut Hit) -> bool {
    let (mut scaled_t, mut area, mut inside) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    let mut candidate = [false; LANES];
    for lane in 0..LANES {
        let edges = triangle::edges(pack, lane, ray);
        (scaled_t[lane], area[lane], inside[lane]) = (edges.scaled_t, edges.area, edges.inside);
    }
    // A loop of its own: in the loop above the mask would be packed and extracted byte by byte.
    for lane in 0..LANES {
        candidate[lane] = inside[lane] >= 0.0;
    }
    let mut candidates = Lanes::of(&candidate);
    let mut closer = false;
    while !candidates.is_empty() {
        let lane = candidates.take();
        let edges = Edges { scaled_t: scaled_t[lane], area: area[lane], inside: inside[lane] };
        closer |= triangle::accept::<R>(pack, lane, edges, ray, best);
    }
    closer
}
