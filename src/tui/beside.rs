//! Two logs beside each other: both trees aligned, what differs marked, the computation of both below.
//!
//! A smaller viewer of its own: what is walked through here are the rows of a comparison, and its keys are those of the viewer as
//! far as they mean something for two logs.

mod view;

use super::Theme;
use super::effect::{Effect, Exit};
use super::keys::{self, Action};
use super::list;
use super::model::Pending;
use super::terminal::{Asker, Input, Terminal};
use crate::report::diff::Rows;
use crate::report::language::Language;
use crossterm::event::KeyEvent;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::io;

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
    /// What is said at the bottom until the next key.
    message: Option<&'static str>,
}

impl<'a> Beside<'a> {
    /// Two logs, at the first row that differs.
    pub fn new(rows: Rows<'a>, titles: [String; 2]) -> Beside<'a> {
        let differing: Vec<usize> = (0..rows.rows().len()).filter(|row| rows.rows()[*row].differs).collect();
        let cursor = differing.first().copied().unwrap_or(0);
        Beside { rows, titles, differing, cursor, height: 1, message: None }
    }

    /// The terminal has this many rows now.
    pub fn resize(&mut self, height: u16) {
        self.height = view::rows_of_table(height);
    }

    /// Does what a key of the viewer means here, and says what is left to do: nothing, to leave or to suspend.
    pub fn press(&mut self, key: KeyEvent) -> Effect {
        let Some(action) = keys::action(&Pending::default(), key) else { return Effect::None };
        self.message = None;
        let last = self.rows.rows().len().saturating_sub(1);
        self.cursor = match action {
            Action::Interrupt => return Effect::Leave(Exit::Interrupted),
            Action::Suspend => return Effect::Suspend,
            Action::Quit | Action::Close => return Effect::Leave(Exit::Quit),
            Action::NextValue | Action::SwitchPane => self.next_difference(),
            Action::PreviousValue | Action::PreviousPane => self.previous_difference(),
            _ => {
                let action = if action == Action::Toggle { Action::PageDown } else { action };
                list::moved(action, self.cursor, 1, [self.height / 2, self.height], last).unwrap_or(self.cursor)
            }
        };
        Effect::None
    }

    fn next_difference(&self) -> usize {
        self.differing.iter().copied().find(|row| *row > self.cursor).unwrap_or(self.cursor)
    }

    fn previous_difference(&self) -> usize {
        self.differing.iter().copied().rev().find(|row| *row < self.cursor).unwrap_or(self.cursor)
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
            Input::Paste(_) => beside.message = Some(Language::default().texts().viewer.messages.pasted_nowhere),
            Input::Mouse(_) | Input::Beat | Input::Size(..) | Input::Tick => {}
        }
    }
}
