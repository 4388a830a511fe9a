//! What an action leaves to be done outside of the model.

use super::model::jumps::Spot;
use crate::log::plane::Plane;

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
    /// Study which rounding caused the error of what is shown, in this arithmetic or in that of the viewer.
    Study(Option<String>),
    /// Look up the worked example that is shown.
    Book,
    /// Put this text on the clipboard.
    Copy(String),
    /// Change the scene, and trace what is shown anew.
    Change(Change),
    /// Show what was before the last change beside what is now.
    Beside,
    /// Save the scene under this name.
    Save(String),
    /// Save a picture of the viewer under this name.
    Screenshot(String),
    /// Save the log that is shown, in the format of this name.
    Export(String),
    /// Keep the notes of the bookmarks.
    Keep,
    /// Open the scene in an editor, where it has this object.
    Edit(Option<u32>),
    /// Render what of the pixels has this name.
    Picture(Plane),
    /// Complete the path of a parameter or of a file in the line that is being typed.
    Complete,
}

/// A change of the scene, or of how it is traced, in the words that were typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// Another value of a parameter.
    Set {
        /// Its path, such as `objects.sphere.shape.sphere.radius`.
        path: String,
        /// The value: JSON, numbers with blanks between them, or a word.
        value: String,
    },
    /// Another arithmetic.
    Arithmetic(String),
    /// Another algorithm.
    Algorithm(String),
    /// Another sampling.
    Sampling(String),
    /// Another depth limit.
    Depth(String),
    /// Take the last change back.
    Undo,
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
