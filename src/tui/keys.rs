//! The keys: one row each, from which the keyboard is read and the help is made.
//!
//! Adding a key is one row here and one arm in `update.rs`. The rows of [`Walk`] have a file of their own.

mod script;
mod walk;

pub use script::{Typed, script, sequence, unknown_name};
pub use walk::Walk;

use super::model::list::Kind;
use super::model::{Model, Overlay, Pending};
use crate::report::language::viewer::{Groups, Keys};
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
    CellLeft,
    Worst,
    Operands,
    Uses,
    Back,
    Contributions,
    Arithmetics,
    Causes,
    Glossary,
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
    /// What they are for: the heading in the help.
    pub group: Title,
    /// The keys: a character, `^` and a letter, two characters in a row, or a name such as `PgUp`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub action: Action,
    /// What the help says of them.
    pub help: Said,
}

/// What the help says of keys, among its texts.
type Said = fn(&Keys) -> &'static str;
/// A heading of the help, among its texts.
type Title = fn(&Groups) -> &'static str;

const fn row(group: Title, keys: &'static [&'static str], action: Action, help: Said) -> Row {
    Row { group, keys, action, help }
}

/// The keys that move in the panes, and those of the viewer itself.
const TABLE: &[Row] = &[
    row(|groups| groups.step, &["n"], NextValue, |keys| keys.next_value),
    row(|groups| groups.step, &["N", "p"], PreviousValue, |keys| keys.previous_value),
    row(|groups| groups.step, &["]"], NextEvent, |keys| keys.next_event),
    row(|groups| groups.step, &["["], PreviousEvent, |keys| keys.previous_event),
    row(|groups| groups.step, &["}"], NextRay, |keys| keys.next_ray),
    row(|groups| groups.step, &["{"], PreviousRay, |keys| keys.previous_ray),
    row(|groups| groups.tree, &["j", "Down"], Down, |keys| keys.down),
    row(|groups| groups.tree, &["k", "Up"], Up, |keys| keys.up),
    row(|groups| groups.tree, &["h", "Left"], Out, |keys| keys.out),
    row(|groups| groups.tree, &["l", "Right"], In, |keys| keys.r#in),
    row(|groups| groups.tree, &["Enter"], Enter, |keys| keys.enter),
    row(|groups| groups.tree, &["J"], NextSibling, |keys| keys.next_sibling),
    row(|groups| groups.tree, &["K"], PreviousSibling, |keys| keys.previous_sibling),
    row(|groups| groups.tree, &["g", "Home"], First, |keys| keys.first),
    row(|groups| groups.tree, &["G", "End"], Last, |keys| keys.last),
    row(|groups| groups.tree, &["^d"], HalfPageDown, |keys| keys.half_page_down),
    row(|groups| groups.tree, &["^u"], HalfPageUp, |keys| keys.half_page_up),
    row(|groups| groups.tree, &["PgDn", "^f"], PageDown, |keys| keys.page_down),
    row(|groups| groups.tree, &["PgUp", "^b"], PageUp, |keys| keys.page_up),
    row(|groups| groups.tree, &["zz"], Center, |keys| keys.center),
    row(|groups| groups.fold, &["Space"], Toggle, |keys| keys.toggle),
    row(|groups| groups.fold, &["e"], OpenSiblings, |keys| keys.open_siblings),
    row(|groups| groups.fold, &["c"], CloseSiblings, |keys| keys.close_siblings),
    row(|groups| groups.fold, &["E"], OpenAll, |keys| keys.open_all),
    row(|groups| groups.fold, &["C"], CloseAll, |keys| keys.close_all),
    row(|groups| groups.picture, &["i"], ZoomIn, |keys| keys.zoom_in),
    row(|groups| groups.picture, &["I"], ZoomOut, |keys| keys.zoom_out),
    row(|groups| groups.picture, &[")"], Brighter, |keys| keys.brighter),
    row(|groups| groups.picture, &["("], Darker, |keys| keys.darker),
    row(|groups| groups.picture, &["v"], NextView, |keys| keys.next_view),
    row(|groups| groups.picture, &["H"], CellLeft, |keys| keys.cell_left),
    row(|groups| groups.picture, &["!"], Worst, |keys| keys.worst),
    row(|groups| groups.understand, &["d"], Operands, |keys| keys.operands),
    row(|groups| groups.understand, &["D"], Uses, |keys| keys.uses),
    row(|groups| groups.understand, &["^o"], Back, |keys| keys.back),
    row(|groups| groups.understand, &["w"], Contributions, |keys| keys.contributions),
    row(|groups| groups.understand, &["a"], Arithmetics, |keys| keys.arithmetics),
    row(|groups| groups.understand, &["W"], Causes, |keys| keys.causes),
    row(|groups| groups.understand, &["V", "F2"], Glossary, |keys| keys.glossary),
    row(|groups| groups.understand, &["Q"], Quiz, |keys| keys.quiz),
    row(|groups| groups.understand, &["="], Answer, |keys| keys.answer),
    row(|groups| groups.viewer, &["Tab"], SwitchPane, |keys| keys.switch_pane),
    row(|groups| groups.viewer, &["Shift-Tab"], PreviousPane, |keys| keys.previous_pane),
    row(|groups| groups.viewer, &["zo"], OnlyPane, |keys| keys.only_pane),
    row(|groups| groups.viewer, &[">"], Wider, |keys| keys.wider),
    row(|groups| groups.viewer, &["<"], Narrower, |keys| keys.narrower),
    row(|groups| groups.viewer, &["?", "F1"], Help, |keys| keys.help),
    row(|groups| groups.viewer, &["Esc"], Close, |keys| keys.close),
    row(|groups| groups.viewer, &["q"], Quit, |keys| keys.quit),
    row(|groups| groups.viewer, &["^c"], Interrupt, |keys| keys.interrupt),
    row(|groups| groups.viewer, &["^z"], Suspend, |keys| keys.suspend),
];

/// Every key of the viewer, in the order of the help.
pub fn rows() -> impl Iterator<Item = &'static Row> {
    TABLE.iter().chain(walk::TABLE)
}

/// What a key does in the viewer as it is now; `None` for a key that is only let go.
pub fn meant(model: &Model, key: KeyEvent) -> Option<Action> {
    match action(&model.pending, key) {
        Some(Suspend) => Some(Suspend),
        Some(_) if model.prompt.is_some() => Some(Typed(key)),
        action => in_list(model, key).or(action),
    }
}

/// What a key does only in a list.
fn in_list(model: &Model, key: KeyEvent) -> Option<Action> {
    let is_list = matches!(model.overlay, Some(Overlay::List { kind: Kind::Breakpoints | Kind::Watches, .. }));
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

/// The names of keys that aren't characters, also those of other programs. Of several for one key the first is shown.
const NAMES: [(&str, KeyCode); 24] = [
    ("Space", KeyCode::Char(' ')),
    ("Up", KeyCode::Up),
    ("Down", KeyCode::Down),
    ("Left", KeyCode::Left),
    ("Right", KeyCode::Right),
    ("PgUp", KeyCode::PageUp),
    ("PgDn", KeyCode::PageDown),
    ("Home", KeyCode::Home),
    ("End", KeyCode::End),
    ("Enter", KeyCode::Enter),
    ("Tab", KeyCode::Tab),
    ("Shift-Tab", KeyCode::BackTab),
    ("BackTab", KeyCode::BackTab),
    ("S-Tab", KeyCode::BackTab),
    ("Esc", KeyCode::Esc),
    ("Escape", KeyCode::Esc),
    ("Return", KeyCode::Enter),
    ("CR", KeyCode::Enter),
    ("PageUp", KeyCode::PageUp),
    ("PageDown", KeyCode::PageDown),
    ("Backspace", KeyCode::Backspace),
    ("BS", KeyCode::Backspace),
    ("Delete", KeyCode::Delete),
    ("Del", KeyCode::Delete),
];

/// The name of a key, as the table has it.
fn name(key: KeyEvent) -> Option<String> {
    let named = NAMES.iter().find(|(_, code)| *code == key.code).map(|(name, _)| (*name).to_owned());
    match key.code {
        _ if key.modifiers.contains(KeyModifiers::ALT) => None,
        KeyCode::Char(letter) if key.modifiers.contains(KeyModifiers::CONTROL) => {
            Some(format!("^{}", letter.to_ascii_lowercase()))
        }
        KeyCode::Char(character) => named.or_else(|| Some(character.to_string())),
        KeyCode::F(number) => Some(format!("F{number}")),
        _ => named,
    }
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
        ('^', Some(letter), None) if letter.is_ascii_alphabetic() => {
            return Some(KeyEvent::new(KeyCode::Char(letter), KeyModifiers::CONTROL));
        }
        _ => {}
    }
    // As other programs write it: `C-d`, `c-d`.
    if let Some(letter) = text
        .strip_prefix(['C', 'c'])
        .and_then(|rest| rest.strip_prefix('-'))
        .filter(|letter| letter.chars().count() == 1)
    {
        return parse(&format!("^{letter}"));
    }
    match NAMES.iter().find(|(name, _)| *name == text) {
        Some((_, code)) => plain(*code),
        None => plain(KeyCode::F(text.strip_prefix('F')?.parse().ok()?)),
    }
}

#[cfg(test)]
mod tests;
