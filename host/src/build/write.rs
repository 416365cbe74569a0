//! Writes the rows: nodes depth first, packs behind them in the same order.

use super::boxes::{Primitives, extent};
use super::collapse::{Collapsed, Wide};
use super::{BuildError, Bvh, Stats};
use obvhs::aabb::Aabb;
use parallax_shared::layout::{NONE, Row};
use parallax_shared::traversal::rows::{
    ELLIPSOID_ROWS, Kind, LANES, LEAF, LINKS, NODE_ROWS, ROW, SPHERE_ROWS, STACK, TRIANGLE_ROWS,
};

/// Rows of a pack.
pub fn pack_rows(kind: Kind) -> usize {
    match kind {
        Kind::Triangles => TRIANGLE_ROWS,
        Kind::Spheres => SPHERE_ROWS,
        Kind::Ellipsoids => ELLIPSOID_ROWS,
    }
}

/// A structure without primitives: one node without children.
pub fn empty() -> Bvh {
    let rows = node_rows(&[]).to_vec();
    let bytes = size_of_val(rows.as_slice());
    let stats = Stats { nodes: 1, depth: 1, bytes, sah_cost: 1.0, ..Stats::default() };
    Bvh { rows, extent: 0.0, stats }
}

/// Writes a collapsed tree.
///
/// # Errors
/// If it needs too deep a stack or too many rows.
pub fn rows(primitives: &Primitives, boxes: &[Aabb], tree: &Collapsed) -> Result<Bvh, BuildError> {
    let (links, total) = place(tree);
    if total > ROW as usize {
        return Err(BuildError::TooMany(primitives.len()));
    }
    let mut rows = Vec::with_capacity(total);
    for node in &tree.nodes {
        if let Wide::Node(children) = node {
            let children: Vec<_> = children.iter().map(|&(bounds, child)| (bounds, links[child])).collect();
            rows.extend_from_slice(&node_rows(&children));
        }
    }
    rows.resize(rows.len().next_multiple_of(2), Row([0; LANES]));
    for node in &tree.nodes {
        if let Wide::Pack(kind, numbers) = node {
            write_pack(&mut rows, primitives, *kind, numbers);
        }
    }
    let stats = stats(tree, primitives.len(), size_of_val(rows.as_slice()));
    if stats.stack > STACK {
        return Err(BuildError::TooDeep { needed: stats.stack, available: STACK });
    }
    Ok(Bvh { rows, extent: extent(boxes), stats })
}

/// The link to each node and pack, and the number of rows.
fn place(tree: &Collapsed) -> (Vec<u32>, usize) {
    let nodes = tree.nodes.iter().filter(|node| matches!(node, Wide::Node(_))).count();
    let mut node_at = 0;
    let mut pack_at = (nodes * NODE_ROWS).next_multiple_of(2);
    let mut links = Vec::with_capacity(tree.nodes.len());
    for node in &tree.nodes {
        match node {
            Wide::Node(_) => {
                links.push(node_at as u32);
                node_at += NODE_ROWS;
            }
            Wide::Pack(kind, _) => {
                links.push(LEAF | *kind as u32 | pack_at as u32);
                pack_at += pack_rows(*kind);
            }
        }
    }
    (links, pack_at)
}

fn node_rows(children: &[(Aabb, u32)]) -> [Row; NODE_ROWS] {
    let (none, below) = (Row([f32::INFINITY.to_bits(); LANES]), Row([f32::NEG_INFINITY.to_bits(); LANES]));
    let mut rows = [none, none, none, below, below, below, Row([LEAF; LANES])];
    for (lane, (bounds, link)) in children.iter().enumerate() {
        for axis in 0..3 {
            rows[axis].0[lane] = bounds.min[axis].to_bits();
            rows[axis + 3].0[lane] = bounds.max[axis].to_bits();
        }
        rows[LINKS].0[lane] = *link;
    }
    rows
}

/// Appends a pack: coordinates of `numbers`, NaN in the lanes that stay empty, and the numbers in the last row.
fn write_pack(rows: &mut Vec<Row>, primitives: &Primitives, kind: Kind, numbers: &[u32]) {
    let first = rows.len();
    let last = first + pack_rows(kind) - 1;
    rows.resize(last, Row([f32::NAN.to_bits(); LANES]));
    rows.push(Row([NONE; LANES]));
    for (lane, &number) in numbers.iter().enumerate() {
        let mut put = |row: usize, value: f32| rows[first + row].0[lane] = value.to_bits();
        coordinates(primitives, kind, number).enumerate().for_each(|(row, value)| put(row, value));
        rows[last].0[lane] = number;
    }
}

/// What stands in a primitive's lane, from the first row on.
fn coordinates(primitives: &Primitives, kind: Kind, number: u32) -> impl Iterator<Item = f32> {
    let mut values = [0.0; ELLIPSOID_ROWS];
    let number = number as usize;
    let spheres_from = primitives.triangles.len();
    let count = match kind {
        Kind::Triangles => {
            values[..9].copy_from_slice(primitives.triangles[number].vertices.as_flattened());
            9
        }
        Kind::Spheres => {
            let sphere = &primitives.spheres[number - spheres_from];
            values[..3].copy_from_slice(&sphere.centre);
            values[3] = sphere.radius;
            4
        }
        Kind::Ellipsoids => {
            let ellipsoid = &primitives.ellipsoids[number - spheres_from - primitives.spheres.len()];
            values[..3].copy_from_slice(&ellipsoid.centre);
            values[3..15].copy_from_slice(ellipsoid.world_to_unit.as_flattened());
            15
        }
    };
    values.into_iter().take(count)
}

/// Counts; a node leaves all but one of its children on the stack.
fn stats(tree: &Collapsed, primitives: usize, bytes: usize) -> Stats {
    let mut stats = Stats { bytes, sah_cost: tree.sah_cost, ..Stats::default() };
    let mut above = vec![(0, 0); tree.nodes.len()];
    for (index, node) in tree.nodes.iter().enumerate() {
        let Wide::Node(children) = node else {
            stats.packs += 1;
            continue;
        };
        let (depth, stack) = (above[index].0 + 1, above[index].1 + children.len() - 1);
        for &(_, child) in children {
            above[child] = (depth, stack);
        }
        stats.nodes += 1;
        stats.depth = stats.depth.max(depth);
        // One more while four or more children are being sorted.
        stats.stack = stats.stack.max(stack + 1);
    }
    stats.fill = primitives as f32 / (stats.packs * LANES) as f32;
    stats
}
