//! What the readers of meshes find wrong, before it has the name of a file and a line.

use std::collections::TryReserveError;
use std::io::{self, ErrorKind};
use std::ops::Range;

use crate::files::{FileError, KeyPath, Problem, Source};

/// Why a mesh can't be read.
#[derive(Debug)]
pub enum Fault {
    /// Something in the file.
    Wrong {
        /// Where, in bytes.
        span: Range<usize>,
        /// What is wrong, what was expected.
        message: String,
    },
    /// The machine has no room for it.
    OutOfMemory,
}

impl Fault {
    /// Something in the file.
    pub fn wrong(span: Range<usize>, message: impl Into<String>) -> Fault {
        Fault::Wrong { span, message: message.into() }
    }

    /// The fault with words in front of it.
    pub fn inside(self, what: impl FnOnce() -> String) -> Fault {
        match self {
            Fault::Wrong { span, message } => Fault::Wrong { span, message: format!("{}: {message}", what()) },
            Fault::OutOfMemory => Fault::OutOfMemory,
        }
    }

    /// The error for a file of text: its line is shown.
    pub fn in_text(self, source: &Source) -> FileError {
        match self {
            Fault::Wrong { span, message } => source.problem(span, KeyPath::default(), message).into(),
            Fault::OutOfMemory => out_of_memory(source.name),
        }
    }

    /// The error for a file that is text up to `text_length` and then bytes, which have no lines.
    pub fn in_binary(self, source: &Source, text_length: usize) -> FileError {
        match self {
            Fault::Wrong { span, message } if span.start >= text_length => {
                let message = format!("{message} (at byte {})", span.start);
                Problem { span: Some(span), ..without_place(source.name, message) }.into()
            }
            _ => self.in_text(source),
        }
    }
}

impl From<TryReserveError> for Fault {
    fn from(_: TryReserveError) -> Fault {
        Fault::OutOfMemory
    }
}

/// A problem with a file as a whole.
pub fn without_place(file: &str, message: String) -> Problem {
    Problem { file: file.to_owned(), line: 0, column: 0, path: KeyPath::default(), message, span: None, excerpt: None }
}

/// The machine has no room for what is in this file.
pub fn out_of_memory(file: &str) -> FileError {
    FileError::Unreadable { file: file.to_owned(), source: io::Error::from(ErrorKind::OutOfMemory) }
}
