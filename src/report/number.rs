//! Numbers for people: rounded half away from zero in one place, then written.

use super::Style;
use crate::log::Value;
use crate::probe::round_half_away;

/// A number. Whole ones have no decimals, which tells an exact 4 from a rounded 4.000; very small and very large ones
/// are written with a power of ten.
pub fn number(x: f64, style: Style) -> String {
    let magnitude = x.abs();
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return x.to_string();
    }
    if magnitude >= 1e7 || round_half_away(magnitude, style.digits) == 0.0 {
        return scientific(x, style);
    }
    if x == x.trunc() {
        return format!("{x:.0}");
    }
    fixed(x, decimals(x, style))
}

/// How many decimals a number has that isn't whole.
fn decimals(x: f64, style: Style) -> u32 {
    const LEAST_SIGNIFICANT: u32 = 3;
    if !style.keeps_small || round_half_away(x, style.digits).abs() >= 1.0 {
        return style.digits;
    }
    // The exponent after rounding: 0.09996 is 0.100.
    let least = style.digits.clamp(1, LEAST_SIGNIFICANT) - 1;
    let text = format!("{x:.*e}", least as usize);
    let exponent: i32 = text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    style.digits.max(least + exponent.unsigned_abs())
}

/// Whether a number is written with a power of ten: a product, which is in parentheses under a power, a root or a fraction bar.
pub fn has_power_of_ten(x: f64, style: Style) -> bool {
    number(x, style).contains("·10")
}

/// The style with the fewest decimals, at least those of `style`, in which two values look different: read back, they are other numbers,
/// which `9` and `9.000` aren't. `style` where they are the same.
pub fn telling(a: &Value, b: &Value, style: Style) -> Style {
    // Of mantissas 17 decimals tell all; what has no power of ten even with 17 decimals is at least 10⁻¹⁷, and has 17 digits by the 34th.
    const MOST: u32 = 34;
    let styles = (style.digits..=MOST).map(|digits| style.with(digits));
    let mut telling = styles.into_iter().filter(|style| {
        let pairs = a.components().iter().zip(b.components());
        pairs.into_iter().any(|(a, b)| read_back(*a, *style) != read_back(*b, *style))
    });
    telling.next().unwrap_or(style)
}

/// The number that is shown of a number.
pub(super) fn read_back(x: f64, style: Style) -> f64 {
    let text = number(x, style);
    let (mantissa, exponent) = text.split_once("·10").unwrap_or((&text, ""));
    format!("{mantissa}e{}", if exponent.is_empty() { "0".to_owned() } else { lowered(exponent) }).parse().unwrap_or(x)
}

fn fixed(x: f64, digits: u32) -> String {
    format!("{:.*}", digits as usize, round_half_away(x, digits))
}

/// Such as `2.147·10⁻¹²`.
fn scientific(x: f64, style: Style) -> String {
    // The shortest decimal digits of the value, exactly: no power is computed.
    let text = format!("{x:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let decimals = mantissa.split_once('.').map_or("", |(_, decimals)| decimals);
    let missing = (style.digits as usize).checked_sub(decimals.len());
    if let (Some(missing), Ok(exponent)) = (missing, exponent.parse()) {
        // As it is: read as a number, a mantissa of 17 digits may become its neighbour.
        let point = if decimals.is_empty() && missing > 0 { "." } else { "" };
        return format!("{mantissa}{point}{}·10{}", "0".repeat(missing), superscript(exponent));
    }
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
        _ => scientific(x, Style { digits: 2, keeps_small: true }),
    }
}

/// The raised digits and the raised minus.
pub const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

/// What they stand for, in the same order.
const LOWERED: &str = "0123456789-";

pub(super) fn superscript(exponent: i32) -> String {
    let raised = |c: char| RAISED.chars().zip(LOWERED.chars()).find(|(_, lowered)| *lowered == c);
    exponent.to_string().chars().filter_map(raised).map(|(raised, _)| raised).collect()
}

/// The ordinary sign of a raised digit or minus.
pub fn unraised(c: char) -> Option<char> {
    RAISED.chars().zip(LOWERED.chars()).find(|(raised, _)| *raised == c).map(|(_, lowered)| lowered)
}

/// The ordinary digits of a raised number: `-12` of `⁻¹²`.
pub(super) fn lowered(raised: &str) -> String {
    raised.chars().filter_map(unraised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::language::Language;

    #[track_caller]
    fn shows(x: f64, expected: &str) {
        assert_eq!(number(x, Style::default()), expected);
    }

    #[test]
    fn numbers_without_end() {
        shows(f64::INFINITY, "inf");
        shows(f64::NEG_INFINITY, "-inf");
        shows(f64::NAN, "NaN");
    }

    #[test]
    fn three_decimals() {
        shows(6.38, "6.380");
        shows(-0.9457, "-0.946");
        shows(1.0005, "1.001");
    }

    #[test]
    fn small_ones_keep_three_significant_digits() {
        let keeping = Style { keeps_small: true, ..Style::default() };
        for (x, expected) in [
            (1.0 / 480.0, "0.00208"),
            (-0.012_345, "-0.0123"),
            (0.099_96, "0.100"),
            (0.999_96, "1.000"),
            (0.000_512_3, "0.000512"),
            (0.05, "0.0500"),
            (0.5, "0.500"),
        ] {
            assert_eq!(number(x, keeping), expected);
        }
        for (digits, expected) in [(1, "2.1·10⁻³"), (3, "0.00208"), (4, "0.00208"), (6, "0.002083")] {
            assert_eq!(number(1.0 / 480.0, keeping.with(digits)), expected);
        }
        shows(1.0 / 480.0, "0.002");
    }

    #[test]
    fn whole_numbers_are_bare() {
        shows(-12.0, "-12");
        shows(0.0, "0");
        shows(-0.0, "0");
        shows(4.000_000_000_000_001, "4.000");
    }

    proptest::proptest! {
        /// Neighbours among all numbers look different where they are to be distinguished.
        #[test]
        fn neighbours_are_distinguished(bits in 0_u64..0x7fef_ffff_ffff_ffff, digits in 0_u32..6, keeps_small: bool, is_negative: bool) {
            let sign = if is_negative { -1.0 } else { 1.0 };
            let [a, b] = [bits, bits + 1].map(|bits| Value::Number(sign * f64::from_bits(bits)));
            let style = telling(&a, &b, Style { digits, keeps_small });
            proptest::prop_assert_ne!(Language::English.value(&a, style), Language::English.value(&b, style));
            let [a, b] = [a, b].map(|x| read_back(x.components()[0], style));
            proptest::prop_assert_ne!(a, b);
        }

        /// A whole number and what is near it, too.
        #[test]
        fn whole_numbers_are_distinguished_from_their_neighbours(whole in 1_u32..1_000_000, ulps in 1_u64..1_000_000_000) {
            let whole = f64::from(whole);
            let near = f64::from_bits(whole.to_bits() + ulps);
            let style = telling(&Value::Number(whole), &Value::Number(near), Style::default());
            let [shown, near] = [whole, near].map(|x| number(x, style).parse::<f64>().expect("no power of ten"));
            proptest::prop_assert!(near > shown, "{} {}", near, shown);
        }

        #[test]
        fn neighbours_of_a_usual_size_are_distinguished(x in 1e-30_f64..1e12, power in -30_i32..1) {
            let x = x * libm::exp10(f64::from(power));
            let [a, b] = [x, f64::from_bits(x.to_bits() + 1)].map(Value::Number);
            let style = telling(&a, &b, Style::default());
            proptest::prop_assert_ne!(Language::English.value(&a, style), Language::English.value(&b, style));
        }
    }

    #[test]
    fn no_more_digits_than_tell_two_values_apart() {
        let telling = |a, b| telling(&Value::Number(a), &Value::Number(b), Style::default()).digits;
        assert_eq!(telling(1.0, 2.0), 3);
        assert_eq!(telling(0.12345, 0.12344), 4);
        assert_eq!(telling(0.3, 0.3), 3);
        assert_eq!(telling(0.1 + 0.2, 0.3), 16);
        // `3 against 3.000` and `9.000 > 9` tell nothing; a ulp of 9 is 2⁻⁴⁹ ≈ 1.8·10⁻¹⁵.
        assert_eq!(telling(3.0, 3.000_000_1), 7);
        assert_eq!(telling(9.0, 9.000_000_000_000_002), 15);
        // 2³³ less a bit has a mantissa of 17 digits.
        assert_eq!(number(8_589_934_591.999_998, Style::default().with(15)), "8.589934591999998·10⁹");
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
