//! What is wrong with the text of a formula.

/// What is wrong with the text of a formula, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrong {
    /// The place in bytes from the beginning.
    pub at: usize,
    /// What was expected there.
    pub expected: Expected,
}

/// What was expected at a place of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// A number, a symbol or something in parentheses.
    Operand,
    /// This sign.
    Sign(&'static str),
    /// The end.
    End,
    /// Fewer operations.
    Less,
}

impl Wrong {
    /// The same in words, with what is there of the text.
    pub fn in_words(self, text: &str) -> String {
        let found = text.get(self.at..).unwrap_or_default();
        match self.expected {
            Expected::Operand => format!("expected a number or a symbol, found `{found}`"),
            Expected::Sign(sign) => format!("expected `{sign}`, found `{found}`"),
            Expected::End => format!("expected the end of the formula, found `{found}`"),
            Expected::Less => "expected fewer operations".to_owned(),
        }
    }
}
