//! Which nodes of the tree are open, and the rows that this leaves visible.
//!
//! Rows are never listed: the nodes are in pre-order in one flat array, and from any visible row the next and the
//! previous one are found in a few steps. So a frame touches only what it shows, however large the log.

use super::visible::Visible;
use crate::log::{Node, Step, Tree};
use std::ops::Range;

/// The nodes whose inside is shown, and which nodes there are to be seen at all.
#[derive(Clone, Debug)]
pub struct Fold {
    open: Vec<bool>,
    /// The nodes to be seen.
    pub visible: Visible,
}

impl Fold {
    /// A small tree opens whole; of a large one the rays open, but not the pixels and samples that hold them.
    pub fn of(tree: &Tree) -> Fold {
        const SMALL: usize = 120;
        let is_small = tree.nodes().len() <= SMALL;
        let opens = |node: &Node| is_small || matches!(node.step, None | Some(Step::Ray { .. }));
        Fold { open: tree.nodes().iter().map(opens).collect(), visible: Visible::default() }
    }

    /// Whether a node has something inside, and shows it.
    pub fn is_open(&self, tree: &Tree, node: usize) -> bool {
        self.open[node] && has_children(tree, node)
    }

    /// Opens or closes a node.
    pub fn set(&mut self, node: usize, open: bool) {
        self.open[node] = open;
    }

    /// Opens or closes every node of a range.
    pub fn set_all(&mut self, nodes: Range<usize>, open: bool) {
        self.open[nodes].fill(open);
    }

    /// Opens every node around this one, which is seen whatever is filtered.
    pub fn reveal(&mut self, tree: &Tree, node: usize) {
        self.visible.show(tree, node);
        self.open_around(tree, node);
    }

    /// Opens every node around this one.
    pub fn open_around(&mut self, tree: &Tree, node: usize) {
        tree.around(node).skip(1).for_each(|at| self.open[at] = true);
    }

    /// The row that stands for a node: itself, or the outermost closed node around it; of one that isn't to be seen, the
    /// node around it that is.
    pub fn row_of(&self, tree: &Tree, node: usize) -> usize {
        let seen = tree.around(node).find(|at| self.visible.is(*at)).unwrap_or(0);
        tree.around(seen).skip(1).filter(|at| !self.open[*at]).last().unwrap_or(seen)
    }

    /// The row below a visible row.
    pub fn below(&self, tree: &Tree, row: usize) -> Option<usize> {
        let next = if self.open[row] { row + 1 } else { tree.nodes()[row].subtree_end };
        self.visible.first_from(next).filter(|next| *next < tree.nodes().len())
    }

    /// The row above a visible row.
    pub fn above(&self, tree: &Tree, row: usize) -> Option<usize> {
        row.checked_sub(1).map(|previous| self.row_of(tree, self.visible.last_to(previous)))
    }

    /// The first node inside a node that is to be seen.
    pub fn first_inside(&self, tree: &Tree, node: usize) -> Option<usize> {
        self.visible.first_from(node + 1).filter(|first| *first < tree.nodes()[node].subtree_end)
    }

    /// The next node inside the same parent that is to be seen.
    pub fn next_sibling(&self, tree: &Tree, node: usize) -> Option<usize> {
        let end = tree.nodes()[tree.nodes()[node].parent].subtree_end;
        // What is inside a sibling is seen only if that one is, which comes before it.
        self.visible.first_from(tree.nodes()[node].subtree_end).filter(|next| node != 0 && *next < end)
    }

    /// The row `count` below a visible row, or the last there is; and how many rows lie between.
    pub fn down(&self, tree: &Tree, row: usize, count: usize) -> (usize, usize) {
        walk(row, count, |row| self.below(tree, row))
    }

    /// The row `count` above a visible row, or the first there is; and how many rows lie between.
    pub fn up(&self, tree: &Tree, row: usize, count: usize) -> (usize, usize) {
        walk(row, count, |row| self.above(tree, row))
    }

    /// The last row.
    pub fn last(&self, tree: &Tree) -> usize {
        self.row_of(tree, self.visible.last_to(tree.nodes().len() - 1))
    }

    /// The first row of a view of `height` rows that shows the row `cursor`, moved from `top` no more than it must be.
    pub fn scrolled(&self, tree: &Tree, top: usize, cursor: usize, height: usize) -> usize {
        let room = height.saturating_sub(1);
        let top = self.row_of(tree, top);
        if cursor < top {
            return cursor;
        }
        let (last_shown, shown) = self.down(tree, top, room);
        if cursor > last_shown {
            return self.up(tree, cursor, room).0;
        }
        // No empty space at the end while there are rows above.
        self.up(tree, top, room - shown).0
    }
}

/// What was open in the trees of the pixels that were left, so that one finds them as they were.
#[derive(Clone, Debug, Default)]
pub struct Folds(Vec<([u32; 2], Vec<bool>)>);

impl Folds {
    /// Remembers the tree of a pixel.
    pub fn keep(&mut self, pixel: Option<[u32; 2]>, fold: Fold) {
        /// So many are remembered.
        const MOST: usize = 64;
        let Some(pixel) = pixel else { return };
        self.0.retain(|(known, _)| *known != pixel);
        if self.0.len() == MOST {
            self.0.remove(0);
        }
        self.0.push((pixel, fold.open));
    }

    /// Opens what was open in the tree of a pixel, if it is known.
    pub fn restore(&self, pixel: Option<[u32; 2]>, fold: &mut Fold) {
        let known = self.0.iter().find(|(known, open)| Some(*known) == pixel && open.len() == fold.open.len());
        if let Some((_, open)) = known {
            fold.open.clone_from(open);
        }
    }
}

/// Whether a node has nodes inside.
pub fn has_children(tree: &Tree, node: usize) -> bool {
    tree.nodes()[node].subtree_end > node + 1
}

/// The previous node inside the same parent.
pub fn previous_sibling(tree: &Tree, node: usize) -> Option<usize> {
    let parent = tree.nodes()[node].parent;
    let mut at = node.checked_sub(1).filter(|before| *before != parent)?;
    while tree.nodes()[at].parent != parent {
        at = tree.nodes()[at].parent;
    }
    Some(at)
}

fn walk(start: usize, count: usize, step: impl Fn(usize) -> Option<usize>) -> (usize, usize) {
    let mut at = start;
    for taken in 0..count {
        match step(at) {
            Some(next) => at = next,
            None => return (at, taken),
        }
    }
    (at, count)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::tui::testing::nested;

    /// Node 1 with 2 (with 3) and 4, then 5 with 6, then 7.
    fn tree() -> Tree {
        Tree::of(&nested("(((.).)(.)).((.)).(.)").events)
    }

    fn rows(fold: &Fold, tree: &Tree) -> Vec<usize> {
        std::iter::successors(Some(0), |row| fold.below(tree, *row)).collect()
    }

    #[test]
    fn above_undoes_below_whatever_is_closed() {
        let tree = tree();
        let count = tree.nodes().len();
        for closed in 0..1_usize << count {
            let open = (0..count).map(|node| closed >> node & 1 == 0).collect();
            let mut fold = Fold { open, visible: Visible::default() };
            for (kept, end) in [(None, count), (Some(vec![3, 7]), count), (Some(vec![4]), 4), (None, 5)] {
                fold.visible.keep(&tree, kept);
                fold.visible.end_before(end);
                let rows = rows(&fold, &tree);
                for pair in rows.windows(2) {
                    assert_eq!(fold.above(&tree, pair[1]), Some(pair[0]), "closed {closed:b}, rows {rows:?}");
                }
                assert_eq!(fold.last(&tree), *rows.last().unwrap());
                for node in 0..count {
                    assert!(rows.contains(&fold.row_of(&tree, node)), "closed {closed:b}, rows {rows:?}, {node}");
                }
            }
        }
    }

    #[test]
    fn closed_nodes_hide_their_inside() {
        let tree = tree();
        let mut fold = Fold::of(&tree);
        assert_eq!(rows(&fold, &tree), (0..tree.nodes().len()).collect::<Vec<_>>());
        fold.set(2, false);
        assert!(!rows(&fold, &tree).contains(&3));
        assert_eq!(fold.row_of(&tree, 3), 2);
        fold.reveal(&tree, 3);
        assert_eq!(fold.row_of(&tree, 3), 3);
    }

    #[test]
    fn siblings_are_found_both_ways() {
        let tree = tree();
        for node in 0..tree.nodes().len() {
            let siblings: Vec<_> = tree.children(node).collect();
            for pair in siblings.windows(2) {
                assert_eq!(Fold::of(&tree).next_sibling(&tree, pair[0]), Some(pair[1]));
                assert_eq!(previous_sibling(&tree, pair[1]), Some(pair[0]));
            }
            if let (Some(first), Some(last)) = (siblings.first(), siblings.last()) {
                assert_eq!(previous_sibling(&tree, *first), None);
                assert_eq!(Fold::of(&tree).next_sibling(&tree, *last), None);
            }
        }
    }

    #[test]
    fn scrolling_moves_no_more_than_it_must() {
        let tree = tree();
        let fold = Fold::of(&tree);
        assert_eq!(fold.scrolled(&tree, 0, 2, 3), 0);
        assert_eq!(fold.scrolled(&tree, 0, 3, 3), 1);
        assert_eq!(fold.scrolled(&tree, 3, 1, 3), 1);
        assert_eq!(fold.scrolled(&tree, 7, 7, 3), 5);
        assert_eq!(fold.scrolled(&tree, 0, 0, 0), 0);
        assert_eq!(fold.scrolled(&tree, 4, 4, 100), 0);
    }
}
