//! The keys: one row each, from which the keyboard is read and the help is made.
//!
//! Adding a key is one row here and one arm in `update.rs`. The rows of [`Walk`] have a file of their own.

mod bound;
mod script;
mod walk;

pub use bound::{
    ANY_LETTER, NOTHING, Refused, bind, bind_in_lists, chord, clashes, has_way_out, hint, in_force, names,
};
pub use script::{Typed, script, sequence, unknown_name};
pub use walk::Walk;

use super::model::bindings::{Bindings, Chord};
use super::model::list::Kind;
use super::model::{Model, Overlay, Pending};
use crate::report::language::viewer::{Groups, Keys};
use Action::*;
use bound::Does;
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
    /// What the schematic shows.
    Schematic,
    ShadowRays,
    RaysOver,
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
    /// The line of this number that a key is bound to.
    Line(u16),
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
    row(|groups| groups.picture, &["Z"], Schematic, |keys| keys.schematic),
    row(|groups| groups.picture, &["X"], ShadowRays, |keys| keys.shadow_rays),
    row(|groups| groups.picture, &["A"], RaysOver, |keys| keys.rays_over),
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
    match action(&model.guide.bindings, &model.pending, key) {
        Some(Suspend) if model.prompt.is_none() || !is_typed(key) => Some(Suspend),
        Some(_) if model.prompt.is_some() => Some(Typed(key)),
        action => in_list(model, key).or(action),
    }
}

/// What a key does only in a list.
fn in_list(model: &Model, key: KeyEvent) -> Option<Action> {
    let is_list =
        matches!(model.overlay, Some(Overlay::List { kind: Kind::Breakpoints | Kind::Bookmarks | Kind::Watches, .. }));
    let chord = Chord { first: model.pending.prefix, key: name(key)? };
    let is_delete = is_list && key.kind != KeyEventKind::Release && bound::deletes(&model.guide.bindings, &chord);
    is_delete.then_some(Walk(Walk::Delete))
}

/// Whether a line that is typed needs a key, whatever it is bound to.
pub fn is_typed(key: KeyEvent) -> bool {
    !key.modifiers.contains(KeyModifiers::CONTROL) && !matches!(key.code, KeyCode::F(_))
}

/// What a key does after what was typed before it; `None` for a key that is only let go.
pub fn action(bindings: &Bindings, pending: &Pending, key: KeyEvent) -> Option<Action> {
    if key.kind == KeyEventKind::Release {
        return None;
    }
    let Some(name) = name(key) else { return Some(Unknown) };
    if let Some(both) = pending.prefix.and_then(|first| of_two(bindings, first, &name)) {
        return Some(both);
    }
    if let Some(digit) = digit(&name).filter(|digit| *digit != 0 || pending.count.is_some()) {
        return Some(Digit(digit));
    }
    let first = name.chars().next().filter(|first| name.len() == first.len_utf8() && pending.prefix.is_none());
    match bound::does(bindings, &Chord { first: pending.prefix, key: name }) {
        Some(Does::Action(action)) => Some(action),
        Some(Does::Letter(_)) => Some(first.map_or(Unknown, Prefix)),
        None => Some(first.filter(|first| bound::begins_a_pair(bindings, *first)).map_or(Unknown, Prefix)),
    }
}

/// What a character and the key after it do together.
fn of_two(bindings: &Bindings, first: char, name: &str) -> Option<Action> {
    if let Some(Does::Action(action)) = bound::does(bindings, &Chord { first: Some(first), key: name.to_owned() }) {
        return Some(action);
    }
    match bound::does(bindings, &Chord { first: None, key: first.to_string() }) {
        Some(Does::Letter(action)) => walk::with_letter(action, name),
        _ => None,
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
    // As other programs write it: `C-d`, `c-d`, `Ctrl-d`.
    let control = text.split_once('-').filter(|(word, _)| ["c", "ctrl"].contains(&word.to_ascii_lowercase().as_str()));
    if let Some((_, letter)) = control.filter(|(_, letter)| letter.chars().count() == 1) {
        return parse(&format!("^{}", letter.to_lowercase()));
    }
    match NAMES.iter().find(|(name, _)| *name == text) {
        Some((_, code)) => plain(*code),
        None => plain(KeyCode::F(text.strip_prefix('F')?.parse().ok()?)),
    }
}

#[cfg(test)]
mod tests;
