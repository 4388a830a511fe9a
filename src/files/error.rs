//! What is wrong with a scene file, and where: for people, and as an exit code.

use std::fmt;
use std::io;
use std::ops::Range;

use super::escape::{escape_hidden, escape_hidden_lines, width};
use super::key_path::KeyPath;

/// Why there is no scene.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The text is no good scene; at least one problem.
    #[error("{}", in_lines(problems, *omitted))]
    Invalid {
        /// What is wrong, in the order of the file's keys.
        problems: Vec<Problem>,
        /// How many more there are.
        omitted: usize,
    },
    /// The file is not one that can be a scene: missing, a directory, a device, too large.
    #[error("{}: {reason}", escape_hidden(file))]
    Refused {
        /// The file's name.
        file: String,
        /// What is wrong, and what was expected.
        reason: String,
    },
    /// The machine did not give the bytes.
    #[error("{}: cannot read: {source}", escape_hidden(file))]
    Unreadable {
        /// The file's name.
        file: String,
        /// What the system said.
        source: io::Error,
    },
}

impl FileError {
    /// 2 when the caller must change something, 3 when a retry may help.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Invalid { .. } | Self::Refused { .. } => 2,
            Self::Unreadable { .. } => 3,
        }
    }

    /// The problems of the text; none when there was no text.
    pub fn problems(&self) -> &[Problem] {
        match self {
            Self::Invalid { problems, .. } => problems,
            Self::Refused { .. } | Self::Unreadable { .. } => &[],
        }
    }

    /// All problems as they are shown to a person, each with its source line; ends without a newline.
    pub fn report(&self, color: bool) -> String {
        let label = Severity::Error.label(color);
        match self {
            Self::Invalid { problems, omitted } => {
                let mut reports: Vec<String> =
                    problems.iter().map(|problem| problem.report(Severity::Error, color)).collect();
                reports.extend((*omitted > 0).then(|| format!("{label}: {}", and_more(*omitted))));
                reports.join("\n")
            }
            Self::Refused { .. } | Self::Unreadable { .. } => format!("{label}: {}", escape_hidden(&self.to_string())),
        }
    }
}

impl From<Problem> for FileError {
    fn from(problem: Problem) -> Self {
        Self::Invalid { problems: vec![problem], omitted: 0 }
    }
}

/// What is said of warnings that are not shown; `None` where there are none.
pub fn more_warnings(count: usize, color: bool) -> Option<String> {
    (count > 0).then(|| format!("{}: and {count} more warnings, not shown", Severity::Warning.label(color)))
}

fn in_lines(problems: &[Problem], omitted: usize) -> String {
    let mut lines: Vec<String> = problems.iter().map(Problem::to_string).collect();
    lines.extend((omitted > 0).then(|| and_more(omitted)));
    lines.join("\n")
}

fn and_more(omitted: usize) -> String {
    format!("and {omitted} more problems, not shown")
}

/// How bad a problem is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The scene is refused.
    Error,
    /// The scene is traced all the same.
    Warning,
}

impl Severity {
    fn label(self, color: bool) -> String {
        let word = match self {
            Self::Error => "error",
            Self::Warning => "warning",
        };
        self.paint(word, color)
    }

    fn paint(self, text: &str, color: bool) -> String {
        let code = match self {
            Self::Error => "1;31",
            Self::Warning => "1;33",
        };
        if color { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_string() }
    }
}

/// One error. It displays as `FILE:LINE:COL: PATH: what is wrong, what was expected`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The file's name.
    pub file: String,
    /// The line, from 1; 0 when the problem has no place in a text.
    pub line: usize,
    /// The column in characters, from 1; 0 when the problem has no place in a text.
    pub column: usize,
    /// The way to the value; the root when the problem is with the text as such.
    pub path: KeyPath,
    /// What is wrong, what was expected.
    pub message: String,
    /// The place in the file in bytes.
    pub span: Option<Range<usize>>,
    /// The source line.
    pub excerpt: Option<Excerpt>,
}

/// The part of a source line that is shown below an error, ready to print.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    /// The line, or the part of it around the place.
    pub line: String,
    /// Characters of `line` before the place.
    pub before: usize,
    /// Characters of `line` to underline, 1 or more.
    pub width: usize,
}

impl Problem {
    /// The problem as it is shown to a person, with its source line underlined; ends without a newline.
    pub fn report(&self, severity: Severity, color: bool) -> String {
        let first_line = format!("{}: {}", severity.label(color), escape_hidden_lines(&self.to_string()));
        let Some(excerpt) = &self.excerpt else {
            return first_line;
        };
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        let columns =
            |from: usize, count: usize| width(&excerpt.line.chars().skip(from).take(count).collect::<String>());
        let underline = severity.paint(&"^".repeat(columns(excerpt.before, excerpt.width).max(1)), color);
        let indent = " ".repeat(columns(0, excerpt.before));
        let line = &excerpt.line;
        format!("{first_line}\n{margin} |\n{number} | {line}\n{margin} | {indent}{underline}")
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}:", escape_hidden(&self.file))?;
        if self.line > 0 {
            write!(formatter, "{}:{}:", self.line, self.column)?;
        }
        if !self.path.is_root() {
            write!(formatter, " {}:", self.path)?;
        }
        write!(formatter, " {}", self.message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Source;

    fn problem() -> Problem {
        let source = Source { name: "a.json", text: b"{\n  \"radius\": -1\n}" };
        source.problem(14..16, KeyPath::default().join("radius"), "must be positive, found -1".into())
    }

    #[test]
    fn the_source_line_is_underlined() {
        let expected =
            "error: a.json:2:13: radius: must be positive, found -1\n  |\n2 |   \"radius\": -1\n  |             ^^";
        assert_eq!(FileError::from(problem()).report(false), expected);
    }

    #[test]
    fn the_mark_is_under_letters_of_any_width() {
        let source = Source { name: "a.json", text: "{\"کره‌ی 球\": 漢字}".as_bytes() };
        let report = source.problem(20..26, KeyPath::default(), "no value".into()).report(Severity::Error, false);
        assert_eq!(report.lines().last(), Some("  |             ^^^^"), "{report}");
    }

    #[test]
    fn colour_leaves_the_words_as_they_are() {
        let report = problem().report(Severity::Warning, true);
        assert!(report.starts_with("\x1b[1;33mwarning\x1b[0m: a.json:2:13: radius:"), "{report}");
    }

    #[test]
    fn problems_that_are_not_shown_are_counted() {
        let error = FileError::Invalid { problems: vec![problem()], omitted: 7 };
        assert!(error.to_string().ends_with("\nand 7 more problems, not shown"));
    }

    #[test]
    fn a_retry_helps_only_against_the_machine() {
        let source = io::Error::from(io::ErrorKind::PermissionDenied);
        assert_eq!(FileError::Unreadable { file: "a".into(), source }.exit_code(), 3);
        assert_eq!(FileError::from(problem()).exit_code(), 2);
    }
}
