//! A proof that serves many rays: nothing lies between any point of a box and a light.
//!
//! The rays from the points of a box to one point fill a shaft, the convex hull of both. At `t` of the way its section is the box, shrunk
//! by `1 − t` and moved: a box again. So the shaft meets a box exactly if some `t` in [0, 1] satisfies six linear inequalities, and the
//! test is that of a ray whose near and far planes have an origin and a direction each. (Haines and Wallace, "Shaft Culling for Efficient
//! Ray-Traced Radiosity", 1991, have planes through the edges of both boxes instead.)
//!
//! The proof is about the rays as [`super::occluded`] traces them, rounding and all: a primitive whose own padded box a ray misses is no
//! hit, so it is boxes alone that the shaft must not miss.

use super::ray::{LARGEST_INVERSE, XYZ_AT, clamped_inverse};
use super::rows::{self, KIND, LANES, LEAF, LINKS, NUMBERS, Node, STACK, Triangles, vector};
use super::rules::Rules;
use super::slab::Lanes;
use crate::layout::{NONE, Row};
use crate::math::{max, min, vector as vectors};
use glam::Vec3;
use kernel_api::device::ON_DEVICE;
use kernel_api::{At, OpenStack, Stack};

/// Distances below it might be rounded to zero when they are multiplied.
const SHORTEST: f32 = 1e-12;

/// Farther away, a target makes distances along a ray, which are counted from the box to it, too small to be multiplied.
const FARTHEST: f32 = 1e8;

/// How much longer than the others a direction's largest component is, if it is so whatever the rounding.
const CLEARLY: f32 = 1.001;

/// The rays from the points of a box to one point, the target, at `t` = 1.
#[derive(Clone, Copy)]
pub struct Shaft {
    /// From where near planes are met first, padded: the rays that lead.
    near_origin: [f32; 3],
    /// From where far planes are met last, padded: the rays that lag.
    far_origin: [f32; 3],
    near_inverse: [f32; 3],
    far_inverse: [f32; 3],
    /// At which word of a node the near planes of each axis start.
    near_at: [usize; 3],
    /// Likewise for the far planes.
    far_at: [usize; 3],
    /// What ends before it, along one axis, all rays leave before `t` = 0, their own padding included.
    begun: [f32; 3],
    /// What of a triangle's own box ends before it is behind all rays along their longest axis; infinite along the others.
    begun_longest: [f32; 3],
}

impl Shaft {
    /// The shaft from the box between `low` and `high` (finite, `low` ≤ `high`) to `target`; `extent` is that of [`super::closest_hit`].
    ///
    /// Boxes are padded by twice what a ray pads them by ([`Rules::PADDING`], 16 half-ULPs of the sum of the largest coordinates): once for
    /// that padding, and once for the rounding of a ray's slab test and direction and of the test here, at most six half-ULPs each.
    #[inline(always)]
    pub fn new<R: Rules>(low: Vec3, high: Vec3, target: Vec3, extent: f32) -> Self {
        let largest = max(vectors::max_abs(low), vectors::max_abs(high));
        // Rounding is monotone: no ray's padding is more.
        let of_ray = (largest + extent) * R::PADDING;
        let padding = 2.0 * of_ray;
        let (low, high, target) = (low.to_array(), high.to_array(), target.to_array());
        let (mut near_origin, mut far_origin) = ([0.0; 3], [0.0; 3]);
        // Beside the target the shaft has no sides along an axis but those of the box, which a very short direction gives it.
        let (mut near_inverse, mut far_inverse) = ([LARGEST_INVERSE; 3], [LARGEST_INVERSE; 3]);
        let (mut near_at, mut far_at) = ([0; 3], [0; 3]);
        let mut begun = [f32::NEG_INFINITY; 3];
        for axis in 0..3 {
            let (first, last) = (low[axis] - padding, high[axis] + padding);
            let (to_low, to_high) = (target[axis] - low[axis], target[axis] - high[axis]);
            let (down, up) = (to_low < 0.0, to_high > 0.0);
            near_origin[axis] = if down { first } else { last };
            far_origin[axis] = if down { last } else { first };
            if down | up {
                near_inverse[axis] = clamped_inverse(if down { to_low } else { to_high });
                far_inverse[axis] = clamped_inverse(if down { to_high } else { to_low });
                begun[axis] =
                    if down { (high[axis] + of_ray) + SHORTEST } else { (low[axis] - of_ray) - SHORTEST };
            }
            near_at[axis] = LANES * axis + if down { 3 * LANES } else { 0 };
            far_at[axis] = LANES * axis + if down { 0 } else { 3 * LANES };
        }
        let begun_longest = begun_longest(low, high, target, of_ray * 0.015625);
        Self { near_origin, far_origin, near_inverse, far_inverse, near_at, far_at, begun, begun_longest }
    }

    /// Whether a box is met, given its near and far planes.
    #[inline(always)]
    fn meets(&self, near: [f32; 3], far: [f32; 3]) -> bool {
        let enter_x = (near[0] - self.near_origin[0]) * self.near_inverse[0];
        let enter_y = (near[1] - self.near_origin[1]) * self.near_inverse[1];
        let enter_z = (near[2] - self.near_origin[2]) * self.near_inverse[2];
        let leave_x = (far[0] - self.far_origin[0]) * self.far_inverse[0];
        let leave_y = (far[1] - self.far_origin[1]) * self.far_inverse[1];
        let leave_z = (far[2] - self.far_origin[2]) * self.far_inverse[2];
        let enter = max(enter_z, max(enter_y, max(enter_x, 0.0)));
        let leave = min(leave_z, min(leave_y, min(leave_x, 1.0)));
        (enter <= leave) & self.is_ahead(far, self.begun)
    }

    /// Whether far planes are nowhere behind `start`.
    #[inline(always)]
    fn is_ahead(&self, far: [f32; 3], start: [f32; 3]) -> bool {
        let x = (far[0] - start[0]) * self.far_inverse[0];
        let y = (far[1] - start[1]) * self.far_inverse[1];
        let z = (far[2] - start[2]) * self.far_inverse[2];
        (x >= 0.0) & (y >= 0.0) & (z >= 0.0)
    }

    /// Whether the box of the child in `lane` is met.
    #[inline(always)]
    fn meets_child(&self, node: &Node, lane: usize) -> bool {
        self.meets(vector(node, self.near_at, lane), vector(node, self.far_at, lane))
    }

    /// Whether the triangle in `lane` may be hit: its own box is met, and does not lie behind where all rays begin along their longest
    /// axis. Behind it the distances of the vertices along the ray are below zero, each by itself, and so is a sum of them with weights
    /// of one sign, however it is rounded: no padding is needed.
    #[inline(always)]
    fn meets_triangle(&self, pack: &Triangles, lane: usize) -> bool {
        const NEXT: usize = 3 * LANES;
        let [x, y, z] = XYZ_AT;
        let a = vector(pack, [x, y, z], lane);
        let b = vector(pack, [x + NEXT, y + NEXT, z + NEXT], lane);
        let c = vector(pack, [x + 2 * NEXT, y + 2 * NEXT, z + 2 * NEXT], lane);
        let (mut near, mut far) = ([0.0; 3], [0.0; 3]);
        for axis in 0..3 {
            let low = min(a[axis], min(b[axis], c[axis]));
            let high = max(a[axis], max(b[axis], c[axis]));
            let down = self.far_at[axis] < 3 * LANES;
            near[axis] = if down { high } else { low };
            far[axis] = if down { low } else { high };
        }
        let is_there = pack.at(NUMBERS * LANES + lane) != NONE;
        is_there & self.meets(near, far) & self.is_ahead(far, self.begun_longest)
    }

    /// Puts the children of `node` that are met onto the stack; returns whether it had room for them.
    #[inline(always)]
    fn visit(&self, node: &Node, stack: &mut OpenStack<u32, STACK>) -> bool {
        let mut fits = true;
        if ON_DEVICE {
            for lane in 0..LANES {
                if self.meets_child(node, lane) {
                    fits &= stack.push(node.at(LINKS * LANES + lane));
                }
            }
            return fits;
        }
        let mut met = [false; LANES];
        #[allow(clippy::needless_range_loop)] // The shape of the loops in `slab`.
        for lane in 0..LANES {
            met[lane] = self.meets_child(node, lane);
        }
        let mut met = Lanes::of(&met);
        while !met.is_empty() {
            fits &= stack.push(node.at(LINKS * LANES + met.take()));
        }
        fits
    }

    /// Whether anything in the pack behind `link` may be hit.
    #[inline(always)]
    fn meets_pack(&self, rows: &[Row], link: u32) -> bool {
        // A pack of spheres or ellipsoids is met where its box is.
        if link & KIND != 0 {
            return true;
        }
        let pack = rows::triangles(rows, link);
        let mut met = false;
        for lane in 0..LANES {
            met |= self.meets_triangle(pack, lane);
        }
        met
    }
}

/// Along the axis along which every ray from the box to `target` is the longest: where they have all begun, less `little`, so that no
/// product with the distance from there is rounded to zero. Along other axes, and if there is no such axis, what nothing lies behind.
#[inline(always)]
fn begun_longest(low: [f32; 3], high: [f32; 3], target: [f32; 3], little: f32) -> [f32; 3] {
    let (mut least, mut most, mut begun) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    for axis in 0..3 {
        let (to_low, to_high) = (target[axis] - low[axis], target[axis] - high[axis]);
        least[axis] = max(to_high, 0.0 - to_low);
        most[axis] = max(to_low, 0.0 - to_high) * CLEARLY;
    }
    for axis in 0..3 {
        let down = target[axis] < low[axis];
        let others = max(most[(axis + 1) % 3], most[(axis + 2) % 3]);
        begun[axis] = if (least[axis] > 0.0) & (least[axis] > others) & (most[axis] < FARTHEST) {
            if down { high[axis] + little } else { low[axis] - little }
        } else if down {
            f32::INFINITY
        } else {
            f32::NEG_INFINITY
        };
    }
    begun
}

/// Whether no ray of the shaft hits anything: if so, [`super::occluded`] says of each of them that it is not.
///
/// A ray of the shaft has its origin in the box, bit for bit, `t_min` +0 or more, `t_max` 1 or less and the direction from its origin to
/// the target, rounded.
#[inline(always)]
pub fn is_clear(rows: &[Row], shaft: &Shaft) -> bool {
    let mut memory = Stack::<u32, STACK>::new();
    let stack = &mut memory.open();
    let mut link = 0;
    loop {
        let goes_on = if link & LEAF == 0 {
            shaft.visit(rows::node(rows, link), stack)
        } else {
            !shaft.meets_pack(rows, link)
        };
        if !goes_on {
            return false;
        }
        let Some(next) = stack.pop() else { return true };
        link = next;
    }
}
