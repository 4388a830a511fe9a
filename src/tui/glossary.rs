//! The glossary: what the symbols of the log mean, those of the selected node first, and the signs of formulas and paths.

use super::model::Model;
use super::model::list::{Entry, Listing, MOST, cells};
use super::theme::Role;
use crate::log::{Name, What};
use std::collections::HashSet;

/// The glossary at the current step.
pub(super) fn listing(model: &Model) -> Listing {
    let texts = &model.texts().lists.glossary;
    let mut seen = HashSet::new();
    let mut terms = |events: &mut dyn Iterator<Item = usize>| {
        let mut entries: Vec<Entry> = Vec::new();
        for event in events.take_while(|event| is_told(model, *event)) {
            let names = names(model, event).into_iter();
            entries.extend(names.filter(|name| seen.insert(name.key())).map(|name| term(model, name, event)));
        }
        entries.truncate(MOST);
        entries
    };
    let here = terms(&mut std::iter::once(model.event));
    let around = terms(&mut model.tree.own_events(model.cursor));
    let others = terms(&mut (0..model.log.events.len()));
    let signs = model
        .language
        .signs()
        .map(|(sign, meaning)| Entry::plain(cells([sign.to_owned(), meaning.to_owned()]), Role::Text));
    let parts = [here.into_iter().chain(around).collect(), others, signs.collect::<Vec<_>>()];
    let mut entries = Vec::new();
    for (heading, part) in texts.headings.into_iter().zip(parts).filter(|(_, part)| !part.is_empty()) {
        entries.push(Entry::heading(heading.to_owned()));
        entries.extend(part);
    }
    Listing::of(&texts.list, texts.title, &[], entries)
}

/// Whether one may know that an event happens: neither a tree that grows nor a quiz tells what is to come.
fn is_told(model: &Model, event: usize) -> bool {
    model.guide.is_known(event) && (model.understanding.quiz.is_none() || event <= model.event)
}

/// The quantities that an event shows: its inputs, and what it notes.
fn names(model: &Model, event: usize) -> Vec<Name> {
    let given = model.log.given(event).iter().map(|(name, _)| *name);
    let noted = match model.log.events[event].what {
        What::Note { name, .. } => Some(name),
        _ => None,
    };
    noted.into_iter().chain(given).collect()
}

fn term(model: &Model, name: Name, event: usize) -> Entry {
    let meaning = model.language.meaning(name.key()).unwrap_or(name.key()).to_owned();
    let formula = name.formula().map(|formula| format!("= {formula}"));
    let section = Some(name.section()).filter(|section| !section.is_empty());
    let section = section.map(|section| format!("({})", (model.texts().status.section)(section)));
    // In columns of their own the longest meaning would push formulas off the screen.
    let explained = [Some(meaning), formula, section].into_iter().flatten().collect::<Vec<_>>().join("  ");
    Entry::to(event, cells([name.symbol().to_owned(), explained]))
}
