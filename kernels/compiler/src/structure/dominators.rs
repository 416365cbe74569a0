//! Dominators of a control flow graph.
//!
//! Cooper, Harvey and Kennedy, "A Simple, Fast Dominance Algorithm" (2001): immediate dominators by iteration
//! to a fixed point over the reverse postorder. Post-dominators are the dominators of the reversed graph.

/// Immediate dominators of the nodes `0..n` of a graph, as seen from its entry.
pub struct Dominators {
    /// Nodes that can be reached, each before those that it dominates.
    pub reverse_postorder: Vec<usize>,
    /// The immediate dominator; `None` for what cannot be reached. The entry's is itself.
    immediate: Vec<Option<usize>>,
    /// Distance from the entry in the tree of dominators.
    depth: Vec<u32>,
}

impl Dominators {
    /// The dominators of the graph with the edges `node -> successors[node]`.
    pub fn new(successors: &[Vec<usize>], entry: usize) -> Self {
        let reverse_postorder = reverse_postorder(successors, entry);
        let immediate = immediate_dominators(successors, &reverse_postorder);
        let mut depth = vec![0; successors.len()];
        for &node in reverse_postorder.iter().skip(1) {
            depth[node] = immediate[node].map_or(0, |parent| depth[parent] + 1);
        }
        Self { reverse_postorder, immediate, depth }
    }

    /// Whether the entry leads to `node`.
    pub fn reaches(&self, node: usize) -> bool {
        self.immediate[node].is_some()
    }

    /// The immediate dominator of `node`; `None` for the entry and for what cannot be reached.
    pub fn immediate(&self, node: usize) -> Option<usize> {
        self.immediate[node].filter(|&parent| parent != node)
    }

    /// Whether every way from the entry to `node` leads through `dominator`. A node dominates itself.
    pub fn dominates(&self, dominator: usize, mut node: usize) -> bool {
        if !self.reaches(dominator) || !self.reaches(node) {
            return false;
        }
        while self.depth[node] > self.depth[dominator] {
            match self.immediate[node] {
                Some(parent) => node = parent,
                None => return false,
            }
        }
        node == dominator
    }
}

/// Each node that can be reached, after all its predecessors but those over back edges.
fn reverse_postorder(successors: &[Vec<usize>], entry: usize) -> Vec<usize> {
    let mut seen = vec![false; successors.len()];
    let mut order = Vec::new();
    let mut open = vec![(entry, 0)];
    seen[entry] = true;
    while let Some((node, next)) = open.pop() {
        let Some(&successor) = successors[node].get(next) else {
            order.push(node);
            continue;
        };
        open.push((node, next + 1));
        if !std::mem::replace(&mut seen[successor], true) {
            open.push((successor, 0));
        }
    }
    order.reverse();
    order
}

fn immediate_dominators(successors: &[Vec<usize>], order: &[usize]) -> Vec<Option<usize>> {
    let mut position = vec![usize::MAX; successors.len()];
    let mut predecessors = vec![Vec::new(); successors.len()];
    for (place, &node) in order.iter().enumerate() {
        position[node] = place;
        successors[node].iter().for_each(|&successor| predecessors[successor].push(node));
    }
    let mut immediate = vec![None; successors.len()];
    immediate[order[0]] = Some(order[0]);
    let mut changed = true;
    while changed {
        changed = false;
        for &node in &order[1..] {
            let known = predecessors[node].iter().copied().filter(|&p| immediate[p].is_some());
            let new = known.reduce(|a, b| intersect(a, b, &immediate, &position));
            changed |= immediate[node] != new;
            immediate[node] = new;
        }
    }
    immediate
}

/// The deepest node that dominates both `a` and `b`.
fn intersect(mut a: usize, mut b: usize, immediate: &[Option<usize>], position: &[usize]) -> usize {
    while a != b {
        let later = if position[a] > position[b] { &mut a } else { &mut b };
        // The entry has the first position, so the later one has a dominator above it.
        *later = immediate[*later].unwrap_or(*later);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A diamond inside a loop, and a block that nothing reaches:
    /// 0 → 1, 1 → 2 | 3, 2 → 4, 3 → 4, 4 → 1 | 5; 6 → 5.
    fn diamond_in_loop() -> Vec<Vec<usize>> {
        vec![vec![1], vec![2, 3], vec![4], vec![4], vec![1, 5], vec![], vec![5]]
    }

    #[test]
    fn immediate_dominators_of_a_diamond_in_a_loop() {
        let dominators = Dominators::new(&diamond_in_loop(), 0);
        let immediate: Vec<_> = (0..7).map(|node| dominators.immediate(node)).collect();
        assert_eq!(immediate, [None, Some(0), Some(1), Some(1), Some(1), Some(4), None]);
        assert!(dominators.dominates(1, 5) && dominators.dominates(5, 5));
        assert!(!dominators.dominates(2, 4) && !dominators.dominates(5, 1));
        assert!(!dominators.reaches(6) && !dominators.dominates(6, 5));
    }

    /// Brute force: `a` dominates `b` if `b` cannot be reached once `a` is removed.
    #[test]
    fn agrees_with_removal_of_nodes_on_random_graphs() {
        let mut state = 1u32;
        let mut random = |bound: u32| {
            state = state.wrapping_mul(1664525).wrapping_add(1013904223);
            ((state >> 16) % bound) as usize
        };
        for _ in 0..200 {
            let graph: Vec<Vec<usize>> =
                (0..8).map(|_| (0..random(3)).map(|_| random(8)).collect()).collect();
            let dominators = Dominators::new(&graph, 0);
            for removed in 1..8 {
                let mut without = graph.clone();
                without.iter_mut().for_each(|successors| successors.retain(|&s| s != removed));
                let left = reverse_postorder(&without, 0);
                for node in (0..8).filter(|&node| dominators.reaches(node) && dominators.reaches(removed)) {
                    let expected = node == removed || !left.contains(&node);
                    assert_eq!(dominators.dominates(removed, node), expected, "{graph:?} {removed} {node}");
                }
            }
        }
    }
}
