//! Places: what is in a tree known by what it is and where, never by a counter, so that it can be found again in the tree of another log.
//!
//! A node is known by the way down to it, an event in its node by what it speaks of; of several that are alike in one node, the number counts.

use super::Tree;
use crate::log::event::question::Question;
use crate::log::event::{Step, What};
use crate::log::{Log, Name};

/// What a node holds: its own events, from its beginning to its end, and the nodes inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// An event of its own.
    Event(usize),
    /// A node inside.
    Node(usize),
}

/// What a part of a node is, apart from what it says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Key {
    /// A node inside.
    Node(Option<Step>),
    /// A value of this [quantity](Name::quantity).
    Quantity(Name),
    /// A decision.
    Decision(Question),
    /// The end.
    Leave,
    /// The colour of the pixel.
    Result,
}

impl Key {
    /// What an event speaks of.
    pub fn of(what: &What) -> Key {
        match *what {
            What::Enter { step, .. } => Key::Node(Some(step)),
            What::Note { name, .. } => Key::Quantity(name.quantity()),
            What::Mark(decision) => Key::Decision(Question::of(decision)),
            What::Leave => Key::Leave,
            What::Result { .. } => Key::Result,
        }
    }
}

impl Tree {
    /// What a node holds, in order.
    pub fn held(&self, node: usize) -> Vec<Held> {
        let events = self.own_events(node).map(|event| (event, Held::Event(event)));
        let nodes = self.children(node).map(|child| (self.nodes()[child].events.start, Held::Node(child)));
        let mut held: Vec<_> = events.chain(nodes).collect();
        held.sort_unstable_by_key(|(at, _)| *at);
        held.into_iter().map(|(_, held)| held).collect()
    }
}

/// The way from the root of a tree to a node: every node on it, and how many that are alike its parent holds before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way(Vec<(Step, usize)>);

impl Way {
    /// The way to a node.
    pub fn to(tree: &Tree, node: usize) -> Way {
        let numbered = |at: usize| {
            let step = tree.nodes()[at].step?;
            let before = tree.children(tree.nodes()[at].parent).take_while(|sibling| *sibling != at);
            Some((step, before.filter(|sibling| is_alike(tree.nodes()[*sibling].step, step)).count()))
        };
        let mut way: Vec<_> = tree.around(node).filter_map(numbered).collect();
        way.reverse();
        Way(way)
    }

    /// The node to which it leads in a tree.
    ///
    /// # Errors
    /// Where the tree has none, the last node on the way there.
    pub fn end_in(&self, tree: &Tree) -> Result<usize, usize> {
        self.followed(tree, is_alike)
    }

    fn followed(&self, tree: &Tree, is_alike: fn(Option<Step>, Step) -> bool) -> Result<usize, usize> {
        self.0.iter().try_fold(0, |node, (step, number)| {
            let mut alike = tree.children(node).filter(|child| is_alike(tree.nodes()[*child].step, *step));
            alike.nth(*number).ok_or(node)
        })
    }
}

/// Whether two nodes are the same part of a computation: the pixel may differ, nothing else.
fn is_alike(one: Option<Step>, other: Step) -> bool {
    match (one, other) {
        (Some(Step::Pixel(_)), Step::Pixel(_)) => true,
        (one, other) => one == Some(other),
    }
}

/// The same, whatever is hit there.
fn is_alike_on_any_object(one: Option<Step>, other: Step) -> bool {
    matches!((one, other), (Some(Step::Shade { .. }), Step::Shade { .. })) || is_alike(one, other)
}

/// The place of an event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    way: Way,
    /// What the event speaks of, and how many before it in the node do; nothing in a log without events.
    event: Option<(Key, usize)>,
}

impl Place {
    /// The place of an event.
    pub fn of(log: &Log, tree: &Tree, event: usize) -> Place {
        let node = tree.owner(event);
        let numbered = log.events.get(event).map(|found| {
            let key = Key::of(&found.what);
            let before = tree.own_events_before(node, event);
            (key, before.filter(|other| Key::of(&log.events[*other].what) == key).count())
        });
        Place { way: Way::to(tree, node), event: numbered }
    }

    /// The event at this place of a log.
    ///
    /// # Errors
    /// Where the log has none, the beginning of the last node on the way there.
    pub fn find(&self, log: &Log, tree: &Tree) -> Result<usize, usize> {
        let node = self.way.end_in(tree).map_err(|node| tree.nodes()[node].events.start)?;
        self.event_in(log, tree, node).ok_or(tree.nodes()[node].events.start)
    }

    /// The event at this place of a log whose rays may hit other objects on the way there.
    pub fn find_on_any_object(&self, log: &Log, tree: &Tree) -> Option<usize> {
        let node = self.way.followed(tree, is_alike_on_any_object).ok()?;
        let is_this = self.way.0.last().is_none_or(|(step, _)| is_alike(tree.nodes()[node].step, *step));
        self.event_in(log, tree, node).filter(|_| is_this)
    }

    fn event_in(&self, log: &Log, tree: &Tree, node: usize) -> Option<usize> {
        let Some((key, number)) = self.event else { return Some(tree.nodes()[node].events.start) };
        tree.own_events(node).filter(|event| Key::of(&log.events[*event].what) == key).nth(number)
    }
}
