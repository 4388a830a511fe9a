//! Whether messages are coloured.

use clap::ValueEnum;
use std::io::{self, IsTerminal};

/// Whether to use colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ColorChoice {
    /// Where the output is a terminal and NO_COLOR isn't set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

impl ColorChoice {
    /// Messages are made with colours: from here on standard error leaves them out unless they are wanted there.
    pub fn choose_for_messages(self) {
        let is_colored = self.applies_to(&io::stderr());
        if is_colored { anstream::ColorChoice::AlwaysAnsi } else { anstream::ColorChoice::Never }.write_global();
    }

    /// Whether output to this stream is coloured.
    pub fn applies_to(self, stream: &impl IsTerminal) -> bool {
        match self {
            ColorChoice::Always => true,
            ColorChoice::Never => false,
            ColorChoice::Auto => stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|set| set.is_empty()),
        }
    }
}
