//! Going from pane to pane, and how large they are.

use super::model::{Model, Pane};

/// Moves the focus to the n-th pane after the one that has it, of those on the screen.
pub(super) fn switch(model: &mut Model, by: isize) {
    let panes: Vec<Pane> =
        Pane::ALL.into_iter().filter(|pane| *pane != Pane::Picture || model.picture.is_some()).collect();
    let at = panes.iter().position(|pane| *pane == model.focus).unwrap_or(0) as isize;
    let next = (at + by).rem_euclid(panes.len() as isize) as usize;
    model.focus_on(panes[next]);
}

/// The tree's width, changed by this many steps to the right. What the screen has no room for is forgotten.
pub(super) fn shifted(model: &Model, steps: i64) -> i16 {
    const STEP: i64 = 4;
    let most = i64::from(model.size.0);
    (i64::from(model.shift) + steps * STEP).clamp(-most, most).clamp(i16::MIN.into(), i16::MAX.into()) as i16
}
