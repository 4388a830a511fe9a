//! What is in each list: a kind of list is one function that makes its entries from the model.

use super::model::list::{Entry, Kind, Listing};
use super::model::watch::Watched;
use super::model::{Model, Overlay};
use super::{bookmarks, breakpoints, run, watch};

/// The list of this kind.
pub fn listing(model: &Model, kind: Kind) -> Listing {
    let texts = &model.texts().lists;
    match kind {
        Kind::Breakpoints => {
            Listing::of(&texts.breakpoints, texts.breakpoints_title, &[1, 2], breakpoints::entries(model))
        }
        Kind::Stops => Listing::of(&texts.stops, texts.stops_title, &[0], run::entries(model)),
        Kind::Bookmarks => {
            let all = Listing::of(&texts.bookmarks, texts.bookmarks_title, &[], bookmarks::entries(model));
            // Without notes there is no column of them.
            let columns = if bookmarks::has_notes(model) { 4 } else { 3 };
            Listing { columns: all.columns[..columns].to_vec(), ..all }
        }
        Kind::Watches => Listing::of(&texts.watches, texts.watches_title, &[0], watch::entries(model, kind)),
        Kind::History => {
            let name = model.guide.watches.history.as_ref().map(Watched::shown).unwrap_or_default();
            Listing::of(&texts.history, (texts.history_title)(&name), &[0], watch::entries(model, kind))
        }
        _ => {
            // Made when it was opened.
            let opened = model.understanding.listing.as_ref().filter(|(of, _)| *of == kind);
            opened.map(|(_, listing)| listing.clone()).unwrap_or_default()
        }
    }
}

/// Opens a list.
pub(super) fn open(model: &mut Model, kind: Kind) {
    let listing = listing(model, kind);
    let selected = listing.entries.iter().position(Entry::leads);
    let selected = selected.unwrap_or_else(|| listing.off_headings(0, false));
    model.overlay = Some(Overlay::List { kind, selected, shift: 0 });
}
