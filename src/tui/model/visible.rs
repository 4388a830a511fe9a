//! Which nodes there are to be seen: all of them, those that have begun (while the tree grows), or those that a filter keeps.
//!
//! Whatever keeps a node keeps those around it. So the next and the previous node to be seen are found by a search in a
//! sorted list, and none is looked at in vain.

use crate::log::Tree;

/// The nodes to be seen.
#[derive(Clone, Debug)]
pub struct Visible {
    /// The first node that hasn't begun yet.
    end: usize,
    /// The only nodes that a filter keeps, in order.
    kept: Option<Vec<u32>>,
    /// The current node and those around it, in order, which are seen in spite of a filter.
    current: Vec<u32>,
}

impl Default for Visible {
    fn default() -> Self {
        Visible { end: usize::MAX, kept: None, current: vec![0] }
    }
}

impl Visible {
    /// Shows only the nodes before this one; the root is always shown.
    pub fn end_before(&mut self, node: usize) {
        self.end = node.max(1);
    }

    /// The first node that hasn't begun yet; all have begun unless the tree grows.
    pub fn end(&self) -> usize {
        self.end
    }

    /// Shows only nodes among these and those around them; `None` shows all.
    pub fn keep(&mut self, tree: &Tree, nodes: Option<impl IntoIterator<Item = usize>>) {
        self.kept = nodes.map(|nodes| {
            let mut is_kept = vec![false; tree.nodes().len()];
            for mut node in nodes {
                while !std::mem::replace(&mut is_kept[node], true) {
                    node = tree.nodes()[node].parent;
                }
            }
            is_kept[0] = true;
            (0..).zip(is_kept).filter_map(|(node, is_kept)| is_kept.then_some(node)).collect()
        });
    }

    /// Shows a node in spite of a filter, until the next one.
    pub fn show(&mut self, tree: &Tree, node: usize) {
        self.current = tree.around(node).map(|node| node as u32).collect();
        self.current.reverse();
    }

    /// Whether a node is to be seen.
    pub fn is(&self, node: usize) -> bool {
        self.first_from(node) == Some(node)
    }

    /// The first node to be seen that isn't before this one. It may lie beyond the end of the tree.
    pub fn first_from(&self, node: usize) -> Option<usize> {
        let first = |sorted: &[u32]| sorted.get(sorted.partition_point(|known| (*known as usize) < node)).copied();
        let found = match &self.kept {
            None => Some(node),
            Some(kept) => first(kept).into_iter().chain(first(&self.current)).min().map(|node| node as usize),
        };
        found.filter(|found| *found < self.end)
    }

    /// The last node to be seen that isn't after this one.
    pub fn last_to(&self, node: usize) -> usize {
        let node = node.min(self.end - 1);
        let last = |sorted: &[u32]| {
            let after = sorted.partition_point(|known| (*known as usize) <= node);
            after.checked_sub(1).map_or(0, |last| sorted[last] as usize)
        };
        self.kept.as_ref().map_or(node, |kept| last(kept).max(last(&self.current)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::testing::nested;

    #[test]
    fn what_is_kept_keeps_what_is_around_it() {
        // Node 1 with 2 (with 3) and 4, then 5 with 6.
        let tree = Tree::of(&nested("(((.).)(.))((.))").events);
        let mut visible = Visible::default();
        let seen = |visible: &Visible| (0..tree.nodes().len()).filter(|node| visible.is(*node)).collect::<Vec<_>>();
        assert_eq!(seen(&visible), [0, 1, 2, 3, 4, 5, 6]);
        visible.keep(&tree, Some([3]));
        assert_eq!(seen(&visible), [0, 1, 2, 3]);
        assert_eq!((visible.first_from(4), visible.last_to(6)), (None, 3));
        visible.show(&tree, 6);
        assert_eq!(seen(&visible), [0, 1, 2, 3, 5, 6]);
        visible.end_before(5);
        assert_eq!(seen(&visible), [0, 1, 2, 3]);
        visible.end_before(0);
        assert_eq!((seen(&visible), visible.last_to(6)), (vec![0], 0));
        visible.end_before(9);
        visible.keep(&tree, None::<[usize; 0]>);
        assert_eq!(seen(&visible).len(), 7);
    }
}
