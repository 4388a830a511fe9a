//! What the viewer can ask of a scene that is traced while one looks, and how it shows the answers. A saved log has nobody to ask.

use super::effect::{Change, Effect};
use super::model::changed::Changed;
use super::model::drawing::Drawing;
use super::model::facts::Facts;
use super::model::fold::Fold;
use super::model::guide::{Note, Notes};
use super::model::layout::Layout;
use super::model::list::Kind;
use super::model::picture::{Image, PictureView, Wanted};
use super::model::{Model, Pane};
use super::{bookmarks, breakpoints, jumps, plane, prompt, quiz, search, understanding, watch};
use crate::files::suggest;
use crate::log::plane::Plane;
use crate::log::tree::Place;
use crate::log::{Log, Subject, Tree};
use crate::report::Style;
use crate::report::causes::Study;
use crate::report::language::Language;
use crate::report::paper::Paper;
use crate::report::words::plain;
use std::mem;
use std::path::PathBuf;
use std::sync::Arc;

/// Traces the scene that the viewer shows.
pub trait Live {
    /// The log of another pixel, in the viewer's arithmetic.
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal>;

    /// The picture as far as it is there, if there is more of it than when it was asked for last; waits for what is wanted.
    fn picture(&mut self, _wanted: Wanted) -> Option<Arc<Image>> {
        None
    }

    /// Has the picture rendered anew with what of the pixels has a name.
    fn show(&mut self, _plane: &Plane) -> Result<(), Refusal> {
        Err(Refusal::NoScene)
    }

    /// The scene as lines.
    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        None
    }

    /// The logs of the same pixel or ray in other arithmetics: by hand, in single precision, in f64 with the digits that can
    /// be trusted.
    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, Refusal>;

    /// Changes the scene, and traces what is shown of it.
    fn change(&mut self, _change: &Change, _subject: Subject) -> Result<Log, Refusal> {
        Err(Refusal::NoScene)
    }

    /// The log of the scene before its last change.
    fn before(&mut self, _subject: Subject) -> Result<Log, Refusal> {
        Err(Refusal::NothingChanged)
    }

    /// Whether the scene has files that may change.
    fn is_watching(&self) -> bool {
        false
    }

    /// The log of the scene if its files have changed since they were read; why it can't be read, if it can't.
    fn reload(&mut self, _subject: Subject) -> Option<Result<Log, Refusal>> {
        None
    }

    /// The paths of the scene's parameters that begin so, with their values.
    fn parameters(&mut self, _beginning: &str) -> Vec<(String, String)> {
        Vec::new()
    }

    /// Saves the scene.
    fn save(&mut self, _path: &str) -> Result<(), Refusal> {
        Err(Refusal::NoScene)
    }

    /// Saves what the viewer made under this name.
    fn write(&mut self, _path: &str, _text: &str) -> Result<(), Refusal> {
        Err(Refusal::NoScene)
    }

    /// Saves a log in the format of the ending of a name.
    fn export(&mut self, _log: &Log, _path: &str, _language: Language, _numbers: Style) -> Result<(), Refusal> {
        Err(Refusal::NoScene)
    }

    /// The files and folders whose paths begin so; those of folders end with `/`.
    fn files(&mut self, _beginning: &str) -> Vec<String> {
        Vec::new()
    }

    /// The notes that are kept for a log.
    fn notes(&mut self, _log: &Log) -> Result<Option<Notes>, Refusal> {
        Ok(None)
    }

    /// Keeps the notes of a log. Gives the name of the file that has them, or had them where there are none left.
    fn keep(&mut self, _log: &Log, _notes: &[Note]) -> Result<String, Refusal> {
        Err(Refusal::OnlyOfLogs)
    }

    /// The file of the scene, and the line where it has an object, from 1.
    fn source(&mut self, _object: Option<u32>) -> Option<(PathBuf, usize)> {
        None
    }

    /// Which rounding caused the error of the result of the same pixel or ray: in this arithmetic; else in the viewer's, or by hand if that
    /// rounds nothing.
    fn study(&mut self, _subject: Subject, _arithmetic: Option<&str>) -> Result<Study, Refusal> {
        Err(Refusal::NoScene)
    }

    /// The worked example that this pixel of the scene is.
    fn book(&mut self, _subject: Subject) -> Result<Paper, Refusal> {
        Err(Refusal::NoExample)
    }
}

/// Why there is no log.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A saved log can't be traced.
    NoScene,
    /// The book prints numbers for one pixel only.
    OnePixelPrinted,
    /// A region has too many values to be compared.
    RegionsNotCompared,
    /// No book has this pixel as its example.
    NoExample,
    /// It has more quantities than this, too many to study the rounding of each.
    TooManyQuantities(usize),
    /// What can be studied are roundings to decimals or to single precision.
    RoundsNothing,
    /// It would have more events than this.
    TooLong(usize),
    /// There is no memory for it.
    NoMemory,
    /// The scene is as it was read.
    NothingChanged,
    /// No path was typed.
    NoPath,
    /// A path leads nowhere; what is there instead.
    NoParameter(String, Vec<String>),
    /// Results go to files only.
    NoFile,
    /// A name ends otherwise than one of these.
    Ending(&'static [&'static str]),
    /// Only notes of saved logs are kept.
    OnlyOfLogs,
    /// A file isn't one of the viewer's notes.
    NotOurs(String),
    /// A file has been changed by another program.
    ChangedMeanwhile(String),
    /// The scene has no such light; those it has.
    NoLight(String, Vec<String>),
    /// No path is of the class; the classes there can be.
    NoClass(String, Vec<String>),
    /// Another reason, in the words of who has it.
    Other(String),
}

impl Refusal {
    /// What to say.
    pub fn text(&self, language: Language) -> String {
        let messages = &language.texts().viewer.messages;
        match self {
            Refusal::NoScene => messages.no_scene.to_owned(),
            Refusal::OnePixelPrinted => messages.one_pixel_printed.to_owned(),
            Refusal::RegionsNotCompared => messages.regions_not_compared.to_owned(),
            Refusal::NoExample => messages.no_example.to_owned(),
            Refusal::TooManyQuantities(most) => (messages.too_many_quantities)(*most),
            Refusal::RoundsNothing => messages.rounds_nothing.to_owned(),
            Refusal::TooLong(most) => (messages.too_long)(*most),
            Refusal::NoMemory => messages.no_memory.to_owned(),
            Refusal::NothingChanged => messages.nothing_changed.to_owned(),
            Refusal::NoPath => messages.no_path.to_owned(),
            Refusal::NoParameter(path, known) => (messages.no_parameter)(&plain(path), &plain(&known.join(", "))),
            Refusal::NoFile => messages.no_file.to_owned(),
            Refusal::Ending(known) => (messages.expected_ending)(&known.join(" ")),
            Refusal::OnlyOfLogs => messages.only_of_logs.to_owned(),
            Refusal::NotOurs(path) => (messages.not_ours)(&plain(path)),
            Refusal::ChangedMeanwhile(path) => (messages.changed_meanwhile)(&plain(path)),
            Refusal::NoLight(name, known) => {
                let near = suggest(name, known.iter().map(String::as_str)).unwrap_or_default();
                (messages.no_light)(&plain(name), &plain(near), &plain(&known.join(", ")))
            }
            Refusal::NoClass(class, known) => (messages.no_class)(&plain(class), &plain(&known.join(", "))),
            Refusal::Other(why) => why.clone(),
        }
    }
}

/// Has somebody do what is left to do outside the model, as far as it concerns the scene.
pub(super) fn answer(model: &mut Model, effect: Effect, live: &mut Option<&mut dyn Live>) {
    let asked = match (effect, live) {
        // The terminal is needed for these.
        (Effect::None | Effect::Leave(_) | Effect::Suspend | Effect::Copy(_) | Effect::Edit(_), _)
        | (Effect::Screenshot(_), _) => return,
        (Effect::Keep, live) => {
            let notes = bookmarks::notes(model);
            let kept = live.as_mut().ok_or(Refusal::OnlyOfLogs).and_then(|live| live.keep(&model.log, &notes));
            bookmarks::kept(model, kept.map_err(|why| why.text(model.language)));
            return;
        }
        (_, None) => Err(Refusal::NoScene),
        (Effect::Trace(pixel), Some(live)) => live.trace(pixel).map(|log| show_log(model, log)),
        (Effect::Revisit(pixel, spot), Some(live)) => live.trace(pixel).map(|log| {
            show_log(model, log);
            jumps::arrive(model, &spot);
        }),
        (Effect::Compare, Some(live)) => live.compare(model.log.header.subject).map(|logs| {
            model.others = logs;
            understanding::open(model, Kind::Arithmetics);
        }),
        (Effect::Change(change), Some(live)) => live.change(&change, model.log.header.subject).map(|log| {
            let said = show_changed(model, log);
            model.say(&said);
        }),
        (Effect::Beside, Some(live)) => live.before(model.log.header.subject).map(|log| model.before = Some(log)),
        (Effect::Save(path), Some(live)) => {
            live.save(&path).map(|()| model.say(&(model.texts().messages.saved)(&plain(&path))))
        }
        (Effect::Export(path), Some(live)) => {
            let written = live.export(&model.log, &path, model.language, model.numbers);
            written.map(|()| model.say(&(model.texts().messages.written)(&plain(&path))))
        }
        (Effect::Picture(plane), Some(live)) => live.show(&plane).map(|()| {
            look(model, &mut Some(&mut **live), Wanted::Latest);
            plane::is_shown(model);
        }),
        (Effect::Complete, Some(live)) => {
            if prompt::is_of_file(model) {
                prompt::complete_file(model, |beginning| live.files(beginning));
            } else {
                prompt::complete_path(model, |beginning| live.parameters(beginning));
            }
            Ok(())
        }
        (Effect::Study(arithmetic), Some(live)) => {
            live.study(model.log.header.subject, arithmetic.as_deref()).map(|study| {
                model.understanding.study = Some(Arc::new(study));
                understanding::open(model, Kind::Causes);
            })
        }
        (Effect::Book, Some(live)) => live.book(model.log.header.subject).map(|book| {
            model.understanding.book = Some(Arc::new(book));
            understanding::open(model, Kind::Book);
        }),
    };
    if let Err(why) = asked {
        model.say(&why.text(model.language));
    }
}

/// Takes the notes that are kept for the log.
pub(super) fn take_notes(model: &mut Model, live: &mut Option<&mut dyn Live>) {
    match live.as_mut().map_or(Ok(None), |live| live.notes(&model.log)) {
        Ok(Some(notes)) => bookmarks::take(model, notes),
        Ok(None) => {}
        Err(why) => model.say(&plain(&why.text(model.language))),
    }
}

/// Looks whether the files of the scene have changed, and shows it anew if they have.
pub(super) fn reload(model: &mut Model, live: &mut Option<&mut dyn Live>) {
    match live.as_mut().and_then(|live| live.reload(model.log.header.subject)) {
        None => {}
        Some(Ok(log)) => {
            let said = show_changed(model, log);
            model.say(&(model.texts().messages.reloaded)(&said));
        }
        Some(Err(why)) => model.say(&(model.texts().messages.not_reloaded)(&why.text(model.language))),
    }
}

/// Shows the log of the scene after a change, and marks what has changed. Gives what to say of it.
fn show_changed(model: &mut Model, log: Log) -> String {
    let before = model.log.clone();
    show_log(model, log);
    let numbers = Style::of(&model.log.header, model.numbers.digits);
    if numbers != model.numbers {
        model.numbers = numbers;
        breakpoints::renew(model);
    }
    // The picture and the lines are those of the scene before.
    model.drawing = None;
    if let Some(view) = &mut model.picture {
        view.is_finished = false;
    }
    model.changed = Changed::between(before, &model.log, &model.tree);
    match &model.changed {
        Changed { count: 0, .. } => model.texts().messages.no_value_differs.to_owned(),
        Changed { count, first, .. } => (model.texts().messages.values_differ)(*count, &plain(first)),
    }
}

/// Waits for what is seen of the picture.
pub(super) fn look_at_what_is_seen(model: &mut Model, live: &mut Option<&mut dyn Live>) {
    let dots = Layout::dots(model.layout(model.size).area(Pane::Picture));
    let Some(view) = model.picture.as_ref().filter(|_| !dots.is_empty()) else { return };
    let seen = view.seen([dots.width.into(), 2 * u32::from(dots.height)]);
    look(model, live, seen);
    if let Some(view) = &mut model.picture {
        view.is_finished = true;
    }
}

/// Looks whether there is more of the picture, and waits for what is wanted.
pub(super) fn look(model: &mut Model, live: &mut Option<&mut dyn Live>, wanted: Wanted) {
    let Some(image) = live.as_mut().and_then(|live| live.picture(wanted)) else { return };
    if let (None, Some(live)) = (&model.drawing, live) {
        model.drawing = live.drawing();
    }
    match &mut model.picture {
        Some(view) => view.show(image),
        None => {
            let middle = image.size.map(|side| side / 2);
            model.picture = Some(PictureView::new(image, model.pixel().unwrap_or(middle)));
        }
    }
}

/// Shows another log of the same scene, at the same place as far as the trees agree.
pub fn show_log(model: &mut Model, log: Log) {
    let place = Place::of(&model.log, &model.tree, model.event);
    model.tree = Tree::of(&log.events);
    model.facts = Facts::of(&log, &model.tree);
    let left = model.pixel();
    model.log = log;
    let fold = mem::replace(&mut model.fold, Fold::of(&model.tree));
    model.guide.folds.keep(left, fold);
    model.guide.folds.restore(model.pixel(), &mut model.fold);
    model.others.clear();
    model.changed = Changed::default();
    // A quiz goes on; what was opened was of the other log.
    (model.understanding.listing, model.understanding.study, model.understanding.book) = (None, None, None);
    let (Ok(event) | Err(event)) = place.find(&model.log, &model.tree);
    model.go_to_event(event);
    if let (Some(view), Subject::Pixel(pixel)) = (&mut model.picture, model.log.header.subject) {
        view.cursor = pixel;
    }
    model.guide.pace.is_playing = false;
    bookmarks::renew(model);
    breakpoints::renew(model);
    watch::renew(model);
    quiz::renew(model);
    search::renew(model);
    // The other tree may be smaller than what was scrolled past.
    let top = model.top.min(model.tree.nodes().len() - 1);
    model.top = model.fold.scrolled(&model.tree, top, model.cursor, model.page());
}
