//! The line that is typed at the bottom: a search, a filter, a command, a breakpoint, an answer.

use super::command::Done;
use super::effect::Effect;
use super::model::Model;
use super::model::prompt::{Prompt, Purpose};
use super::{breakpoints, command, quiz, search};
use crate::files::escape::escape_hidden;
use crate::report::words::plain;
use crossterm::event::{Event, KeyCode, KeyEvent, KeyModifiers};
use std::collections::HashMap;
use tui_input::Input;
use tui_input::backend::crossterm::EventHandler;

/// Puts a pasted text into the line, whatever its characters would do as keys: ends of lines become blanks, and what isn't seen is shown
/// as messages show it. Where no line is typed it does nothing.
pub(super) fn pasted(model: &mut Model, text: &str) {
    model.message = None;
    let Some(prompt) = &mut model.prompt else { return model.say(model.texts().messages.pasted_nowhere) };
    prompt.line = with_pasted(&prompt.line, text);
}

/// A line with a text at its cursor.
pub(super) fn with_pasted(typed: &Input, text: &str) -> Input {
    let text = text.replace("\r\n", " ").replace(['\r', '\n', '\t'], " ");
    let (line, cursor) = (typed.value(), typed.cursor());
    let at = line.char_indices().nth(cursor).map_or(line.len(), |(at, _)| at);
    let before = format!("{}{}", &line[..at], escape_hidden(&text));
    let cursor = before.chars().count();
    Input::new(before + &line[at..]).with_cursor(cursor)
}

/// Does what a key does to the line: `Enter` ends it, unless something is wrong with it, and `Esc` or `^C` forgets it.
pub(super) fn typed(model: &mut Model, key: KeyEvent) -> Effect {
    model.message = None;
    let Some(prompt) = &mut model.prompt else { return Effect::None };
    match key.code {
        KeyCode::Esc => model.prompt = None,
        KeyCode::Char('c') if key.modifiers.contains(KeyModifiers::CONTROL) => model.prompt = None,
        KeyCode::Backspace if prompt.line.value().is_empty() => model.prompt = None,
        KeyCode::Tab if is_of_scene_or_file(prompt) => {
            return Effect::Complete;
        }
        KeyCode::Tab => complete(model),
        KeyCode::Up => recall(model, |back| back + 1),
        KeyCode::Down => recall(model, |back| back.saturating_sub(1)),
        KeyCode::Enter => return finish(model),
        _ => {
            prompt.line.handle_event(&Event::Key(key));
        }
    }
    Effect::None
}

/// Ends the line; one that is wrong stays to be mended, with what is wrong above it.
fn finish(model: &mut Model) -> Effect {
    let Some(prompt) = model.prompt.take() else { return Effect::None };
    let text = prompt.line.value().to_owned();
    model.guide.history.remember(prompt.purpose, &text);
    done(model, prompt.purpose, &text).unwrap_or_else(|why| {
        // It is the latest of the lines now; `Up` leads to the one before, and `Down` back to it as it was mended.
        let tried = usize::from(model.guide.history.before(prompt.purpose, 1).is_some_and(|(_, line)| line == text));
        model.prompt = Some(Prompt { recalled: 0, left: HashMap::new(), tried, ..prompt });
        model.say(&why);
        Effect::None
    })
}

/// Brings back a line that was typed before, or what was being typed. Lines that are left come back as they were changed.
fn recall(model: &mut Model, further: fn(usize) -> usize) {
    let Some(prompt) = &mut model.prompt else { return };
    let wanted = further(prompt.recalled);
    let known = model.guide.history.before(prompt.purpose, wanted + prompt.tried).filter(|_| wanted > 0);
    // There may be fewer before it.
    let place = known.map_or(0, |(back, _)| back - prompt.tried);
    if place == prompt.recalled || (place == 0 && wanted > 0) {
        return;
    }
    let line = prompt.left.remove(&place).or(known.map(|(_, line)| line.to_owned())).unwrap_or_default();
    let left = std::mem::replace(&mut prompt.line, line.into());
    prompt.left.insert(prompt.recalled, left.value().to_owned());
    prompt.recalled = place;
}

/// Whether the path of a file is being typed.
pub(super) fn is_of_file(model: &Model) -> bool {
    model.prompt.as_ref().is_some_and(|prompt| command::file_in(prompt.line.value()).is_some())
}

/// Whether what is being typed can only be completed by who knows the scene and the files.
fn is_of_scene_or_file(prompt: &Prompt) -> bool {
    let line = prompt.line.value();
    prompt.purpose == Purpose::Command && (command::is_of_parameter(line) || command::file_in(line).is_some())
}

/// Completes the path of a file, and says which there are.
pub(super) fn complete_file(model: &mut Model, files: impl FnOnce(&str) -> Vec<String>) {
    let Some(prompt) = &model.prompt else { return };
    let line = prompt.line.value();
    let Some(typed) = command::file_in(line) else { return };
    let before = line[..line.len() - typed.len()].to_owned();
    let found = files(typed);
    let ways: Vec<_> = found.iter().map(|file| format!("{before}{file}")).collect();
    if !complete_to(model, &ways) && found.len() > 1 {
        let name = |file: &String| plain(file.trim_end_matches('/').rsplit('/').next().unwrap_or_default());
        let some: Vec<_> = found.iter().take(12).map(name).collect();
        model.say(&some.join("  "));
    }
}

/// Completes the path of a parameter, and says which values there are.
pub(super) fn complete_path(model: &mut Model, parameters: impl FnOnce(&str) -> Vec<(String, String)>) {
    let Some(prompt) = &model.prompt else { return };
    let Some((command, typed)) = prompt.line.value().split_once(' ') else { return };
    // Behind the path is the value.
    let path = typed.split(' ').next().unwrap_or_default();
    let found = parameters(path);
    let ways: Vec<_> = found.iter().map(|(path, _)| format!("{command} {path} ")).collect();
    let nothing = (model.texts().messages.no_parameter)(&plain(path), "");
    match &ways[..] {
        // The value stays as it was typed.
        _ if typed.contains(' ') => {}
        // The only one may have other steps in between.
        [way] => model.prompt = Some(Prompt { line: way.as_str().into(), ..prompt.clone() }),
        ways => _ = complete_to(model, ways),
    }
    let some: Vec<_> = found.iter().take(8).map(|(path, value)| format!("{path} = {value}")).collect();
    model.say(&if some.is_empty() { nothing } else { plain(&some.join("   ")) });
}

/// Completes the line as far as there is no choice, and says what there is where there is one.
fn complete(model: &mut Model) {
    let Some(prompt) = &model.prompt else { return };
    let ways = command::completions(model, prompt.purpose, prompt.line.value());
    if !complete_to(model, &ways) && ways.len() > 1 {
        let some: Vec<_> = ways.iter().take(12).map(|way| plain(way.trim_end())).collect();
        model.say(&some.join("  "));
    }
}

/// Completes the line as far as all ways have in common, and says whether that is further than it was.
fn complete_to(model: &mut Model, ways: &[String]) -> bool {
    let (Some(prompt), Some(first)) = (&model.prompt, ways.first()) else { return false };
    let common = ways.iter().skip(1).fold(first.as_str(), |common, way| {
        let same = common.char_indices().zip(way.chars()).find(|((_, ours), theirs)| ours != theirs);
        &common[..same.map_or(common.len().min(way.len()), |((at, _), _)| at)]
    });
    let is_longer = common.len() > prompt.line.value().len();
    if is_longer {
        model.prompt = Some(Prompt { line: common.into(), ..prompt.clone() });
    }
    is_longer
}

/// Does what a finished line asks for.
fn done(model: &mut Model, purpose: Purpose, text: &str) -> Done {
    match purpose {
        Purpose::Search => search::begin(model, text),
        Purpose::Filter => search::filter(model, text),
        Purpose::Break if text.trim().is_empty() => Ok(()),
        Purpose::Break => breakpoints::add(model, text),
        Purpose::Command => return command::run(model, text),
        Purpose::Help => {
            text.clone_into(&mut model.guide.help);
            Ok(())
        }
        Purpose::Answer => quiz::answer(model, text),
    }
    .map(|()| Effect::None)
}
