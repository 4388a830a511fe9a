//! The lines that were typed before: of each kind of line by itself, from which `Up` and `Down` bring them back.

use super::prompt::Purpose;
use std::collections::{HashMap, VecDeque};

/// The lines that were typed before, the latest last.
#[derive(Clone, Debug, Default)]
pub struct History {
    lines: HashMap<Purpose, VecDeque<String>>,
}

/// So many of a kind are remembered.
const MOST: usize = 200;

impl History {
    /// Remembers a line, unless it is blank or the same as the one before.
    pub fn remember(&mut self, purpose: Purpose, line: &str) {
        let lines = self.lines.entry(purpose).or_default();
        if line.trim().is_empty() || lines.back().is_some_and(|last| last == line) {
            return;
        }
        if lines.len() == MOST {
            lines.pop_front();
        }
        lines.push_back(line.to_owned());
    }

    /// The n-th most recent line (1 is the latest), or the earliest; with it, which one it is.
    pub fn before(&self, purpose: Purpose, back: usize) -> Option<(usize, &str)> {
        let lines = self.lines.get(&purpose)?;
        let back = back.min(lines.len());
        Some((back, lines.get(lines.len() - back)?.as_str()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_line_has_its_own_history() {
        let mut history = History::default();
        for (purpose, line) in [(Purpose::Search, "a"), (Purpose::Break, "hit"), (Purpose::Search, "b")] {
            history.remember(purpose, line);
        }
        let before = |purpose, back| history.before(purpose, back);
        assert_eq!(before(Purpose::Search, 1), Some((1, "b")));
        assert_eq!(before(Purpose::Search, 2), Some((2, "a")));
        assert_eq!(before(Purpose::Search, 9), Some((2, "a")));
        assert_eq!(before(Purpose::Break, 1), Some((1, "hit")));
        assert_eq!((before(Purpose::Search, 0), before(Purpose::Filter, 1)), (None, None));
    }

    #[test]
    fn neither_blanks_nor_repetitions_nor_too_much_is_kept() {
        let mut history = History::default();
        for line in ["a", "a", "", "  ", "b", "a"] {
            history.remember(Purpose::Command, line);
        }
        let all: Vec<_> = (1..4).filter_map(|back| history.before(Purpose::Command, back)).collect();
        assert_eq!(all, [(1, "a"), (2, "b"), (3, "a")]);
        (0..2 * MOST).for_each(|number| history.remember(Purpose::Command, &number.to_string()));
        assert_eq!(history.before(Purpose::Command, usize::MAX), Some((MOST, MOST.to_string().as_str())));
    }
}
