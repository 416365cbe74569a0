//! From a binary tree to nodes of eight children: the cut that is optimal by the surface area heuristic (Ylitie, Karras and Laine
//! 2017, equations 3 to 5), with cost 1 for a node and for a pack, and a pack's primitives of one kind.

use super::boxes::Primitives;
use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use parallax_shared::traversal::rows::{Kind, LANES};

/// A wide node or a pack.
pub enum Wide {
    /// Children: each its box and its index among the [`Collapsed::nodes`].
    Node(Vec<(Aabb, usize)>),
    /// The numbers of up to eight primitives of one kind, ascending.
    Pack(Kind, Vec<u32>),
}

/// The wide tree: the root is the first, parents come before children.
pub struct Collapsed {
    /// Nodes depth first, the largest child first, each followed by its packs.
    pub nodes: Vec<Wide>,
    /// The programme's optimum over the area of the root's box.
    pub sah_cost: f32,
}

/// What is best for "this subtree as at most k roots".
#[derive(Clone, Copy, PartialEq)]
enum Cut {
    /// One root that is a pack.
    Pack,
    /// So many roots in the left subtree, the others in the right.
    Split(usize),
    /// As with one root fewer.
    Fewer,
}

/// The programme's table of one binary node; index k − 1 is for at most k roots.
#[derive(Clone, Copy)]
struct Choice {
    cost: [f32; LANES],
    cut: [Cut; LANES],
    count: usize,
    /// None when kinds are mixed.
    kind: Option<Kind>,
}

/// Collapses `tree`, which is not empty.
pub fn collapse(tree: &Bvh2, primitives: &Primitives) -> Collapsed {
    let choices = choose(tree, primitives);
    let root_area = tree.nodes[0].aabb().half_area();
    let cost = choices[0].cost[0];
    let sah_cost = if root_area > 0.0 { cost / root_area } else { 1.0 };
    Collapsed { nodes: Cutter { tree, choices: &choices }.nodes(), sah_cost }
}

fn children(node: &Bvh2Node) -> Option<[usize; 2]> {
    (node.prim_count == 0).then_some([node.first_index as usize, node.first_index as usize + 1])
}

/// Fills the table from the leaves up.
fn choose(tree: &Bvh2, primitives: &Primitives) -> Vec<Choice> {
    let empty = Choice { cost: [0.0; LANES], cut: [Cut::Pack; LANES], count: 0, kind: None };
    let mut choices = vec![empty; tree.nodes.len()];
    let mut order = vec![0];
    let mut at = 0;
    while at < order.len() {
        order.extend(children(&tree.nodes[order[at]]).into_iter().flatten());
        at += 1;
    }
    for &index in order.iter().rev() {
        let node = &tree.nodes[index];
        let area = node.aabb().half_area();
        choices[index] = match children(node) {
            None => leaf(tree, node, area, primitives),
            Some([left, right]) => inner(area, &choices[left], &choices[right]),
        };
    }
    choices
}

fn leaf(tree: &Bvh2, node: &Bvh2Node, area: f32, primitives: &Primitives) -> Choice {
    let kind = primitives.kind(tree.primitive_indices[node.first_index as usize]);
    let count = node.prim_count as usize;
    Choice { cost: [area; LANES], cut: [Cut::Pack; LANES], count, kind: Some(kind) }
}

/// The cheapest way to have exactly `roots` roots in two subtrees.
fn split(roots: usize, left: &Choice, right: &Choice) -> (f32, Cut) {
    let ways = (1..roots).map(|a| (left.cost[a - 1] + right.cost[roots - a - 1], Cut::Split(a)));
    ways.fold((f32::INFINITY, Cut::Split(1)), |best, way| if way.0 < best.0 { way } else { best })
}

fn inner(area: f32, left: &Choice, right: &Choice) -> Choice {
    let count = left.count + right.count;
    let kind = left.kind.filter(|_| left.kind == right.kind);
    let mut choice = Choice { cost: [0.0; LANES], cut: [Cut::Fewer; LANES], count, kind };
    let node = split(LANES, left, right);
    let packs = count <= LANES && kind.is_some();
    (choice.cost[0], choice.cut[0]) =
        if packs && area <= node.0 + area { (area, Cut::Pack) } else { (node.0 + area, node.1) };
    for roots in 2..=LANES {
        let way = split(roots, left, right);
        let fewer = (choice.cost[roots - 2], Cut::Fewer);
        (choice.cost[roots - 1], choice.cut[roots - 1]) = if way.0 < fewer.0 { way } else { fewer };
    }
    choice
}

/// Reads the optimum out of the table.
struct Cutter<'a> {
    tree: &'a Bvh2,
    choices: &'a [Choice],
}

impl Cutter<'_> {
    fn nodes(&self) -> Vec<Wide> {
        let mut nodes: Vec<Wide> = Vec::new();
        let mut todo = vec![(0, None)];
        while let Some((binary, parent)) = todo.pop() {
            let me = nodes.len();
            self.link(&mut nodes, parent, me);
            let roots = self.roots_below(binary);
            nodes.push(Wide::Node(roots.iter().map(|&root| (*self.tree.nodes[root].aabb(), 0)).collect()));
            for (lane, &root) in roots.iter().enumerate() {
                if self.choices[root].cut[0] == Cut::Pack {
                    let pack = nodes.len();
                    self.link(&mut nodes, Some((me, lane)), pack);
                    nodes.push(self.pack(root));
                }
            }
            let inner = |&(_, &root): &(usize, &usize)| self.choices[root].cut[0] != Cut::Pack;
            todo.extend(
                roots.iter().enumerate().filter(inner).rev().map(|(lane, &root)| (root, Some((me, lane)))),
            );
        }
        nodes
    }

    /// Enters `child` in a lane of its parent.
    fn link(&self, nodes: &mut [Wide], parent: Option<(usize, usize)>, child: usize) {
        if let Some((parent, lane)) = parent
            && let Wide::Node(children) = &mut nodes[parent]
        {
            children[lane].1 = child;
        }
    }

    /// The children of the wide node at `binary`, the largest first. A tree that is one pack gets a node above it.
    fn roots_below(&self, binary: usize) -> Vec<usize> {
        let mut roots = Vec::with_capacity(LANES);
        match (self.choices[binary].cut[0], children(&self.tree.nodes[binary])) {
            (Cut::Split(a), Some([left, right])) => {
                self.roots(left, a, &mut roots);
                self.roots(right, LANES - a, &mut roots);
            }
            _ => roots.push(binary),
        }
        let area = |&root: &usize| self.tree.nodes[root].aabb().half_area();
        roots.sort_by(|a, b| area(b).total_cmp(&area(a)));
        roots
    }

    /// The roots of `binary` as at most `count`. Recursion no deeper than the eight roots that it shares out.
    fn roots(&self, binary: usize, mut count: usize, roots: &mut Vec<usize>) {
        while count > 1 && self.choices[binary].cut[count - 1] == Cut::Fewer {
            count -= 1;
        }
        match (self.choices[binary].cut[count - 1], children(&self.tree.nodes[binary])) {
            (Cut::Split(a), Some([left, right])) if count > 1 => {
                self.roots(left, a, roots);
                self.roots(right, count - a, roots);
            }
            _ => roots.push(binary),
        }
    }

    fn pack(&self, root: usize) -> Wide {
        let mut numbers = Vec::with_capacity(LANES);
        let mut todo = vec![root];
        while let Some(index) = todo.pop() {
            let node = &self.tree.nodes[index];
            match children(node) {
                Some(both) => todo.extend(both),
                None => {
                    let first = node.first_index as usize;
                    let end = first + node.prim_count as usize;
                    numbers.extend_from_slice(&self.tree.primitive_indices[first..end]);
                }
            }
        }
        numbers.sort_unstable();
        // A pack has one kind: that of any of its leaves.
        Wide::Pack(self.choices[root].kind.unwrap_or(Kind::Triangles), numbers)
    }
}
