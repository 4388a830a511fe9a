//! Exact answers: decimal numbers of many digits, and how far an f64 is from one.

use crate::geometry::doubled::{Doubled, exponent};

/// The number that a decimal text stands for, to about 30 digits; `None` if the text is no decimal number.
pub(super) fn parse(text: &str) -> Option<Doubled> {
    let (mantissa, power) = match text.split_once(['e', 'E']) {
        Some((mantissa, power)) => (mantissa, power.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (is_negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa.strip_prefix('+').unwrap_or(mantissa)),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: Vec<u8> = whole.bytes().chain(fraction.bytes()).collect();
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let leading = digits.iter().take_while(|digit| **digit == b'0').count();
    let kept = &digits[leading..digits.len().min(leading + DIGITS)];
    let number = kept.iter().fold(0_u128, |number, digit| number * 10 + u128::from(digit - b'0'));
    let head = number as f64;
    // What is left fits into an i128 and is at most half a unit of the head.
    let tail = (number as i128 - head as u128 as i128) as f64;
    let places = i32::try_from(whole.len()).ok()? - i32::try_from(leading + kept.len()).ok()? + power;
    let value = times_power_of_ten(Doubled { head, tail }, places);
    Some(if is_negative { -value } else { value })
}

/// As many digits as a u128 holds with room for one more.
const DIGITS: usize = 36;

/// The number times 10^`power`. Powers beyond those of f64 give infinity or 0.
fn times_power_of_ten(mut value: Doubled, power: i32) -> Doubled {
    let ten = Doubled::from(10.0);
    for _ in 0..power.unsigned_abs().min(700) {
        value = if power > 0 { value * ten } else { value / ten };
    }
    if value.head.is_finite() { value } else { Doubled::from(value.head) }
}

/// |found − exact|, rounded.
pub(super) fn error(found: f64, exact: Doubled) -> f64 {
    if found == exact.head && exact.tail == 0.0 {
        return 0.0;
    }
    (Doubled::from(found) - exact).value().abs()
}

/// The distance of the two f64 around this number.
pub(super) fn ulp(exact: Doubled) -> f64 {
    const MANTISSA: i32 = 52;
    const LEAST: i32 = -1074;
    libm::scalbn(1.0, (exponent(exact.head) - MANTISSA).max(LEAST))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn value(text: &str, head: f64) {
        assert_eq!(parse(text).map(Doubled::value), Some(head), "{text}");
    }

    #[test]
    fn decimals_of_any_form() {
        value("0", 0.0);
        value("-0.25", -0.25);
        value("1460.21786853453982725533921868", 1460.2178685345398);
        value("2.62560677675841556983902025419e-6", 2.6256067767584156e-6);
        value("7.12398271658068972089296168784e-218", 7.12398271658069e-218);
        value("5725871355412076.40225448207847", 5725871355412076.0);
        value("-1E3", -1000.0);
        value("1e-400", 0.0);
    }

    #[test]
    fn what_is_no_number() {
        for text in ["", "-", ".", "1e", "1e1.5", "nan", "0x10", "1,5"] {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    #[test]
    fn errors_below_one_ulp_are_seen() {
        let third = parse("0.33333333333333333333333333333333333333").expect("a decimal number");
        let found = error(1.0 / 3.0, third) / ulp(third);
        assert!((found - 1.0 / 3.0).abs() < 1e-9, "{found}");
        let exact = parse("0.1").expect("a decimal number");
        assert!((error(0.1, exact) / ulp(exact) - 0.4).abs() < 1e-9);
        assert_eq!(ulp(parse("1").expect("a decimal number")), f64::EPSILON);
    }
}
