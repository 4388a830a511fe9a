//! Which value of one run is which of another: by the place in the tree, never by the number.

use crate::log::tree::Held;
use crate::log::{Event, Step, Tree, What};
use crate::probe::is_same;
use std::collections::HashMap;

/// A run of a computation.
pub(super) struct Run<'e> {
    pub events: &'e [Event],
    pub tree: Tree,
}

/// What another run says in the place of each event of the first.
pub(super) struct Alignment<'a> {
    pub ours: &'a Run<'a>,
    pub theirs: &'a Run<'a>,
    /// Their values by our events.
    pub values: &'a mut [[f64; 3]],
    /// By our events, whether a decision differs there or before.
    pub differs: &'a mut [bool],
}

impl<'e> Run<'e> {
    pub fn of(events: &'e [Event]) -> Run<'e> {
        Run { events, tree: Tree::of(events) }
    }

    fn step(&self, node: usize) -> Option<Step> {
        self.tree.nodes()[node].step
    }

    fn is_test(&self, node: usize) -> bool {
        matches!(self.step(node), Some(Step::Test { .. } | Step::Motion { .. }))
    }

    /// What a node holds and says something, in order, beside intersection tests.
    fn items(&self, node: usize) -> Vec<Held> {
        let counts = |held: &Held| match held {
            Held::Event(event) => !matches!(self.events[*event].what, What::Enter { .. } | What::Leave),
            Held::Node(node) => !self.is_test(*node),
        };
        self.tree.held(node).into_iter().filter(counts).collect()
    }
}

impl Alignment<'_> {
    /// Compares a node with theirs, and says whether the two come to something by different decisions.
    ///
    /// Once something else happens than in theirs, all that follows in the node was decided otherwise. What a node inside
    /// brings is used by the node around it, or, for a ray, by its weighted sum.
    pub fn node(&mut self, ours: usize, theirs: usize) -> bool {
        self.tests(ours, theirs);
        let is_ray = matches!(self.ours.step(ours), Some(Step::Ray { .. }));
        let (items, their_items) = (self.ours.items(ours), self.theirs.items(theirs));
        let (mut differs, mut uses_what_differs) = (false, false);
        for (index, item) in items.iter().enumerate() {
            let their_item = their_items.get(index).filter(|their_item| !differs && self.is_same(*item, **their_item));
            match (*item, their_item) {
                (Held::Event(event), Some(Held::Event(theirs))) => {
                    self.values[event] = components(&self.theirs.events[*theirs].what);
                    let is_value = !matches!(self.ours.events[event].what, What::Mark(_));
                    self.differs[event] |= is_value && uses_what_differs && !is_ray;
                }
                (Held::Node(node), Some(Held::Node(theirs))) => {
                    let is_sum = self.ours.step(node) == Some(Step::Combine);
                    if is_sum && uses_what_differs {
                        self.give_up(*item);
                    }
                    uses_what_differs |= self.node(node, *theirs);
                }
                _ => {
                    differs = true;
                    self.give_up(*item);
                }
            }
        }
        differs || uses_what_differs || items.len() != their_items.len()
    }

    /// Compares the tests of two nodes. What they come to shows in their node: the nearest object, the light that passes.
    fn tests(&mut self, ours: usize, theirs: usize) {
        let (own, other) = (self.ours, self.theirs);
        let their_tests = other.tree.children(theirs).filter(|child| other.is_test(*child));
        let their_tests: HashMap<Option<Step>, usize> = their_tests.map(|test| (other.step(test), test)).collect();
        for test in own.tree.children(ours).filter(|child| own.is_test(*child)) {
            match their_tests.get(&own.step(test)) {
                Some(theirs) => _ = self.node(test, *theirs),
                None => self.give_up(Held::Node(test)),
            }
        }
    }

    fn is_same(&self, ours: Held, theirs: Held) -> bool {
        match (ours, theirs) {
            (Held::Node(ours), Held::Node(theirs)) => self.ours.step(ours) == self.theirs.step(theirs),
            (Held::Event(ours), Held::Event(theirs)) => {
                match (&self.ours.events[ours].what, &self.theirs.events[theirs].what) {
                    (What::Note { name: ours, .. }, What::Note { name: theirs, .. }) => ours == theirs,
                    (What::Mark(ours), What::Mark(theirs)) => is_same(*ours, *theirs),
                    (What::Result { .. }, What::Result { .. }) => true,
                    _ => false,
                }
            }
            _ => false,
        }
    }

    /// Nothing of theirs is in this place.
    fn give_up(&mut self, item: Held) {
        let events = match item {
            Held::Event(event) => event..event + 1,
            Held::Node(node) => self.ours.tree.nodes()[node].events.clone(),
        };
        self.differs[events].fill(true);
    }
}

/// The value of an event; zeros for those that have none.
pub(super) fn components(what: &What) -> [f64; 3] {
    let mut components = [0.0; 3];
    if let Some(value) = what.value() {
        components.iter_mut().zip(value.components()).for_each(|(component, x)| *component = *x);
    }
    components
}
