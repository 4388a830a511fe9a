//! What can be wrong with a log.

use super::reader::MAX_SAVED_EVENTS;
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
