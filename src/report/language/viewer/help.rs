//! The help: every key in words.

use super::super::OfName;

/// The texts of the help.
pub struct Help {
    /// Its title.
    pub title: &'static str,
    /// What keys do in it where all of it is seen.
    pub finds: &'static str,
    /// What they do where it scrolls.
    pub scrolls: &'static str,
    /// What stands for the letter of one's choice in `m+letter`.
    pub letter: &'static str,
    /// What a number before a key does.
    pub counts: &'static str,
    /// All commands, in a sentence.
    pub commands: OfName,
    /// How to change to another language; in that language, so that those who want it can read it.
    pub other_language: &'static str,
    /// No key matches.
    pub nothing: &'static str,
    /// The headings.
    pub groups: Groups,
    /// The keys.
    pub keys: Keys,
}

/// The headings of the help, by what the keys under them are for.
#[allow(missing_docs)]
pub struct Groups {
    pub step: &'static str,
    pub tree: &'static str,
    pub fold: &'static str,
    pub picture: &'static str,
    pub understand: &'static str,
    pub viewer: &'static str,
    pub nesting: &'static str,
    pub run: &'static str,
    pub find: &'static str,
    pub keep: &'static str,
    pub breakpoints: &'static str,
}

/// What the keys do; the names are those of the actions.
#[allow(missing_docs)]
pub struct Keys {
    pub next_value: &'static str,
    pub previous_value: &'static str,
    pub next_event: &'static str,
    pub previous_event: &'static str,
    pub next_ray: &'static str,
    pub previous_ray: &'static str,
    pub down: &'static str,
    pub up: &'static str,
    pub out: &'static str,
    pub r#in: &'static str,
    pub enter: &'static str,
    pub next_sibling: &'static str,
    pub previous_sibling: &'static str,
    pub first: &'static str,
    pub last: &'static str,
    pub half_page_down: &'static str,
    pub half_page_up: &'static str,
    pub page_down: &'static str,
    pub page_up: &'static str,
    pub center: &'static str,
    pub toggle: &'static str,
    pub open_siblings: &'static str,
    pub close_siblings: &'static str,
    pub open_all: &'static str,
    pub close_all: &'static str,
    pub zoom_in: &'static str,
    pub zoom_out: &'static str,
    pub brighter: &'static str,
    pub darker: &'static str,
    pub next_view: &'static str,
    pub operands: &'static str,
    pub uses: &'static str,
    pub back: &'static str,
    pub contributions: &'static str,
    pub arithmetics: &'static str,
    pub quiz: &'static str,
    pub answer: &'static str,
    pub switch_pane: &'static str,
    pub previous_pane: &'static str,
    pub only_pane: &'static str,
    pub wider: &'static str,
    pub narrower: &'static str,
    pub help: &'static str,
    pub close: &'static str,
    pub quit: &'static str,
    pub interrupt: &'static str,
    pub suspend: &'static str,
    pub step_into: &'static str,
    pub step_into_back: &'static str,
    pub step_over: &'static str,
    pub step_over_back: &'static str,
    pub step_out: &'static str,
    pub step_out_back: &'static str,
    pub first_step: &'static str,
    pub last_step: &'static str,
    pub r#break: &'static str,
    pub toggle_break: &'static str,
    pub breakpoints: &'static str,
    pub run: &'static str,
    pub run_back: &'static str,
    pub stops: &'static str,
    pub play: &'static str,
    pub faster: &'static str,
    pub slower: &'static str,
    pub grow: &'static str,
    pub search: &'static str,
    pub next_match: &'static str,
    pub previous_match: &'static str,
    pub filter: &'static str,
    pub mark: &'static str,
    pub go_to_mark: &'static str,
    pub jump_back: &'static str,
    pub marks: &'static str,
    pub copy_value: &'static str,
    pub copy_path: &'static str,
    pub command: &'static str,
    pub mouse: &'static str,
    pub delete: &'static str,
}
