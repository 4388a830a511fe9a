//! A text from outside and the places in it: offsets become lines and columns, and lines become what is shown of them.

use std::ops::Range;

use super::error::{Excerpt, Problem};
use super::escape::escape_hidden;
use super::key_path::KeyPath;

/// How many bytes of a long line are shown before and after the place; twice as many are not yet long.
const SHOWN: usize = 60;

/// A text with the name of the file that it came from.
#[derive(Clone, Copy)]
pub struct Source<'t> {
    /// The file's name, as it is to be printed.
    pub name: &'t str,
    /// The text; it need not be UTF-8.
    pub text: &'t [u8],
}

impl Source<'_> {
    /// A problem at a place of this text.
    pub fn problem(&self, span: Range<usize>, path: KeyPath, message: String) -> Problem {
        let (line, column) = self.line_and_column(span.start);
        Problem {
            file: self.name.to_string(),
            line,
            column,
            path,
            message,
            excerpt: Some(self.excerpt(&span)),
            span: Some(span),
        }
    }

    /// Line and column of a byte, both from 1; columns count characters.
    pub fn line_and_column(&self, offset: usize) -> (usize, usize) {
        let before = &self.text[..offset.min(self.text.len())];
        let line = memchr::memchr_iter(b'\n', before).count() + 1;
        let in_line = &before[start_of_last_line(before)..];
        let column = in_line.iter().filter(|&&byte| starts_character(byte)).count() + 1;
        (line, column)
    }

    fn excerpt(&self, span: &Range<usize>) -> Excerpt {
        let start = span.start.min(self.text.len());
        let line_start = start_of_last_line(&self.text[..start]);
        let line_end = self.text[start..]
            .iter()
            .position(|&byte| byte == b'\n' || byte == b'\r')
            .map_or(self.text.len(), |length| start + length);
        let end = span.end.clamp(start, line_end);
        let shown = if line_end - line_start <= 2 * SHOWN { 2 * SHOWN } else { SHOWN };
        let from = start.saturating_sub(shown).max(line_start);
        let from = self.next_boundary(from).min(start);
        let cut = end.min(start + shown);
        let to = self.next_boundary(line_end.min(cut + shown));
        let part = |range: Range<usize>| {
            escape_hidden(&String::from_utf8_lossy(&self.text[range]).replace('\t', " ")).into_owned()
        };
        let head = if from > line_start { "…" } else { "" };
        let tail = if to < line_end { "…" } else { "" };
        // Escapes lengthen what is shown, so the parts are cut once more.
        let before = format!("{head}{}", last(&part(from..start), shown));
        let place = first(&part(start..self.next_boundary(cut)), shown).to_owned();
        let after = part(self.next_boundary(cut)..to);
        let after = first(&after, shown);
        Excerpt {
            before: before.chars().count(),
            width: place.chars().count().max(1),
            line: format!("{before}{place}{after}{tail}"),
        }
    }

    /// The first beginning of a character at or after an offset.
    fn next_boundary(&self, offset: usize) -> usize {
        let rest = &self.text[offset..];
        let skipped = rest.iter().position(|&byte| starts_character(byte));
        skipped.map_or(self.text.len(), |skipped| offset + skipped)
    }
}

/// A text without the mark that editors on some systems begin it with.
pub fn without_mark(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)
}

/// The first characters of a text, at most `limit`.
fn first(text: &str, limit: usize) -> &str {
    text.char_indices().nth(limit).map_or(text, |(end, _)| &text[..end])
}

/// The last characters of a text, at most `limit`.
fn last(text: &str, limit: usize) -> &str {
    let left_out = text.chars().count().saturating_sub(limit);
    text.char_indices().nth(left_out).map_or("", |(start, _)| &text[start..])
}

fn start_of_last_line(text: &[u8]) -> usize {
    memchr::memrchr(b'\n', text).map_or(0, |newline| newline + 1)
}

fn starts_character(byte: u8) -> bool {
    byte & 0b1100_0000 != 0b1000_0000
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn shows(text: &str, span: Range<usize>, line: &str, underlined: &str) {
        let source = Source { name: "t", text: text.as_bytes() };
        let excerpt = source.excerpt(&span);
        assert_eq!(excerpt.line, line);
        let part: String = excerpt.line.chars().skip(excerpt.before).take(excerpt.width).collect();
        assert_eq!(part, underlined);
    }

    #[test]
    fn columns_count_characters() {
        let source = Source { name: "t", text: "ñ\nñañ".as_bytes() };
        assert_eq!(source.line_and_column(6), (2, 3));
    }

    #[test]
    fn the_line_of_the_place() {
        shows("one\ntwo three\r\nfour", 8..13, "two three", "three");
    }

    #[test]
    fn a_place_of_several_lines_is_underlined_on_its_first() {
        shows("a {\n}\n", 2..5, "a {", "{");
    }

    #[test]
    fn escapes_move_the_underline() {
        shows("\u{1b}ab", 2..3, "\\u{1b}ab", "b");
    }

    #[test]
    fn long_lines_are_cut_around_the_place() {
        let text = format!("{}X{}", "a".repeat(1000), "b".repeat(1000));
        let line = format!("…{}X{}…", "a".repeat(SHOWN), "b".repeat(SHOWN));
        shows(&text, 1000..1001, &line, "X");
    }

    #[test]
    fn what_escapes_lengthen_is_cut_again() {
        let text = format!("{}X", "\0".repeat(30));
        shows(&text, 30..31, &format!("{}X", "\\u{0}".repeat(24)), "X");
    }

    #[test]
    fn the_end_of_the_text_is_a_place() {
        shows("{", 1..1, "{", "");
    }
}
