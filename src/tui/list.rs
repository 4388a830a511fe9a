//! Moving in a list, going to the place of an entry and closing it: the same for all lists.

use super::effect::Effect;
use super::keys::{Action, Walk};
use super::listing::listing;
use super::model::list::{Entry, Kind};
use super::model::{Model, Overlay};
use super::{bookmarks, breakpoints, jumps, run, view, watch};
use ratatui::layout::Position;

/// How many columns of the screen a list is scrolled at once.
const STRIDE: usize = 8;

/// Moves in a list, goes to the place of its selected entry, or closes it.
pub(super) fn update(
    model: &mut Model,
    action: Action,
    kind: Kind,
    (selected, shift): (usize, usize),
    count: Option<u32>,
) -> Effect {
    let listing = listing(model, kind);
    let times = count.unwrap_or(1) as usize;
    match (action, kind) {
        (Action::In | Action::Enter, Kind::Breakpoints) => breakpoints::go_to_next(model, selected),
        (Action::Toggle, Kind::Breakpoints) => breakpoints::turn(model, selected),
        (Action::Walk(Walk::Delete), Kind::Breakpoints) => breakpoints::delete(model, selected),
        (Action::Walk(Walk::Delete), Kind::Bookmarks) => return bookmarks::delete(model, selected),
        (Action::In | Action::Enter, Kind::Watches | Kind::History) => watch::enter(model, kind, selected),
        (Action::Walk(Walk::Delete), Kind::Watches) => watch::delete(model, selected),
        (Action::In | Action::Enter, Kind::Stops) => return run::go_to(model, selected),
        (Action::In | Action::Enter, _) => {
            let selected = listing.entries.get(selected).filter(|entry| entry.leads());
            if let Some(Entry { target, pixel, .. }) = selected {
                model.overlay = None;
                if let Some(pixel) = pixel {
                    jumps::remember(model);
                    return Effect::Trace(*pixel);
                }
                target.iter().for_each(|target| jumps::to_event(model, *target));
            }
        }
        (Action::Close | Action::Quit | Action::Out | Action::Interrupt, _) => model.overlay = None,
        (Action::Walk(Walk::Click(x, y)), _) => {
            if let Some(row) = view::entry_at(model, (&listing, kind), selected, Position { x, y }) {
                model.overlay = Some(Overlay::List { kind, selected: listing.off_headings(row, false), shift });
            }
        }
        (Action::Suspend, _) => return Effect::Suspend,
        (Action::Wider, _) => {
            let shift = shift.saturating_add(STRIDE * times).min(view::last_shift(model, &listing, kind));
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
        (Action::Narrower, _) => {
            let shift = shift.saturating_sub(STRIDE * times);
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
        _ => {
            let (page, last) = (usize::from(model.size.1 / 2).max(1), listing.entries.len().saturating_sub(1));
            let row = moved(action, selected, times, [page; 2], last).unwrap_or(selected);
            let selected = listing.off_headings(row, row < selected || action == Action::Last);
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
    }
    Effect::None
}

/// The row to which an action moves from another one, by `times` rows, by half a page or a page, or to an end; `None` for other actions.
pub(super) fn moved(
    action: Action,
    from: usize,
    times: usize,
    [half_page, page]: [usize; 2],
    last: usize,
) -> Option<usize> {
    let row = match action {
        Action::Down => from.saturating_add(times),
        Action::Up => from.saturating_sub(times),
        Action::HalfPageDown => from.saturating_add(half_page),
        Action::HalfPageUp => from.saturating_sub(half_page),
        Action::PageDown => from.saturating_add(page),
        Action::PageUp => from.saturating_sub(page),
        Action::First => 0,
        Action::Last => last,
        _ => return None,
    };
    Some(row.min(last))
}
