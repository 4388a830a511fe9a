//! The events as a tree: nodes in pre-order in one flat array, so that a view needs to touch only what it shows.

mod children;
pub(super) mod index;
mod memo;
mod path;
mod place;

pub use children::Child;
pub(super) use path::add_step;
pub use path::path_of_child;
pub use place::{Held, Key, Place, Way};

use super::event::{Event, RayKind, Step, What};
use super::events::Events;
use index::Index;
use std::iter::Map;
use std::ops::Range;
use std::slice;
use std::sync::OnceLock;

/// The tree of a log's nodes. Node 0 is the root: the pixel, or the whole region.
#[derive(Clone, Debug)]
pub struct Tree {
    nodes: Vec<Node>,
    /// The node of each event.
    owner: Vec<u32>,
    /// The events of each node itself, node after node. A ray may contain a hundred thousand tests, which a search passes over at once.
    own: Vec<u32>,
    /// Where those of each node begin, and at the end where they all end.
    own_start: Vec<u32>,
    /// What is in nodes that hold much, made when it is first asked for.
    index: OnceLock<Index>,
    /// What is known of the paths of deep nodes, made likewise.
    deep: OnceLock<Vec<path::Deep>>,
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
        let mut tree = Tree {
            nodes: vec![root],
            owner: Vec::with_capacity(events.len()),
            own: Vec::new(),
            own_start: Vec::new(),
            index: OnceLock::new(),
            deep: OnceLock::new(),
        };
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
            if event.what == What::Leave && open.len() > 1 {
                tree.close_down_to(open.len() - 1, &mut open, index + 1);
            }
        }
        tree.close_down_to(0, &mut open, events.len());
        tree.list_own_events();
        tree
    }

    /// Sorts the events by their nodes.
    fn list_own_events(&mut self) {
        // First the number of each node's events is one place further on, then where they begin.
        let mut starts = vec![0_u32; self.nodes.len() + 2];
        self.owner.iter().for_each(|node| starts[*node as usize + 2] += 1);
        for node in 2..starts.len() {
            starts[node] += starts[node - 1];
        }
        self.own = vec![0; self.owner.len()];
        for (event, node) in (0..).zip(&self.owner) {
            let place = &mut starts[*node as usize + 1];
            self.own[*place as usize] = event;
            *place += 1;
        }
        starts.pop();
        self.own_start = starts;
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

    /// A node and those around it, up to the root.
    pub fn around(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(node), |at| Some(self.nodes[*at].parent).filter(|parent| parent != at))
    }

    /// The pixel of a region that a node lies in.
    pub fn pixel_around(&self, node: usize) -> Option<[u32; 2]> {
        self.around(node).find_map(|at| match self.nodes[at].step {
            Some(Step::Pixel(pixel)) => Some(pixel),
            _ => None,
        })
    }

    /// What the ray is for that a node is; `None` of another node.
    pub fn ray(&self, node: usize) -> Option<RayKind> {
        match self.nodes[node].step {
            Some(Step::Ray { kind, .. }) => Some(kind),
            _ => None,
        }
    }

    /// The nodes directly inside a node.
    pub fn children(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        let end = self.nodes[node].subtree_end;
        let first = Some(node + 1).filter(|first| *first < end);
        std::iter::successors(first, move |child| Some(self.nodes[*child].subtree_end).filter(|next| *next < end))
    }

    /// What a node holds, in order: its own events, and the nodes inside it where they are between them.
    pub fn items(&self, node: usize) -> impl Iterator<Item = Item> + '_ {
        let Range { mut start, end } = self.nodes[node].events.clone();
        std::iter::from_fn(move || {
            let event = Some(start).filter(|event| *event < end)?;
            let owner = self.owner(event);
            let (item, next) = match owner == node {
                true => (Item::Event(event), event + 1),
                false => (Item::Node(owner), self.nodes[owner].events.end),
            };
            start = next;
            Some(item)
        })
    }

    /// The events of a node itself, without those of the nodes inside it, in order.
    pub fn own_events(&self, node: usize) -> OwnEvents<'_> {
        self.own_list(node).iter().map(|event| *event as usize)
    }

    /// Those of them that lie before an event.
    pub fn own_events_before(&self, node: usize, before: usize) -> OwnEvents<'_> {
        let all = self.own_list(node);
        let count = all.partition_point(|event| (*event as usize) < before);
        all[..count].iter().map(|event| *event as usize)
    }

    /// Those of them from an event on.
    pub fn own_events_from(&self, node: usize, from: usize) -> OwnEvents<'_> {
        let all = self.own_list(node);
        let before = all.partition_point(|event| (*event as usize) < from);
        all[before..].iter().map(|event| *event as usize)
    }

    fn own_list(&self, node: usize) -> &[u32] {
        &self.own[self.own_start[node] as usize..self.own_start[node + 1] as usize]
    }

    /// What is in nodes that hold much. The events are those that the tree was made of.
    pub(super) fn index(&self, events: &Events) -> &Index {
        self.index.get_or_init(|| Index::of(events, self))
    }
}

/// What is directly in a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// An event of the node itself.
    Event(usize),
    /// A node inside it.
    Node(usize),
}

/// The events of a node itself, in order.
pub type OwnEvents<'t> = Map<slice::Iter<'t, u32>, fn(&u32) -> usize>;
