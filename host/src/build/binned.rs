//! A binary tree from the top down by the surface area heuristic over bins (Wald 2007), with two departures: primitives are counted
//! in blocks of eight, as packs hold them (packs get fuller by half), and a leaf holds primitives of one kind.

use obvhs::aabb::Aabb;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use parallax_shared::traversal::rows::{Kind, LANES};

const BINS: usize = 32;

/// Cost of a range of so many primitives, without its area.
fn blocks(count: usize) -> f32 {
    count.div_ceil(LANES) as f32
}

#[derive(Clone, Copy)]
struct Bin {
    bounds: Aabb,
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self { bounds: Aabb::INVALID, count: 0 };

    fn add(&mut self, bounds: &Aabb, count: usize) {
        self.bounds = self.bounds.union(bounds);
        self.count += count;
    }

    fn cost(&self) -> f32 {
        if self.count == 0 { 0.0 } else { self.bounds.half_area() * blocks(self.count) }
    }
}

/// The bins of one axis over the centres of boxes (doubled, which saves a rounding).
struct Binning {
    axis: usize,
    first: f32,
    scale: f32,
}

impl Binning {
    /// None when all centres agree in this axis.
    fn new(centres: &Aabb, axis: usize) -> Option<Self> {
        let scale = BINS as f32 * 0.9999 / (centres.max[axis] - centres.min[axis]);
        (scale > 0.0 && scale.is_finite()).then_some(Self { axis, first: centres.min[axis], scale })
    }

    fn bin(&self, bounds: &Aabb) -> usize {
        let offset = centre(bounds)[self.axis] - self.first;
        ((offset * self.scale) as usize).min(BINS - 1)
    }

    /// The cheapest split: its cost and the first bin on the right.
    fn best_split(&self, boxes: &[Aabb], range: &[u32]) -> Option<(f32, usize)> {
        let mut bins = [Bin::EMPTY; BINS];
        for &number in range {
            let bounds = &boxes[number as usize];
            bins[self.bin(bounds)].add(bounds, 1);
        }
        let mut right_cost = [0.0; BINS];
        let mut right = Bin::EMPTY;
        for at in (1..BINS).rev() {
            right.add(&bins[at].bounds, bins[at].count);
            right_cost[at] = right.cost();
        }
        let mut left = Bin::EMPTY;
        let mut best = None;
        for at in 1..BINS {
            left.add(&bins[at - 1].bounds, bins[at - 1].count);
            let cost = left.cost() + right_cost[at];
            let splits = left.count > 0 && left.count < range.len();
            if splits && best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, at));
            }
        }
        best
    }
}

fn centre(bounds: &Aabb) -> glam::Vec3A {
    bounds.min * 0.5 + bounds.max * 0.5
}

/// Builds the tree over `boxes`, of which there is at least one. Below `levels` levels ranges are halved instead.
pub fn build(boxes: &[Aabb], kind: impl Fn(u32) -> Kind, levels: usize) -> Bvh2 {
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let mut nodes = vec![Bvh2Node::default(); 2 * boxes.len() - 1];
    let mut used = 1;
    let mut todo = vec![(0, 0, boxes.len(), 0)];
    while let Some((node, start, end, level)) = todo.pop() {
        let range = &mut order[start..end];
        let mut bounds = Aabb::INVALID;
        for &number in &*range {
            bounds = bounds.union(&boxes[number as usize]);
        }
        let mixed = range.iter().any(|&number| kind(number) != kind(range[0]));
        if range.len() <= LANES && !mixed {
            nodes[node] = Bvh2Node::new(bounds, range.len() as u32, start as u32);
            continue;
        }
        let left = match range.len() {
            ..=LANES => by_kind(range, &kind),
            _ if level < levels => by_bins(boxes, range),
            _ => by_half(boxes, &bounds, range),
        };
        let middle = start + left;
        nodes[node] = Bvh2Node::new(bounds, 0, used as u32);
        todo.push((used + 1, middle, end, level + 1));
        todo.push((used, start, middle, level + 1));
        used += 2;
    }
    nodes.truncate(used);
    Bvh2 {
        nodes,
        primitive_indices: order,
        children_are_ordered_after_parents: true,
        max_depth: 192,
        ..Default::default()
    }
}

/// Moves the primitives of the first kind to the front; how many there are.
fn by_kind(range: &mut [u32], kind: &impl Fn(u32) -> Kind) -> usize {
    range.sort_by_key(|&number| kind(number));
    range.partition_point(|&number| kind(number) == kind(range[0]))
}

/// Halves along the longest side; how many are on the left.
fn by_half(boxes: &[Aabb], bounds: &Aabb, range: &mut [u32]) -> usize {
    let size = bounds.max - bounds.min;
    let axis = size.max_position();
    let at = |number: &u32| centre(&boxes[*number as usize])[axis];
    let middle = range.len() / 2;
    range.select_nth_unstable_by(middle, |a, b| at(a).total_cmp(&at(b)));
    middle
}

/// Splits where it is cheapest, or in the middle where all centres agree; how many are on the left.
fn by_bins(boxes: &[Aabb], range: &mut [u32]) -> usize {
    let mut centres = Aabb::INVALID;
    for &number in &*range {
        centres.extend(centre(&boxes[number as usize]));
    }
    let best = (0..3)
        .filter_map(|axis| {
            let binning = Binning::new(&centres, axis)?;
            let (cost, at) = binning.best_split(boxes, range)?;
            Some((cost, at, binning))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, at, binning)) = best else { return range.len() / 2 };
    let mut middle = 0;
    for i in 0..range.len() {
        if binning.bin(&boxes[range[i] as usize]) < at {
            range.swap(i, middle);
            middle += 1;
        }
    }
    middle
}
