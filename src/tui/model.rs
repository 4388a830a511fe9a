//! The state of the viewer: the log, the place in it, and what of it is shown. It draws nothing and reads no keys.

use super::drawing::{Drawing, Projection};
use super::facts::Facts;
use super::fold::Fold;
use super::guide::{self, Guide};
use super::jumps;
use super::layout::{Arrangement, Layout};
use super::list;
use super::live::{Live, Refusal};
use super::picture::PictureView;
use super::prompt::Prompt;
use super::understanding::{self, Understanding};
use super::update::Effect;
use crate::log::tree::{Item, Place};
use crate::log::{Log, Subject, Tree};
use crate::report::Style as Numbers;
use crate::report::language::Language;
use std::mem;
use std::sync::Arc;

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
    /// From where the schematic is seen.
    pub projection: Projection,
    /// How often the schematic is enlarged twofold.
    pub magnification: u32,
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
    /// What the viewer speaks.
    pub language: Language,
    /// What is shown, in other arithmetics, once somebody asked for it.
    pub others: Vec<Log>,
    /// Breakpoints, the search, bookmarks and other navigation.
    pub guide: Guide,
    /// Lists that explain, and the quiz.
    pub understanding: Understanding,
}

/// A pane, in the order of `Tab`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pane {
    /// The picture.
    Picture,
    /// The ray tree.
    Tree,
    /// The computation of the selected node.
    Computation,
    /// The algorithm as the source text writes it.
    Code,
    /// The scene with the rays in it.
    Schematic,
}

impl Pane {
    /// All panes.
    pub const ALL: [Pane; 5] = [Pane::Picture, Pane::Tree, Pane::Computation, Pane::Code, Pane::Schematic];
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
            side: Pane::Computation,
            is_alone: false,
            shift: 0,
            picture: None,
            drawing: None,
            projection: Projection::Top,
            magnification: 0,
            pending: Pending::default(),
            overlay: None,
            prompt: None,
            message: None,
            numbers: Numbers::default(),
            language: Language::default(),
            others: Vec::new(),
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
        guide::grow(self);
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
            (Effect::None | Effect::Leave(_) | Effect::Suspend | Effect::Copy(_), _) => return,
            (_, None) => Err(Refusal::NoScene),
            (Effect::Trace(pixel), Some(live)) => live.trace(pixel).map(|log| self.show(log)),
            (Effect::Revisit(pixel, spot), Some(live)) => live.trace(pixel).map(|log| {
                self.show(log);
                jumps::arrive(self, &spot);
            }),
            (Effect::Compare, Some(live)) => live.compare(self.log.header.subject).map(|logs| {
                self.others = logs;
                understanding::open(self, list::Kind::Arithmetics);
            }),
        };
        if let Err(why) = asked {
            self.say(&why.text(self.language));
        }
    }

    /// Looks whether there is more of the picture; `whole` waits for all of it.
    pub fn look(&mut self, live: &mut Option<&mut dyn Live>, whole: bool) {
        let Some(image) = live.as_mut().and_then(|live| live.picture(whole)) else { return };
        if let (None, Some(live)) = (&self.drawing, live) {
            self.drawing = live.drawing();
        }
        match &mut self.picture {
            Some(view) => view.show(image),
            None => {
                let middle = image.size.map(|side| side / 2);
                self.picture = Some(PictureView::new(image, self.pixel().unwrap_or(middle)));
            }
        }
    }

    /// Shows another log of the same scene, at the same place as far as the trees agree.
    pub fn show(&mut self, log: Log) {
        let place = Place::of(&self.log, &self.tree, self.event);
        self.tree = Tree::of(&log.events);
        self.facts = Facts::of(&log, &self.tree);
        let left = self.pixel();
        self.log = log;
        let fold = mem::replace(&mut self.fold, Fold::of(&self.tree));
        self.guide.folds.keep(left, fold);
        self.guide.folds.restore(self.pixel(), &mut self.fold);
        self.others.clear();
        // A quiz goes on; what was opened was of the other log.
        self.understanding.listing = None;
        let (Ok(event) | Err(event)) = place.find(&self.log, &self.tree);
        self.go_to_event(event);
        if let (Some(view), Subject::Pixel(pixel)) = (&mut self.picture, self.log.header.subject) {
            view.cursor = pixel;
        }
        guide::renew(self);
        // The other tree may be smaller than what was scrolled past.
        let top = self.top.min(self.tree.nodes().len() - 1);
        self.top = self.fold.scrolled(&self.tree, top, self.cursor, self.page());
    }

    /// The pixel that an event is of, in the log of a region.
    pub fn pixel_of(&self, event: usize) -> Option<[u32; 2]> {
        let Subject::Region(_) = self.log.header.subject else { return None };
        self.tree.pixel_around(self.tree.owner(event))
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
