//! Which rays are drawn, in the schematic and over the picture, and from where.

use super::effect::Effect;
use super::keys::Action;
use super::model::drawing::Projection;
use super::model::schematic::Shown;
use super::model::{Model, Pane};
use crate::files::suggest;
use crate::report::words::plain;

/// The word for the side from which the rays spread most.
const AUTO: &str = "auto";

/// Does what an action means where the schematic or the picture is on the screen; `None` where it isn't.
pub(super) fn update(model: &mut Model, action: Action) -> Option<Effect> {
    let is_shown = |pane: Pane| !model.layout(model.size).area(pane).is_empty();
    match action {
        Action::Schematic if is_shown(Pane::Schematic) => model.schematic.shown = model.schematic.shown.next(),
        Action::ShadowRays if is_shown(Pane::Schematic) => toggle_shadows(model),
        Action::RaysOver if is_shown(Pane::Picture) => toggle_rays_over(model),
        _ => return None,
    }
    Some(Effect::None)
}

/// Draws shadow rays, or no longer; says so, since a pixel may have none.
pub(super) fn toggle_shadows(model: &mut Model) {
    model.schematic.has_shadows = !model.schematic.has_shadows;
    model.say(model.texts().messages.shadows[usize::from(model.schematic.has_shadows)]);
}

/// Draws the rays over the picture, or no longer.
fn toggle_rays_over(model: &mut Model) {
    model.schematic.is_over_picture = !model.schematic.is_over_picture;
    model.say(model.texts().messages.rays_over[usize::from(model.schematic.is_over_picture)]);
}

/// Draws the rays over the picture, or no longer, and shows it.
pub(super) fn rays_over(model: &mut Model) -> Result<(), String> {
    if model.picture.is_none() {
        return Err(model.texts().messages.no_picture.to_owned());
    }
    toggle_rays_over(model);
    if model.schematic.is_over_picture && model.layout(model.size).area(Pane::Picture).is_empty() {
        model.focus_on(Pane::Picture);
    }
    Ok(())
}

/// Goes to the schematic: to what this word says, or looks at it from there.
pub(super) fn schematic(model: &mut Model, word: &str) -> Result<(), String> {
    let shown = Shown::ALL.into_iter().zip(Shown::WORDS).find(|(_, known)| *known == word);
    let side = Projection::called(word);
    if side == Some(Projection::Camera) && model.drawing.is_none() {
        return Err(model.texts().messages.no_eye.to_owned());
    }
    let view = &mut model.schematic;
    match shown {
        Some((shown, _)) => view.shown = shown,
        None if side.is_some() || word == AUTO => {
            view.side = side;
            // The vectors have a plane of their own.
            view.shown = if view.shown == Shown::Vectors { Shown::default() } else { view.shown };
        }
        None if word.is_empty() => {}
        None => {
            let (texts, near) = (&model.texts().commands, suggest(word, words()));
            return Err((texts.unknown_schematic)(&plain(word), near, &words().join(", ")));
        }
    }
    model.focus_on(Pane::Schematic);
    Ok(())
}

/// The words behind `:schematic`.
pub(super) fn words() -> Vec<&'static str> {
    [Shown::WORDS.as_slice(), &Projection::WORDS, &[AUTO]].concat()
}
