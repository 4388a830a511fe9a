//! Which rays make a pixel: the choice. What each method does stands in `sampling`.

/// The methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// One ray through the pixel's centre.
    Center,
    /// Rays through the corners of n × n cells, which neighbours share.
    Shared {
        /// Cells a side, 1 or more.
        n: u32,
    },
}

impl Sampling {
    /// The word of the method, as a scene file has it.
    pub fn word(self) -> &'static str {
        match self {
            Sampling::Center => "none",
            Sampling::Shared { .. } => "shared",
        }
    }

    /// Its parameters by name.
    pub fn parameters(self) -> Vec<(&'static str, f64)> {
        match self {
            Sampling::Center => Vec::new(),
            Sampling::Shared { n } => vec![("n", n.into())],
        }
    }
}
