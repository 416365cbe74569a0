//! The structure that a ray walks through: one buffer of [`Row`]s of eight words, a word for each lane.
//!
//! * A node is [`NODE_ROWS`] rows: the smallest x, y, z and the largest x, y, z of each child's box, then the links to the children.
//! * A pack is up to eight primitives of one kind, a lane each. Its last row holds the primitives' numbers.
//! * A link is the row number of a node, or [`LEAF`], the [kind](Kind) and the row number of a pack.
//! * The root is the node at row 0. A lane without a child has the box `min = +∞, max = −∞`; a lane without a primitive has
//!   coordinates that are NaN, which no comparison accepts.

use crate::layout::Row;

/// Lanes of a row: children of a node, primitives of a pack.
pub const LANES: usize = 8;
/// Rows of a node.
pub const NODE_ROWS: usize = 7;
/// Which row of a node holds the links.
pub const LINKS: usize = 6;
/// Rows of a pack of triangles: three vertices (x, y, z each), numbers.
pub const TRIANGLE_ROWS: usize = 10;
/// Rows of a pack of spheres: centre, radius, numbers; one more keeps packs even.
pub const SPHERE_ROWS: usize = 6;
/// Rows of a pack of ellipsoids: centre, three rows of four words of `world_to_unit`, numbers.
pub const ELLIPSOID_ROWS: usize = 16;

/// The bit of a link to a pack.
pub const LEAF: u32 = 1 << 31;
/// The row number in a link to a pack.
pub const ROW: u32 = (1 << 29) - 1;
/// The kind in a link to a pack.
pub const KIND: u32 = 3 << 29;
/// Items of the traversal's stack. A node pushes all but one of the children that are hit; the builder works out the worst case and
/// refuses a structure that needs more.
pub const STACK: usize = 96;

/// What a pack holds, as it stands in a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u32)]
pub enum Kind {
    /// Triangles.
    Triangles = 0,
    /// Spheres.
    Spheres = 1 << 29,
    /// Ellipsoids.
    Ellipsoids = 2 << 29,
}

/// The number in `lane` of `row`.
#[inline(always)]
pub(crate) fn float(row: &Row, lane: usize) -> f32 {
    f32::from_bits(row.0[lane % LANES])
}
