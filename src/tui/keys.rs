//! The keys: one row each, from which the keyboard is read and the help is made.
//!
//! Adding a key is one row here, of which the action follows, and one arm in [`super::update`]. The rows of [`Walk`] have a file of their own.

mod script;
mod walk;

pub use script::{Typed, script, sequence, unknown_name};

use super::guide::Walk;
use super::list;
use super::model::{Model, Overlay, Pending};
use crate::report::language::viewer::{Groups, Keys};
use Action::*;
use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

macro_rules! keys {
    ($($group:ident [$($key:literal)+] $action:ident $help:ident;)*) => {
        /// What can be done in the viewer.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)]
        pub enum Action {
            $($action,)*
            Search,
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

        /// The keys that move in the panes, and those of the viewer itself.
        const TABLE: &[Row] = &[$(row(Group::$group, &[$($key),+], Action::$action, |keys| keys.$help),)*];
    };
}

// What a key is for, the keys, what they do, and the text of the help.
keys! {
    Step ["n"] NextValue next_value;
    Step ["N" "p"] PreviousValue previous_value;
    Step ["]"] NextEvent next_event;
    Step ["["] PreviousEvent previous_event;
    Step ["}"] NextRay next_ray;
    Step ["{"] PreviousRay previous_ray;

    Tree ["j" "Down"] Down down;
    Tree ["k" "Up"] Up up;
    Tree ["h" "Left"] Out out;
    Tree ["l" "Right"] In r#in;
    Tree ["Enter"] Enter enter;
    Tree ["J"] NextSibling next_sibling;
    Tree ["K"] PreviousSibling previous_sibling;
    Tree ["g" "Home"] First first;
    Tree ["G" "End"] Last last;
    Tree ["^d"] HalfPageDown half_page_down;
    Tree ["^u"] HalfPageUp half_page_up;
    Tree ["PgDn" "^f"] PageDown page_down;
    Tree ["PgUp" "^b"] PageUp page_up;
    Tree ["zz"] Center center;

    Fold ["Space"] Toggle toggle;
    Fold ["e"] OpenSiblings open_siblings;
    Fold ["c"] CloseSiblings close_siblings;
    Fold ["E"] OpenAll open_all;
    Fold ["C"] CloseAll close_all;

    Picture ["i"] ZoomIn zoom_in;
    Picture ["I"] ZoomOut zoom_out;
    Picture [")"] Brighter brighter;
    Picture ["("] Darker darker;
    Picture ["v"] NextView next_view;

    Understand ["d"] Operands operands;
    Understand ["D"] Uses uses;
    Understand ["^o"] Back back;
    Understand ["w"] Contributions contributions;
    Understand ["a"] Arithmetics arithmetics;
    Understand ["Q"] Quiz quiz;
    Understand ["="] Answer answer;

    Viewer ["Tab"] SwitchPane switch_pane;
    Viewer ["Shift-Tab"] PreviousPane previous_pane;
    Viewer ["zo"] OnlyPane only_pane;
    Viewer [">"] Wider wider;
    Viewer ["<"] Narrower narrower;
    Viewer ["?" "F1"] Help help;
    Viewer ["Esc"] Close close;
    Viewer ["q"] Quit quit;
    Viewer ["^c"] Interrupt interrupt;
    Viewer ["^z"] Suspend suspend;
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

macro_rules! groups {
    ($($group:ident $title:ident,)*) => {
        /// What keys are for: the headings of the help.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)]
        pub enum Group { $($group,)* }

        impl Group {
            /// The heading.
            pub fn title(self, groups: &Groups) -> &'static str {
                match self { $(Group::$group => groups.$title,)* }
            }
        }
    };
}

groups! {
    Step step,
    Tree tree,
    Fold fold,
    Picture picture,
    Understand understand,
    Viewer viewer,
    Nesting nesting,
    Run run,
    Find find,
    Keep keep,
    Breakpoints breakpoints,
}

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
    match key.code {
        KeyCode::Char(letter) if is_control => Some(format!("^{}", letter.to_ascii_lowercase())),
        KeyCode::F(number) => Some(format!("F{number}")),
        code => match NAMES.iter().find(|(_, named)| *named == code) {
            Some((name, _)) => Some((*name).to_owned()),
            None => code.as_char().map(String::from),
        },
    }
}

/// The keys that have names; a later name of a key is only read.
const NAMES: &[(&str, KeyCode)] = &[
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
    ("Esc", KeyCode::Esc),
];

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
    let named = NAMES.iter().find(|(name, _)| *name == text).map(|(_, code)| *code);
    plain(match named {
        Some(code) => code,
        None => KeyCode::F(text.strip_prefix('F')?.parse().ok()?),
    })
}

#[cfg(test)]
mod tests;
