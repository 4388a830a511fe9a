//! Navigation in a log: stepping, breakpoints, playing, searching, bookmarks, copying, the mouse.
//!
//! Each has a file of its own; here they are held together, so that the model and its update know only this one type.

use super::bookmarks::{self, Bookmark};
use super::breakpoints::Breakpoint;
use super::fold::Folds;
use super::history::History;
use super::jumps::{self, Jumps};
use super::model::{Model, Overlay};
use super::play::{self, Pace};
use super::prompt::{Prompt, Purpose};
use super::run::{self, Stopped};
use super::search::{self, Search};
use super::steps::{self, Step};
use super::update::Effect;
use super::{breakpoints, copy, list, mouse};

/// What the user has set to find the way.
#[derive(Clone, Debug, Default)]
pub struct Guide {
    /// Where to stop.
    pub breakpoints: Vec<Breakpoint>,
    /// Where runs have stopped, the latest last.
    pub stops: Vec<Stopped>,
    /// How fast it plays, and whether.
    pub pace: Pace,
    /// While the tree grows: the event up to which it has.
    pub grown: Option<usize>,
    /// What is searched.
    pub search: Option<Search>,
    /// What the rows of the tree must match.
    pub filter: Option<String>,
    /// The places to come back to.
    pub bookmarks: Vec<Bookmark>,
    /// Where jumps began.
    pub jumps: Jumps,
    /// What was open in the trees of other pixels.
    pub folds: Folds,
    /// The lines that were typed.
    pub history: History,
    /// Whether the mouse selects and scrolls.
    pub has_mouse: bool,
    /// What the rows of the help must contain.
    pub help: String,
}

/// What is done to find the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Walk {
    /// Step by the nesting of the nodes.
    Step(Step),
    FirstStep,
    LastStep,
    Break,
    ToggleBreak,
    Breakpoints,
    Run,
    RunBack,
    Stops,
    Play,
    Faster,
    Slower,
    /// It is time for the next step while playing.
    Tick,
    Grow,
    NextMatch,
    PreviousMatch,
    Filter,
    /// Set the bookmark with this letter.
    Mark(char),
    /// Go to the bookmark with this letter; to before the last jump with `'`.
    GoTo(char),
    Marks,
    CopyValue,
    CopyPath,
    Command,
    Mouse,
    /// A click into this column and row.
    Click(u16, u16),
    /// The wheel was turned by this many rows, at this column and row.
    Wheel(i16, u16, u16),
    /// Delete the selected entry of a list.
    Delete,
}

/// Does it; `count` is the number typed before.
pub(super) fn update(model: &mut Model, walk: Walk, count: Option<u32>) -> Effect {
    let times = count.unwrap_or(1) as usize;
    match walk {
        Walk::Step(step) => steps::go(model, step, times),
        Walk::FirstStep => jump(model, 0),
        Walk::LastStep => jump(model, usize::MAX),
        Walk::Break => model.prompt = Some(Prompt::new(Purpose::Break)),
        Walk::ToggleBreak => breakpoints::toggle_here(model),
        Walk::Breakpoints => list::open(model, list::Kind::Breakpoints),
        Walk::Run => run::run(model, true, times),
        Walk::RunBack => run::run(model, false, times),
        Walk::Stops => run::open(model),
        Walk::Play => play::toggle(model),
        Walk::Faster => play::change(model, |rate| rate * 2),
        Walk::Slower => play::change(model, |rate| rate / 2),
        Walk::Grow => toggle_growing(model),
        Walk::NextMatch => search::go(model, true, times),
        Walk::PreviousMatch => search::go(model, false, times),
        Walk::Filter => {
            // It begins empty, as nothing typed shows all; the filter that is on is the first that `Up` brings.
            let filter = model.guide.filter.as_deref().unwrap_or_default();
            model.guide.history.remember(Purpose::Filter, filter);
            model.prompt = Some(Prompt::new(Purpose::Filter));
        }
        Walk::Mark(letter) => bookmarks::set(model, letter),
        Walk::GoTo('\'') => return jumps::over(model),
        Walk::GoTo(letter) => bookmarks::go(model, letter),
        Walk::Marks => list::open(model, list::Kind::Bookmarks),
        Walk::CopyValue => return copy::value(model),
        Walk::CopyPath => return copy::path(model),
        Walk::Command => model.prompt = Some(Prompt::new(Purpose::Command)),
        Walk::Mouse => mouse::toggle(model),
        Walk::Click(x, y) => return mouse::click(model, x, y),
        Walk::Wheel(rows, x, y) => return mouse::wheel(model, rows, x, y),
        Walk::Tick | Walk::Delete => {}
    }
    Effect::None
}

/// Goes far, to an event that `''` and `^o` come back from.
pub(super) fn jump(model: &mut Model, event: usize) {
    jumps::remember(model);
    model.go_to_event(event);
}

/// The next step of playing.
pub(super) fn tick(model: &mut Model) {
    play::tick(model);
}

/// Ends the latest of what can be ended: the message, playing, the search, the filter.
pub(super) fn close(model: &mut Model) {
    if model.message.take().is_some() {
    } else if model.guide.pace.is_playing {
        model.guide.pace.is_playing = false;
    } else if model.guide.search.take().is_none() {
        search::show_all(model);
    }
}

/// Opens the help, with all its rows.
pub(super) fn open_help(model: &mut Model) {
    model.guide.help.clear();
    model.overlay = Some(Overlay::Help { top: 0 });
}

/// Lets the tree grow with the steps, or shows all of it.
fn toggle_growing(model: &mut Model) {
    if model.guide.grown.take().is_some() {
        model.fold.visible.end_before(usize::MAX);
        model.say(model.texts().messages.whole_tree);
    } else {
        model.guide.grown = Some(model.event);
        grow(model);
        model.say(model.texts().messages.tree_grows);
    }
}

/// Shows the tree as far as the current event, if it grows.
pub(super) fn grow(model: &mut Model) {
    let event = model.event;
    if let Some(grown) = &mut model.guide.grown {
        *grown = event;
        // Nodes are in the order in which they begin.
        model.fold.visible.end_before(model.tree.nodes().partition_point(|node| node.events.start <= event));
    }
}

/// Finds in another log what was set in the one before.
pub(super) fn renew(model: &mut Model) {
    model.guide.pace.is_playing = false;
    bookmarks::renew(model);
    search::renew(model);
}

impl Guide {
    /// Whether an event has happened, as far as one may see.
    pub fn is_known(&self, event: usize) -> bool {
        self.grown.is_none_or(|grown| event <= grown)
    }
}

/// The modes that are on, in words for the bottom line.
pub fn modes(model: &Model) -> Vec<String> {
    let (guide, status) = (&model.guide, &model.texts().status);
    let search = guide.search.as_ref().map(|search| search.place(model.event, status));
    let modes = [
        play::words(guide.pace, status),
        guide.grown.map(|_| status.growing.to_owned()),
        search,
        guide.filter.as_ref().map(|_| status.filtered.to_owned()),
        guide.has_mouse.then(|| status.mouse.to_owned()),
    ];
    modes.into_iter().flatten().collect()
}
