//! A text that is searched, and what of a log was found.

use crate::report::language::viewer::Status;

/// A text to look for. Capitals count if it has any.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The text as it was typed.
    pub text: String,
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

    /// Whether it has one of these characters.
    pub fn has_any(&self, characters: &str) -> bool {
        self.text.contains(|c| characters.contains(c))
    }

    /// Whether it begins with one of these characters.
    pub fn begins_with_any(&self, characters: &str) -> bool {
        self.text.starts_with(|c| characters.contains(c))
    }

    /// Whether it has only such characters.
    pub fn is_made_of(&self, characters: &str) -> bool {
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
    pub found: Vec<u32>,
}

impl Search {
    /// A search among so many events that begins behind one of them and hasn't looked at anything.
    pub fn new(text: &str, behind: usize, count: usize) -> Search {
        let start = (behind + 1) % count.max(1);
        Search { pattern: Pattern::of(text), start, looked_at: 0, count, found: Vec::new() }
    }

    /// Looks at this many more events, given which of them match.
    pub fn look(&mut self, most: usize, mut matches: impl FnMut(usize) -> bool) {
        let until = self.looked_at.saturating_add(most).min(self.count);
        let events = (self.looked_at..until).map(|number| (self.start + number) % self.count);
        self.found.extend(events.filter(|event| matches(*event)).map(|event| event as u32));
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
    pub fn next_known(&self, event: usize) -> Option<usize> {
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
