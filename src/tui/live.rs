//! What the viewer can ask of a scene that is traced while one looks, and how it shows the answers. A saved log has nobody to ask.

use super::effect::Effect;
use super::model::Model;
use super::model::drawing::Drawing;
use super::model::facts::Facts;
use super::model::fold::Fold;
use super::model::list::Kind;
use super::model::picture::{Image, PictureView};
use super::{bookmarks, jumps, search, understanding};
use crate::log::tree::Place;
use crate::log::{Log, Subject, Tree};
use crate::report::causes::Study;
use crate::report::language::Language;
use crate::report::paper::Paper;
use std::mem;
use std::sync::Arc;

/// Traces the scene that the viewer shows.
pub trait Live {
    /// The log of another pixel, in the viewer's arithmetic.
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal>;

    /// The picture as far as it is there, if there is more of it than when it was asked for last; `whole` waits for all of it.
    fn picture(&mut self, _whole: bool) -> Option<Arc<Image>> {
        None
    }

    /// The scene as lines.
    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        None
    }

    /// The logs of the same pixel or ray in other arithmetics: by hand, in single precision, in f64 with the digits that can
    /// be trusted.
    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, Refusal>;

    /// Which rounding caused the error of the result of the same pixel or ray: in the viewer's arithmetic, or by hand if that rounds nothing.
    fn study(&mut self, _subject: Subject) -> Result<Study, Refusal> {
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
    /// It would have more events than this.
    TooLong(usize),
    /// There is no memory for it.
    NoMemory,
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
            Refusal::TooLong(most) => (messages.too_long)(*most),
            Refusal::NoMemory => messages.no_memory.to_owned(),
            Refusal::Other(why) => why.clone(),
        }
    }
}

/// Has somebody do what is left to do outside the model, as far as it concerns the scene.
pub(super) fn answer(model: &mut Model, effect: Effect, live: &mut Option<&mut dyn Live>) {
    let asked = match (effect, live) {
        (Effect::None | Effect::Leave(_) | Effect::Suspend | Effect::Copy(_), _) => return,
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
        (Effect::Study, Some(live)) => live.study(model.log.header.subject).map(|study| {
            model.understanding.study = Some(Arc::new(study));
            understanding::open(model, Kind::Causes);
        }),
        (Effect::Book, Some(live)) => live.book(model.log.header.subject).map(|book| {
            model.understanding.book = Some(Arc::new(book));
            understanding::open(model, Kind::Book);
        }),
    };
    if let Err(why) = asked {
        model.say(&why.text(model.language));
    }
}

/// Looks whether there is more of the picture; `whole` waits for all of it.
pub(super) fn look(model: &mut Model, live: &mut Option<&mut dyn Live>, whole: bool) {
    let Some(image) = live.as_mut().and_then(|live| live.picture(whole)) else { return };
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
    // A quiz goes on; what was opened was of the other log.
    (model.understanding.listing, model.understanding.study, model.understanding.book) = (None, None, None);
    let (Ok(event) | Err(event)) = place.find(&model.log, &model.tree);
    model.go_to_event(event);
    if let (Some(view), Subject::Pixel(pixel)) = (&mut model.picture, model.log.header.subject) {
        view.cursor = pixel;
    }
    model.guide.pace.is_playing = false;
    bookmarks::renew(model);
    search::renew(model);
    // The other tree may be smaller than what was scrolled past.
    let top = model.top.min(model.tree.nodes().len() - 1);
    model.top = model.fold.scrolled(&model.tree, top, model.cursor, model.page());
}
