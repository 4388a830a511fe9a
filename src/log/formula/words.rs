//! The words and signs of formulas that stand for more than one operation.

/// The function of Student's quantile in formulas.
pub const QUANTILE: &str = "student";

/// What a sum, product or statistic goes over, but for the lights.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Several {
    /// The samples of a pixel.
    Samples,
    /// The accepted cells of a pixel.
    Cells,
    /// The surfaces that a shadow ray crosses.
    Surfaces,
    /// The samples of a pixel, for the standard error of their mean.
    StandardError,
    /// The samples of a pixel, for the degrees of freedom of that error.
    Freedom,
}

impl Several {
    /// Every value.
    pub const ALL: [Several; 5] =
        [Several::Samples, Several::Cells, Several::Surfaces, Several::StandardError, Several::Freedom];

    /// The sign in formulas.
    pub fn sign(self) -> &'static str {
        match self {
            Several::Samples => "Σ_s",
            Several::Cells => "Σ_c",
            Several::Surfaces => "Π",
            Several::StandardError => "se_s",
            Several::Freedom => "df_s",
        }
    }

    /// Whether it is a statistic, which has no terms or factors.
    pub fn is_statistic(self) -> bool {
        matches!(self, Several::StandardError | Several::Freedom)
    }
}

/// A function of one number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    /// The cosine.
    Cos,
    /// The sine.
    Sin,
    /// The tangent.
    Tan,
    /// eˣ
    Exp,
    /// eˣ − 1
    ExpM1,
    /// The natural logarithm of 1 + x.
    Ln1p,
    /// The least whole number that isn't below.
    Ceil,
}

impl Function {
    /// Every value.
    pub const ALL: [Function; 7] =
        [Function::Cos, Function::Sin, Function::Tan, Function::Exp, Function::ExpM1, Function::Ln1p, Function::Ceil];

    /// What it is called in formulas.
    pub fn word(self) -> &'static str {
        match self {
            Function::Cos => "cos",
            Function::Sin => "sin",
            Function::Tan => "tan",
            Function::Exp => "exp",
            Function::ExpM1 => "expm1",
            Function::Ln1p => "ln1p",
            Function::Ceil => "ceil",
        }
    }
}
