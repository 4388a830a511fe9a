//! The viewer as a file, as it is now.

use super::dump;
use super::effect::Effect;
use super::live::{self, Live, Refusal};
use super::model::Model;
use super::screenshot::{self, Form};
use super::theme::Theme;
use super::view;
use crate::report::words::plain;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Has somebody do what is left to do outside the model, and takes a picture of it if that is it.
pub(super) fn answer(model: &mut Model, effect: Effect, live: &mut Option<&mut dyn Live>, theme: &Theme) {
    let Effect::Screenshot(path) = effect else { return live::answer(model, effect, live) };
    let taken = match (Form::of_name(&path), live) {
        (None, _) => Err(Refusal::Ending(&Form::ENDINGS)),
        (_, None) => Err(Refusal::NoScene),
        (Some(form), Some(live)) => live.write(&path, &drawn(model, form, theme)),
    };
    match taken {
        Ok(()) => model.say(&(model.texts().messages.written)(&plain(&path))),
        Err(why) => model.say(&plain(&why.text(model.language))),
    }
}

/// The frame of a model in this form.
pub(super) fn drawn(model: &Model, form: Form, theme: &Theme) -> String {
    let mut buffer = Buffer::empty(Rect::new(0, 0, model.size.0, model.size.1));
    view::draw(model, theme, &mut buffer);
    match form {
        Form::Svg => screenshot::svg(&buffer, theme.background),
        Form::Text => dump::text(&buffer),
    }
}
