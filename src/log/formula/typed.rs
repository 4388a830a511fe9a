//! What formulas have where people type them: signs of ASCII, numbers with powers of ten, and more functions, which become what formulas have.

use super::{Extreme, Formula, Operator, Unary};

/// Signs between terms beside those of formulas.
pub(super) const SUMS: &[(&str, Operator)] = &[("-", Operator::Minus)];

/// Signs between factors beside those of formulas; letters as they are shown where there is only ASCII.
pub(super) const PRODUCTS: &[(&str, Operator)] =
    &[("*", Operator::Times), ("x ", Operator::Cross), ("o ", Operator::Channelwise)];

/// A function that becomes other operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Call {
    Dot,
    Cross,
    Length,
    Unit,
    Clamp,
    Root,
    Radians,
}

/// Their names.
pub(super) const CALLS: &[(&str, Call)] = &[
    ("dot", Call::Dot),
    ("cross", Call::Cross),
    ("length", Call::Length),
    ("abs", Call::Length),
    ("unit", Call::Unit),
    ("clamp", Call::Clamp),
    ("sqrt", Call::Root),
    ("rad", Call::Radians),
];

impl Call {
    /// How many operands it has.
    pub fn operands(self) -> usize {
        match self {
            Call::Dot | Call::Cross => 2,
            Call::Clamp => 3,
            Call::Length | Call::Unit | Call::Root | Call::Radians => 1,
        }
    }

    /// What it is of these operands; `None` of another number of them.
    pub fn formula<Leaf: Clone>(self, operands: Vec<Formula<Leaf>>) -> Option<Formula<Leaf>> {
        let extreme = |extreme, a, b| Formula::binary(Operator::Extreme(extreme), a, b);
        let mut operands = operands.into_iter();
        let first = operands.next()?;
        Some(match self {
            Call::Dot => Formula::binary(Operator::Times, grouped(first), grouped(operands.next()?)),
            Call::Cross => Formula::binary(Operator::Cross, grouped(first), grouped(operands.next()?)),
            Call::Length => Formula::unary(Unary::Length, first),
            Call::Unit => {
                let length = Formula::unary(Unary::Length, first.clone());
                Formula::binary(Operator::Over, grouped(first), length)
            }
            Call::Clamp => {
                let least = operands.next()?;
                extreme(Extreme::Min, extreme(Extreme::Max, first, least), operands.next()?)
            }
            Call::Root => Formula::unary(Unary::Root, grouped(first)),
            Call::Radians => Formula::unary(Unary::Degrees, grouped(first)),
        })
    }
}

/// In parentheses, if it needs them beside an operator.
fn grouped<Leaf>(formula: Formula<Leaf>) -> Formula<Leaf> {
    match formula {
        Formula::Binary(Operator::Extreme(_), ..) => formula,
        Formula::Binary(..) | Formula::Unary(Unary::Negated | Unary::Root, _) => {
            Formula::unary(Unary::Grouped, formula)
        }
        single => single,
    }
}

/// The number that a text begins with, such as `12.5` or `1e-3`, and its length in bytes.
pub(super) fn number(text: &str, has_decimal_commas: bool) -> Option<(f64, usize)> {
    let digits = |from: usize| {
        let rest = &text.as_bytes()[from..];
        from + rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let byte = |at: usize| text.as_bytes().get(at).copied();
    let mut end = digits(0);
    let is_mark =
        byte(end) == Some(b'.') || (has_decimal_commas && byte(end) == Some(b',') && digits(end + 1) > end + 1);
    if is_mark {
        end = digits(end + 1);
    }
    if matches!(byte(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(byte(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    let number: f64 = text[..end].replace(',', ".").parse().ok()?;
    Some((number, end)).filter(|(number, _)| number.is_finite())
}

/// The raised number that a text begins with, such as `⁻¹²`, and its length in bytes. A square has a sign of its own.
pub(super) fn raised(text: &str) -> Option<(f64, usize)> {
    const DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let minus = text.strip_prefix('⁻').map_or(0, |_| '⁻'.len_utf8());
    let digits =
        text[minus..].chars().map_while(|c| DIGITS.chars().position(|digit| digit == c).map(|value| (value, c)));
    let (value, length) =
        digits.fold((0.0, 0), |(value, length), (digit, c)| (10.0 * value + digit as f64, length + c.len_utf8()));
    let is_square = minus == 0 && value == 2.0;
    let value = if minus > 0 { -value } else { value };
    (length > 0 && !is_square).then_some((value, minus + length))
}
