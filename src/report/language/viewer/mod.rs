//! The texts of the viewer.
//!
//! What is typed or written in files has one form in every language: keys, commands, the words of breakpoints, the names of
//! quantities. What explains them is a text of a language.

mod breakpoints;
mod commands;
mod glossary;
mod help;
mod lists;
mod messages;
mod panes;
mod values;

pub use breakpoints::Breakpoints;
pub use commands::Commands;
pub use help::{Groups, Help, Keys};
pub use lists::{Account, Arithmetics, Book, Glossary, Hints, List, Lists, ToCome};
pub use messages::{Messages, Quiz, Warnings};
pub use panes::{Outcomes, Panes, Picture, Schematic, Status, StatusHints};
pub use values::{Eval, Watch};

texts! {
    /// The texts of the viewer.
    Viewer;
    /// The bottom line.
    status: Status;
    /// The panes.
    panes: Panes;
    /// The lists over them.
    lists: Lists;
    /// The help.
    help: Help;
    /// What is said at the bottom.
    messages: Messages;
    /// The quiz.
    quiz: Quiz;
    /// Breakpoints, and what is wrong with one that was typed.
    breakpoints: Breakpoints;
    /// Quantities that are watched.
    watch: Watch;
    /// Expressions that are evaluated.
    eval: Eval;
    /// Commands, and what is wrong with one that was typed.
    commands: Commands;
}
