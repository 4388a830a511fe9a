//! The keys: one row each, from which the keyboard is read and the help is made.
//!
//! Adding a key is one row here and one arm in [`super::update`]. The rows of [`Walk`] have a file of their own.

mod script;
mod walk;

pub use script::{Typed, script, sequence, unknown_name};

use super::guide::Walk;
use super::list;
use super::model::{Model, Overlay, Pending};
use Action::*;
use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

/// What can be done in the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Action {
    Down,
    Up,
    HalfPageDown,
    HalfPageUp,
    PageDown,
    PageUp,
    First,
    Last,
    Out,
    In,
    Enter,
    NextSibling,
    PreviousSibling,
    Center,
    Toggle,
    OpenSiblings,
    CloseSiblings,
    OpenAll,
    CloseAll,
    NextValue,
    PreviousValue,
    NextEvent,
    PreviousEvent,
    NextRay,
    PreviousRay,
    SwitchPane,
    PreviousPane,
    OnlyPane,
    Wider,
    Narrower,
    ZoomIn,
    ZoomOut,
    Brighter,
    Darker,
    NextView,
    Operands,
    Uses,
    Back,
    Contributions,
    Arithmetics,
    Quiz,
    Answer,
    Search,
    Help,
    Close,
    Quit,
    Interrupt,
    Suspend,
    /// Getting about by steps, breakpoints, searches, bookmarks and commands.
    Walk(Walk),
    /// A digit of a count.
    Digit(u8),
    /// The first of two keys.
    Prefix(char),
    /// A key that means nothing.
    Unknown,
    /// The terminal has this many columns and rows now.
    Resize(u16, u16),
    /// A key in the line that is being typed.
    Typed(KeyEvent),
}

/// Some keys, what they do, and how the help says it.
#[derive(Debug)]
pub struct Row {
    /// The heading in the help under which the row stands.
    pub group: &'static str,
    /// The keys: a character, `^` and a letter, two characters in a row, or a name such as `PgUp`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub action: Action,
    /// What the help says.
    pub help: &'static str,
}

const fn row(group: &'static str, keys: &'static [&'static str], action: Action, help: &'static str) -> Row {
    Row { group, keys, action, help }
}

const STEP: &str = "Step through the computation";
const MOVE: &str = "Move in the tree";
const FOLD: &str = "Fold";
const PICTURE: &str = "In the picture and the schematic";
const UNDERSTAND: &str = "Understand";
const VIEWER: &str = "The viewer";

/// The keys that move in the panes, and those of the viewer itself.
const TABLE: &[Row] = &[
    row(STEP, &["n"], NextValue, "to the next computed value"),
    row(STEP, &["N", "p"], PreviousValue, "to the previous computed value"),
    row(STEP, &["]"], NextEvent, "to the next event"),
    row(STEP, &["["], PreviousEvent, "to the previous event"),
    row(STEP, &["}"], NextRay, "to the next ray"),
    row(STEP, &["{"], PreviousRay, "to the previous ray"),
    row(MOVE, &["j", "Down"], Down, "down"),
    row(MOVE, &["k", "Up"], Up, "up"),
    row(MOVE, &["h", "Left"], Out, "close the node, or go to the one around it"),
    row(MOVE, &["l", "Right"], In, "open the node, go into it, then to its computation"),
    row(MOVE, &["Enter"], Enter, "the same; in the picture: to the tree of the pixel"),
    row(MOVE, &["J"], NextSibling, "to the next node of the same parent"),
    row(MOVE, &["K"], PreviousSibling, "to the previous node of the same parent"),
    row(MOVE, &["g", "Home"], First, "to the first row"),
    row(MOVE, &["G", "End"], Last, "to the last row; with a count, to that step"),
    row(MOVE, &["^d"], HalfPageDown, "half a page down"),
    row(MOVE, &["^u"], HalfPageUp, "half a page up"),
    row(MOVE, &["PgDn", "^f"], PageDown, "a page down"),
    row(MOVE, &["PgUp", "^b"], PageUp, "a page up"),
    row(MOVE, &["zz"], Center, "put the row into the middle"),
    row(FOLD, &["Space"], Toggle, "open or close the node"),
    row(FOLD, &["e"], OpenSiblings, "open the node and its siblings"),
    row(FOLD, &["c"], CloseSiblings, "close the node and its siblings"),
    row(FOLD, &["E"], OpenAll, "open everything inside the node"),
    row(FOLD, &["C"], CloseAll, "close everything inside the node"),
    row(PICTURE, &["i"], ZoomIn, "larger"),
    row(PICTURE, &["I"], ZoomOut, "smaller"),
    row(PICTURE, &[")"], Brighter, "brighter by half a stop"),
    row(PICTURE, &["("], Darker, "darker by half a stop"),
    row(PICTURE, &["v"], NextView, "another view: colours, depth, rays, samples; top, front, camera"),
    row(UNDERSTAND, &["d"], Operands, "what this value is made of; Enter goes to an operand"),
    row(UNDERSTAND, &["D"], Uses, "which steps take this value"),
    row(UNDERSTAND, &["^o"], Back, "back to before the last jump, then to before the one before it"),
    row(UNDERSTAND, &["w"], Contributions, "why the pixel has this colour"),
    row(UNDERSTAND, &["a"], Arithmetics, "the node's values by hand, in f32 and in f64, with the digits to trust"),
    row(UNDERSTAND, &["Q"], Quiz, "begin or end a quiz, which hides results and decisions"),
    row(UNDERSTAND, &["="], Answer, "answer in the quiz (Enter in the computation, too)"),
    row(VIEWER, &["Tab"], SwitchPane, "to the next pane; in the computation j and k move too"),
    row(VIEWER, &["Shift-Tab"], PreviousPane, "to the pane before"),
    row(VIEWER, &["zo"], OnlyPane, "only this pane, or all again"),
    row(VIEWER, &[">"], Wider, "a wider tree; in a list, on to the right"),
    row(VIEWER, &["<"], Narrower, "a narrower tree; in a list, back to the left"),
    row(VIEWER, &["?", "F1"], Help, "this help"),
    row(
        VIEWER,
        &["Esc"],
        Close,
        "close what lies over the panes; else dismiss the message, stop playing, end the search, then the filter",
    ),
    row(VIEWER, &["q"], Quit, "quit (or close the help)"),
    row(VIEWER, &["^c"], Interrupt, "quit at once"),
    row(VIEWER, &["^z"], Suspend, "to the shell; fg comes back"),
];

/// Every key of the viewer, in the order of the help.
pub fn rows() -> impl Iterator<Item = &'static Row> {
    TABLE.iter().chain(walk::TABLE)
}

/// What a key does in the viewer as it is now; `None` for a key that is only let go.
pub fn meant(model: &Model, key: KeyEvent) -> Option<Action> {
    match action(&model.pending, key) {
        Some(known @ (Interrupt | Suspend)) => Some(known),
        Some(_) if model.prompt.is_some() => Some(Typed(key)),
        action => in_list(model, key).or(action),
    }
}

/// What a key does only in a list.
fn in_list(model: &Model, key: KeyEvent) -> Option<Action> {
    let is_list = matches!(model.overlay, Some(Overlay::List { kind: list::Kind::Breakpoints, .. }));
    let is_delete = key.code == KeyCode::Char('d') && key.modifiers.is_empty() && key.kind != KeyEventKind::Release;
    (is_list && is_delete).then_some(Walk(Walk::Delete))
}

/// What a key does after what was typed before it; `None` for a key that is only let go.
pub fn action(pending: &Pending, key: KeyEvent) -> Option<Action> {
    if key.kind == KeyEventKind::Release {
        return None;
    }
    let Some(name) = name(key) else { return Some(Unknown) };
    if let Some(marked) = pending.prefix.and_then(|prefix| walk::marked(prefix, &name)) {
        return Some(marked);
    }
    if let Some(digit) = digit(&name).filter(|digit| *digit != 0 || pending.count.is_some()) {
        return Some(Digit(digit));
    }
    let typed = pending.prefix.map_or_else(|| name.clone(), |prefix| format!("{prefix}{name}"));
    if let Some(row) = rows().find(|row| row.keys.contains(&typed.as_str())) {
        return Some(row.action);
    }
    let mut characters = typed.chars();
    match (characters.next(), characters.next()) {
        (Some(first), None) if begins_a_pair(first) => Some(Prefix(first)),
        _ => Some(Unknown),
    }
}

/// The name of a key, as the table has it.
fn name(key: KeyEvent) -> Option<String> {
    let is_control = key.modifiers.contains(KeyModifiers::CONTROL);
    if key.modifiers.contains(KeyModifiers::ALT) {
        return None;
    }
    let name = match key.code {
        KeyCode::Char(letter) if is_control => return Some(format!("^{}", letter.to_ascii_lowercase())),
        KeyCode::Char(' ') => "Space",
        KeyCode::Char(character) => return Some(character.to_string()),
        KeyCode::F(number) => return Some(format!("F{number}")),
        KeyCode::Up => "Up",
        KeyCode::Down => "Down",
        KeyCode::Left => "Left",
        KeyCode::Right => "Right",
        KeyCode::PageUp => "PgUp",
        KeyCode::PageDown => "PgDn",
        KeyCode::Home => "Home",
        KeyCode::End => "End",
        KeyCode::Enter => "Enter",
        KeyCode::Tab => "Tab",
        KeyCode::BackTab => "Shift-Tab",
        KeyCode::Esc => "Esc",
        _ => return None,
    };
    Some(name.to_owned())
}

fn digit(name: &str) -> Option<u8> {
    name.parse().ok().filter(|_| name.len() == 1)
}

/// Whether a character is the first of a row with two, such as the `z` of `zz`.
fn begins_a_pair(first: char) -> bool {
    let is_pair = |key: &&str| key.chars().count() == 2 && key.chars().all(|c| c.is_ascii_lowercase());
    walk::begins_a_mark(first) || rows().flat_map(|row| row.keys).any(|key| is_pair(key) && key.starts_with(first))
}

/// The key that a text such as `j`, `^d` or `PgUp` names.
pub fn parse(text: &str) -> Option<KeyEvent> {
    let plain = |code| Some(KeyEvent::new(code, KeyModifiers::NONE));
    let mut characters = text.chars();
    match (characters.next()?, characters.next(), characters.next()) {
        (character, None, _) => return plain(KeyCode::Char(character)),
        ('^', Some(letter), None) => return Some(KeyEvent::new(KeyCode::Char(letter), KeyModifiers::CONTROL)),
        _ => {}
    }
    // As other programs write it: `C-d`.
    if let Some(letter) = text.strip_prefix("C-").filter(|letter| letter.chars().count() == 1) {
        return parse(&format!("^{letter}"));
    }
    plain(match text {
        "Space" => KeyCode::Char(' '),
        "Up" => KeyCode::Up,
        "Down" => KeyCode::Down,
        "Left" => KeyCode::Left,
        "Right" => KeyCode::Right,
        "PgUp" => KeyCode::PageUp,
        "PgDn" => KeyCode::PageDown,
        "Home" => KeyCode::Home,
        "End" => KeyCode::End,
        "Enter" => KeyCode::Enter,
        "Tab" => KeyCode::Tab,
        "Shift-Tab" | "BackTab" => KeyCode::BackTab,
        "Esc" => KeyCode::Esc,
        _ => KeyCode::F(text.strip_prefix('F')?.parse().ok()?),
    })
}

#[cfg(test)]
mod tests;
