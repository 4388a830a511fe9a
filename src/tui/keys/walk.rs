//! The keys that step, run to breakpoints, find, remember and copy.
//!
//! `c` and `C` fold here, as they do in neighbours with a tree; debuggers that continue with them find `r` and `R`. `n` and
//! `N` step; so the matches of a search are `;` and `,`.

use super::Action::{self, Search};
use super::{Row, row};
use crate::tui::steps::Step;

/// What is done to find the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Walk {
    /// Step by the nesting of the nodes.
    Step(Step),
    FirstStep,
    LastStep,
    Break,
    ToggleBreak,
    Breakpoints,
    Run,
    RunBack,
    Stops,
    /// Watch the quantity at the current step, or no longer.
    Watch,
    /// All values of that quantity.
    History,
    Play,
    Faster,
    Slower,
    /// It is time for the next step while playing.
    Tick,
    Grow,
    NextMatch,
    PreviousMatch,
    Filter,
    /// Hide the intersection tests, or show them.
    Tests,
    /// Set the bookmark with this letter.
    Mark(char),
    /// Go to the bookmark with this letter; to before the last jump with `'`.
    GoTo(char),
    Marks,
    CopyValue,
    CopyPath,
    Command,
    Mouse,
    Edit,
    /// A click into this column and row.
    Click(u16, u16),
    /// The wheel was turned by this many rows, at this column and row.
    Wheel(i16, u16, u16),
    /// Delete the selected entry of a list.
    Delete,
}

/// The keys of [`Walk`].
pub(super) const TABLE: &[Row] = &[
    row(|groups| groups.nesting, &["s"], Action::Walk(Walk::Step(Step::Into)), |keys| keys.step_into),
    row(|groups| groups.nesting, &["S"], Action::Walk(Walk::Step(Step::IntoBack)), |keys| keys.step_into_back),
    row(|groups| groups.nesting, &["o"], Action::Walk(Walk::Step(Step::Over)), |keys| keys.step_over),
    row(|groups| groups.nesting, &["O"], Action::Walk(Walk::Step(Step::OverBack)), |keys| keys.step_over_back),
    row(|groups| groups.nesting, &["u"], Action::Walk(Walk::Step(Step::Out)), |keys| keys.step_out),
    row(|groups| groups.nesting, &["U"], Action::Walk(Walk::Step(Step::OutBack)), |keys| keys.step_out_back),
    row(|groups| groups.nesting, &["0"], Action::Walk(Walk::FirstStep), |keys| keys.first_step),
    row(|groups| groups.nesting, &["$"], Action::Walk(Walk::LastStep), |keys| keys.last_step),
    row(|groups| groups.run, &["b"], Action::Walk(Walk::Break), |keys| keys.r#break),
    row(|groups| groups.run, &["x"], Action::Walk(Walk::ToggleBreak), |keys| keys.toggle_break),
    row(|groups| groups.run, &["B"], Action::Walk(Walk::Breakpoints), |keys| keys.breakpoints),
    row(|groups| groups.run, &["r"], Action::Walk(Walk::Run), |keys| keys.run),
    row(|groups| groups.run, &["R"], Action::Walk(Walk::RunBack), |keys| keys.run_back),
    row(|groups| groups.run, &["L"], Action::Walk(Walk::Stops), |keys| keys.stops),
    row(|groups| groups.run, &["*"], Action::Walk(Walk::Watch), |keys| keys.watch),
    row(|groups| groups.run, &["#"], Action::Walk(Walk::History), |keys| keys.history),
    row(|groups| groups.run, &["P"], Action::Walk(Walk::Play), |keys| keys.play),
    row(|groups| groups.run, &["+"], Action::Walk(Walk::Faster), |keys| keys.faster),
    row(|groups| groups.run, &["-"], Action::Walk(Walk::Slower), |keys| keys.slower),
    row(|groups| groups.run, &["t"], Action::Walk(Walk::Grow), |keys| keys.grow),
    row(|groups| groups.find, &["/"], Search, |keys| keys.search),
    row(|groups| groups.find, &[";"], Action::Walk(Walk::NextMatch), |keys| keys.next_match),
    row(|groups| groups.find, &[","], Action::Walk(Walk::PreviousMatch), |keys| keys.previous_match),
    row(|groups| groups.find, &["f"], Action::Walk(Walk::Filter), |keys| keys.filter),
    row(|groups| groups.find, &["T"], Action::Walk(Walk::Tests), |keys| keys.tests),
    row(|groups| groups.keep, &["m+letter"], Action::Walk(Walk::Mark('a')), |keys| keys.mark),
    row(|groups| groups.keep, &["'+letter"], Action::Walk(Walk::GoTo('a')), |keys| keys.go_to_mark),
    row(|groups| groups.keep, &["''"], Action::Walk(Walk::GoTo('\'')), |keys| keys.jump_back),
    row(|groups| groups.keep, &["M"], Action::Walk(Walk::Marks), |keys| keys.marks),
    row(|groups| groups.keep, &["y"], Action::Walk(Walk::CopyValue), |keys| keys.copy_value),
    row(|groups| groups.keep, &["Y"], Action::Walk(Walk::CopyPath), |keys| keys.copy_path),
    row(|groups| groups.keep, &[":"], Action::Walk(Walk::Command), |keys| keys.command),
    row(|groups| groups.keep, &["^e"], Action::Walk(Walk::Edit), |keys| keys.edit),
    row(|groups| groups.keep, &["^t"], Action::Walk(Walk::Mouse), |keys| keys.mouse),
    row(|groups| groups.breakpoints, &["d"], Action::Walk(Walk::Delete), |keys| keys.delete),
];

/// An action with the letter that was typed behind its key.
pub(super) fn with_letter(action: Action, name: &str) -> Option<Action> {
    let mut characters = name.chars();
    let letter = characters.next().filter(|letter| characters.next().is_none() && letter.is_alphanumeric())?;
    match action {
        Action::Walk(Walk::Mark(_)) => Some(Action::Walk(Walk::Mark(letter))),
        Action::Walk(Walk::GoTo(_)) => Some(Action::Walk(Walk::GoTo(letter))),
        _ => None,
    }
}
