//! Text that fits: lines broken with a hanging indent, and text in ASCII for terminals that have no more.

pub(super) use crate::files::escape::width as width_of;

use crate::files::escape::cells;
use crate::report::number::unraised;
use crate::tui::theme::Theme;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// Some text in a style.
pub(super) type Piece = (String, Style);

/// Breaks pieces into lines of at most `width` columns, the second and later ones indented. Lines break at spaces, inside
/// a list such as a triple and beside `=` only when it doesn't fit, and anywhere else only when nothing else helps.
pub(super) fn wrap(pieces: &[Piece], width: usize, indent: usize) -> Vec<Line<'static>> {
    let mut paper = Paper { width, indent: indent.min(width / 2), lines: vec![Line::default()], used: 0 };
    for (text, style) in pieces {
        for word in split(text, |before, after| !matches!(before, ',' | '=') && after != '=') {
            paper.place(word, *style);
        }
    }
    paper.lines
}

/// The text of a theme: itself, or in ASCII.
pub(super) fn shown(text: &str, theme: &Theme) -> String {
    if theme.is_ascii() { ascii(text) } else { text.to_owned() }
}

struct Paper {
    width: usize,
    indent: usize,
    lines: Vec<Line<'static>>,
    /// Columns of the last line in use.
    used: usize,
}

impl Paper {
    fn place(&mut self, word: &str, style: Style) {
        if self.fits(word) {
            return self.write(word, style);
        }
        // A new line must have more room than what is left of this one.
        if self.used > self.indent {
            self.new_line();
        }
        let parts: Vec<_> = split(word, |_, _| true).collect();
        if self.fits(word) {
            self.write(word.trim_start(), style);
        } else if parts.len() > 1 {
            parts.into_iter().for_each(|part| self.place(part, style));
        } else {
            self.cut(word.trim_start(), style);
        }
    }

    /// Whether a word fits, but for the spaces at its end.
    fn fits(&self, word: &str) -> bool {
        self.used + width_of(word.trim_end()) <= self.width
    }

    fn cut(&mut self, word: &str, style: Style) {
        let mut start = 0;
        let mut columns = 0;
        let mut at = 0;
        for (cell, width) in cells(word) {
            if self.used + columns + width > self.width && at > start {
                self.write(&word[start..at], style);
                self.new_line();
                (start, columns) = (at, 0);
            }
            columns += width;
            at += cell.len();
        }
        self.write(&word[start..], style);
    }

    fn write(&mut self, text: &str, style: Style) {
        self.used += width_of(text);
        if let Some(line) = self.lines.last_mut() {
            line.push_span(Span::styled(text.to_owned(), style));
        }
    }

    fn new_line(&mut self) {
        self.lines.push(Line::from(" ".repeat(self.indent)));
        self.used = self.indent;
    }
}

/// Splits after spaces where `may_break` says so, given the character before the space and the one after it.
fn split(text: &str, may_break: impl Fn(char, char) -> bool) -> impl Iterator<Item = &str> {
    let mut breaks = Vec::new();
    let mut before = ' ';
    let mut characters = text.char_indices().peekable();
    while let Some((at, character)) = characters.next() {
        let after = characters.peek().map(|(_, next)| *next);
        if character == ' ' && after.is_some_and(|after| after != ' ' && may_break(before, after)) {
            breaks.push(at + 1);
        }
        before = character;
    }
    breaks.push(text.len());
    breaks.into_iter().scan(0, |start, end| {
        let word = &text[*start..end];
        *start = end;
        Some(word)
    })
}

/// A text in ASCII: symbols by their usual names.
pub(super) fn ascii(text: &str) -> String {
    let mut out = String::new();
    let mut is_raised = false;
    for character in text.chars() {
        let unraised = unraised(character);
        if let Some(digit) = unraised {
            out.push_str(if is_raised { "" } else { "^" });
            out.push(digit);
        } else {
            out.push_str(plain(character).unwrap_or(character.encode_utf8(&mut [0; 4])));
        }
        is_raised = unraised.is_some();
    }
    out
}

fn plain(character: char) -> Option<&'static str> {
    Some(match character {
        character if character.is_ascii() => return None,
        '·' => "*",
        '∘' => "o",
        '−' => "-",
        '√' => "sqrt",
        'Σ' => "sum",
        '⁺' => "+",
        '′' => "'",
        '₀' => "0",
        '₁' => "1",
        '₂' => "2",
        '₃' => "3",
        '₄' => "4",
        '₅' => "5",
        '₆' => "6",
        '₇' => "7",
        '₈' => "8",
        '₉' => "9",
        'η' => "eta",
        'φ' => "phi",
        'τ' => "tau",
        'ℓ' => "l",
        '→' => "->",
        '←' => "<-",
        '“' | '”' => "\"",
        '×' => "x",
        '…' => "~",
        'á' => "a",
        'é' => "e",
        'í' => "i",
        'ó' => "o",
        'ú' | 'ü' => "u",
        'ñ' => "n",
        'Á' => "A",
        'É' => "E",
        'Í' => "I",
        'Ó' => "O",
        'Ú' => "U",
        'Ñ' => "N",
        '¿' | '¡' | '\u{200c}' | '\u{200d}' => "",
        _ => "?",
    })
}

/// A path with steps that repeat counted: `C R×46 S1`.
pub(super) fn counted(path: &str) -> String {
    /// Two of a kind are as short as their count.
    const SEVERAL: usize = 3;
    let steps: Vec<_> = path.split(' ').collect();
    let runs = steps.chunk_by(|a, b| a == b).map(|run| match run {
        [step, ..] if run.len() >= SEVERAL => format!("{step}×{}", run.len()),
        _ => run.join(" "),
    });
    runs.collect::<Vec<_>>().join(" ")
}

/// A text with a path in it, whose repeated steps are counted.
pub(super) fn with_counted(text: &str, path: &str) -> String {
    text.replacen(path, &counted(path), 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn wraps(text: &str, width: usize, expected: &[&str]) {
        let lines = wrap(&[(text.to_owned(), Style::new())], width, 2);
        let lines: Vec<_> = lines.iter().map(|line| line.to_string().trim_end().to_owned()).collect();
        assert_eq!(lines, expected, "{text} in {width}");
    }

    #[test]
    fn lines_break_at_spaces_and_hang() {
        wraps("one two three", 20, &["one two three"]);
        wraps("one two three", 8, &["one two", "  three"]);
        wraps("", 8, &[""]);
    }

    #[test]
    fn steps_that_repeat_are_counted() {
        let path = |count: usize| format!("3 C{} S1", " R".repeat(count));
        assert_eq!(
            [0, 1, 2, 3, 46].map(|count| counted(&path(count))),
            ["3 C S1", "3 C R S1", "3 C R R S1", "3 C R×3 S1", "3 C R×46 S1"]
        );
        assert_eq!(counted("C T T.1 T.2 T T T"), "C T T.1 T.2 T×3");
        assert_eq!(counted(""), "");
        assert_eq!(with_counted("ray C R R R R, reflected", "C R R R R"), "ray C R×4, reflected");
    }

    #[test]
    fn triples_stay_together_if_they_can() {
        wraps("one x = (1, 2, 3)", 15, &["one", "  x = (1, 2, 3)"]);
        wraps("x = (1, 2, 3)", 9, &["x = (1,", "  2, 3)"]);
    }

    #[test]
    fn long_words_are_cut_and_no_width_is_too_small() {
        wraps("abcdefgh", 5, &["abcde", "  fgh"]);
        for width in 0..4 {
            assert!(!wrap(&[("a bc, def".to_owned(), Style::new())], width, 9).is_empty());
        }
    }

    #[test]
    fn joined_letters_stay_together_and_take_the_columns_that_they_show() {
        wraps("क्‍षक्‍षक्‍ष", 4, &["क्‍षक्‍ष", "  क्‍ष"]);
        wraps("کره‌ی قرمز", 10, &["کره‌ی قرمز"]);
        wraps("👩‍🔬👩‍🔬", 4, &["👩‍🔬👩‍🔬"]);
    }

    #[test]
    fn formulas_in_ascii() {
        assert_eq!(ascii("√(η² − |d|²)/10⁻¹²"), "sqrt(eta^2 - |d|^2)/10^-12");
        assert_eq!(ascii("P₀ P₁₂, H′₁"), "P0 P12, H'1");
        assert_eq!(ascii("ж→x"), "?->x");
        assert_eq!(ascii("ه\u{200c}ی"), "??");
        assert_eq!(ascii("¿decisión? píxel, señal"), "decision? pixel, senal");
    }
}
