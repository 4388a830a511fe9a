//! Searching: in names, symbols, titles, the words of decisions and the values as they are shown; and the filter of the tree.
//!
//! A text that was typed is looked for from the current step on until it is found, and in what is left slice by slice while
//! nothing else is to be done. A text is made only where one is looked into, and what was found out about each name and node
//! is remembered. Once all is found every question is one of a sorted list.

use super::model::Model;
use super::model::search::{Pattern, Search};
use super::text::ascii;
use super::{jumps, rows};
use crate::log::{Log, Name, Step, Tree, Value, What};
use crate::report::language::Language;
use crate::report::number::RAISED;
use crate::report::{Style, words};
use std::collections::HashMap;

/// Tells which events match, and remembers what it was asked before.
struct Matcher<'a> {
    log: &'a Log,
    tree: &'a Tree,
    numbers: Style,
    language: Language,
    pattern: &'a Pattern,
    names: HashMap<Name, bool>,
    steps: HashMap<Step, bool>,
    /// What tells which events are hidden: a search for values or decisions would find out what a quiz hides.
    in_quiz: Option<&'a Model>,
    could_be_number: bool,
    could_be_path: bool,
}

impl Matcher<'_> {
    fn new<'a>(model: &'a Model, pattern: &'a Pattern) -> Matcher<'a> {
        Matcher {
            log: &model.log,
            tree: &model.tree,
            numbers: model.numbers,
            language: model.language,
            pattern,
            names: HashMap::new(),
            steps: HashMap::new(),
            in_quiz: model.understanding.quiz.is_some().then_some(model),
            could_be_number: pattern.is_made_of(&format!("0123456789.-·{RAISED}(),; naNif")),
            could_be_path: pattern.is_made_of("CRTScrts0123456789. ay"),
        }
    }

    fn matches(&mut self, event: usize) -> bool {
        match &self.log.events[event].what {
            What::Note { name, value } => self.has_name(*name) || self.has_value(event, value),
            What::Result { color } => {
                self.pattern.is_in(self.language.texts().result) || self.has_value(event, &Value::Triple(*color))
            }
            What::Mark(_) if self.is_hidden(event) => false,
            What::Mark(decision) => {
                self.pattern.is_in(&words::decision(self.language, &self.log.header, decision, self.numbers))
            }
            What::Enter { step, .. } => self.has_step(self.tree.owner(event), *step),
            What::Leave => false,
        }
    }

    fn has_name(&mut self, name: Name) -> bool {
        let pattern = self.pattern;
        let symbol = name.symbol();
        *self
            .names
            .entry(name)
            .or_insert_with(|| pattern.is_in(name.key()) || pattern.is_in(symbol) || pattern.is_in(&ascii(symbol)))
    }

    fn is_hidden(&self, event: usize) -> bool {
        self.in_quiz.is_some_and(|model| model.hides(event))
    }

    fn has_value(&self, event: usize, value: &Value) -> bool {
        self.could_be_number && !self.is_hidden(event) && self.pattern.is_in(&self.language.value(value, self.numbers))
    }

    fn has_step(&mut self, node: usize, step: Step) -> bool {
        let (log, tree, pattern, language) = (self.log, self.tree, self.pattern, self.language);
        let title = || words::title(language, log, tree, node);
        match step {
            // The title of a ray has its path, which no other ray has.
            Step::Ray { .. } if self.could_be_path && pattern.is_in(&title()) => true,
            Step::Ray { kind, .. } => {
                let alike = Step::Ray { kind, depth: 0, split: 0 };
                let ray = language.texts().viewer.panes.ray;
                let is_in = || pattern.is_in(&ray(&words::ray_kind(language, &log.header, kind)));
                *self.steps.entry(alike).or_insert_with(is_in)
            }
            step => *self.steps.entry(step).or_insert_with(|| pattern.is_in(&title())),
        }
    }
}

/// Searches for a text and goes to the first match after the current step; no text ends the search.
pub(super) fn begin(model: &mut Model, text: &str) -> Result<(), String> {
    if text.is_empty() {
        model.guide.search = None;
        return Ok(());
    }
    let search = begun(model, text);
    if search.found.is_empty() {
        return Err(not_found(model, text));
    }
    model.guide.search = Some(search);
    go_on(model, true, 1);
    Ok(())
}

/// A search that has looked until it found something, or at everything.
fn begun(model: &Model, text: &str) -> Search {
    let mut search = new(model, text);
    while search.found.is_empty() && !search.is_complete() {
        look(model, &mut search, SLICE);
    }
    search
}

/// A search that begins after the current step and hasn't looked at anything.
fn new(model: &Model, text: &str) -> Search {
    Search::new(text, model.event, model.log.events.len())
}

/// Searches this many more events.
fn look(model: &Model, search: &mut Search, most: usize) {
    let pattern = search.pattern.clone();
    let mut matcher = Matcher::new(model, &pattern);
    search.look(most, |event| matcher.matches(event));
}

fn not_found(model: &Model, text: &str) -> String {
    (model.texts().messages.not_found)(&words::plain(text))
}

/// The events that are searched while one waits: some hundredths of a second where values are looked for.
const SLICE: usize = 1 << 17;

/// Looks at the next slice of the log, if the search isn't complete.
pub(super) fn look_on(model: &mut Model) {
    look_at(model, SLICE);
}

/// Completes the search.
pub(super) fn finish(model: &mut Model) {
    look_at(model, usize::MAX);
}

fn look_at(model: &mut Model, most: usize) {
    if let Some(mut search) = model.guide.search.take_if(|search| !search.is_complete()) {
        look(model, &mut search, most);
        model.guide.search = Some(search);
    }
}

/// Whether events are left to be looked at.
pub(super) fn is_looking(model: &Model) -> bool {
    model.guide.search.as_ref().is_some_and(|search| !search.is_complete())
}

/// The n-th match from here on, and whether that is around the end.
fn next(model: &mut Model, is_forward: bool, times: usize) -> Option<(usize, bool)> {
    let here = model.event;
    if is_forward && times == 1 && is_looking(model) {
        let known = model.guide.search.as_ref().and_then(|search| search.next_known(here));
        if let Some(found) = known {
            return Some((found, found <= here));
        }
    }
    finish(model);
    model.guide.search.as_ref()?.next(here, is_forward, times)
}

/// Goes to the next match, or to the previous one; beyond the last comes the first.
pub(super) fn go(model: &mut Model, is_forward: bool, times: usize) {
    // What a quiz has told since the search was begun is found, too.
    if model.understanding.quiz.is_some() {
        let renewed = model.guide.search.as_ref().map(|search| begun(model, &search.pattern.text));
        model.guide.search = renewed;
    }
    go_on(model, is_forward, times);
}

fn go_on(model: &mut Model, is_forward: bool, times: usize) {
    let found = next(model, is_forward, times);
    let Some(search) = &model.guide.search else { return model.say(model.texts().messages.no_search) };
    match found {
        None => {
            let text = not_found(model, &search.pattern.text);
            model.guide.search = None;
            model.say(&text);
        }
        Some((event, goes_around)) => {
            jumps::to_event(model, event);
            if goes_around {
                let messages = &model.texts().messages;
                model.say(if is_forward { messages.from_the_beginning } else { messages.from_the_end });
            }
        }
    }
}

/// Leaves only the rows of the tree in which something matches, and those around them; no text shows all.
pub(super) fn filter(model: &mut Model, text: &str) -> Result<(), String> {
    if text.is_empty() {
        show_all(model);
        return Ok(());
    }
    let mut search = new(model, text);
    look(model, &mut search, usize::MAX);
    if search.found.is_empty() {
        return Err((model.texts().messages.no_row)(&words::plain(text)));
    }
    // The word for a kind of ray leaves all that such rays bring.
    let nodes = rows::of_rays(model, text)
        .unwrap_or_else(|| search.found.iter().map(|event| model.tree.owner(*event as usize)).collect());
    for node in &nodes {
        model.fold.open_around(&model.tree, *node);
    }
    rows::keep(model, Some(nodes));
    model.guide.filter = Some(text.to_owned());
    Ok(())
}

/// Ends the filter.
pub(super) fn show_all(model: &mut Model) {
    model.guide.filter = None;
    rows::keep(model, None);
}

/// Searches and filters another log in the same way.
pub(super) fn renew(model: &mut Model) {
    let search = model.guide.search.take();
    model.guide.search = search.map(|search| new(model, &search.pattern.text));
    look_on(model);
    renew_rows(model);
}

/// Filters the rows of the tree anew, without the tests if they are hidden.
pub(super) fn renew_rows(model: &mut Model) {
    let Some(text) = model.guide.filter.take() else { return rows::keep(model, None) };
    if let Err(why) = filter(model, &text) {
        show_all(model);
        model.say(&why);
    }
}

#[cfg(test)]
mod tests;
