//! The bottom line: what is typed there, and what is said.

use crate::report::language::viewer::Status;
use std::collections::HashMap;
use tui_input::Input;

/// A line that is being typed.
#[derive(Clone, Debug)]
pub struct Prompt {
    /// What for.
    pub purpose: Purpose,
    /// What has been typed.
    pub line: Input,
    /// How many lines before this one it was brought back from; 0 where it wasn't.
    pub recalled: usize,
    /// What was at each of these places when another line was brought back; at 0 what was being typed.
    pub left: HashMap<usize, String>,
    /// How many of the latest lines before are this one, which was wrong and is being mended.
    pub tried: usize,
}

/// What a line is typed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Purpose {
    /// What to look for.
    Search,
    /// What the rows of the tree must match.
    Filter,
    /// Where to stop.
    Break,
    /// A command.
    Command,
    /// What the rows of the help must contain.
    Help,
    /// The result of the current step, in a quiz.
    Answer,
}

impl Purpose {
    /// What precedes the line.
    pub fn sign(self, status: &Status) -> &'static str {
        match self {
            Purpose::Search => "/",
            Purpose::Filter => status.filter,
            Purpose::Break => status.break_at,
            Purpose::Command => ":",
            Purpose::Help => status.keys_with,
            Purpose::Answer => status.answer,
        }
    }
}

impl Prompt {
    /// An empty line.
    pub fn new(purpose: Purpose) -> Prompt {
        Prompt { purpose, line: Input::default(), recalled: 0, left: HashMap::new(), tried: 0 }
    }
}

/// Something said at the bottom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// The words.
    pub text: String,
    /// Whether it stays until it is dismissed; else until the next key.
    pub is_warning: bool,
}
