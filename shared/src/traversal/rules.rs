//! The rules that make a hit a function of ray and mesh, each of which can be taken away: a test that holds a rule shows that it
//! fails without it.

use crate::layout::Hit;

/// What [`Exact`] promises beyond the arithmetic. Everything but tests uses [`Exact`].
pub trait Rules {
    /// Boxes are padded by this times the sum of the largest absolute coordinate of the primitives and that of the ray's origin:
    /// at least the largest |vertex − origin|. It covers the rounding of a projected vertex, and is enough for origin ± padding to
    /// differ from the origin.
    const PADDING: f32 = 8.0 * f32::EPSILON;
    /// Of two hits at the same `t` the smaller primitive number wins.
    const SMALLER_ID: bool = true;
    /// A ray that meets an edge or a vertex is shifted by (ε, ε²), so that every point has one owner.
    const SHIFT: bool = true;
}

/// All the rules.
pub struct Exact;

impl Rules for Exact {}

/// Whether a hit at `t` wins over the best one so far.
#[inline(always)]
pub(crate) fn closer<R: Rules>(t: f32, prim_id: u32, best: &Hit) -> bool {
    (t < best.t) | ((t == best.t) & (prim_id < best.prim_id) & R::SMALLER_ID)
}
