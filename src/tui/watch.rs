//! Watching quantities: what is pinned with its value here and everywhere in the log, and the history of one of them. Both are the same list.

use super::jumps;
use super::model::list::{Entry, Kind, MOST, cells};
use super::model::quantity::{self, Part};
use super::model::watch::{Spread, Watched};
use super::model::{Model, Overlay};
use super::text::counted;
use super::theme::{self, Role};
use crate::files::suggest;
use crate::log::scope::Operand;
use crate::log::{Name, Value};
use crate::report::words::plain;
use std::collections::BTreeSet;
use std::ops::Range;

/// Pins what a text names; with nothing typed opens the list.
pub(super) fn add(model: &mut Model, text: &str) -> Result<(), String> {
    if text.is_empty() {
        open(model);
        return Ok(());
    }
    let watched = named(model, text)?;
    pin(model, watched);
    Ok(())
}

fn pin(model: &mut Model, mut watched: Watched) {
    watched.find(&model.log.events, &model.tree);
    let (key, count) = (watched.key(), told(model, &watched).len());
    if !model.guide.watches.pinned.iter().any(|known| known.is(&watched)) {
        model.guide.watches.pinned.push(watched);
    }
    let is_all = model.told().is_none();
    model.say(&(model.texts().watch.pinned)(&key, is_all.then_some(count)));
}

/// Unpins what a text names.
pub(super) fn remove(model: &mut Model, text: &str) -> Result<(), String> {
    let texts = &model.texts().watch;
    let called = quantity::named(text);
    let is_it = |watched: &Watched| {
        let names = called.as_ref().filter(|(_, part)| *part == watched.part).map(|(names, _)| names);
        names.is_some_and(|names| watched.names.iter().any(|name| names.contains(name)))
    };
    let Some(at) = model.guide.watches.pinned.iter().position(is_it) else {
        let keys: Vec<_> = model.guide.watches.pinned.iter().map(Watched::key).collect();
        return Err((texts.not_pinned)(&plain(text), &keys.join(", ")));
    };
    let watched = model.guide.watches.pinned.remove(at);
    model.say(&(texts.unpinned)(&watched.key()));
    Ok(())
}

/// Pins the quantity at the current step, or unpins it.
pub(super) fn toggle_here(model: &mut Model) {
    let Some(watched) = current(model) else { return model.say(model.texts().watch.nothing_here) };
    match model.guide.watches.pinned.iter().position(|known| known.is(&watched)) {
        Some(at) => {
            model.guide.watches.pinned.remove(at);
            model.say(&(model.texts().watch.unpinned)(&watched.key()));
        }
        None => pin(model, watched),
    }
}

/// The quantity that the current step computes.
fn current(model: &Model) -> Option<Watched> {
    let (name, _) = model.log.events.get(model.event)?.noted()?;
    Some(Watched::new(name, Part::Whole))
}

/// What a text names: a quantity by its key, or by a symbol that no other quantity of the log has.
pub(super) fn named(model: &Model, text: &str) -> Result<Watched, String> {
    let texts = &model.texts().watch;
    let Some((names, part)) = quantity::named(text) else {
        return Err(match suggest(text, quantity::words()) {
            Some(near) => (texts.name_like)(&plain(text), near),
            None => (texts.no_name)(&plain(text)),
        });
    };
    let first = names[0];
    if let (Part::Component(_), false) = (part, first.is_triple()) {
        return Err((model.texts().breakpoints.no_components)(first.symbol()));
    }
    let keys: BTreeSet<_> = names.iter().map(|name| name.key()).collect();
    let in_log = if keys.len() > 1 { known_keys(model) } else { BTreeSet::new() };
    let mut found: Vec<_> = keys.intersection(&in_log).copied().collect();
    if found.is_empty() {
        found = keys.into_iter().collect();
    }
    match found[..] {
        [key] => Ok(Watched::new(names.into_iter().find(|name| name.key() == key).unwrap_or(first), part)),
        _ => Err((texts.may_be)(&plain(text), &found.join(", "))),
    }
}

/// The keys of the quantities in the log, as far as it may be shown.
fn known_keys(model: &Model) -> BTreeSet<&'static str> {
    let count = model.told().map_or(model.log.events.len(), |told| told + 1);
    let mut is_there = vec![false; Name::all().count()];
    for event in model.log.events.iter().take(count) {
        let noted = event.noted().map(|(name, _)| name);
        let given = model.log.events.given(event).iter().map(|(name, _)| *name);
        noted.into_iter().chain(given).for_each(|name| is_there[name as usize] = true);
    }
    Name::all().filter(|name| is_there[*name as usize]).map(Name::key).collect()
}

/// How what is typed behind `:watch` and `:history` may go on: by the keys that the log has, else by any.
pub(super) fn completions(model: &Model, text: &str) -> Vec<String> {
    let begun = |keys: BTreeSet<&'static str>| -> Vec<String> {
        keys.into_iter().filter(|key| key.starts_with(text)).map(str::to_owned).collect()
    };
    let known = begun(known_keys(model));
    if known.is_empty() { begun(Name::all().map(Name::key).collect()) } else { known }
}

/// How it may go on behind `:unwatch`.
pub(super) fn pinned_completions(model: &Model, text: &str) -> Vec<String> {
    model.guide.watches.pinned.iter().map(Watched::key).filter(|key| key.starts_with(text)).collect()
}

/// Looks for all that is watched in another log.
pub(super) fn renew(model: &mut Model) {
    let watches = &mut model.guide.watches;
    let all = watches.pinned.iter_mut().chain(&mut watches.history);
    all.for_each(|watched| watched.find(&model.log.events, &model.tree));
}

/// The value of what is watched that holds at the current step, and the event that has it.
pub(super) fn here(model: &Model, watched: &Watched) -> Option<Operand> {
    let found = model.here(&watched.names)?;
    watched.of(&found.value).map(|value| Operand { value, ..found })
}

/// The events of what is watched, as far as they may be shown.
fn told<'w>(model: &Model, watched: &'w Watched) -> &'w [u32] {
    let count = watched.events.partition_point(|event| model.is_told(*event as usize));
    &watched.events[..count]
}

/// Opens the list of all that is pinned.
fn open(model: &mut Model) {
    model.overlay = Some(Overlay::List { kind: Kind::Watches, selected: 0, shift: 0 });
}

/// Shows all values of what a text names, or of the quantity at the current step, from the current one on.
pub(super) fn open_history(model: &mut Model, text: &str) -> Result<(), String> {
    let watched = match text {
        "" => current(model).ok_or(model.texts().watch.no_history)?,
        text => named(model, text)?,
    };
    show_history(model, watched);
    Ok(())
}

fn show_history(model: &mut Model, mut watched: Watched) {
    watched.find(&model.log.events, &model.tree);
    model.guide.watches.history = Some(watched);
    let rows = rows(model, Kind::History);
    let event = model.event;
    let is_before = |row: &Row| matches!(row.what, Told::Occurrence(at) if at <= event);
    let selected = rows.iter().rposition(is_before).or_else(|| rows.iter().position(|row| !row.is_heading()));
    model.overlay = Some(Overlay::List { kind: Kind::History, selected: selected.unwrap_or(0), shift: 0 });
}

/// A row of the list.
struct Row {
    /// The number of what it is about among all that is watched.
    watched: usize,
    what: Told,
}

/// What a row says.
enum Told {
    /// The value here, and how all values are spread.
    Overview,
    /// A value of the log.
    Occurrence(usize),
    /// So many values aren't listed, before or after those that are.
    More { count: usize, is_before: bool },
}

impl Row {
    fn is_heading(&self) -> bool {
        matches!(self.what, Told::More { .. })
    }
}

/// What is listed.
fn watched(model: &Model, kind: Kind) -> Vec<&Watched> {
    match kind {
        Kind::History => model.guide.watches.history.iter().collect(),
        _ => model.guide.watches.pinned.iter().collect(),
    }
}

/// The rows of the list: of each quantity an overview and the values around the current step.
fn rows(model: &Model, kind: Kind) -> Vec<Row> {
    let all = watched(model, kind);
    let room = (MOST / all.len().max(1)).max(3);
    let mut rows = Vec::new();
    for (number, watched) in all.into_iter().enumerate() {
        let events = told(model, watched);
        let Range { start, end } = around(events, model.event, room);
        let more = |count: usize, is_before: bool| {
            let row = Row { watched: number, what: Told::More { count, is_before } };
            (count > 0).then_some(row)
        };
        rows.push(Row { watched: number, what: Told::Overview });
        rows.extend(more(start, true));
        let listed = events[start..end].iter().map(|event| Told::Occurrence(*event as usize));
        rows.extend(listed.map(|what| Row { watched: number, what }));
        rows.extend(more(events.len() - end, false));
    }
    rows
}

/// This many of some events around one.
fn around(events: &[u32], event: usize, room: usize) -> Range<usize> {
    let here = events.partition_point(|at| (*at as usize) <= event);
    let start = here.saturating_sub(room / 2).min(events.len().saturating_sub(room));
    start..(start + room).min(events.len())
}

/// The entries of the list.
pub(super) fn entries(model: &Model, kind: Kind) -> Vec<Entry> {
    let all = watched(model, kind);
    rows(model, kind).iter().map(|row| entry(model, all[row.watched], row)).collect()
}

fn entry(model: &Model, watched: &Watched, row: &Row) -> Entry {
    let texts = &model.texts().watch;
    match row.what {
        Told::Overview => Entry::plain(overview(model, watched), Role::Title),
        Told::More { count, is_before } => {
            Entry { is_heading: true, ..Entry::plain((texts.more)(count, is_before), Role::Faint) }
        }
        Told::Occurrence(event) => {
            let value = watched.value(&model.log.events, event).map_or(String::new(), |value| model.value(&value));
            let node = model.tree.owner(event);
            let glyphs = if model.is_ascii { &theme::ASCII } else { &theme::UNICODE };
            let is_changed = model.changed.events.contains(&event);
            let step = format!("{}{}", if is_changed { glyphs.differs } else { "" }, event + 1);
            let noted = model.log.events[event].noted();
            let is_given = noted.is_none_or(|(name, _)| !watched.names.contains(&name));
            let given = if is_given { texts.given } else { "" };
            let path = counted(&model.tree.shown_path(node));
            let path = model.pixel_of(event).map_or(path.clone(), |[x, y]| format!("{x},{y} {path}"));
            let text = cells([step, value, path, model.title(node), given.to_owned()]);
            let is_here = here(model, watched).is_some_and(|here| here.event == event);
            Entry { role: if is_here { Role::Current } else { Role::Text }, ..Entry::to(event, text) }
        }
    }
}

/// `N·L = 0.800: 7 values, 0.300 to 0.900 ▁▃█`
fn overview(model: &Model, watched: &Watched) -> String {
    let texts = &model.texts().watch;
    let events = told(model, watched);
    let now = match here(model, watched) {
        Some(here) => format!("{} = {}", watched.shown(), model.value(&here.value)),
        None => (texts.not_here)(&watched.shown()),
    };
    let count = (texts.values)(events.len());
    let is_all = events.len() == watched.events.len();
    let so_far = || watched.spread_of(&model.log.events, events.len());
    let Some(spread) = (if is_all { watched.spread.clone() } else { so_far() }) else {
        return format!("{now}; {count}");
    };
    let first = events.first().and_then(|event| watched.value(&model.log.events, *event as usize));
    let is_triple = matches!(first, Some(Value::Triple(_)));
    let of = if is_triple { format!("|{}| ", watched.shown()) } else { String::new() };
    let [least, greatest] = [spread.least, spread.greatest].map(|x| model.value(&Value::Number(x)));
    format!("{now}; {count}, {of}{}  {}", (texts.from_to)(&least, &greatest), bars(model, &spread))
}

/// The bars of a spread as characters.
fn bars(model: &Model, spread: &Spread) -> String {
    const UNICODE: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    const ASCII: [char; 8] = ['_', '.', ',', '-', '=', '+', '*', '#'];
    let signs = if model.is_ascii { ASCII } else { UNICODE };
    let sign = |bar: &Option<f64>| bar.map_or('?', |part| signs[((part * 8.0) as usize).min(7)]);
    spread.bars.iter().map(sign).collect()
}

/// Goes to the value in this row of the list; from an overview to the history of its quantity.
pub(super) fn enter(model: &mut Model, kind: Kind, selected: usize) {
    let rows = rows(model, kind);
    let Some(row) = rows.get(selected) else { return };
    match row.what {
        Told::Occurrence(event) => {
            model.overlay = None;
            jumps::to_event(model, event);
        }
        Told::Overview if kind == Kind::Watches => {
            let chosen = model.guide.watches.pinned[row.watched].clone();
            show_history(model, chosen);
        }
        Told::Overview | Told::More { .. } => {}
    }
}

/// Unpins what this row of the list is about.
pub(super) fn delete(model: &mut Model, selected: usize) {
    let Some(row) = rows(model, Kind::Watches).into_iter().nth(selected) else { return };
    let watched = model.guide.watches.pinned.remove(row.watched);
    model.say(&(model.texts().watch.unpinned)(&watched.key()));
    // To the overview of the next one, or of the last.
    let rows = rows_of(model);
    let last = model.guide.watches.pinned.len().saturating_sub(1);
    let wanted = rows.iter().position(|at| *at == row.watched.min(last)).unwrap_or(0);
    if let Some(Overlay::List { selected, .. }) = &mut model.overlay {
        *selected = wanted;
    }
}

/// Which quantity each row of the list is about.
fn rows_of(model: &Model) -> Vec<usize> {
    rows(model, Kind::Watches).iter().map(|row| row.watched).collect()
}

#[cfg(test)]
mod tests;
