//! Ray against boxes. The arithmetic is monotone: a box that encloses another one is entered no later and left no earlier, bit for
//! bit. Hence no box that holds a hit is ever missed or culled, and no tolerance is needed anywhere.

use super::ray::Prepared;
use super::rows::{LANES, Node, vector};
use crate::math::{max, min};

/// Where the ray enters and leaves a padded box, given its near and far planes, within `t_min` and `limit`. It is hit if the first is
/// not behind the second.
#[inline(always)]
pub(super) fn slab(near: [f32; 3], far: [f32; 3], ray: &Prepared, limit: f32) -> (f32, f32) {
    let enter_x = (near[0] - ray.near_origin[0]) * ray.inv_dir[0];
    let enter_y = (near[1] - ray.near_origin[1]) * ray.inv_dir[1];
    let enter_z = (near[2] - ray.near_origin[2]) * ray.inv_dir[2];
    let leave_x = (far[0] - ray.far_origin[0]) * ray.inv_dir[0];
    let leave_y = (far[1] - ray.far_origin[1]) * ray.inv_dir[1];
    let leave_z = (far[2] - ray.far_origin[2]) * ray.inv_dir[2];
    // t_min comes first, so that the result is never −0.
    (max(enter_z, max(enter_y, max(enter_x, ray.t_min))), min(leave_z, min(leave_y, min(leave_x, limit))))
}

/// [`slab`] of the child in `lane`.
#[inline(always)]
pub(super) fn child(node: &Node, lane: usize, ray: &Prepared, limit: f32) -> (f32, f32) {
    slab(vector(node, ray.near_at, lane), vector(node, ray.far_at, lane), ray, limit)
}

/// [`slab`] of all children: where they are entered, and which of them are hit.
#[inline(always)]
pub(super) fn children(node: &Node, ray: &Prepared, limit: f32) -> ([f32; LANES], [bool; LANES]) {
    let (mut enter, mut leave, mut hit) = ([0.0; LANES], [0.0; LANES], [false; LANES]);
    for lane in 0..LANES {
        (enter[lane], leave[lane]) = child(node, lane, ray, limit);
    }
    // A loop of its own: only then has SSE2 a short way to its mask.
    for lane in 0..LANES {
        hit[lane] = enter[lane] <= leave[lane];
    }
    (enter, hit)
}

/// Where the ray enters and leaves the padded box of a primitive, unlimited: for a hit's `t`, which must not lie outside.
///
/// Both products are formed and ordered by comparison, which gives the bits of [`slab`] without selecting planes by sign.
#[inline(always)]
pub(crate) fn own_box(low: [f32; 3], high: [f32; 3], ray: &Prepared) -> (f32, f32) {
    let (near_x, far_x) = side(low[0], high[0], ray, 0);
    let (near_y, far_y) = side(low[1], high[1], ray, 1);
    let (near_z, far_z) = side(low[2], high[2], ray, 2);
    (max(near_x, max(near_y, near_z)), min(far_x, min(far_y, far_z)))
}

#[inline(always)]
fn side(low: f32, high: f32, ray: &Prepared, axis: usize) -> (f32, f32) {
    let a = (low - max(ray.near_origin[axis], ray.far_origin[axis])) * ray.inv_dir[axis];
    let b = (high - min(ray.near_origin[axis], ray.far_origin[axis])) * ray.inv_dir[axis];
    (min(a, b), max(a, b))
}

/// One bit for each lane, as a list to take lanes from, the lowest first.
#[derive(Clone, Copy)]
pub(super) struct Lanes(u32);

impl Lanes {
    /// The lanes that are set. With AVX2 this is one `vmovmskps`: the seed's second bit is shifted out again, but without it LLVM 22
    /// leaves a dozen instructions behind, and `mask |= hit << lane` keeps its SLP vectoriser from using eight lanes at all.
    #[inline(always)]
    pub(super) fn of(hit: &[bool; LANES]) -> Self {
        let mut mask = (hit[LANES - 1] as u8) | ((hit[0] as u8) << 1);
        let mut lane = LANES - 1;
        while lane > 0 {
            lane -= 1;
            mask = (mask << 1) | hit[lane] as u8;
        }
        Self(mask as u32)
    }

    /// Whether no lane is left.
    #[inline(always)]
    pub(super) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The next lane, of which there must be one.
    #[inline(always)]
    pub(super) fn take(&mut self) -> usize {
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0.wrapping_sub(1);
        lane % LANES
    }
}
