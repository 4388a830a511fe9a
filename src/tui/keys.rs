//! The keys: one row each, from which the keyboard is read and the help is made.
//!
//! Adding a key is one row here and one arm in `update.rs`. The rows of [`Walk`] have a file of their own.

mod script;
mod walk;

pub use script::{Typed, script, sequence, unknown_name};

use super::guide::Walk;
use super::list;
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
    /// What it is for.
    pub group: Group,
    /// The keys: a character, `^` and a letter, two characters in a row, or a name such as `PgUp`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub action: Action,
    /// What the help says of them.
    pub help: Said,
}

/// What the help says of keys, among its texts.
type Said = fn(&Keys) -> &'static str;

const fn row(group: Group, keys: &'static [&'static str], action: Action, help: Said) -> Row {
    Row { group, keys, action, help }
}

/// What keys are for: the headings of the help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Group {
    Step,
    Tree,
    Fold,
    Picture,
    Understand,
    Viewer,
    Nesting,
    Run,
    Find,
    Keep,
    Breakpoints,
}

impl Group {
    /// The heading.
    pub fn title(self, groups: &Groups) -> &'static str {
        match self {
            Group::Step => groups.step,
            Group::Tree => groups.tree,
            Group::Fold => groups.fold,
            Group::Picture => groups.picture,
            Group::Understand => groups.understand,
            Group::Viewer => groups.viewer,
            Group::Nesting => groups.nesting,
            Group::Run => groups.run,
            Group::Find => groups.find,
            Group::Keep => groups.keep,
            Group::Breakpoints => groups.breakpoints,
        }
    }
}

/// The keys that move in the panes, and those of the viewer itself.
const TABLE: &[Row] = &[
    row(Group::Step, &["n"], NextValue, |keys| keys.next_value),
    row(Group::Step, &["N", "p"], PreviousValue, |keys| keys.previous_value),
    row(Group::Step, &["]"], NextEvent, |keys| keys.next_event),
    row(Group::Step, &["["], PreviousEvent, |keys| keys.previous_event),
    row(Group::Step, &["}"], NextRay, |keys| keys.next_ray),
    row(Group::Step, &["{"], PreviousRay, |keys| keys.previous_ray),
    row(Group::Tree, &["j", "Down"], Down, |keys| keys.down),
    row(Group::Tree, &["k", "Up"], Up, |keys| keys.up),
    row(Group::Tree, &["h", "Left"], Out, |keys| keys.out),
    row(Group::Tree, &["l", "Right"], In, |keys| keys.r#in),
    row(Group::Tree, &["Enter"], Enter, |keys| keys.enter),
    row(Group::Tree, &["J"], NextSibling, |keys| keys.next_sibling),
    row(Group::Tree, &["K"], PreviousSibling, |keys| keys.previous_sibling),
    row(Group::Tree, &["g", "Home"], First, |keys| keys.first),
    row(Group::Tree, &["G", "End"], Last, |keys| keys.last),
    row(Group::Tree, &["^d"], HalfPageDown, |keys| keys.half_page_down),
    row(Group::Tree, &["^u"], HalfPageUp, |keys| keys.half_page_up),
    row(Group::Tree, &["PgDn", "^f"], PageDown, |keys| keys.page_down),
    row(Group::Tree, &["PgUp", "^b"], PageUp, |keys| keys.page_up),
    row(Group::Tree, &["zz"], Center, |keys| keys.center),
    row(Group::Fold, &["Space"], Toggle, |keys| keys.toggle),
    row(Group::Fold, &["e"], OpenSiblings, |keys| keys.open_siblings),
    row(Group::Fold, &["c"], CloseSiblings, |keys| keys.close_siblings),
    row(Group::Fold, &["E"], OpenAll, |keys| keys.open_all),
    row(Group::Fold, &["C"], CloseAll, |keys| keys.close_all),
    row(Group::Picture, &["i"], ZoomIn, |keys| keys.zoom_in),
    row(Group::Picture, &["I"], ZoomOut, |keys| keys.zoom_out),
    row(Group::Picture, &[")"], Brighter, |keys| keys.brighter),
    row(Group::Picture, &["("], Darker, |keys| keys.darker),
    row(Group::Picture, &["v"], NextView, |keys| keys.next_view),
    row(Group::Understand, &["d"], Operands, |keys| keys.operands),
    row(Group::Understand, &["D"], Uses, |keys| keys.uses),
    row(Group::Understand, &["^o"], Back, |keys| keys.back),
    row(Group::Understand, &["w"], Contributions, |keys| keys.contributions),
    row(Group::Understand, &["a"], Arithmetics, |keys| keys.arithmetics),
    row(Group::Understand, &["Q"], Quiz, |keys| keys.quiz),
    row(Group::Understand, &["="], Answer, |keys| keys.answer),
    row(Group::Viewer, &["Tab"], SwitchPane, |keys| keys.switch_pane),
    row(Group::Viewer, &["Shift-Tab"], PreviousPane, |keys| keys.previous_pane),
    row(Group::Viewer, &["zo"], OnlyPane, |keys| keys.only_pane),
    row(Group::Viewer, &[">"], Wider, |keys| keys.wider),
    row(Group::Viewer, &["<"], Narrower, |keys| keys.narrower),
    row(Group::Viewer, &["?", "F1"], Help, |keys| keys.help),
    row(Group::Viewer, &["Esc"], Close, |keys| keys.close),
    row(Group::Viewer, &["q"], Quit, |keys| keys.quit),
    row(Group::Viewer, &["^c"], Interrupt, |keys| keys.interrupt),
    row(Group::Viewer, &["^z"], Suspend, |keys| keys.suspend),
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
