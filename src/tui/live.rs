//! What the viewer can ask of a scene that is traced while one looks. A saved log has nobody to ask.

use super::drawing::Drawing;
use super::picture::Image;
use crate::log::{Log, Subject};
use crate::report::language::Language;
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
            Refusal::TooLong(most) => (messages.too_long)(*most),
            Refusal::NoMemory => messages.no_memory.to_owned(),
            Refusal::Other(why) => why.clone(),
        }
    }
}
