//! What is said at the bottom: why something can't be done, and what was done that isn't seen.

use super::super::{OfName, OfNames};
use crate::log::file::Ending;

/// What is said at the bottom.
pub struct Messages {
    /// There are fewer steps than that.
    pub last_step: fn(usize) -> String,
    /// Nobody would let the viewer go on.
    pub no_shell: &'static str,
    /// A saved log can't be traced.
    pub no_scene: &'static str,
    /// The key is for other panes.
    pub other_pane: &'static str,
    /// The key means nothing.
    pub no_key: &'static str,
    /// The node has no more siblings.
    pub no_siblings: &'static str,
    /// The log ends.
    pub no_steps: &'static str,
    /// It has no more values.
    pub no_values: &'static str,
    /// It has no more rays.
    pub no_rays: &'static str,
    /// There is nothing to step over to.
    pub no_step_over: &'static str,
    /// There is nothing to step out to.
    pub no_step_out: &'static str,
    /// All of the tree is shown.
    pub whole_tree: &'static str,
    /// It grows.
    pub tree_grows: &'static str,
    /// It plays at so many steps a second, or would.
    pub rate: fn(u32, bool) -> String,
    /// There is nothing left to play.
    pub nothing_to_play: &'static str,
    /// All was played.
    pub played: &'static str,
    /// Nothing was jumped from.
    pub nowhere_back: &'static str,
    /// There was no jump.
    pub no_jump: &'static str,
    /// A ray of one's own isn't traced again.
    pub not_traced_again: &'static str,
    /// The step is only near.
    pub nearest_step: &'static str,
    /// What was copied.
    pub copied: OfName,
    /// The log has no steps.
    pub no_step_to_remember: &'static str,
    /// A bookmark, and its address.
    pub bookmark: fn(char, &str) -> String,
    /// There is no such bookmark.
    pub no_bookmark: fn(char) -> String,
    /// The log doesn't have its address.
    pub bookmark_elsewhere: fn(char, &str) -> String,
    /// Nothing is searched for.
    pub no_search: &'static str,
    /// A text wasn't found.
    pub not_found: OfName,
    /// No row of the tree matches a text.
    pub no_row: OfName,
    /// The search went on at the beginning.
    pub from_the_beginning: &'static str,
    /// It went on at the end.
    pub from_the_end: &'static str,
    /// A text was pasted where no line is typed.
    pub pasted_nowhere: &'static str,
    /// The mouse belongs to the viewer.
    pub mouse_is_ours: &'static str,
    /// It belongs to the terminal.
    pub mouse_is_the_terminals: &'static str,
    /// The book has one pixel.
    pub one_pixel_printed: &'static str,
    /// A region has too many values to be compared.
    pub regions_not_compared: &'static str,
    /// The log of a pixel would have more events than this.
    pub too_long: fn(usize) -> String,
    /// There is no memory for it.
    pub no_memory: &'static str,
    /// It is shown in this language now.
    pub language: &'static str,
    /// The call that leads back to where the viewer was left.
    pub back_here: OfName,
    /// Warnings that stay until they are dismissed.
    pub warnings: Warnings,
}

/// What to warn of before one looks.
pub struct Warnings {
    /// How a saved log ends, unless it is complete.
    pub ending: fn(&Ending) -> Option<String>,
    /// Adaptive sampling is biased with these effects.
    pub biased: OfName,
}

/// What the quiz says.
pub struct Quiz {
    /// It begins.
    pub begins: &'static str,
    /// It ends: so many right, of so many.
    pub ends: fn(u32, u32) -> String,
    /// There is none.
    pub none: &'static str,
    /// The step has nothing to answer.
    pub nothing_hidden: &'static str,
    /// A decision is asked for.
    pub what_is_decided: &'static str,
    /// The answer is right.
    pub right: &'static str,
    /// The value is off by so much.
    pub off: OfName,
    /// The decision is another one.
    pub not_it: &'static str,
    /// How it is wrong, and what would have been right.
    pub it_is: OfNames,
    /// How it is wrong, while it may be tried again.
    pub try_again: OfName,
    /// The answer is no number.
    pub no_number: &'static str,
    /// It isn't three numbers.
    pub no_triple: &'static str,
    /// It is no decision.
    pub no_decision: &'static str,
    /// A list would tell the results.
    pub tells_results: &'static str,
    /// A value would.
    pub tells_result: &'static str,
    /// A name would.
    pub tells_decision: &'static str,
}

/// What is said of breakpoints.
pub struct Breakpoints {
    /// One was set.
    pub set: OfName,
    /// One was deleted.
    pub deleted: OfName,
    /// The quiz hides where it stops.
    pub hidden: &'static str,
    /// The step can't have one.
    pub nothing_here: &'static str,
    /// It stops nowhere.
    pub nowhere: OfName,
    /// All are off.
    pub all_off: &'static str,
    /// There are none.
    pub none: &'static str,
    /// A run ended: after so many stops of so many, forward or not.
    pub no_more: fn(usize, usize, bool) -> String,
    /// A run stopped: by which, and at what.
    pub stopped: OfNames,
    /// What can be typed.
    pub expected: &'static str,
    /// What kinds of events there are.
    pub expected_kind: &'static str,
    /// No kind of event is called so, but so.
    pub kind_like: OfNames,
    /// The log has no object called so, but one called so.
    pub object_like: OfNames,
    /// The log has no object called so, but others, and so many more.
    pub other_objects: fn(&str, &str, usize) -> String,
    /// The log has no objects.
    pub no_objects: &'static str,
    /// The log has no light called so, but one called so.
    pub light_like: OfNames,
    /// The log has no light called so, but others, and so many more.
    pub other_lights: fn(&str, &str, usize) -> String,
    /// The log has no lights.
    pub no_lights: &'static str,
    /// What can be typed behind `depth`.
    pub expected_depth: &'static str,
    /// A number has no components.
    pub no_components: OfName,
    /// A triple can only be compared by parts.
    pub three_numbers: OfName,
    /// What stands in place of a number.
    pub expected_number: OfName,
    /// Nothing is called so, but so.
    pub name_like: OfNames,
    /// Nothing is called so.
    pub no_name: OfName,
}

/// What is said of commands.
pub struct Commands {
    /// What stands for the letter that a command takes.
    pub letter: &'static str,
    /// What stands for the condition.
    pub condition: &'static str,
    /// What stands for the text.
    pub text: &'static str,
    /// That a number is one, too.
    pub step: &'static str,
    /// A command takes nothing.
    pub nothing_behind: OfName,
    /// No command is called so, but so.
    pub like: OfNames,
    /// All commands.
    pub expected: OfName,
    /// A beginning that several have.
    pub may_be: OfNames,
    /// How many steps there are.
    pub steps: fn(usize) -> String,
    /// What stands behind `bookmark`.
    pub expected_letter: &'static str,
    /// What stands behind `pixel`.
    pub expected_pixel: &'static str,
    /// What stands behind `lang`.
    pub expected_language: &'static str,
    /// The first and last columns and rows of the log.
    pub log_has: fn([u32; 4]) -> String,
    /// The last column and row of the picture.
    pub picture_has: fn([u32; 2]) -> String,
}
