//! The arithmetics, by name, and how a computation is run in one of them.

use crate::probe::{Alteration, Altered, Decimal, Erased, Perturbed, Printed, Probe, Silent, Single};
use crate::scene::{Color, Formulas};
use std::fmt;
use std::str::FromStr;

/// The arithmetic in which named quantities go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Arithmetic {
    /// Double precision, nothing altered.
    #[default]
    F64,
    /// Single precision.
    F32,
    /// By hand, with this many decimals.
    Decimal(u32),
    /// The same, and the products of every dot product are rounded before they are added.
    DecimalProducts(u32),
    /// Double precision with every named quantity moved by one ulp at random, from this seed.
    Perturbed(u64),
    /// The book's own values, in the numeric example.
    Printed,
}

/// A computation that any probe may see.
pub trait Computation {
    /// Runs it; gives the colour.
    fn run<P: Probe>(self, probe: &mut P) -> Color;

    /// The pixel that it is about, or any. What is random in it depends on that.
    fn pixel(&self) -> [u32; 2] {
        [0, 0]
    }
}

/// Text that names no arithmetic.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown arithmetic `{found}`, expected f64, f32, decimal:N with N from 0 to {}, perturbed:SEED with a whole SEED \
     from 0 to {}, or printed",
    Decimal::MAX_DIGITS,
    u64::MAX
)]
pub struct ArithmeticError {
    found: String,
}

impl Arithmetic {
    /// The same arithmetic with the products of dot products rounded; `None` unless it is one by hand.
    pub fn with_rounded_products(self) -> Option<Arithmetic> {
        match self {
            Arithmetic::Decimal(digits) | Arithmetic::DecimalProducts(digits) => {
                Some(Arithmetic::DecimalProducts(digits))
            }
            _ => None,
        }
    }

    /// Whether the products of dot products are rounded.
    pub fn rounds_products(self) -> bool {
        matches!(self, Arithmetic::DecimalProducts(_))
    }

    /// The formulas that go with it where nobody names others: by hand those of the notes.
    pub fn implied_formulas(self) -> Formulas {
        match self {
            Arithmetic::Decimal(_) | Arithmetic::DecimalProducts(_) | Arithmetic::Printed => Formulas::Notes,
            Arithmetic::F64 | Arithmetic::F32 | Arithmetic::Perturbed(_) => Formulas::Robust,
        }
    }

    /// The colour of a computation that nobody sees. Single precision isn't erased here: renders and the viewer's picture ask for it by the
    /// million.
    pub fn color<C: Computation>(self, computation: C) -> Color {
        match self {
            Arithmetic::F32 => computation.run(&mut Altered { alteration: Single, probe: Silent }),
            _ => self.run(Silent, computation).0,
        }
    }

    /// Runs a computation before `probe`, and gives its colour and the probe.
    pub fn run<P: Probe, C: Computation>(self, mut probe: P, computation: C) -> (Color, P) {
        match self {
            Arithmetic::F64 => (computation.run(&mut probe), probe),
            Arithmetic::F32 => altered(Single, probe, computation),
            Arithmetic::Decimal(digits) => altered(Decimal::new(digits), probe, computation),
            Arithmetic::DecimalProducts(digits) => altered(Decimal::with_rounded_products(digits), probe, computation),
            Arithmetic::Perturbed(seed) => altered(Perturbed::new(seed, computation.pixel()), probe, computation),
            Arithmetic::Printed => altered(Printed::default(), probe, computation),
        }
    }
}

fn altered<A: Alteration, P: Probe, C: Computation>(alteration: A, probe: P, computation: C) -> (Color, P) {
    let mut altered = Altered { alteration, probe };
    let color = computation.run(&mut Erased::of(&mut altered));
    (color, altered.probe)
}

impl fmt::Display for Arithmetic {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Arithmetic::F64 => f.write_str("f64"),
            Arithmetic::F32 => f.write_str("f32"),
            Arithmetic::Decimal(digits) | Arithmetic::DecimalProducts(digits) => write!(f, "decimal:{digits}"),
            Arithmetic::Perturbed(seed) => write!(f, "perturbed:{seed}"),
            Arithmetic::Printed => f.write_str("printed"),
        }
    }
}

impl FromStr for Arithmetic {
    type Err = ArithmeticError;

    fn from_str(text: &str) -> Result<Self, ArithmeticError> {
        let unknown = || ArithmeticError { found: text.to_owned() };
        match text {
            "f64" => Ok(Arithmetic::F64),
            "f32" => Ok(Arithmetic::F32),
            "printed" => Ok(Arithmetic::Printed),
            "perturbed" => Ok(Arithmetic::Perturbed(0)),
            _ if text.starts_with("perturbed:") => {
                let seed = text["perturbed:".len()..].parse();
                seed.map(Arithmetic::Perturbed).map_err(|_| unknown())
            }
            _ => {
                let digits = text.strip_prefix("decimal:").ok_or_else(unknown)?;
                let digits: u32 = digits.parse().map_err(|_| unknown())?;
                if digits <= Decimal::MAX_DIGITS { Ok(Arithmetic::Decimal(digits)) } else { Err(unknown()) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        use Arithmetic::*;
        for arithmetic in [F64, F32, Decimal(3), Perturbed(0), Perturbed(u64::MAX), Printed] {
            assert_eq!(arithmetic.to_string().parse(), Ok(arithmetic));
        }
        assert_eq!("perturbed".parse(), Ok(Perturbed(0)));
    }

    #[test]
    fn other_words_are_refused() {
        for text in [
            "",
            "f16",
            "decimal",
            "decimal:",
            "decimal:-1",
            "decimal:16",
            "decimal:x",
            "perturbed:",
            "perturbed:-1",
            "perturbed:1.5",
        ] {
            assert!(text.parse::<Arithmetic>().is_err(), "{text}");
        }
    }
}
