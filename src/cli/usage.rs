//! How the command line is read, and what is said of one that can't be: arguments are shown in messages, and never sent to the terminal.

use super::failure::{CALLER, Failure};
use super::{Cli, output};
use clap::builder::{StyledStr, Styles};
use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Error, Parser};
use raywalk::files::{escape_hidden, escape_hidden_lines};
use std::error::Error as _;
use std::io::{self, Write};
use std::process::ExitCode;

/// Reads the command line. Where there is nothing to run, help and version were printed to standard output or what is wrong to
/// standard error.
pub fn parse() -> Result<Cli, ExitCode> {
    Cli::try_parse().map_err(|error| ExitCode::from(print(&error)))
}

/// Gives the exit code.
fn print(error: &Error) -> u8 {
    if error.use_stderr() {
        // Where standard error is closed nothing can be reported.
        let _ = match is_plain() {
            true => error.print(),
            false => {
                io::stderr().write_all(escaped().unwrap_or_else(|| escape_hidden_lines(&error.to_string())).as_bytes())
            }
        };
        return CALLER;
    }
    let print = || error.print().and_then(|()| io::stdout().flush()).map_err(|error| Failure::stdout(&error));
    // The lock is gone before it is asked for again.
    match output::standard().map(drop).and_then(|()| print()) {
        Ok(()) => 0,
        Err(failure) => {
            failure.print();
            failure.code()
        }
    }
}

/// Whether all arguments are seen as themselves.
fn is_plain() -> bool {
    std::env::args_os().skip(1).all(|argument| argument.to_str().is_some_and(|text| *escape_hidden(text) == *text))
}

/// What is wrong with this call, without colours and with all that comes from the arguments made visible.
///
/// The arguments occur in the message's parts, and in what the reader of a value said. With them escaped there no line of theirs can be taken
/// for one of the message. `None` if nothing is found wrong.
fn escaped() -> Option<String> {
    // The same mistake again, but without colours: what is escaped then is what comes from outside.
    let mut error = Cli::command().styles(Styles::plain()).try_get_matches_from(std::env::args_os()).err()?;
    let parts: Vec<(ContextKind, ContextValue)> = error.context().map(|(kind, value)| (kind, value.clone())).collect();
    let styled = |text: StyledStr| StyledStr::from(escape_hidden(&text.ansi().to_string()).into_owned());
    for (kind, value) in parts {
        let shown = match value {
            ContextValue::String(text) => ContextValue::String(escape_hidden(&text).into_owned()),
            ContextValue::Strings(texts) => {
                ContextValue::Strings(texts.iter().map(|text| escape_hidden(text).into_owned()).collect())
            }
            ContextValue::StyledStrs(texts) => ContextValue::StyledStrs(texts.into_iter().map(styled).collect()),
            // How the command is called, in several lines, knows nothing of this call.
            other => other,
        };
        error.insert(kind, shown);
    }
    let text = error.render().ansi().to_string();
    let said = error.source().map(ToString::to_string).filter(|said| !said.is_empty());
    let text = said.map_or(text.clone(), |said| text.replace(&said, &escape_hidden(&said)));
    Some(escape_hidden_lines(&text))
}
