//! The words and signs of formulas that stand for more than one operation.

/// What a sum or product goes over, but for the lights.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Several {
    /// The samples of a pixel.
    Samples,
    /// The accepted cells of a pixel.
    Cells,
    /// The surfaces that a shadow ray crosses.
    Surfaces,
}

impl Several {
    /// Every value.
    pub const ALL: [Several; 3] = [Several::Samples, Several::Cells, Several::Surfaces];

    /// The sign in formulas.
    pub fn sign(self) -> &'static str {
        match self {
            Several::Samples => "Σ_s",
            Several::Cells => "Σ_c",
            Several::Surfaces => "Π",
        }
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
