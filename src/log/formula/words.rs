//! The words and signs of formulas that stand for more than one operation.

use crate::log::words::words;

/// The function of Student's quantile in formulas.
pub const QUANTILE: &str = "student";

words! {
    /// What a sum, product or statistic goes over, but for the lights.
    pub Several {
        /// The samples of a pixel.
        Samples = "Σ_s",
        /// The accepted cells of a pixel.
        Cells = "Σ_c",
        /// The surfaces that a shadow ray crosses.
        Surfaces = "Π",
        /// The samples of a pixel, for the standard error of their mean.
        StandardError = "se_s",
        /// The samples of a pixel, for the degrees of freedom of that error.
        Freedom = "df_s",
    }
}

impl Several {
    /// Whether it is a statistic, which has no terms or factors.
    pub fn is_statistic(self) -> bool {
        matches!(self, Several::StandardError | Several::Freedom)
    }
}

words! {
    /// A function of one number.
    pub Function {
        /// The cosine.
        Cos = "cos",
        /// The sine.
        Sin = "sin",
        /// The tangent.
        Tan = "tan",
        /// eˣ
        Exp = "exp",
        /// eˣ − 1
        ExpM1 = "expm1",
        /// The natural logarithm.
        Ln = "ln",
        /// The natural logarithm of 1 + x.
        Ln1p = "ln1p",
        /// The least whole number that isn't below.
        Ceil = "ceil",
        /// The angle with this sine, from −π/2 to π/2.
        Asin = "asin",
        /// The angle with this cosine, from 0 to π.
        Acos = "acos",
        /// The angle with this tangent, from −π/2 to π/2.
        Atan = "atan",
        /// An angle in radians in degrees.
        Deg = "deg",
    }
}
