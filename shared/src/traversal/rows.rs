//! The structure that a ray walks through: one buffer of [`Row`]s of eight words, a word for each lane.
//!
//! * A node is [`NODE_ROWS`] rows: the smallest x, y, z and the largest x, y, z of each child's box, then the links to the children.
//! * A pack is up to eight primitives of one kind, a lane each. Its last row holds the primitives' numbers.
//! * A link is the row number of a node, or [`LEAF`], the [kind](Kind) and the row number of a pack.
//! * The root is the node at row 0. A lane without a child has the box `min = +∞, max = −∞`; a lane without a primitive has
//!   coordinates that are NaN, which no comparison accepts.

use crate::layout::Row;
use bytemuck::must_cast_ref;
use kernel_api::At;

/// Lanes of a row: children of a node, primitives of a pack.
pub const LANES: usize = 8;
/// Rows of a node.
pub const NODE_ROWS: usize = 7;
/// Which row of a node holds the links.
pub const LINKS: usize = 6;
/// Which row of a pack of triangles holds their numbers.
pub const NUMBERS: usize = 9;
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

/// A node, as words.
pub type Node = [u32; NODE_ROWS * LANES];
/// A pack of triangles, as words.
pub type Triangles = [u32; TRIANGLE_ROWS * LANES];

/// The node in row `link`.
#[inline(always)]
pub(crate) fn node(rows: &[Row], link: u32) -> &Node {
    must_cast_ref(rows.window::<NODE_ROWS>(link))
}

/// The pack of triangles behind `link`.
#[inline(always)]
pub(crate) fn triangles(rows: &[Row], link: u32) -> &Triangles {
    must_cast_ref(rows.window::<TRIANGLE_ROWS>(link & ROW))
}

/// Hints that what is behind `link`, which waits on the stack, will be wanted. The first line is enough: the processor fetches the
/// ones behind it by itself. Worth 2 to 3 % of a walk to the closest hit; any-hit walks, most of which end early, lose by it.
#[inline(always)]
pub(crate) fn prefetch(rows: &[Row], link: u32) {
    rows.prefetch::<1>(link & ROW);
}

/// The vector in `lane` of three rows of a node or pack, given by the words at which they start.
///
/// Written out: a closure in `map` may stay a call, compiled without vector instructions, which would throw all the ray's constants
/// out of their registers.
#[inline(always)]
pub(crate) fn vector(words: &[u32], starts: [usize; 3], lane: usize) -> [f32; 3] {
    [float(words, starts[0], lane), float(words, starts[1], lane), float(words, starts[2], lane)]
}

/// The number in `lane` of the row that starts at word `start`.
#[inline(always)]
fn float(words: &[u32], start: usize, lane: usize) -> f32 {
    f32::from_bits(words.window::<LANES>(start as u32)[lane % LANES])
}
