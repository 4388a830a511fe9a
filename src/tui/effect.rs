//! What an action leaves to be done outside of the model.

use super::model::jumps::Spot;

/// What is left to do outside the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Nothing.
    None,
    /// Leave the viewer.
    Leave(Exit),
    /// Stop, until the shell lets the viewer go on.
    Suspend,
    /// Trace this pixel and show its log.
    Trace([u32; 2]),
    /// Trace this pixel and go to the step of it.
    Revisit([u32; 2], Spot),
    /// Trace what is shown in the other arithmetics.
    Compare,
    /// Study which rounding caused the error of what is shown.
    Study,
    /// Look up the worked example that is shown.
    Book,
    /// Put this text on the clipboard.
    Copy(String),
}

/// Why the viewer was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// By the key for it.
    Quit,
    /// By `^C` or SIGINT.
    Interrupted,
    /// By SIGTERM or SIGQUIT.
    Terminated,
    /// By SIGHUP, or because the terminal is gone.
    HungUp,
}
