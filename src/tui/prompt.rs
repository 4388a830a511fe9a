//! The line that is typed at the bottom: a search, a filter, a command, a breakpoint, an answer.

use super::model::Model;
use super::update::Effect;
use super::{breakpoints, command, search};
use crate::report::words::plain;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

/// A line that is being typed.
#[derive(Clone, Debug)]
pub struct Prompt {
    /// What for.
    pub purpose: Purpose,
    /// What has been typed.
    pub line: Input,
}

/// What a line is typed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// What to look for.
    Search,
    /// What the rows of the tree must match.
    Filter,
    /// Where to stop.
    Break,
    /// A command.
    Command,
    /// What the rows of the help must contain.
    Help,
    /// The result of the current step, in a quiz.
    Answer,
}

impl Purpose {
    /// What stands before the line.
    pub fn sign(self) -> &'static str {
        match self {
            Purpose::Search => "/",
            Purpose::Filter => "filter: ",
            Purpose::Break => "break at: ",
            Purpose::Command => ":",
            Purpose::Help => "keys with: ",
            Purpose::Answer => "your answer: ",
        }
    }
}

impl Prompt {
    /// An empty line.
    pub fn new(purpose: Purpose) -> Prompt {
        Prompt { purpose, line: Input::default() }
    }
}

/// Does what a key does to the line; `Enter` ends it and `Esc` forgets it.
pub(super) fn typed(model: &mut Model, key: KeyEvent) -> Effect {
    model.message.take_if(|message| !message.is_warning);
    let Some(prompt) = &mut model.prompt else { return Effect::None };
    match key.code {
        KeyCode::Esc => model.prompt = None,
        KeyCode::Backspace if prompt.line.value().is_empty() => model.prompt = None,
        KeyCode::Tab => complete(model),
        KeyCode::Enter => {
            let text = prompt.line.value().to_owned();
            let purpose = prompt.purpose;
            model.prompt = None;
            return done(model, purpose, &text);
        }
        _ => {
            if let Some(request) = request(key) {
                prompt.line.handle(request);
            }
        }
    }
    Effect::None
}

/// Completes the line as far as there is no choice, and says what there is where there is one.
fn complete(model: &mut Model) {
    let Some(prompt) = &model.prompt else { return };
    let typed = prompt.line.value().to_owned();
    let ways = command::completions(model, prompt.purpose, &typed);
    let Some(first) = ways.first() else { return };
    let common = ways.iter().skip(1).fold(first.as_str(), |common, way| {
        let same = common.char_indices().zip(way.chars()).find(|((_, ours), theirs)| ours != theirs);
        &common[..same.map_or(common.len().min(way.len()), |((at, _), _)| at)]
    });
    if common.len() > typed.len() {
        let line = Input::new(common.to_owned());
        model.prompt = Some(Prompt { purpose: prompt.purpose, line });
    } else if ways.len() > 1 {
        let some: Vec<_> = ways.iter().take(12).map(|way| plain(way.trim_end())).collect();
        model.say(&some.join("  "));
    }
}

/// What a key changes in a line: as in a shell.
fn request(key: KeyEvent) -> Option<InputRequest> {
    let is_control = key.modifiers.contains(KeyModifiers::CONTROL);
    Some(match key.code {
        KeyCode::Char('a') if is_control => InputRequest::GoToStart,
        KeyCode::Char('e') if is_control => InputRequest::GoToEnd,
        KeyCode::Char('u') if is_control => InputRequest::DeleteLine,
        KeyCode::Char('w') if is_control => InputRequest::DeletePrevWord,
        KeyCode::Char('k') if is_control => InputRequest::DeleteTillEnd,
        KeyCode::Char(_) if is_control => return None,
        KeyCode::Char(character) => InputRequest::InsertChar(character),
        KeyCode::Backspace => InputRequest::DeletePrevChar,
        KeyCode::Delete => InputRequest::DeleteNextChar,
        KeyCode::Left => InputRequest::GoToPrevChar,
        KeyCode::Right => InputRequest::GoToNextChar,
        KeyCode::Home => InputRequest::GoToStart,
        KeyCode::End => InputRequest::GoToEnd,
        _ => return None,
    })
}

/// Does what a finished line asks for.
fn done(model: &mut Model, purpose: Purpose, text: &str) -> Effect {
    match purpose {
        Purpose::Search => search::begin(model, text),
        Purpose::Filter => search::filter(model, text),
        Purpose::Break if text.trim().is_empty() => {}
        Purpose::Break => breakpoints::add(model, text),
        Purpose::Command => return command::run(model, text),
        Purpose::Help => text.clone_into(&mut model.guide.help),
        Purpose::Answer => super::quiz::answer(model, text),
    }
    Effect::None
}
