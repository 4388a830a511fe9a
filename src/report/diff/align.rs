//! Which step of one log is which of the other: by the kind and the place of a step, never by a counter.
//!
//! Both trees are walked together. In a node a step is known by what it is (a quantity's key, an input's, the question that a
//! decision answers, what a node inside is) and by how many of that kind are before it in the node. So tests may come in another
//! order, and a step that only one log has shifts no other.

use crate::log::What;
use crate::log::tree::{Held, Key};
use crate::report::provenance;
use crate::report::side_by_side::Run;
use std::collections::{HashMap, VecDeque};

/// An item in a log that can be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Item {
    /// What an event says: a value, a decision, the result.
    Event(usize),
    /// An input of an event: the event, and its number among the event's inputs.
    Input(usize, usize),
    /// A node with all that it holds.
    Node(usize),
}

impl Item {
    /// The node in which it is; of a node itself.
    pub(super) fn owner(self, run: Run) -> usize {
        match self {
            Item::Event(event) | Item::Input(event, _) => run.tree.owner(event),
            Item::Node(node) => node,
        }
    }
}

/// An item of either log, or both: the first is that of A.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Spot {
    /// In both.
    Both(Item, Item),
    /// In A only.
    OnlyA(Item),
    /// In B only.
    OnlyB(Item),
}

/// The alignment of two logs.
#[derive(Debug, Default)]
pub(super) struct Alignment {
    /// Every item of both logs in the order of A, those of B alone after what precedes them in B. A node is here only if
    /// one log has it alone; what it holds doesn't. An input doesn't if what it passes on was computed before.
    pub spots: Vec<Spot>,
    /// For each of them, the node of A in which it is or would be.
    pub homes: Vec<usize>,
    /// By the events of A, those of B in their places.
    pub partners: Vec<Option<usize>>,
    /// By the nodes of A, those of B in their places.
    pub nodes: Vec<Option<usize>>,
    /// By the nodes of B, whether A has one in their places.
    pub is_shared: Vec<bool>,
}

/// Aligns two logs whose objects and lights have the same numbers.
pub(super) fn align(a: Run, b: Run) -> Alignment {
    let mut alignment = Alignment {
        spots: Vec::new(),
        homes: Vec::new(),
        partners: vec![None; a.log.events.len()],
        nodes: vec![None; a.tree.nodes().len()],
        is_shared: vec![false; b.tree.nodes().len()],
    };
    alignment.node(a, 0, b, 0);
    alignment
}

impl Alignment {
    fn node(&mut self, a: Run, node_a: usize, b: Run, node_b: usize) {
        self.nodes[node_a] = Some(node_b);
        self.is_shared[node_b] = true;
        let (ours, theirs) = (items(a, node_a), items(b, node_b));
        let mut places: HashMap<Key, VecDeque<usize>> = HashMap::new();
        for (place, item) in theirs.iter().enumerate() {
            places.entry(key(b, *item)).or_default().push_back(place);
        }
        let partners: Vec<Option<usize>> =
            ours.iter().map(|item| places.get_mut(&key(a, *item)).and_then(VecDeque::pop_front)).collect();
        let mut is_shared = vec![false; theirs.len()];
        partners.iter().flatten().for_each(|place| is_shared[*place] = true);
        let mut told = 0;
        for (item, partner) in ours.into_iter().zip(partners) {
            let Some(place) = partner else {
                self.tell_alone(node_a, a, Spot::OnlyA, item);
                continue;
            };
            for earlier in (told..place).filter(|place| !is_shared[*place]) {
                self.tell_alone(node_a, b, Spot::OnlyB, theirs[earlier]);
            }
            told = told.max(place);
            self.pair(a, item, b, theirs[place]);
        }
        for place in (told..theirs.len()).filter(|place| !is_shared[*place]) {
            self.tell_alone(node_a, b, Spot::OnlyB, theirs[place]);
        }
    }

    fn tell_alone(&mut self, home: usize, run: Run, spot: fn(Item) -> Spot, item: Item) {
        if computed(run, item).is_none() {
            self.tell(home, spot(item));
        }
    }

    fn tell(&mut self, home: usize, spot: Spot) {
        self.spots.push(spot);
        self.homes.push(home);
    }

    fn pair(&mut self, a: Run, ours: Item, b: Run, theirs: Item) {
        let home = ours.owner(a);
        match (ours, theirs) {
            (Item::Node(ours), Item::Node(theirs)) => self.node(a, ours, b, theirs),
            (Item::Event(event_a), Item::Event(event_b)) => {
                self.partners[event_a] = Some(event_b);
                self.tell(home, Spot::Both(ours, theirs));
            }
            // Both were compared where they were computed.
            (Item::Input(..), Item::Input(..)) if computed(a, ours).is_some() && computed(b, theirs).is_some() => {}
            _ => self.tell(home, Spot::Both(ours, theirs)),
        }
    }
}

/// The event that computed what an input passes on.
pub(super) fn computed(run: Run, item: Item) -> Option<usize> {
    let Item::Input(event, number) = item else { return None };
    let (name, value) = run.log.given(event)[number];
    provenance::handed_on_from(run.log, run.tree, event, name, &value)
}

/// What a node holds, in order: an event's inputs are before it.
fn items(run: Run, node: usize) -> Vec<Item> {
    let mut items = Vec::new();
    for held in run.tree.held(node) {
        match held {
            Held::Event(event) => {
                items.extend((0..run.log.given(event).len()).map(|number| Item::Input(event, number)));
                if !matches!(run.log.events[event].what, What::Enter { .. } | What::Leave) {
                    items.push(Item::Event(event));
                }
            }
            Held::Node(node) => items.push(Item::Node(node)),
        }
    }
    items
}

/// What an item is. A quantity may be noted or an input: the ray of the middle pixel has as an input what others compute.
fn key(run: Run, item: Item) -> Key {
    match item {
        Item::Node(node) => Key::Node(run.tree.nodes()[node].step),
        Item::Input(event, number) => Key::Quantity(run.log.given(event)[number].0.quantity()),
        Item::Event(event) => Key::of(&run.log.events[event].what),
    }
}
