//! The texts of the viewer.
//!
//! What is typed or written in files has one form in every language: keys, commands, the words of breakpoints, the names of
//! quantities. What explains them is a text of a language.

mod help;
mod lists;
mod messages;
mod panes;

pub use help::{Groups, Help, Keys};
pub use lists::{Account, Arithmetics, Hints, List, Lists, ToCome};
pub use messages::{Breakpoints, Commands, Messages, Quiz, Warnings};
pub use panes::{Outcomes, Panes, Picture, Schematic, Status};

/// The texts of the viewer.
pub struct Viewer {
    /// The bottom line.
    pub status: Status,
    /// The panes.
    pub panes: Panes,
    /// The lists over them.
    pub lists: Lists,
    /// The help.
    pub help: Help,
    /// What is said at the bottom.
    pub messages: Messages,
    /// The quiz.
    pub quiz: Quiz,
    /// Breakpoints, and what is wrong with one that was typed.
    pub breakpoints: Breakpoints,
    /// Commands, and what is wrong with one that was typed.
    pub commands: Commands,
}
