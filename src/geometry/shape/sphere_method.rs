//! Which formulas intersect a sphere.

/// Which formulas intersect a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// Those that keep their digits.
    Robust,
    /// Those of the source text.
    Geometric,
}

impl SphereMethod {
    /// The word for it in scene files and logs.
    pub fn word(self) -> &'static str {
        match self {
            SphereMethod::Robust => "robust",
            SphereMethod::Geometric => "geometric",
        }
    }
}
