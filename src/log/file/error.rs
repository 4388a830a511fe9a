//! What can be wrong with a log, and how it ends.

use super::MAX_SAVED_EVENTS;
use crate::files::escape::shortened;
use crate::log::header::FORMAT;

/// Why a log can't be read.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    /// The bytes couldn't be had.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// There is no header.
    #[error("1:1: not a log: expected the header of a `{FORMAT}` log, found {found}")]
    NotALog {
        /// What is there instead.
        found: String,
    },
    /// The header isn't whole.
    #[error("1:1: the log was cut off in its header")]
    NoWholeHeader,
    /// The log is of another version.
    #[error("1:1: log: this program reads `{FORMAT}`, the log is `{found}`")]
    OtherVersion {
        /// The version that the log names.
        found: String,
    },
    /// There are more events than are held in memory.
    #[error(
        "{line}:1: the log is too long to be held in memory, expected at most {MAX_SAVED_EVENTS} events, found more"
    )]
    TooLong {
        /// The line of the first that is too many, from 1.
        line: usize,
    },
    /// A record is damaged.
    #[error("{line}:{column}: {message}")]
    Damaged {
        /// The line of the record, from 1.
        line: usize,
        /// The column in it, from 1.
        column: usize,
        /// What is wrong with it.
        message: String,
    },
}

impl LogError {
    /// A record that is damaged. The message may quote the log, so it is escaped and shortened.
    pub(super) fn damaged(line: usize, column: usize, message: &str) -> LogError {
        const LONGEST: usize = 200;
        LogError::Damaged { line, column, message: shortened(message, LONGEST) }
    }
}

pub(super) fn error_at(line: usize, error: &serde_json::Error) -> LogError {
    LogError::damaged(line + error.line().saturating_sub(1), error.column().max(1), &message_of(error))
}

/// What is wrong, without the place.
pub(super) fn message_of(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.split(" at line ").next().unwrap_or(&text).to_owned()
}

/// How a log ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// With an end line that fits.
    Complete,
    /// Without an end line: the log was cut off, or is still being written.
    Missing {
        /// Whether the last line is incomplete (it was skipped).
        incomplete_record: bool,
    },
    /// With an end line that fits, but the log has quantities that this program doesn't know. They were skipped.
    Unknown {
        /// How many there are.
        count: usize,
        /// What the first is called.
        key: String,
        /// Its line.
        line: usize,
    },
    /// With an end line that doesn't fit what precedes it.
    Mismatch {
        /// What doesn't fit.
        what: String,
    },
    /// With a record that can't be read, or with packed data that can't be unpacked: what precedes it was read.
    Damaged {
        /// Where and what the damage is.
        what: String,
    },
}

impl Ending {
    /// Whether the log is whole, and all of it was read.
    pub fn is_whole(&self) -> bool {
        *self == Ending::Complete
    }

    /// A sentence for people; `None` if all is well.
    pub fn warning(&self) -> Option<String> {
        match self {
            Ending::Complete => None,
            Ending::Missing { incomplete_record: false } => Some("the log has no end line: it was cut off".into()),
            Ending::Missing { incomplete_record: true } => {
                Some("the log was cut off: 1 incomplete record was skipped".into())
            }
            Ending::Unknown { count, key, line } => Some(match count {
                1 => format!("1 value of an unknown quantity was skipped, in line {line}: `{key}`"),
                _ => {
                    format!("{count} values of unknown quantities were skipped, the first in line {line}: `{key}`")
                }
            }),
            Ending::Mismatch { what } => Some(format!("the log was changed after it was written: {what}")),
            Ending::Damaged { what } => Some(format!("the log is damaged, this is what precedes the damage: {what}")),
        }
    }
}
