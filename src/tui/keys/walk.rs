//! The keys that step, run to breakpoints, find, remember and copy.
//!
//! `c` and `C` fold here, as they do in neighbours with a tree; debuggers that continue with them find `r` and `R`. `n` and
//! `N` step; so the matches of a search are `;` and `,`.

use super::Action::{self, Search};
use super::{Group, Row, row};
use crate::tui::guide::Walk;
use crate::tui::steps::Step;

/// The keys of [`Walk`].
pub(super) const TABLE: &[Row] = &[
    row(Group::Nesting, &["s"], Action::Walk(Walk::Step(Step::Into)), |keys| keys.step_into),
    row(Group::Nesting, &["S"], Action::Walk(Walk::Step(Step::IntoBack)), |keys| keys.step_into_back),
    row(Group::Nesting, &["o"], Action::Walk(Walk::Step(Step::Over)), |keys| keys.step_over),
    row(Group::Nesting, &["O"], Action::Walk(Walk::Step(Step::OverBack)), |keys| keys.step_over_back),
    row(Group::Nesting, &["u"], Action::Walk(Walk::Step(Step::Out)), |keys| keys.step_out),
    row(Group::Nesting, &["U"], Action::Walk(Walk::Step(Step::OutBack)), |keys| keys.step_out_back),
    row(Group::Nesting, &["0"], Action::Walk(Walk::FirstStep), |keys| keys.first_step),
    row(Group::Nesting, &["$"], Action::Walk(Walk::LastStep), |keys| keys.last_step),
    row(Group::Run, &["b"], Action::Walk(Walk::Break), |keys| keys.r#break),
    row(Group::Run, &["x"], Action::Walk(Walk::ToggleBreak), |keys| keys.toggle_break),
    row(Group::Run, &["B"], Action::Walk(Walk::Breakpoints), |keys| keys.breakpoints),
    row(Group::Run, &["r"], Action::Walk(Walk::Run), |keys| keys.run),
    row(Group::Run, &["R"], Action::Walk(Walk::RunBack), |keys| keys.run_back),
    row(Group::Run, &["L"], Action::Walk(Walk::Stops), |keys| keys.stops),
    row(Group::Run, &["P"], Action::Walk(Walk::Play), |keys| keys.play),
    row(Group::Run, &["+"], Action::Walk(Walk::Faster), |keys| keys.faster),
    row(Group::Run, &["-"], Action::Walk(Walk::Slower), |keys| keys.slower),
    row(Group::Run, &["t"], Action::Walk(Walk::Grow), |keys| keys.grow),
    row(Group::Find, &["/"], Search, |keys| keys.search),
    row(Group::Find, &[";"], Action::Walk(Walk::NextMatch), |keys| keys.next_match),
    row(Group::Find, &[","], Action::Walk(Walk::PreviousMatch), |keys| keys.previous_match),
    row(Group::Find, &["f"], Action::Walk(Walk::Filter), |keys| keys.filter),
    row(Group::Keep, &["m+letter"], Action::Walk(Walk::Mark('a')), |keys| keys.mark),
    row(Group::Keep, &["'+letter"], Action::Walk(Walk::GoTo('a')), |keys| keys.go_to_mark),
    row(Group::Keep, &["''"], Action::Walk(Walk::GoTo('\'')), |keys| keys.jump_back),
    row(Group::Keep, &["M"], Action::Walk(Walk::Marks), |keys| keys.marks),
    row(Group::Keep, &["y"], Action::Walk(Walk::CopyValue), |keys| keys.copy_value),
    row(Group::Keep, &["Y"], Action::Walk(Walk::CopyPath), |keys| keys.copy_path),
    row(Group::Keep, &[":"], Action::Walk(Walk::Command), |keys| keys.command),
    row(Group::Keep, &["^t"], Action::Walk(Walk::Mouse), |keys| keys.mouse),
    row(Group::Breakpoints, &["d"], Action::Walk(Walk::Delete), |keys| keys.delete),
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
