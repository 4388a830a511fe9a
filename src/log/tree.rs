//! The events as a tree: nodes in pre-order in one flat array, so that a view needs to touch only what it shows.

use super::event::{Event, RayKind, Step, What};
use std::ops::Range;

/// The tree of a log's nodes. Node 0 is the root: the pixel, or the whole region.
#[derive(Clone, Debug)]
pub struct Tree {
    nodes: Vec<Node>,
    /// The node of each event.
    owner: Vec<u32>,
    /// The events of pixels themselves, of the root too. A pixel may hold thousands of samples, which a search for one of these passes over.
    of_pixels: Vec<u32>,
}

/// A node of the tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// What the node is; `None` for the root.
    pub step: Option<Step>,
    /// The index of the enclosing node (the root's is its own).
    pub parent: usize,
    /// How many nodes enclose it.
    pub level: usize,
    /// Its events, from the one that enters to the one that leaves, with those of the nodes inside.
    pub events: Range<usize>,
    /// The index after its last descendant.
    pub subtree_end: usize,
}

impl Tree {
    /// The tree of these events. Nodes that are never left (in a log that was cut off) end where the events do.
    pub fn of(events: &[Event]) -> Tree {
        let root = Node { step: None, parent: 0, level: 0, events: 0..events.len(), subtree_end: 1 };
        let mut tree = Tree { nodes: vec![root], owner: Vec::with_capacity(events.len()), of_pixels: Vec::new() };
        let mut open = vec![0];
        for (index, event) in events.iter().enumerate() {
            if let What::Enter { step, .. } = event.what {
                if matches!(step, Step::Pixel(_)) {
                    // Pixels of a region follow one another without being left.
                    tree.close_down_to(1, &mut open, index);
                }
                let parent = open[open.len() - 1];
                open.push(tree.nodes.len());
                let node = Node {
                    step: Some(step),
                    parent,
                    level: open.len() - 1,
                    events: index..events.len(),
                    subtree_end: tree.nodes.len() + 1,
                };
                tree.nodes.push(node);
            }
            let owner = open[open.len() - 1];
            tree.owner.push(owner as u32);
            if matches!(tree.nodes[owner].step, None | Some(Step::Pixel(_))) {
                tree.of_pixels.push(index as u32);
            }
            if event.what == What::Leave && open.len() > 1 {
                tree.close_down_to(open.len() - 1, &mut open, index + 1);
            }
        }
        tree.close_down_to(0, &mut open, events.len());
        tree
    }

    fn close_down_to(&mut self, count: usize, open: &mut Vec<usize>, end: usize) {
        while open.len() > count {
            if let Some(node) = open.pop() {
                self.nodes[node].events.end = end;
                self.nodes[node].subtree_end = self.nodes.len();
            }
        }
    }

    /// The nodes in pre-order.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The node that an event belongs to.
    pub fn owner(&self, event: usize) -> usize {
        self.owner.get(event).map_or(0, |node| *node as usize)
    }

    /// The nodes directly inside a node.
    pub fn children(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        let end = self.nodes[node].subtree_end;
        let first = Some(node + 1).filter(|first| *first < end);
        std::iter::successors(first, move |child| Some(self.nodes[*child].subtree_end).filter(|next| *next < end))
    }

    /// The events of a node itself, without those of the nodes inside it, in order.
    pub fn own_events(&self, node: usize) -> OwnEvents<'_> {
        OwnEvents { tree: self, node, rest: self.nodes[node].events.clone() }
    }

    /// Those of them that lie before an event.
    pub fn own_events_before(&self, node: usize, before: usize) -> OwnEvents<'_> {
        let Range { start, end } = self.nodes[node].events;
        OwnEvents { tree: self, node, rest: start..end.min(before) }
    }

    /// The way of a node's ray from the eye, such as `C R S1`, or `3 C R S1` in the third sample; empty outside every ray.
    pub fn path(&self, node: usize) -> String {
        let mut steps = Vec::new();
        let mut at = node;
        while at != 0 {
            steps.extend(self.nodes[at].step);
            at = self.nodes[at].parent;
        }
        steps.iter().rev().fold(String::new(), |path, step| path_of_child(&path, *step))
    }
}

/// The events of a node itself. A node inside it is passed over in one step, however much it holds.
#[derive(Clone, Debug)]
pub struct OwnEvents<'t> {
    tree: &'t Tree,
    node: usize,
    rest: Range<usize>,
}

impl OwnEvents<'_> {
    /// The events of the node directly inside that holds this one; `None` if no node inside does.
    fn inside(&self, event: usize) -> Option<Range<usize>> {
        let mut holder = self.tree.owner(event);
        if holder == self.node {
            return None;
        }
        // The root is its own parent.
        while self.tree.nodes[holder].parent != self.node && holder != 0 {
            holder = self.tree.nodes[holder].parent;
        }
        let inside = self.tree.nodes[holder].events.clone();
        Some(if self.is_pixel() { self.gap_around(inside) } else { inside })
    }

    /// Whether the node has a list of its events.
    fn is_pixel(&self) -> bool {
        let is_region = || matches!(self.tree.nodes.get(1).map(|node| node.step), Some(Some(Step::Pixel(_))));
        match self.tree.nodes[self.node].step {
            Some(step) => matches!(step, Step::Pixel(_)),
            None => !is_region(),
        }
    }

    /// The nodes inside that follow one another without an event of the node itself between them, around one of them.
    fn gap_around(&self, inside: Range<usize>) -> Range<usize> {
        let list = &self.tree.of_pixels;
        let next = list.partition_point(|event| (*event as usize) < inside.end);
        let previous = list[..next].iter().rev().find(|event| (**event as usize) < inside.start);
        let bounds = &self.tree.nodes[self.node].events;
        let start = previous.map_or(bounds.start, |event| (*event as usize + 1).max(bounds.start));
        let end = list.get(next).map_or(bounds.end, |event| (*event as usize).min(bounds.end));
        start..end
    }
}

impl Iterator for OwnEvents<'_> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        while !self.rest.is_empty() {
            let event = self.rest.start;
            match self.inside(event) {
                None => {
                    self.rest.start += 1;
                    return Some(event);
                }
                Some(inside) => self.rest.start = inside.end,
            }
        }
        None
    }
}

impl DoubleEndedIterator for OwnEvents<'_> {
    fn next_back(&mut self) -> Option<usize> {
        while !self.rest.is_empty() {
            let event = self.rest.end - 1;
            match self.inside(event) {
                None => {
                    self.rest.end = event;
                    return Some(event);
                }
                Some(inside) => self.rest.end = inside.start,
            }
        }
        None
    }
}

/// The path of a node inside a node with this path: samples add their number, rays their letter, a
/// shadow ray also its light's number from 1: `3 C R S1`. Of several rays of a kind from one place each has its number after a
/// dot: `C R.12 S1.4` is the fourth shadow ray to the first light from the twelfth zone of a blurred reflection. A pixel of one sample has no sample node and no number.
pub fn path_of_child(path: &str, step: Step) -> String {
    let gap = if path.is_empty() { "" } else { " " };
    match step {
        Step::Pixel(_) => String::new(),
        Step::Sample { number } => format!("{path}{gap}{number}"),
        Step::Ray { kind, split, .. } => {
            let light = if let RayKind::Shadow { light } = kind { (light + 1).to_string() } else { String::new() };
            let split = if split == 0 { String::new() } else { format!(".{split}") };
            format!("{path}{gap}{}{light}{split}", kind.letter())
        }
        _ => path.to_owned(),
    }
}
