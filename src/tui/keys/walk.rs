//! The keys that step, run to breakpoints, find, remember and copy.
//!
//! `c` and `C` fold here, as they do in neighbours with a tree; debuggers that continue with them find `r` and `R`. `n` and
//! `N` step; so the matches of a search are `;` and `,`.

use super::Action::{self, Search};
use super::{Row, row};
use crate::tui::guide::Walk;
use crate::tui::steps::Step;

const STEP: &str = "Step into, over and out";
const RUN: &str = "Run and play";
const FIND: &str = "Find";
const KEEP: &str = "Remember and copy";
/// The group of the keys that only a list has.
pub(super) const IN_LISTS: &str = "In the list of breakpoints";

/// The keys of [`Walk`].
pub(super) const TABLE: &[Row] = &[
    row(STEP, &["s"], Action::Walk(Walk::Step(Step::Into)), "into: to the next event, wherever it is"),
    row(STEP, &["S"], Action::Walk(Walk::Step(Step::IntoBack)), "into, backward"),
    row(STEP, &["o"], Action::Walk(Walk::Step(Step::Over)), "over: to the next event of this node or one around it"),
    row(STEP, &["O"], Action::Walk(Walk::Step(Step::OverBack)), "over, backward"),
    row(STEP, &["u"], Action::Walk(Walk::Step(Step::Out)), "out: past the end of this node, to one around it"),
    row(STEP, &["U"], Action::Walk(Walk::Step(Step::OutBack)), "out, backward: to before this node"),
    row(STEP, &["0"], Action::Walk(Walk::FirstStep), "to the first step (42G goes to step 42)"),
    row(STEP, &["$"], Action::Walk(Walk::LastStep), "to the last step"),
    row(RUN, &["b"], Action::Walk(Walk::Break), "type a breakpoint: hit, object NAME, depth 2, T2_A < 0"),
    row(RUN, &["x"], Action::Walk(Walk::ToggleBreak), "set or clear a breakpoint on what happens here"),
    row(RUN, &["B"], Action::Walk(Walk::Breakpoints), "list the breakpoints"),
    row(RUN, &["r"], Action::Walk(Walk::Run), "run to the next breakpoint (c folds)"),
    row(RUN, &["R"], Action::Walk(Walk::RunBack), "run back to the previous breakpoint"),
    row(RUN, &["L"], Action::Walk(Walk::Stops), "list where the runs stopped"),
    row(RUN, &["P"], Action::Walk(Walk::Play), "play, value by value; again to stop"),
    row(RUN, &["+"], Action::Walk(Walk::Faster), "play twice as fast"),
    row(RUN, &["-"], Action::Walk(Walk::Slower), "play half as fast"),
    row(RUN, &["t"], Action::Walk(Walk::Grow), "let the tree grow with the steps; again to see all of it"),
    row(FIND, &["/"], Search, "search names, symbols, words and values; capitals count if there are any"),
    row(FIND, &[";"], Action::Walk(Walk::NextMatch), "to the next match (n steps)"),
    row(FIND, &[","], Action::Walk(Walk::PreviousMatch), "to the previous match"),
    row(FIND, &["f"], Action::Walk(Walk::Filter), "show only rows that match; nothing typed shows all"),
    row(KEEP, &["m+letter"], Action::Walk(Walk::Mark('a')), "set a bookmark here"),
    row(KEEP, &["'+letter"], Action::Walk(Walk::GoTo('a')), "go to a bookmark"),
    row(KEEP, &["''"], Action::Walk(Walk::GoTo('\'')), "go back to before the last jump"),
    row(KEEP, &["M"], Action::Walk(Walk::Marks), "list the bookmarks"),
    row(KEEP, &["y"], Action::Walk(Walk::CopyValue), "copy the value with all its digits"),
    row(KEEP, &["Y"], Action::Walk(Walk::CopyPath), "copy the address, such as C R S1 shade.n_dot_l"),
    row(KEEP, &[":"], Action::Walk(Walk::Command), "type a command; :help lists them"),
    row(KEEP, &["^t"], Action::Walk(Walk::Mouse), "let the mouse select and scroll, or not"),
    row(
        IN_LISTS,
        &["d"],
        Action::Walk(Walk::Delete),
        "delete it; Space turns it on or off, Enter goes to its next place",
    ),
];

/// Whether a character is the first of two keys of which the second is anybody's choice.
pub(super) fn begins_a_mark(first: char) -> bool {
    matches!(first, 'm' | '\'')
}

/// What such a first key and the name of the second mean.
pub(super) fn marked(prefix: char, name: &str) -> Option<Action> {
    let mut characters = name.chars();
    let second = characters.next().filter(|_| characters.next().is_none())?;
    match prefix {
        'm' if second.is_alphanumeric() => Some(Action::Walk(Walk::Mark(second))),
        '\'' if second.is_alphanumeric() || second == '\'' => Some(Action::Walk(Walk::GoTo(second))),
        _ => None,
    }
}
