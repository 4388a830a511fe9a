//! The viewer: steps through a log in the terminal.
//!
//! A key becomes an [`Action`] (`keys`), an action changes the [`Model`] (`update`), and the model is drawn
//! (`view`). Of these only the loop below and `terminal` know that there is a terminal, so that all the rest is
//! tested without one. The module knows logs and reports; it computes no geometry and needs no scene.
//!
//! At the bottom is the state, in `model`; the files beside this one change it, one a concern, and `update` is above them.

mod account;
pub mod beside;
mod bookmarks;
mod breakpoints;
mod command;
mod copy;
mod drawn;
pub mod dump;
mod edit;
mod effect;
mod eval;
mod glossary;
mod jumps;
pub mod keys;
mod list;
mod listing;
mod live;
mod model;
mod mouse;
mod panes;
mod paper;
mod plane;
mod play;
mod prompt;
mod quiz;
mod rows;
mod run;
pub mod screenshot;
mod search;
mod steps;
mod still;
mod terminal;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_picture;
#[cfg(test)]
mod tests_schematic;
#[cfg(test)]
mod tests_understanding;
mod text;
pub mod theme;
mod understanding;
mod update;
mod view;
mod walk;
mod watch;

pub use command::check as check_command;
pub use effect::{Change, Effect, Exit};
pub use keys::{Action, Walk};
pub use live::{Live, Refusal, show_log};
pub use model::bindings::{Bindings, Chord};
pub use model::drawing::{Drawing, PlaceOf, Projection, Wireframe};
pub use model::guide::{Guide, MAX_NOTE_LENGTH, MAX_NOTES, Note, Notes, Spelt};
pub use model::jumps::Spot;
pub use model::list::{Entry, Kind, Listing};
pub use model::picture::{COARSEST, Dot, Image, Layer, Levels, Named, PictureView, Shows, Wanted};
pub use model::prompt::{Message, Prompt, Purpose};
pub use model::schematic::{SchematicView, Shown};
pub use model::understanding::{Quiz, Understanding};
pub use model::{Model, Overlay, Pane, Pending};
pub use theme::{Background, Palette, Theme};
pub use update::update;

use crate::log::{Log, Subject, Tree};
use crate::report::diff::{Rows, Tolerance};
use crate::report::language::Language;
use crate::report::side_by_side::Run;
use crate::report::{Style as Numbers, words};
use beside::Beside;
use keys::Typed;
use model::changed::renumber;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::io;
use std::time::Duration;
use terminal::{Asker, Input, Terminal};

/// How the viewer starts.
#[derive(Clone, Debug)]
pub struct Options {
    /// How it looks.
    pub theme: Theme,
    /// The step to begin at, from 1 (`--at`).
    pub start: Option<usize>,
    /// What to warn of until it is dismissed, such as a log that was cut off.
    pub warning: Option<String>,
    /// The message until the first key.
    pub note: Option<String>,
    /// How numbers are shown.
    pub numbers: Numbers,
    /// Its language at first.
    pub language: Language,
    /// What it reacts to.
    pub controls: Controls,
}

/// What the viewer reacts to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// The keys that the user has bound.
    pub bindings: Bindings,
    /// Whether the mouse selects and scrolls at first.
    pub has_mouse: bool,
}

/// How the viewer ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Why it was left.
    pub exit: Exit,
    /// Where it was left.
    pub position: Position,
    /// Its language at the end.
    pub language: Language,
    /// How numbers were shown at the end.
    pub numbers: Numbers,
}

/// A place in a log that a link can lead back to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// The pixel, unless the log is that of a ray.
    pub pixel: Option<[u32; 2]>,
    /// The number of the event in its pixel, of a region in the whole log; 0 in a log without events.
    pub at: u32,
}

/// Shows a log until the viewer is left; `live` traces the scene, if there is one. The terminal is restored whatever happens.
pub fn run(log: Log, options: Options, mut live: Option<&mut dyn Live>) -> io::Result<Outcome> {
    let theme = options.theme;
    let mut model = opened(log, &options);
    live::take_notes(&mut model, &mut live);
    live::look(&mut model, &mut live, Wanted::Latest);
    let mut terminal = Terminal::enter()?;
    let exit = show(&mut model, &mut terminal, &mut live, &theme).or_else(|error| terminal.left_by(error))?;
    Ok(Outcome { exit, position: position(&model), language: model.language, numbers: model.numbers })
}

/// How often the files of the scene are looked at.
const LOOKS: Duration = Duration::from_millis(500);

/// Draws and reacts until something asks to leave.
fn show(
    model: &mut Model,
    terminal: &mut Terminal,
    live: &mut Option<&mut dyn Live>,
    theme: &Theme,
) -> io::Result<Exit> {
    resized(model, terminal)?;
    loop {
        terminal.draw(|buffer| view::draw(model, theme, buffer))?;
        terminal.use_mouse(model.guide.has_mouse)?;
        let waits = model.picture.as_ref().is_some_and(|view| !view.is_finished) || search::is_looking(model);
        let looks = live.as_ref().is_some_and(|live| live.is_watching()).then_some(LOOKS);
        let mut input = Some(terminal.next(waits, play::interval(model).or(looks))?);
        while let Some(now) = input {
            if let Some(exit) = react(model, terminal, live, theme, now)? {
                return Ok(exit);
            }
            input = terminal.next_at_once()?;
        }
    }
}

/// The model of a log, at the place where the options want it.
pub fn opened(log: Log, options: &Options) -> Model {
    let mut model = Model::new(log);
    model.numbers = options.numbers;
    model.language = options.language;
    model.is_ascii = options.theme.is_ascii();
    model.guide.bindings = options.controls.bindings.clone();
    model.guide.has_mouse = options.controls.has_mouse;
    if let Some(note) = &options.note {
        model.say(note);
    }
    if let Some(warning) = &options.warning {
        model.warn(warning);
    }
    if let Some(step) = options.start {
        let count = model.log.events.len();
        model.go_to_event(step.saturating_sub(1));
        if step > count {
            model.say(&(model.texts().messages.last_step)(count));
        }
    }
    model
}

/// The screen of a model in a terminal of this size.
pub fn frame(model: &Model, width: u16, height: u16, theme: &Theme) -> Buffer {
    let mut buffer = Buffer::empty(Rect::new(0, 0, width, height));
    view::draw(model, theme, &mut buffer);
    buffer
}

/// The model of a log in a terminal of this size, after these keys (see [`keys::script`]).
pub fn opened_with_keys(
    log: Log,
    options: &Options,
    mut live: Option<&mut dyn Live>,
    keys: &str,
    (width, height): (u16, u16),
) -> Model {
    let mut model = opened(log, options);
    live::take_notes(&mut model, &mut live);
    live::look(&mut model, &mut live, Wanted::Latest);
    update(&mut model, Action::Resize(width, height));
    for typed in keys::script(keys) {
        let key = match typed {
            Typed::Key(key) => key,
            // Not before the first character of the line.
            Typed::Gap(key) if model.prompt.as_ref().is_some_and(|prompt| !prompt.line.value().is_empty()) => key,
            Typed::Gap(_) => continue,
        };
        if let Some(action) = keys::meant(&model, key) {
            let effect = update(&mut model, action);
            still::answer(&mut model, effect, &mut live, &options.theme);
        }
    }
    search::finish(&mut model);
    live::look_at_what_is_seen(&mut model, &mut live);
    model
}

/// The viewer as an SVG picture, after these keys.
pub fn picture(
    log: Log,
    options: &Options,
    live: Option<&mut dyn Live>,
    keys: &str,
    (width, height): (u16, u16),
) -> String {
    picture_as(screenshot::Form::Svg, log, options, live, keys, (width, height))
}

/// The viewer in one of the forms of pictures, after these keys.
pub fn picture_as(
    form: screenshot::Form,
    log: Log,
    options: &Options,
    live: Option<&mut dyn Live>,
    keys: &str,
    (width, height): (u16, u16),
) -> String {
    still::drawn(&opened_with_keys(log, options, live, keys, (width, height)), form, &options.theme)
}

fn react(
    model: &mut Model,
    terminal: &mut Terminal,
    live: &mut Option<&mut dyn Live>,
    theme: &Theme,
    input: Input,
) -> io::Result<Option<Exit>> {
    match input {
        Input::Leave(exit) => return Ok(Some(exit)),
        Input::Tick => {
            live::look(model, live, Wanted::Latest);
            search::look_on(model);
        }
        Input::Suspend => suspend(model, terminal, Asker::Signal)?,
        Input::Resume => come_back(model, terminal)?,
        Input::Size(width, height) => {
            update(model, Action::Resize(width, height));
        }
        Input::Beat if play::interval(model).is_some() => {
            update(model, Action::Walk(Walk::Tick));
            live::reload(model, live);
        }
        Input::Beat => live::reload(model, live),
        Input::Mouse(event) => {
            if let Some(action) = mouse::meant(model, event) {
                let asked = update(model, action);
                still::answer(model, asked, live, theme);
            }
        }
        Input::Paste(text) => prompt::pasted(model, &text),
        Input::Key(key) => {
            let effect = keys::meant(model, key).map(|action| update(model, action));
            match effect {
                Some(Effect::Leave(exit)) => return Ok(Some(exit)),
                Some(Effect::Suspend) => suspend(model, terminal, Asker::Key)?,
                Some(Effect::Copy(text)) => terminal.copy(&text)?,
                Some(Effect::Edit(object)) => edit(model, terminal, live, object)?,
                Some(asked) => {
                    if matches!(asked, Effect::Study(_)) && live.is_some() {
                        say_at_once(model, terminal, theme, model.texts().messages.studying)?;
                    }
                    still::answer(model, asked, live, theme);
                }
                None => {}
            }
            if let Some(before) = model.before.take() {
                return beside(model, terminal, before, theme);
            }
        }
    }
    Ok(None)
}

/// Shows a message while something is done that takes its time.
fn say_at_once(model: &mut Model, terminal: &mut Terminal, theme: &Theme, text: &str) -> io::Result<()> {
    model.say(text);
    terminal.draw(|buffer| view::draw(model, theme, buffer))?;
    model.message = None;
    Ok(())
}

/// Shows what was before the last change beside what is now, until that is left.
fn beside(model: &mut Model, terminal: &mut Terminal, mut before: Log, theme: &Theme) -> io::Result<Option<Exit>> {
    renumber(&mut before, &model.log);
    let tree = Tree::of(&before.events);
    let rows =
        Rows::of(Run { log: &before, tree: &tree }, Run { log: &model.log, tree: &model.tree }, Tolerance::default());
    let name = words::plain(&model.log.header.scene.name);
    let title = |which: &&str| format!("{name} - {which}");
    let [of_before, of_now] = model.texts().messages.before_and_now;
    let exit = beside::show(
        &mut Beside::new(rows, [title(&of_before), title(&of_now)]).with_keys(model.guide.bindings.clone()),
        terminal,
        theme,
    )?;
    resized(model, terminal)?;
    Ok(Some(exit).filter(|exit| *exit != Exit::Quit))
}

/// Lets the user edit the scene where it has an object, and shows what was changed.
fn edit(
    model: &mut Model,
    terminal: &mut Terminal,
    live: &mut Option<&mut dyn Live>,
    object: Option<u32>,
) -> io::Result<()> {
    let Some((path, line)) = live.as_mut().and_then(|live| live.source(object)) else {
        model.say(model.texts().messages.no_source);
        return Ok(());
    };
    let edited = terminal.edit(&path, line)?;
    resized(model, terminal)?;
    match edited {
        Ok(()) => live::reload(model, live),
        Err(why) => model.say(&(model.texts().messages.no_editor)(&words::plain(&why))),
    }
    Ok(())
}

fn suspend(model: &mut Model, terminal: &mut Terminal, asked_by: Asker) -> io::Result<()> {
    if !terminal.suspend(asked_by)? {
        model.say(model.texts().messages.no_shell);
    }
    resized(model, terminal)
}

fn come_back(model: &mut Model, terminal: &mut Terminal) -> io::Result<()> {
    terminal.resume()?;
    resized(model, terminal)
}

fn resized(model: &mut Model, terminal: &Terminal) -> io::Result<()> {
    let (width, height) = terminal.size()?;
    update(model, Action::Resize(width, height));
    Ok(())
}

fn position(model: &Model) -> Position {
    let pixel = model.tree.pixel_around(model.cursor).or(model.pixel());
    let at = match model.log.header.subject {
        // The numbers of events begin again at each pixel; a link counts through.
        Subject::Region(_) => model.step() as u32,
        _ => model.log.events.get(model.event).map_or(0, |event| event.at),
    };
    Position { pixel, at }
}
