//! Floors with the numbers put in. A floor jumps: the numbers that are shown must have the one that was computed, which rounded ones
//! needn't have.

use super::{Expression, Leaf, Part, Substitution};
use crate::log::Value;
use crate::log::formula::{Formula, Operator, Unary};
use crate::report::{Style, number};

/// The most decimals that are tried: up to these, powers of ten are exact.
const MOST: u32 = 22;

impl Substitution<'_> {
    /// `⌊a⌋` with as many decimals as make it right.
    pub(super) fn floor(&self, inner: &Formula) -> Part {
        let inner = self.part(inner).shown();
        inner.map_or(Part::Zero, |inner| Part::There(Formula::unary(Unary::Floor, told(inner, self.style))))
    }
}

/// A quotient or a value, shown with as many decimals as give it its floor. Where none do, because the last bit of a decimal fraction
/// decided (the f64 of 0.3 over that of 0.1 is below 3) or the division rounded up to a whole number, it is the quotient itself.
fn told(inner: Expression, style: Style) -> Expression {
    let (above, below) = match &inner {
        Formula::Binary(Operator::Over, above, below) => (put_in(above), put_in(below)),
        whole => (put_in(whole), Some((Value::Number(1.0), None))),
    };
    let (Some((above, link)), Some((Value::Number(below), link_below))) = (above, below) else { return inner };
    match (telling(above.components(), below, style), inner) {
        (Some((of_above, of_below)), Formula::Binary(operator, first, second)) => {
            let above = shown(above, link, &of_above, style).map_or(first, Box::new);
            let below = shown(Value::Number(below), link_below, &[of_below], style).map_or(second, Box::new);
            Formula::Binary(operator, above, below)
        }
        (Some((of_above, _)), whole) => shown(above, link, &of_above, style).unwrap_or(whole),
        (None, inner) => {
            let quotient = above.map(|x| x / below);
            let Some((digits, _)) = telling(quotient.components(), 1.0, style) else { return inner };
            shown(quotient, None, &digits, style).unwrap_or(Expression::value(quotient, None))
        }
    }
}

/// A value that was put in, and the event that computed it.
fn put_in(expression: &Expression) -> Option<(Value, Option<usize>)> {
    match expression {
        Formula::Leaf(Leaf::Value(value, link)) => Some((*value, *link)),
        Formula::Number(x) => Some((Value::Number(*x), None)),
        _ => None,
    }
}

/// A value whose components have this many decimals; `None` where those are the decimals that all numbers have.
fn shown(value: Value, link: Option<usize>, digits: &[u32], style: Style) -> Option<Expression> {
    let part = |x: f64, digits: u32| match digits {
        _ if digits == style.digits => Expression::value(Value::Number(x), link),
        _ => Formula::Leaf(Leaf::Precise(x, digits, link)),
    };
    match (value, digits) {
        (_, digits) if digits.iter().all(|digits| *digits == style.digits) => None,
        (Value::Triple([x, y, z]), [of_x, of_y, of_z]) => {
            Some(Formula::Triple(Box::new([part(x, *of_x), part(y, *of_y), part(z, *of_z)])))
        }
        (Value::Number(x), [digits]) => Some(part(x, *digits)),
        _ => None,
    }
}

/// How many decimals of each of some numbers, and of the one that they are divided by, give the floors of the quotients: the fewest of the
/// divisor, which all of them have in common, and then of each. `None` where none do.
fn telling(above: &[f64], below: f64, style: Style) -> Option<(Vec<u32>, u32)> {
    decimals(below, style).find_map(|(of_below, divisor)| {
        let of_one = |x: &f64| {
            let floor = (x / below).floor();
            decimals(*x, style).find(|(_, shown)| has_floor(*shown, divisor, floor)).map(|(digits, _)| digits)
        };
        Some((above.iter().map(of_one).collect::<Option<Vec<u32>>>()?, of_below))
    })
}

/// A number as it is shown with more and more decimals, up to where it reads back as the same f64.
fn decimals(x: f64, style: Style) -> impl Iterator<Item = (u32, Decimal)> {
    let mut is_over = false;
    (style.digits..=MOST.max(style.digits)).map_while(move |digits| {
        if is_over {
            return None;
        }
        let shown = Decimal::of(&number::number(x, style.with(digits)))?;
        is_over = shown.nearest() == x;
        Some((digits, shown))
    })
}

/// A number as it is written: digits·10^exponent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    digits: i128,
    exponent: i32,
}

impl Decimal {
    /// Reads what [`number::number`] wrote; `None` for what is no number or has too many digits.
    fn of(text: &str) -> Option<Decimal> {
        let (mantissa, power) = match text.split_once("·10") {
            Some((mantissa, raised)) => (mantissa, number::lowered(raised).parse().ok()?),
            None => (text, 0_i32),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let places = i32::try_from(fraction.len()).ok()?;
        Some(Decimal { digits: format!("{whole}{fraction}").parse().ok()?, exponent: power - places })
    }

    /// The f64 nearest to it.
    fn nearest(self) -> f64 {
        format!("{}e{}", self.digits, self.exponent).parse().unwrap_or(f64::NAN)
    }

    /// Its digits where the last one stands for 10^exponent; `None` where there are too many.
    fn scaled(self, exponent: i32) -> Option<i128> {
        let places = u32::try_from(self.exponent.checked_sub(exponent)?).ok()?;
        self.digits.checked_mul(10_i128.checked_pow(places)?)
    }
}

/// Whether a quotient of numbers as they are written has this floor, in exact arithmetic. Sizes that are too far apart for that are
/// asked in f64: neither is anywhere near a whole number of the other.
fn has_floor(above: Decimal, below: Decimal, floor: f64) -> bool {
    let exact = || {
        let exponent = above.exponent.min(below.exponent);
        let (above, below) = (above.scaled(exponent)?, below.scaled(exponent)?);
        // Beyond this not every whole number is an f64.
        let whole = (floor.abs() <= 9e15).then_some(floor as i128)?;
        let (low, high) = (whole.checked_mul(below)?, whole.checked_add(1)?.checked_mul(below)?);
        Some(if below > 0 { low <= above && above < high } else { low >= above && above > high })
    };
    exact().unwrap_or_else(|| (above.nearest() / below.nearest()).floor() == floor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::language::Language;
    use crate::report::notation::{Numbers, Plain, written};

    fn line(above: [f64; 3], below: f64, digits: u32) -> String {
        let [above, below] =
            [Value::Triple(above), Value::Number(below)].map(|value| Box::new(Expression::value(value, None)));
        let style = Style { digits, keeps_small: false };
        written::<Plain>(
            Numbers { language: Language::English, style },
            &told(Formula::Binary(Operator::Over, above, below), style),
        )
    }

    #[test]
    fn as_many_decimals_as_it_takes() {
        let below_half = 0.5_f64.next_down();
        for (above, below, expected) in [
            ([2.3, 0.876_25, 0.5], 0.5, "(2.300, 0.876, 0.500)/0.500"),
            ([2.3, 0.876_25, below_half], 0.5, "(2.300, 0.876, 0.4999999999999999)/0.500"),
            ([2.3, 0.499_96, -1e-20], 0.5, "(2.300, 0.49996, -1.000·10⁻²⁰)/0.500"),
            ([0.75, 0.5, 0.25], 1.0 / 4.0, "(0.750, 0.500, 0.250)/0.250"),
            ([2.0 / 3.0, 0.1, 0.2], 1.0 / 3.0, "(0.667, 0.100, 0.200)/0.333"),
            ([0.666, 0.1, 0.2], 1.0 / 3.0, "(0.666, 0.100, 0.200)/0.3333"),
            // By the last bit of 0.1, and by the rounding of the division.
            ([0.3, 0.6, 0.2], 0.1, "(2.9999999999999996, 5.999999999999999, 2)"),
            ([1e300, -1e300, 1e-300], 1e-3, "(1.000·10³⁰⁰, -1.000·10³⁰⁰, 1.000·10⁻³⁰⁰)/0.001"),
        ] {
            assert_eq!(line(above, below, 3), expected);
        }
    }
}
