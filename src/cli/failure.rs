//! What goes wrong, as a message and an exit code.

use raywalk::files::{FileError, escape_hidden, escape_hidden_lines};
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// The answer is negative: a check failed.
pub const NEGATIVE: u8 = 1;
/// The caller must change something.
pub const CALLER: u8 = 2;
/// The machine said no; a retry may help.
pub const MACHINE: u8 = 3;
/// The terminal is gone (SIGHUP).
pub const HUNG_UP: u8 = 129;
/// Interrupted (SIGINT).
pub const INTERRUPTED: u8 = 130;
/// Terminated (SIGTERM).
pub const TERMINATED: u8 = 143;

/// A path as messages show it: whatever its name has in it, it is text.
pub fn shown(path: &Path) -> String {
    escape_hidden(&path.to_string_lossy()).into_owned()
}

/// Why a command ends early.
#[derive(Debug)]
pub struct Failure {
    code: u8,
    /// The message, ready to be printed; empty when there is nothing to say.
    message: String,
}

impl Failure {
    /// The caller must change something. What a message quotes is [`shown`] where it is put in, so that it stays in its line; whatever isn't is
    /// made visible here.
    pub fn caller(message: impl Into<String>) -> Failure {
        Failure { code: CALLER, message: escape_hidden_lines(&format!("error: {}", message.into())) }
    }

    /// The machine said no.
    pub fn machine(message: impl Into<String>) -> Failure {
        Failure { code: MACHINE, message: escape_hidden_lines(&format!("error: {}", message.into())) }
    }

    /// The same, with what helps in a line of its own.
    pub fn with_note(mut self, note: &str) -> Failure {
        self.message = format!("{}\nnote: {note}", self.message);
        self
    }

    /// An exit code without a message.
    pub fn silent(code: u8) -> Failure {
        Failure { code, message: String::new() }
    }

    /// A scene that can't be had.
    pub fn scene(error: &FileError) -> Failure {
        Failure { code: error.exit_code(), message: error.report(true) }
    }

    /// A file that can't be read or written.
    pub fn io(path: &Path, doing: &str, error: &io::Error) -> Failure {
        Failure::machine(format!("{}: cannot {doing}: {error}", shown(path)))
    }

    /// Writing to standard output. A closed pipe ends the program quietly.
    pub fn stdout(error: &io::Error) -> Failure {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::silent(0),
            _ => Failure::machine(format!("standard output: cannot write: {error}")),
        }
    }

    /// The exit code.
    pub fn code(&self) -> u8 {
        self.code
    }

    /// Prints the message to standard error, and gives the exit code of the process.
    pub fn exit(&self) -> ExitCode {
        self.print();
        ExitCode::from(self.code)
    }

    /// The first line of the message, without its label.
    pub fn line(&self) -> &str {
        let line = self.message.lines().next().unwrap_or_default();
        line.strip_prefix("error: ").unwrap_or(line)
    }

    /// Prints the message to standard error.
    pub fn print(&self) {
        if !self.message.is_empty() {
            // Where standard error is closed nothing can be reported.
            let _ = writeln!(anstream::stderr(), "{}", self.message);
        }
    }
}
