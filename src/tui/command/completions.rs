//! How a line that is typed may go on.

use super::{Argument, BREAK, COMMANDS, Command, EVAL, HISTORY, SCHEMATIC, SET, UNWATCH, WATCH};
use crate::tui::model::prompt::Purpose;
use crate::tui::model::{Model, breakpoint};
use crate::tui::{drawn, eval, plane, watch};

/// Whether a line is about a parameter, whose paths only the scene knows.
pub(in crate::tui) fn is_of_parameter(line: &str) -> bool {
    line.strip_prefix(SET).is_some_and(|rest| rest.starts_with(' '))
}

/// What of the path of a file is typed, in a line with a command that takes one.
pub(in crate::tui) fn file_in(line: &str) -> Option<&str> {
    let (word, rest) = line.split_once(' ')?;
    let mut begun = COMMANDS.iter().filter(|command| command.name.starts_with(word));
    let command = begun.next().filter(|command| command.name == word || begun.next().is_none())?;
    (command.argument == Argument::File).then(|| rest.trim_start())
}

/// How the typed text may go on, if something can go on there.
pub(in crate::tui) fn completions(model: &Model, purpose: Purpose, text: &str) -> Vec<String> {
    let (word, rest) = text.split_once(' ').map_or((text, None), |(word, rest)| (word, Some(rest)));
    let behind = |ways: Vec<String>| ways.into_iter().map(|way| format!("{word} {way}")).collect();
    match (purpose, word, rest) {
        (Purpose::Break, ..) => breakpoint::completions(&model.log, text),
        (Purpose::Command, BREAK, Some(condition)) => behind(breakpoint::completions(&model.log, condition)),
        (Purpose::Command, EVAL, Some(expression)) => behind(eval::completions(model, expression)),
        (Purpose::Command, WATCH | HISTORY, Some(key)) => behind(watch::completions(model, key)),
        (Purpose::Command, UNWATCH, Some(key)) => behind(watch::pinned_completions(model, key)),
        (Purpose::Command, SCHEMATIC, Some(begun)) => {
            behind(drawn::words().into_iter().filter(|word| word.starts_with(begun)).map(str::to_owned).collect())
        }
        (Purpose::Command, plane::PICTURE, Some(_)) => plane::completions(model, text),
        (Purpose::Command, _, None) => {
            let begun = COMMANDS.iter().filter(|command| command.name.starts_with(text));
            let gap = |command: &Command| if command.argument == Argument::Nothing { "" } else { " " };
            begun.map(|command| format!("{}{}", command.name, gap(command))).collect()
        }
        _ => Vec::new(),
    }
}
