//! Searching: in names, symbols, titles, the words of decisions and the values as they are shown; and the filter of the tree.
//!
//! A text that was typed is looked for from the current step on until it is found, and in what is left slice by slice while
//! nothing else is to be done. A text is made only where one is looked into, and what was found out about each name and node
//! is remembered. Once all is found every question is one of a sorted list.

use super::guide;
use super::model::Model;
use super::view::ascii;
use crate::log::{Log, Name, Step, Tree, Value, What};
use crate::report::language::Language;
use crate::report::language::viewer::Status;
use crate::report::number::RAISED;
use crate::report::{Style, words};
use std::collections::HashMap;

/// A text to look for. Capitals count if it has any.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    text: String,
    is_exact: bool,
}

impl Pattern {
    /// The pattern of a typed text.
    pub fn of(text: &str) -> Pattern {
        Pattern { text: text.to_owned(), is_exact: text.chars().any(char::is_uppercase) }
    }

    /// Whether a text contains it.
    pub fn is_in(&self, text: &str) -> bool {
        if self.is_exact { text.contains(&self.text) } else { text.to_lowercase().contains(&self.text) }
    }

    /// Where it begins and ends among the letters of a text, which are given one by one.
    pub fn places(&self, letters: &[&str]) -> Vec<std::ops::Range<usize>> {
        let mut text = String::new();
        let mut begins = Vec::with_capacity(letters.len());
        for letter in letters {
            begins.push(text.len());
            text += &if self.is_exact { (*letter).to_owned() } else { letter.to_lowercase() };
        }
        let letter = |at: usize| begins.partition_point(|begin| *begin < at);
        let found = text.match_indices(&self.text).filter(|(_, part)| !part.is_empty());
        found.map(|(at, part)| letter(at)..letter(at + part.len())).collect()
    }

    /// Whether it has only such characters.
    fn is_made_of(&self, characters: &str) -> bool {
        self.text.chars().all(|c| characters.contains(c))
    }
}

/// A search and what it has found.
#[derive(Clone, Debug)]
pub struct Search {
    /// What is looked for.
    pub pattern: Pattern,
    /// The event that it began with.
    start: usize,
    /// How many events it has looked at, from the first on and around the end.
    looked_at: usize,
    /// How many there are.
    count: usize,
    /// The events that match, in the order in which they were looked at; once it has looked at all, in theirs.
    found: Vec<u32>,
}

impl Search {
    /// A search that begins after the current step and hasn't looked at anything.
    fn new(model: &Model, text: &str) -> Search {
        let count = model.log.events.len();
        Search {
            pattern: Pattern::of(text),
            start: (model.event + 1) % count.max(1),
            looked_at: 0,
            count,
            found: Vec::new(),
        }
    }

    /// Searches a whole log.
    pub fn of(model: &Model, text: &str) -> Search {
        let mut search = Search::new(model, text);
        search.look(model, usize::MAX);
        search
    }

    /// Searches this many more events.
    fn look(&mut self, model: &Model, most: usize) {
        let mut matcher = Matcher::new(model, &self.pattern);
        // A search for values or decisions would find out what a quiz hides.
        matcher.in_quiz = model.understanding.quiz.is_some().then_some(model);
        let until = self.looked_at.saturating_add(most).min(self.count);
        let events = (self.looked_at..until).map(|number| (self.start + number) % self.count);
        self.found.extend(events.filter(|event| matcher.matches(*event)).map(|event| event as u32));
        self.looked_at = until;
        if self.is_complete() {
            self.found.sort_unstable();
        }
    }

    /// Whether it has looked at every event.
    pub fn is_complete(&self) -> bool {
        self.looked_at == self.count
    }

    /// Which of how many matches an event is, such as `match 3/17`.
    pub fn place(&self, event: usize, status: &Status) -> String {
        if !self.is_complete() {
            return status.counting.to_owned();
        }
        let count = self.found.len().to_string();
        let number = self.found.binary_search(&(event as u32)).map_or("-".to_owned(), |index| (index + 1).to_string());
        (status.matches)(&number, &count)
    }

    /// The next match after an event, as far as that is known before all events were looked at.
    fn next_known(&self, event: usize) -> Option<usize> {
        let number = |event: usize| (event + self.count - self.start) % self.count;
        let from = number(event + 1);
        let index = self.found.partition_point(|found| number(*found as usize) < from);
        let found = self.found.get(index).filter(|_| from <= self.looked_at)?;
        Some(*found as usize)
    }

    /// The n-th match after an event, or before it, of a complete search; and whether that went around the end.
    pub fn next(&self, event: usize, is_forward: bool, times: usize) -> Option<(usize, bool)> {
        let count = self.found.len();
        let event = event as u32;
        let times = times.max(1) - 1;
        let index = if is_forward {
            self.found.partition_point(|found| *found <= event).saturating_add(times)
        } else {
            let before = self.found.partition_point(|found| *found < event);
            // Counted from the end, so that it can't run below zero.
            let from_end = (count - before).saturating_add(times);
            let found = *self.found.get(count.checked_sub(1)? - from_end % count)?;
            return Some((found as usize, from_end >= count));
        };
        let found = *self.found.get(index.checked_rem(count)?)?;
        Some((found as usize, index >= count))
    }
}

/// Tells which events match, and remembers what it was asked before.
struct Matcher<'a> {
    log: &'a Log,
    tree: &'a Tree,
    numbers: Style,
    language: Language,
    pattern: &'a Pattern,
    names: HashMap<Name, bool>,
    steps: HashMap<Step, bool>,
    /// What tells which events are hidden, if some are.
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
            in_quiz: None,
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
    let mut search = Search::new(model, text);
    while search.found.is_empty() && !search.is_complete() {
        search.look(model, SLICE);
    }
    search
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
        search.look(model, most);
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
            guide::jump(model, event);
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
    let search = Search::of(model, text);
    if search.found.is_empty() {
        return Err((model.texts().messages.no_row)(&words::plain(text)));
    }
    let nodes: Vec<_> = search.found.iter().map(|event| model.tree.owner(*event as usize)).collect();
    for node in &nodes {
        model.fold.open_around(&model.tree, *node);
    }
    model.fold.visible.keep(&model.tree, Some(nodes));
    // One's own place isn't lost.
    model.fold.visible.show(&model.tree, model.cursor);
    model.guide.filter = Some(text.to_owned());
    Ok(())
}

/// Ends the filter.
pub(super) fn show_all(model: &mut Model) {
    model.guide.filter = None;
    model.fold.visible.keep(&model.tree, None::<[usize; 0]>);
}

/// Searches and filters another log in the same way.
pub(super) fn renew(model: &mut Model) {
    let search = model.guide.search.take();
    model.guide.search = search.map(|search| Search::new(model, &search.pattern.text));
    look_on(model);
    if let Some(text) = model.guide.filter.take()
        && let Err(why) = filter(model, &text)
    {
        show_all(model);
        model.say(&why);
    }
}

#[cfg(test)]
mod tests;
