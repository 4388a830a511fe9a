//! Searching in all that is shown: names, symbols, formulas, titles, values and inputs, decisions in the words of the computation and of the
//! tree and with their numbers; and the filter of the tree.
//!
//! A text that was typed is looked for from the current step on until it is found, and in what is left slice by slice while
//! nothing else is to be done. A text is made only where one is looked into, and what was found out about each name and node
//! is remembered. Once all is found every question is one of a sorted list.

use super::model::Model;
use super::model::search::{Pattern, Search};
use super::text::ascii;
use super::{jumps, rows};
use crate::log::{Decision, Name, Step, Value, What};
use crate::report::number::RAISED;
use crate::report::{self, path_class, words};
use std::collections::HashMap;

/// Tells which events match, and remembers what it was asked before.
struct Matcher<'a> {
    /// What tells also which events are hidden: a search for values or decisions would find out what a quiz hides.
    model: &'a Model,
    pattern: &'a Pattern,
    names: HashMap<Name, bool>,
    steps: HashMap<Step, bool>,
    could_be_number: bool,
    could_be_path: bool,
    could_be_class: bool,
    /// Whether it may be a part of a formula, and not only of a symbol.
    could_be_formula: bool,
    /// Whether it may be a part of `T2_A = 6.304`.
    could_be_equation: bool,
    /// Whether it may be a part of `T2_A ≥ 0: 6.304 ≥ 0` that no value has: what compares is evaluated only then.
    could_be_comparison: bool,
    /// Whether the word for a light that isn't blocked has it.
    is_lit: bool,
    is_in_quiz: bool,
}

impl Matcher<'_> {
    fn new<'a>(model: &'a Model, pattern: &'a Pattern) -> Matcher<'a> {
        let could_be_number = pattern.is_made_of(&format!("0123456789.-·{RAISED}(),; naNif"));
        Matcher {
            model,
            pattern,
            names: HashMap::new(),
            steps: HashMap::new(),
            could_be_number,
            could_be_path: pattern.is_made_of("CRTScrts0123456789. ay"),
            could_be_class: pattern.is_made_of(&format!("LDSEAB(|){RAISED}")),
            could_be_formula: pattern.has_any(" +−-·*/√²∘×⊘^()|[]Σ"),
            could_be_equation: pattern.has_any("="),
            could_be_comparison: pattern.has_any("<>≤≥=≠"),
            is_lit: pattern.is_in(model.texts().panes.outcomes.lit),
            is_in_quiz: model.understanding.quiz.is_some(),
        }
    }

    fn matches(&mut self, event: usize) -> bool {
        let model = self.model;
        let happening = &model.log.events[event];
        let is_found = match &happening.what {
            What::Note { name, value } => self.has_name(*name) || self.has_value(event, *name, value),
            What::Result { color } => {
                let is_value = || self.could_be_number && self.pattern.is_in(&model.color(*color));
                self.pattern.is_in(model.language.texts().result) || (!self.is_hidden(event) && is_value())
            }
            What::Mark(decision) => !self.is_hidden(event) && self.has_decision(event, decision),
            What::Enter { step, .. } => self.has_step(model.tree.owner(event), *step),
            What::Leave => self.is_lit && !self.is_later(event) && model.is_lit(model.tree.owner(event)),
        };
        let is_marked = || {
            let marker = report::digits::marker(model.language, &model.log, &model.tree, event);
            !marker.is_empty() && !self.is_hidden(event) && self.pattern.is_in(&marker)
        };
        is_found || is_marked() || self.has_given(event)
    }

    fn has_name(&mut self, name: Name) -> bool {
        let (pattern, symbol) = (self.pattern, name.symbol());
        let is_in = |text: &str| pattern.is_in(text) || pattern.is_in(&ascii(text));
        let formula = name.formula().filter(|_| self.could_be_formula);
        let is_in_formula = |formula: &str| is_in(&format!("{symbol} = {formula}"));
        let found = || pattern.is_in(name.key()) || is_in(symbol) || formula.is_some_and(is_in_formula);
        *self.names.entry(name).or_insert_with(found)
    }

    fn is_hidden(&self, event: usize) -> bool {
        self.is_in_quiz && self.model.hides(event)
    }

    /// Whether a quiz hides it because it comes after the current step.
    fn is_later(&self, event: usize) -> bool {
        self.is_in_quiz && event > self.model.event
    }

    fn has_value(&self, event: usize, name: Name, value: &Value) -> bool {
        (self.could_be_number || self.could_be_equation) && !self.is_hidden(event) && self.is_value(name, value)
    }

    /// Whether it is in `S_c = (17, 9, 8)`.
    fn is_value(&self, name: Name, value: &Value) -> bool {
        let value = self.model.value(value);
        let equation = || format!("{} = {value}", name.symbol());
        if self.could_be_equation { self.pattern.is_in(&equation()) } else { self.pattern.is_in(&value) }
    }

    /// Whether an input that is stated before an event has it: its name, or its value as it is shown.
    fn has_given(&mut self, event: usize) -> bool {
        let model = self.model;
        let given = model.log.given(event);
        if given.is_empty() || self.is_in_quiz && model.hides_operands(event) {
            return false;
        }
        let could_be_value = self.could_be_number || self.could_be_equation;
        given.iter().any(|(name, value)| self.has_name(*name) || (could_be_value && self.is_value(*name, value)))
    }

    /// Whether the words of a decision have it, in a computation or in a row of the tree, or the numbers that decided.
    fn has_decision(&self, event: usize, decision: &Decision) -> bool {
        let (model, pattern) = (self.model, self.pattern);
        let numbers = || report::notation::line(model.language, &model.log, &model.tree, event, model.numbers);
        pattern.is_in(&model.decision(decision))
            || model.outcome(decision).is_some_and(|words| pattern.is_in(&words))
            || (self.could_be_comparison && numbers().is_some_and(|numbers| pattern.is_in(&numbers)))
    }

    fn has_step(&mut self, node: usize, step: Step) -> bool {
        let (model, pattern) = (self.model, self.pattern);
        let title = || model.title(node);
        let Step::Ray { kind, .. } = step else {
            return *self.steps.entry(step).or_insert_with(|| pattern.is_in(&title()));
        };
        // The title of a ray has its path, which no other ray has; in a row of the tree it is before what the ray is for.
        let kind_of = || words::ray_kind(model.language, &model.log.header, kind);
        let has_path = pattern.begins_with_any("CRTSa0123456789")
            && pattern.is_in(&format!("{} {}", model.tree.shown_path(node), kind_of()));
        let class = || path_class::of_ray(&model.log, &model.tree, node).is_some_and(|class| pattern.is_in(&class));
        if has_path
            || (self.could_be_path && pattern.is_in(&title()))
            || (self.could_be_class && !self.is_in_quiz && class())
        {
            return true;
        }
        let alike = Step::Ray { kind, depth: 0, split: 0 };
        let is_in = || pattern.is_in(&(model.texts().panes.ray)(&kind_of()));
        *self.steps.entry(alike).or_insert_with(is_in)
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
