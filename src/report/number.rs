//! Numbers for people: rounded half away from zero in one place, then written.

use super::Style;
use crate::log::Value;
use crate::probe::round_half_away;

/// A number or triple: `6.380`, `(4, 5.996, 8.002)`.
pub fn value(value: &Value, style: Style) -> String {
    match value {
        Value::Number(x) => number(*x, style),
        Value::Triple(xyz) => {
            let components: Vec<_> = xyz.iter().map(|x| number(*x, style)).collect();
            format!("({})", components.join(", "))
        }
    }
}

/// A number. Whole ones have no decimals, which tells an exact 4 from a rounded 4.000; very small and very large ones
/// are written with a power of ten.
pub fn number(x: f64, style: Style) -> String {
    let magnitude = x.abs();
    if x == 0.0 {
        return "0".to_owned();
    }
    if magnitude >= 1e7 || round_half_away(magnitude, style.digits) == 0.0 {
        return scientific(x, style);
    }
    if x == x.trunc() {
        return format!("{x:.0}");
    }
    fixed(x, style.digits)
}

/// Whether a number is written with a power of ten: a product, which stands in parentheses under a power, a root or a fraction bar.
pub fn has_power_of_ten(x: f64, style: Style) -> bool {
    number(x, style).contains("·10")
}

fn fixed(x: f64, digits: u32) -> String {
    format!("{:.*}", digits as usize, round_half_away(x, digits))
}

/// Such as `2.147·10⁻¹²`.
fn scientific(x: f64, style: Style) -> String {
    // The shortest decimal digits of the value, exactly: no power is computed.
    let text = format!("{x:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mut mantissa: f64 = mantissa.parse().unwrap_or(x);
    let mut exponent: i32 = exponent.parse().unwrap_or(0);
    mantissa = round_half_away(mantissa, style.digits);
    if mantissa.abs() >= 10.0 {
        mantissa /= 10.0;
        exponent += 1;
    }
    format!("{}·10{}", fixed(mantissa, style.digits), superscript(exponent))
}

/// A size with three digits that count, such as `0.00359`, `12.7` or `2.84·10⁻⁵`: how far two values are apart.
pub fn size(x: f64) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    // The exponent after rounding: 9.999 is 10.0.
    let text = format!("{x:.2e}");
    let exponent: i32 = text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    match exponent {
        _ if x == 0.0 => "0".to_owned(),
        -3..=5 => format!("{:.*}", usize::try_from(2 - exponent).unwrap_or(0), x),
        _ => scientific(x, Style { digits: 2 }),
    }
}

pub(super) fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    exponent.to_string().chars().map(raised).collect()
}

/// The ordinary digits of a raised number: `-12` of `⁻¹²`.
pub(super) fn lowered(raised: &str) -> String {
    let digit = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == c);
    let lowered = |c: char| digit(c).map_or('-', |digit| char::from(b"0123456789"[digit]));
    raised.chars().map(lowered).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn shows(x: f64, expected: &str) {
        assert_eq!(number(x, Style::default()), expected);
    }

    #[test]
    fn three_decimals() {
        shows(6.38, "6.380");
        shows(-0.9457, "-0.946");
        shows(1.0005, "1.001");
    }

    #[test]
    fn whole_numbers_stand_bare() {
        shows(-12.0, "-12");
        shows(0.0, "0");
        shows(-0.0, "0");
        shows(4.000_000_000_000_001, "4.000");
    }

    #[test]
    fn sizes_have_three_digits() {
        let sizes = [0.0, 0.003_586, 9.999, 0.000_028_4, 12.651, 987_654.0, 1e7, f64::INFINITY];
        let expected = ["0", "0.00359", "10.0", "2.84·10⁻⁵", "12.7", "987654", "1.00·10⁷", "inf"];
        assert_eq!(sizes.map(size), expected);
    }

    #[test]
    fn very_small_and_large_ones_have_powers_of_ten() {
        shows(2.147_038_870_254_324e-12, "2.147·10⁻¹²");
        shows(-0.000_499_99, "-5.000·10⁻⁴");
        shows(1.5e30, "1.500·10³⁰");
        shows(9.9999e-5, "1.000·10⁻⁴");
    }
}
