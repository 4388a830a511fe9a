//! What each [`Walk`] does: the way through a log by steps, breakpoints, playing, searches, bookmarks and the mouse.

use super::effect::Effect;
use super::keys::Walk;
use super::model::list::Kind;
use super::model::prompt::{Prompt, Purpose};
use super::model::{Model, Overlay};
use super::steps::Step;
use super::{bookmarks, breakpoints, copy, edit, jumps, listing, mouse, plane, play, run, search, watch};

/// Does it; `count` is the number typed before.
pub(super) fn update(model: &mut Model, walk: Walk, count: Option<u32>) -> Effect {
    let times = count.unwrap_or(1) as usize;
    match walk {
        Walk::Step(step) => step_by(model, step, times),
        Walk::FirstStep => jumps::to_event(model, 0),
        Walk::LastStep => jumps::to_event(model, usize::MAX),
        Walk::Break => model.prompt = Some(Prompt::new(Purpose::Break)),
        Walk::ToggleBreak => breakpoints::toggle_here(model),
        Walk::Breakpoints => listing::open(model, Kind::Breakpoints),
        Walk::Run => run::run(model, true, times),
        Walk::RunBack => run::run(model, false, times),
        Walk::Stops => run::open(model),
        Walk::Watch => watch::toggle_here(model),
        Walk::History => {
            if let Err(why) = watch::open_history(model, "") {
                model.say(&why);
            }
        }
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
        Walk::Tests => toggle_tests(model),
        Walk::Mark(letter) => {
            return bookmarks::set(model, letter, "").unwrap_or_else(|why| {
                model.say(&why);
                Effect::None
            });
        }
        Walk::GoTo('\'') => return jumps::over(model),
        Walk::GoTo(letter) => bookmarks::go(model, letter),
        Walk::Marks => listing::open(model, Kind::Bookmarks),
        Walk::CopyValue => return copy::value(model),
        Walk::CopyPath => return copy::path(model),
        Walk::Command => model.prompt = Some(Prompt::new(Purpose::Command)),
        Walk::Mouse => mouse::toggle(model),
        Walk::Edit => return edit::object(model),
        Walk::Click(..) | Walk::Wheel(..) | Walk::Tick | Walk::Delete => {}
    }
    Effect::None
}

/// Steps so often, or as far as that goes.
fn step_by(model: &mut Model, step: Step, times: usize) {
    let way = std::iter::successors(Some(model.event), |event| step.from(&model.tree, *event));
    match way.skip(1).take(times).last() {
        Some(event) => model.go_to_event(event),
        None => model.say(step.end(&model.texts().messages)),
    }
}

/// Ends the latest of what can be ended: the message, playing, the search, the filter.
pub(super) fn close(model: &mut Model) {
    if model.message.take().is_some() || model.warning.take().is_some() {
    } else if model.guide.pace.is_playing {
        model.guide.pace.is_playing = false;
    } else if model.guide.search.take().is_none() {
        search::show_all(model);
    }
}

/// Opens the help, with all its rows.
pub(super) fn open_help(model: &mut Model) -> Effect {
    model.guide.help.clear();
    model.overlay = Some(Overlay::Help { top: 0 });
    Effect::None
}

/// Lets the tree grow with the steps, or shows all of it.
fn toggle_growing(model: &mut Model) {
    if model.guide.grown.take().is_some() {
        model.fold.visible.end_before(usize::MAX);
        model.say(model.texts().messages.whole_tree);
    } else {
        model.guide.grown = Some(model.event);
        model.grow();
        plane::hide(model);
        model.say(model.texts().messages.tree_grows);
    }
}

/// Hides the intersection tests, or shows them again.
fn toggle_tests(model: &mut Model) {
    model.guide.hides_tests = !model.guide.hides_tests;
    search::renew_rows(model);
    let messages = &model.texts().messages;
    model.say(if model.guide.hides_tests { messages.tests_hidden } else { messages.tests_shown });
}
