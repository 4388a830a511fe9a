//! Two logs beside each other: both trees aligned, what differs marked, the computation of both below.
//!
//! A smaller viewer of its own: what is walked through here are the rows of a comparison, and its keys are those of the viewer as
//! far as they mean something for two logs.

mod view;

use super::Theme;
use super::effect::{Effect, Exit};
use super::keys::{self, Action, Walk};
use super::model::Pending;
use super::model::bindings::Bindings;
use super::model::prompt::{Prompt, Purpose};
use super::model::search::Pattern;
use super::terminal::{Asker, Input, Terminal};
use super::{list, prompt};
use crate::report::diff::Rows;
use crate::report::language::Language;
use crossterm::event::{Event, KeyCode, KeyEvent, KeyModifiers};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::io;
use tui_input::backend::crossterm::EventHandler;

/// Two logs, and where in them one is.
pub struct Beside<'a> {
    rows: Rows<'a>,
    /// What the two logs are, such as `textbook, pixel 160,120, f64`.
    titles: [String; 2],
    /// The rows that differ.
    differing: Vec<usize>,
    cursor: usize,
    /// How many rows of the table the screen has.
    height: usize,
    /// By how many columns the rows are scrolled to the right.
    shift: usize,
    /// What is said at the bottom until the next key.
    message: Option<String>,
    /// A count that was typed and isn't used yet.
    pending: Pending,
    /// The line that is being typed.
    prompt: Option<Prompt>,
    /// What is looked for.
    search: Option<Pattern>,
    /// Whether the keys are listed.
    has_help: bool,
    /// The keys that the user has bound.
    bindings: Bindings,
}

/// How many columns the rows are scrolled at once.
const STRIDE: usize = 8;

impl<'a> Beside<'a> {
    /// Two logs, at the first row that differs.
    pub fn new(rows: Rows<'a>, titles: [String; 2]) -> Beside<'a> {
        let differing: Vec<usize> = (0..rows.rows().len()).filter(|row| rows.rows()[*row].differs).collect();
        let cursor = differing.first().copied().unwrap_or(0);
        Beside {
            rows,
            titles,
            differing,
            cursor,
            height: 1,
            shift: 0,
            message: None,
            pending: Pending::default(),
            prompt: None,
            search: None,
            has_help: false,
            bindings: Bindings::default(),
        }
    }

    /// The same, with these keys.
    pub fn with_keys(self, bindings: Bindings) -> Beside<'a> {
        Beside { bindings, ..self }
    }

    /// The terminal has this many rows now.
    pub fn resize(&mut self, height: u16) {
        self.height = view::rows_of_table(height);
    }

    /// Does what a key of the viewer means here, and says what is left to do: nothing, to leave or to suspend.
    pub fn press(&mut self, key: KeyEvent) -> Effect {
        let Some(action) = keys::action(&self.bindings, &self.pending, key) else { return Effect::None };
        self.message = None;
        if action != Action::Suspend || (self.prompt.is_some() && keys::is_typed(key)) {
            if self.prompt.is_some() {
                return self.type_key(key);
            }
            if std::mem::take(&mut self.has_help) {
                return Effect::None;
            }
        }
        if let Action::Digit(digit) = action {
            let count = self.pending.count.unwrap_or(0).saturating_mul(10).saturating_add(u32::from(digit));
            self.pending.count = Some(count);
            return Effect::None;
        }
        let count = std::mem::take(&mut self.pending).count;
        self.act(action, count)
    }

    /// Does an action as often as the number typed before it says.
    fn act(&mut self, action: Action, count: Option<u32>) -> Effect {
        let times = count.unwrap_or(1) as usize;
        let last = self.rows.rows().len().saturating_sub(1);
        match action {
            Action::Interrupt => return Effect::Leave(Exit::Interrupted),
            Action::Suspend => return Effect::Suspend,
            Action::Close if self.search.take().is_some() => {}
            Action::Quit | Action::Close => return Effect::Leave(Exit::Quit),
            Action::Help => self.has_help = true,
            Action::Search => self.prompt = Some(Prompt::new(Purpose::Search)),
            Action::Walk(Walk::Command) => self.prompt = Some(Prompt::new(Purpose::Command)),
            Action::Walk(Walk::NextMatch) => self.find(true, times),
            Action::Walk(Walk::PreviousMatch) => self.find(false, times),
            Action::NextValue | Action::SwitchPane => self.go_by_differences(times as isize),
            Action::PreviousValue | Action::PreviousPane => self.go_by_differences(-(times as isize)),
            Action::Wider => {
                self.shift = self.shift.saturating_add(STRIDE.saturating_mul(times)).min(view::widest(self))
            }
            Action::Narrower => self.shift = self.shift.saturating_sub(STRIDE.saturating_mul(times)),
            Action::Last if count.is_some() => self.cursor = times.saturating_sub(1).min(last),
            _ => {
                let action = if action == Action::Toggle { Action::PageDown } else { action };
                let pages = [self.height / 2, self.height].map(|rows| rows.saturating_mul(times));
                match list::moved(action, self.cursor, times, pages, last) {
                    Some(row) => self.cursor = row,
                    None => self.message = Some(view::NO_KEY.to_owned()),
                }
            }
        }
        Effect::None
    }

    /// Does what a key does to the line that is typed.
    fn type_key(&mut self, key: KeyEvent) -> Effect {
        let Some(prompt) = &mut self.prompt else { return Effect::None };
        match key.code {
            KeyCode::Esc => self.prompt = None,
            KeyCode::Char('c') if key.modifiers.contains(KeyModifiers::CONTROL) => self.prompt = None,
            KeyCode::Backspace if prompt.line.value().is_empty() => self.prompt = None,
            KeyCode::Enter => {
                let (purpose, text) = (prompt.purpose, prompt.line.value().to_owned());
                self.prompt = None;
                return self.run(purpose, text.trim());
            }
            _ => _ = prompt.line.handle_event(&Event::Key(key)),
        }
        Effect::None
    }

    /// Searches for what was typed, or does the command.
    fn run(&mut self, purpose: Purpose, text: &str) -> Effect {
        if purpose == Purpose::Search {
            self.search = Some(Pattern::of(text)).filter(|_| !text.is_empty());
            if self.search.is_some() {
                self.find(true, 1);
            }
            return Effect::None;
        }
        match (text, text.parse::<usize>()) {
            ("q" | "quit", _) => return Effect::Leave(Exit::Quit),
            ("h" | "help", _) => self.has_help = true,
            (_, Ok(row)) => self.cursor = row.saturating_sub(1).min(self.rows.rows().len().saturating_sub(1)),
            ("", _) => {}
            _ => self.message = Some(view::COMMANDS.to_owned()),
        }
        Effect::None
    }

    /// Goes to the next row that has what is looked for, or to the previous one; behind the last comes the first.
    fn find(&mut self, is_forward: bool, times: usize) {
        let Some(pattern) = self.search.clone() else { return self.message = Some(view::NO_SEARCH.to_owned()) };
        let rows = self.rows.rows();
        let has_it = |row: usize| self.rows.cells(&rows[row]).iter().flatten().any(|cell| pattern.is_in(cell));
        for _ in 0..times.min(rows.len()) {
            let further = |step: usize| if is_forward { self.cursor + step } else { self.cursor + rows.len() - step };
            let found = (1..=rows.len()).map(|step| further(step) % rows.len()).find(|row| has_it(*row));
            let Some(row) = found else {
                self.search = None;
                return self.message = Some(view::not_found(&pattern.text));
            };
            self.cursor = row;
        }
    }

    /// So many differences on, or as far as there are some; back if it is negative.
    fn go_by_differences(&mut self, count: isize) {
        let before = self.differing.partition_point(|row| *row < self.cursor);
        let times = count.unsigned_abs();
        let target = if count > 0 {
            let first = before + usize::from(self.differing.get(before) == Some(&self.cursor));
            let last = self.differing.len().saturating_sub(1);
            (first < self.differing.len()).then(|| first.saturating_add(times - 1).min(last))
        } else {
            before.checked_sub(1).map(|last| last.saturating_sub(times - 1))
        };
        if let Some(row) = target.and_then(|number| self.differing.get(number)) {
            self.cursor = *row;
        }
    }
}

/// The screen in a terminal of this size.
pub fn frame(beside: &Beside, width: u16, height: u16, theme: &Theme) -> Buffer {
    let mut buffer = Buffer::empty(Rect::new(0, 0, width, height));
    view::draw(beside, theme, &mut buffer);
    buffer
}

/// Shows two logs until the viewer is left. The terminal is restored whatever happens.
///
/// # Errors
/// Those of the terminal.
pub fn run(mut beside: Beside, theme: &Theme) -> io::Result<Exit> {
    let mut terminal = Terminal::enter()?;
    show(&mut beside, &mut terminal, theme).or_else(|error| terminal.left_by(error))
}

pub(super) fn show(beside: &mut Beside, terminal: &mut Terminal, theme: &Theme) -> io::Result<Exit> {
    loop {
        beside.resize(terminal.size()?.1);
        terminal.draw(|buffer| view::draw(beside, theme, buffer))?;
        match terminal.next(false, None)? {
            Input::Leave(exit) => return Ok(exit),
            Input::Suspend => _ = terminal.suspend(Asker::Signal)?,
            Input::Resume => terminal.resume()?,
            Input::Key(key) => match beside.press(key) {
                Effect::Leave(exit) => return Ok(exit),
                Effect::Suspend => _ = terminal.suspend(Asker::Key)?,
                _ => {}
            },
            Input::Paste(text) => match &mut beside.prompt {
                Some(prompt) => prompt.line = prompt::with_pasted(&prompt.line, &text),
                None => beside.message = Some(Language::default().texts().viewer.messages.pasted_nowhere.to_owned()),
            },
            Input::Mouse(_) | Input::Beat | Input::Size(..) | Input::Tick => {}
        }
    }
}
