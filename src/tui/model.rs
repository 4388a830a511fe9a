//! The state of the viewer: the log, the place in it, and what of it is shown. It draws nothing and reads no keys.

use super::facts::Facts;
use super::fold::Fold;
use super::layout::Layout;
use super::list;
use super::live::Live;
use super::prompt::Prompt;
use super::understanding::{self, Understanding};
use super::update::Effect;
use crate::log::{Log, Tree};
use crate::report::Style as Numbers;

/// Everything that the viewer knows.
#[derive(Clone, Debug)]
pub struct Model {
    /// The log.
    pub log: Log,
    /// Its nodes.
    pub tree: Tree,
    /// What they came to.
    pub facts: Facts,
    /// Which of them are open.
    pub fold: Fold,
    /// The selected node; it is always visible.
    pub cursor: usize,
    /// The current event: how far one has stepped. It lies in the selected node or inside it.
    pub event: usize,
    /// The first row of the tree on the screen.
    pub top: usize,
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    /// The pane that the keys move in.
    pub focus: Pane,
    /// What was typed and isn't a key yet.
    pub pending: Pending,
    /// What lies over the panes.
    pub overlay: Option<Overlay>,
    /// The line that is being typed.
    pub prompt: Option<Prompt>,
    /// What is said at the bottom.
    pub message: Option<Message>,
    /// How numbers are shown.
    pub numbers: Numbers,
    /// What is shown, in other arithmetics, once somebody asked for it.
    pub others: Vec<Log>,
    /// Lists that explain, and the quiz.
    pub understanding: Understanding,
}

/// A pane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pane {
    /// The ray tree.
    Tree,
    /// The computation of the selected node.
    Computation,
}

/// The beginning of a command: a count such as the `5` of `5j`, and the first of two keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pending {
    /// How often.
    pub count: Option<u32>,
    /// The first of two keys.
    pub prefix: Option<char>,
}

/// What lies over the panes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The help, from this line on.
    Help {
        /// The first line shown.
        top: u16,
    },
    /// A list of places and figures.
    List {
        /// Of what.
        kind: list::Kind,
        /// The selected entry.
        selected: usize,
    },
}

/// Something said at the bottom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// The words.
    pub text: String,
    /// Whether it stays until it is dismissed; else until the next key.
    pub is_warning: bool,
}

impl Model {
    /// The viewer of a log, at its first step.
    pub fn new(log: Log) -> Model {
        let tree = Tree::of(&log.events);
        let facts = Facts::of(&log, &tree);
        let fold = Fold::of(&tree);
        let mut model = Model {
            log,
            tree,
            facts,
            fold,
            cursor: 0,
            event: 0,
            top: 0,
            size: (80, 24),
            focus: Pane::Tree,
            pending: Pending::default(),
            overlay: None,
            prompt: None,
            message: None,
            numbers: Numbers::default(),
            others: Vec::new(),
            understanding: Understanding::default(),
        };
        model.go_to_event(0);
        model
    }

    /// Goes to an event and shows its node. The last event stands for those beyond it.
    pub fn go_to_event(&mut self, event: usize) {
        self.event = event.min(self.log.events.len().saturating_sub(1));
        self.cursor = self.tree.owner(self.event);
        self.fold.reveal(&self.tree, self.cursor);
    }

    /// Goes to a visible node, and to its first event.
    pub fn go_to_node(&mut self, node: usize) {
        self.cursor = node;
        self.event = self.tree.nodes()[node].events.start.min(self.log.events.len().saturating_sub(1));
    }

    /// Has somebody do what is left to do outside the model, as far as it concerns the scene.
    pub fn answer(&mut self, effect: Effect, live: &mut Option<&mut dyn Live>) {
        let asked = match (effect, live) {
            (Effect::None | Effect::Leave(_) | Effect::Suspend, _) => return,
            (_, None) => Err("a saved log has no scene to trace".to_owned()),
            (Effect::Trace(pixel), Some(live)) => live.trace(pixel).map(|log| self.show(log)),
            (Effect::Compare, Some(live)) => live.compare(self.log.header.subject).map(|logs| {
                self.others = logs;
                understanding::open(self, list::Kind::Arithmetics);
            }),
        };
        if let Err(why) = asked {
            self.say(&why);
        }
    }

    /// Shows another log of the same scene.
    pub fn show(&mut self, log: Log) {
        self.tree = Tree::of(&log.events);
        self.facts = Facts::of(&log, &self.tree);
        self.fold = Fold::of(&self.tree);
        self.log = log;
        self.others.clear();
        self.understanding = Understanding::default();
        self.go_to_event(0);
    }

    /// The number of the current step, from 1; 0 in a log without events.
    pub fn step(&self) -> usize {
        if self.log.events.is_empty() { 0 } else { self.event + 1 }
    }

    /// Says something until the next key. A warning that nobody dismissed stays instead.
    pub fn say(&mut self, text: &str) {
        if self.message.as_ref().is_none_or(|message| !message.is_warning) {
            self.message = Some(Message { text: text.to_owned(), is_warning: false });
        }
    }

    /// Says something until it is dismissed.
    pub fn warn(&mut self, text: &str) {
        self.message = Some(Message { text: text.to_owned(), is_warning: true });
    }

    /// Where the panes lie.
    pub fn layout(&self) -> Layout {
        Layout::of(self.size, self.focus, self.message.is_some())
    }

    /// The events of the selected node itself, in order, and the nodes inside it, where they stand between them.
    pub fn items(&self) -> Vec<Item> {
        let range = self.tree.nodes()[self.cursor].events.clone();
        let mut items = Vec::new();
        let mut event = range.start;
        while event < range.end {
            let owner = self.tree.owner(event);
            if owner == self.cursor {
                items.push(Item::Event(event));
                event += 1;
            } else {
                items.push(Item::Node(owner));
                event = self.tree.nodes()[owner].events.end;
            }
        }
        items
    }
}

/// A line of the selected node's computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// An event of the node itself.
    Event(usize),
    /// A node inside it.
    Node(usize),
}
