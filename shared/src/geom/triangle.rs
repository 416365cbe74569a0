//! Ray against triangle: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2 (1), 2013, with three departures.
//!
//! * Edge functions that round to zero are decided exactly, by the errors of their two products (Dekker 1971), and where a ray really
//!   meets an edge or a vertex, by a symbolic shift of the ray. So every point of a closed mesh has one owner.
//! * `t` is clamped to the interval in which the ray is inside the triangle's own padded box, and a triangle whose own box is missed is
//!   not hit. So no structure over such boxes can lose a hit.
//! * z is scaled by 1/d_z while projecting, so that coordinates of 10¹⁵ do not overflow.

use crate::layout::Hit;
use crate::math::{div, max, min, product_error};
use crate::traversal::ray::{Prepared, XYZ_AT};
use crate::traversal::rows::{LANES, NUMBERS, Triangles, vector};
use crate::traversal::rules::{Rules, closer};
use crate::traversal::slab::own_box;
use kernel_api::{At, rare};

/// What the edge functions say of one triangle.
#[derive(Clone, Copy)]
pub struct Edges {
    /// Numerator of `t`.
    pub scaled_t: f32,
    /// Its denominator, twice the projected area.
    pub area: f32,
    /// Whether the ray goes through: > 0 yes, 0 perhaps (see [`accept`]), < 0 or NaN no.
    pub inside: f32,
}

/// A vertex as the ray sees it: offset in x and y, distance along the ray. A vertex that triangles share has one projection.
#[inline(always)]
fn project(vertex: [f32; 3], origin: [f32; 3], shear: [f32; 3]) -> [f32; 3] {
    let z = (vertex[2] - origin[2]) * shear[2];
    [(vertex[0] - origin[0]) - shear[0] * z, (vertex[1] - origin[1]) - shear[1] * z, z]
}

/// The vertices of the triangle in `lane`, their coordinates in the order of `axes_at`.
#[inline(always)]
fn vertices(pack: &Triangles, lane: usize, [x, y, z]: [usize; 3]) -> [[f32; 3]; 3] {
    const NEXT: usize = 3 * LANES;
    [
        vector(pack, [x, y, z], lane),
        vector(pack, [x + NEXT, y + NEXT, z + NEXT], lane),
        vector(pack, [x + 2 * NEXT, y + 2 * NEXT, z + 2 * NEXT], lane),
    ]
}

/// The edge functions of the triangle in `lane`.
#[inline(always)]
pub fn edges(pack: &Triangles, lane: usize, ray: &Prepared) -> Edges {
    let [a, b, c] = vertices(pack, lane, ray.axes_at);
    let [ax, ay, az] = project(a, ray.origin, ray.shear);
    let [bx, by, bz] = project(b, ray.origin, ray.shear);
    let [cx, cy, cz] = project(c, ray.origin, ray.shear);
    let u = cx * by - cy * bx;
    let v = ax * cy - ay * cx;
    let w = bx * ay - by * ax;
    let least = min(min(u, v), w);
    let most = max(max(u, v), w);
    Edges { scaled_t: u * az + v * bz + w * cz, area: u + v + w, inside: max(least, 0.0 - most) }
}

/// Whether the edge function `p.x·q.y − p.y·q.x` is positive, and whether it is negative: one of both unless `p = q`.
///
/// Rounding is monotone, so the rounded products decide where they differ; then their errors do; then a shift of the ray by (ε, ε²).
#[inline(always)]
fn edge_sign<R: Rules>(p: [f32; 3], q: [f32; 3]) -> (bool, bool) {
    let (a, b) = (p[0] * q[1], p[1] * q[0]);
    let sign = a - b;
    let sign = if sign != 0.0 { sign } else { product_error(p[0], q[1], a) - product_error(p[1], q[0], b) };
    if !R::SHIFT {
        return (sign >= 0.0, sign <= 0.0);
    }
    let sign = if sign != 0.0 { sign } else { p[1] - q[1] };
    let sign = if sign != 0.0 { sign } else { q[0] - p[0] };
    (sign > 0.0, sign < 0.0)
}

/// Whether the triangle owns a ray that meets its projection at an edge or vertex, or too close to it to tell in rounded arithmetic.
#[rare]
fn owns<R: Rules>(
    pack: &Triangles,
    lane: usize,
    axes_at: [usize; 3],
    origin: [f32; 3],
    shear: [f32; 3],
) -> bool {
    let [a, b, c] = vertices(pack, lane, axes_at);
    let (a, b, c) = (project(a, origin, shear), project(b, origin, shear), project(c, origin, shear));
    let (u, v, w) = (edge_sign::<R>(c, b), edge_sign::<R>(a, c), edge_sign::<R>(b, a));
    (u.0 & v.0 & w.0) | (u.1 & v.1 & w.1)
}

/// `t` when it is not between `near` and `far` (or NaN: the triangle's projection is a point): moved there, NaN if the box is missed.
#[rare]
fn outside(t: f32, near: f32, far: f32) -> f32 {
    if near <= far { min(max(t, near), far) } else { f32::NAN }
}

/// Makes the triangle in `lane`, whose edge functions do not rule it out, the best hit if it is one; returns whether it is.
#[inline(always)]
pub fn accept<R: Rules>(pack: &Triangles, lane: usize, edges: Edges, ray: &Prepared, best: &mut Hit) -> bool {
    let t = div(edges.scaled_t, edges.area);
    let prim_id = pack.at(NUMBERS * LANES + lane);
    let [a, b, c] = vertices(pack, lane, XYZ_AT);
    let low = [min(a[0], min(b[0], c[0])), min(a[1], min(b[1], c[1])), min(a[2], min(b[2], c[2]))];
    let high = [max(a[0], max(b[0], c[0])), max(a[1], max(b[1], c[1])), max(a[2], max(b[2], c[2]))];
    let (near, far) = own_box(low, high, ray);
    // A branch, not a selection: the best hit then waits for the division alone, and the box is checked meanwhile.
    let t = if (near <= t) & (t <= far) { t } else { outside(t, near, far) };
    if (t >= ray.t_min) & closer::<R>(t, prim_id, best) {
        if (edges.inside <= 0.0) && !owns::<R>(pack, lane, ray.axes_at, ray.origin, ray.shear) {
            return false;
        }
        *best = Hit { t, prim_id };
        return true;
    }
    false
}
