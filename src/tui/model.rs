//! The state of the viewer: the log, the place in it, and what of it is shown. It draws nothing and reads no keys.

pub mod bindings;
pub mod breakpoint;
pub mod changed;
pub mod drawing;
pub mod facts;
pub mod fold;
pub mod guide;
pub mod here;
pub mod hidden;
pub mod history;
pub mod jumps;
pub mod layout;
pub mod list;
pub mod picture;
pub mod prompt;
pub mod quantity;
pub mod schematic;
pub mod search;
pub mod understanding;
mod visible;
pub mod watch;
mod words;

pub use layout::Pane;

use crate::log::tree::{Item, Place};
use crate::log::{Log, Subject, Tree};
use crate::report::Style as Numbers;
use crate::report::language::Language;
use changed::Changed;
use drawing::Drawing;
use facts::Facts;
use fold::Fold;
use guide::Guide;
use jumps::Spot;
use layout::{Arrangement, Layout};
use picture::PictureView;
use prompt::{Message, Prompt};
use schematic::SchematicView;
use std::sync::Arc;
use understanding::Understanding;

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
    /// The pane beside the tree: the last one that had the focus.
    pub side: Pane,
    /// Whether only the pane with the focus is shown.
    pub is_alone: bool,
    /// How many columns the tree is wider than usual.
    pub shift: i16,
    /// The picture and how it is looked at, if there is a scene.
    pub picture: Option<PictureView>,
    /// The scene as lines, if there is one.
    pub drawing: Option<Arc<Drawing>>,
    /// How the schematic is looked at.
    pub schematic: SchematicView,
    /// What was typed and isn't a key yet.
    pub pending: Pending,
    /// What lies over the panes.
    pub overlay: Option<Overlay>,
    /// The line that is being typed.
    pub prompt: Option<Prompt>,
    /// What is said at the bottom until the next key.
    pub message: Option<Message>,
    /// What is warned of until it is dismissed; a message hides it.
    pub warning: Option<Message>,
    /// Whether only ASCII characters are drawn.
    pub is_ascii: bool,
    /// How numbers are shown.
    pub numbers: Numbers,
    /// What the viewer speaks.
    pub language: Language,
    /// What is shown, in other arithmetics, once somebody asked for it.
    pub others: Vec<Log>,
    /// What the last change of the scene has changed here.
    pub changed: Changed,
    /// What was before it, while it is to be shown beside what is now.
    pub before: Option<Log>,
    /// Breakpoints, the search, bookmarks and other navigation.
    pub guide: Guide,
    /// Lists that explain, and the quiz.
    pub understanding: Understanding,
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
        top: usize,
    },
    /// A list of places and figures.
    List {
        /// Of what.
        kind: list::Kind,
        /// The selected entry.
        selected: usize,
        /// By how many columns it is scrolled to the right.
        shift: usize,
    },
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
            side: Pane::Computation,
            is_alone: false,
            shift: 0,
            picture: None,
            drawing: None,
            schematic: SchematicView::default(),
            pending: Pending::default(),
            overlay: None,
            prompt: None,
            message: None,
            warning: None,
            is_ascii: false,
            numbers: Numbers::default(),
            language: Language::default(),
            others: Vec::new(),
            changed: Changed::default(),
            before: None,
            guide: Guide::default(),
            understanding: Understanding::default(),
        };
        model.go_to_event(0);
        model
    }

    /// Goes to an event and shows its node. The last event stands for those beyond it.
    pub fn go_to_event(&mut self, event: usize) {
        self.event = event.min(self.log.events.len().saturating_sub(1));
        self.cursor = self.tree.owner(self.event);
        self.grow();
        self.fold.reveal(&self.tree, self.cursor);
    }

    /// Shows the tree as far as the current event, if it grows.
    pub fn grow(&mut self) {
        if let Some(grown) = &mut self.guide.grown {
            *grown = self.event;
            // Nodes are in the order in which they begin.
            let begun = self.tree.nodes().partition_point(|node| node.events.start <= self.event);
            self.fold.visible.end_before(begun);
        }
    }

    /// Goes to a visible node, and to its first event.
    pub fn go_to_node(&mut self, node: usize) {
        self.cursor = node;
        self.event = self.tree.nodes()[node].events.start.min(self.log.events.len().saturating_sub(1));
    }

    /// The pixel that an event is of, in the log of a region.
    pub fn pixel_of(&self, event: usize) -> Option<[u32; 2]> {
        let Subject::Region(_) = self.log.header.subject else { return None };
        self.tree.pixel_around(self.tree.owner(event))
    }

    /// An event of the log that is shown, so that one can go back to it.
    pub fn spot(&self, event: usize) -> Spot {
        Spot { pixel: self.pixel(), event, place: Place::of(&self.log, &self.tree, event) }
    }

    /// The number of the current step, from 1; 0 in a log without events.
    pub fn step(&self) -> usize {
        if self.log.events.is_empty() { 0 } else { self.event + 1 }
    }

    /// Says something until the next key. A warning that nobody dismissed comes back after it.
    pub fn say(&mut self, text: &str) {
        self.message = Some(Message { text: text.to_owned(), is_warning: false });
    }

    /// Says something until it is dismissed.
    pub fn warn(&mut self, text: &str) {
        self.warning = Some(Message { text: text.to_owned(), is_warning: true });
    }

    /// Where the panes lie on a screen of this many columns and rows.
    pub fn layout(&self, size: (u16, u16)) -> Layout {
        Layout::of(&Arrangement {
            size,
            focus: self.focus,
            side: self.side,
            is_alone: self.is_alone,
            shift: self.shift,
            has_picture: self.picture.is_some(),
        })
    }

    /// Lets the keys move in this pane.
    pub fn focus_on(&mut self, pane: Pane) {
        self.focus = pane;
        if pane != Pane::Tree {
            self.side = pane;
        }
    }

    /// The rows of a page.
    pub fn page(&self) -> usize {
        self.layout(self.size).page(self.focus)
    }

    /// The pixel that is shown.
    pub fn pixel(&self) -> Option<[u32; 2]> {
        match self.log.header.subject {
            Subject::Pixel(pixel) => Some(pixel),
            Subject::Ray(_) | Subject::Region(_) => None,
        }
    }

    /// The events of the selected node itself, in order, and the nodes inside it, where they are between them.
    pub fn items(&self) -> Vec<Item> {
        let begins_at = |item: &Item| match *item {
            Item::Event(event) => event,
            Item::Node(node) => self.tree.nodes()[node].events.start,
        };
        self.tree.items(self.cursor).take_while(|item| self.guide.is_known(begins_at(item))).collect()
    }
}
