//! Two logs beside each other: both trees aligned, what differs marked, the computation of both below.
//!
//! A smaller viewer of its own: what is walked through here are the rows of a comparison, and its keys are those of the viewer as
//! far as they mean something for two logs.

mod view;

use super::Theme;
use super::terminal::{Asker, Input, Terminal};
use super::update::Exit;
use crate::report::diff::Rows;
use crate::report::language::Language;
use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
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

/// What a key asks for that the model can't do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Nothing more.
    None,
    /// To be left.
    Leave(Exit),
    /// To give the terminal to the shell.
    Suspend,
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

    /// Does what a key says.
    pub fn press(&mut self, key: KeyEvent) -> Wish {
        if key.kind == KeyEventKind::Release {
            return Wish::None;
        }
        self.message = None;
        let last = self.rows.rows().len().saturating_sub(1);
        let is_control = key.modifiers.contains(KeyModifiers::CONTROL);
        self.cursor = match key.code {
            KeyCode::Char('c') if is_control => return Wish::Leave(Exit::Interrupted),
            KeyCode::Char('z') if is_control => return Wish::Suspend,
            KeyCode::Char('q') | KeyCode::Esc => return Wish::Leave(Exit::Quit),
            KeyCode::Char('d') if is_control => self.cursor + self.height / 2,
            KeyCode::Char('u') if is_control => self.cursor.saturating_sub(self.height / 2),
            KeyCode::Char('f') if is_control => self.cursor + self.height,
            KeyCode::Char('b') if is_control => self.cursor.saturating_sub(self.height),
            KeyCode::Char('j') | KeyCode::Down => self.cursor + 1,
            KeyCode::Char('k') | KeyCode::Up => self.cursor.saturating_sub(1),
            KeyCode::PageDown | KeyCode::Char(' ') => self.cursor + self.height,
            KeyCode::PageUp => self.cursor.saturating_sub(self.height),
            KeyCode::Char('g') | KeyCode::Home => 0,
            KeyCode::Char('G') | KeyCode::End => last,
            KeyCode::Char('n') | KeyCode::Tab => self.next_difference(),
            KeyCode::Char('N' | 'p') | KeyCode::BackTab => self.previous_difference(),
            _ => self.cursor,
        }
        .min(last);
        Wish::None
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

fn show(beside: &mut Beside, terminal: &mut Terminal, theme: &Theme) -> io::Result<Exit> {
    loop {
        beside.resize(terminal.size()?.1);
        terminal.draw(|buffer| view::draw(beside, theme, buffer))?;
        match terminal.next(false, None)? {
            Input::Leave(exit) => return Ok(exit),
            Input::Suspend => _ = terminal.suspend(Asker::Signal)?,
            Input::Resume => terminal.resume()?,
            Input::Key(key) => match beside.press(key) {
                Wish::None => {}
                Wish::Leave(exit) => return Ok(exit),
                Wish::Suspend => _ = terminal.suspend(Asker::Key)?,
            },
            Input::Paste(_) => beside.message = Some(Language::default().texts().viewer.messages.pasted_nowhere),
            Input::Mouse(_) | Input::Beat | Input::Size(..) | Input::Tick => {}
        }
    }
}
