//! The user's answers: read from a line, and judged as exactly as values are shown.

use super::{Style, evaluate, number};
use crate::log::{Log, Tree, Value, What, formula};

/// How an answer compares with the value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// It is the value, to half a unit of the last decimal shown.
    Right,
    /// It is off; by so much in the worst component.
    Off(f64),
}

/// Why a line is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// It isn't a number.
    NoNumber,
    /// It isn't three numbers.
    NoTriple,
}

/// The number or triple in a line: `-0.946`, `−0,946`, `(1, 2, 3)`, `1 2 3`, `0,9 0,143 0,412`, `2.147·10⁻¹²`.
///
/// # Errors
/// [`Unreadable`].
pub fn parse(line: &str, is_triple: bool) -> Result<Value, Unreadable> {
    let line = line.trim().trim_start_matches(['(', '[']).trim_end_matches([')', ']']);
    let words: Vec<&str> =
        line.split([' ', ';', '\t']).map(|word| word.trim_matches(',')).filter(|word| !word.is_empty()).collect();
    if !is_triple {
        let [word] = words[..] else { return Err(Unreadable::NoNumber) };
        return number_of(word).map(Value::Number).ok_or(Unreadable::NoNumber);
    }
    let words = match words[..] {
        // Commas without spaces can only part the three.
        [alone] => alone.split(',').collect(),
        _ => words,
    };
    let numbers: Option<Vec<f64>> = words.iter().map(|word| number_of(word)).collect();
    match numbers.as_deref() {
        Some([x, y, z]) => Ok(Value::Triple([*x, *y, *z])),
        _ => Err(Unreadable::NoTriple),
    }
}

fn number_of(word: &str) -> Option<f64> {
    let mut text = String::new();
    let mut is_in_power = false;
    for c in word.replace("·10", "e").replace("*10", "e").replace(',', ".").chars() {
        match c {
            '−' => text.push('-'),
            '^' => is_in_power = true,
            _ => text.push(number::unraised(c).unwrap_or(c)),
        }
    }
    let is_written_out = text.chars().all(|c| c.is_ascii_digit() || "+-.eE".contains(c));
    text.parse().ok().filter(|x: &f64| x.is_finite() && is_written_out && (!is_in_power || text.contains('e')))
}

/// The value of the formula of the quantity that `event` notes, computed from the operands as they are shown: what somebody gets who computes it
/// from the screen. `None` without a formula, and where not all operands are shown, as those of statistics.
pub fn from_shown(log: &Log, tree: &Tree, event: usize, style: Style) -> Option<Value> {
    let What::Note { name, .. } = log.events[event].what else { return None };
    let shown = |symbol, light| {
        let value = match light {
            None if name.is_doubled() => evaluate::doubled_operand(&log.events, tree, event, symbol).ok()?,
            _ => evaluate::operand(&log.events, tree, event, symbol, light)?.value,
        };
        Some(value.map(|x| number::read_back(x, style)))
    };
    evaluate::evaluate_with(log, tree, event, formula::of(name)?, &shown).ok()
}

/// Judges an answer: each component may be off by half a unit of the last decimal that is shown of the true one.
pub fn judge(answer: &Value, truth: &Value, style: Style) -> Verdict {
    let pairs = answer.components().iter().zip(truth.components());
    let off = |(answer, truth): (&f64, &f64)| (answer - truth).abs();
    let is_right = |(answer, truth): (&f64, &f64)| {
        // What is typed as it is shown is right, however its last bits fall.
        off((answer, truth)) <= tolerance(*truth, style) * (1.0 + 1e-9) + truth.abs() * 1e-15
    };
    if answer.components().len() == truth.components().len() && pairs.clone().all(is_right) {
        return Verdict::Right;
    }
    Verdict::Off(pairs.map(off).fold(0.0, f64::max))
}

/// Half a unit of the last decimal that is shown of a number.
fn tolerance(x: f64, style: Style) -> f64 {
    let shown = number::number(x, style);
    let mantissa = shown.split('·').next().unwrap_or_default();
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    // A whole number is exact, and has none.
    let unit = (0..decimals.max(style.digits as usize)).fold(0.5, |unit, _| unit / 10.0);
    // Very small and large numbers have their decimals before a power of ten.
    match shown.split_once("·10") {
        Some((_, power)) => number_of(&format!("1·10{power}")).map_or(unit, |power| unit * power),
        None => unit,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn reads(line: &str, expected: Value) {
        let is_triple = matches!(expected, Value::Triple(_));
        assert_eq!(parse(line, is_triple), Ok(expected), "{line}");
    }

    #[test]
    fn numbers_and_triples_as_people_write_them() {
        for line in ["-0.946", " −0,946 ", "-.946", "(-0.946)", "-9.46e-1", "−9,46·10⁻¹", "-9.46*10^-1"] {
            reads(line, Value::Number(-0.946));
        }
        for line in
            ["(0.9, 0.143, 0.412)", "0.9 0.143 0.412", "0,9 0,143 0,412", "(0,9, 0,143, 0,412)", "0.9,0.143,0.412"]
        {
            reads(line, Value::Triple([0.9, 0.143, 0.412]));
        }
        reads("1;2;3", Value::Triple([1.0, 2.0, 3.0]));
    }

    #[test]
    fn what_is_no_answer() {
        for line in ["", "x", "1 2", "nan", "inf", "1e999", "--1"] {
            assert!(parse(line, false).is_err(), "{line}");
        }
        for line in ["", "1", "1 2", "1 2 3 4", "1,2", "a b c"] {
            assert!(parse(line, true).is_err(), "{line}");
        }
    }

    #[track_caller]
    fn is_right(answer: f64, truth: f64, expected: bool) {
        let verdict = judge(&Value::Number(answer), &Value::Number(truth), Style::default());
        assert_eq!(verdict == Verdict::Right, expected, "{answer} for {truth}: {verdict:?}");
    }

    #[test]
    fn half_a_unit_of_the_last_decimal_shown() {
        is_right(6.380, 6.3795, true);
        is_right(6.379, 6.3795, true);
        is_right(6.381, 6.3795, false);
        is_right(-12.0, -12.0, true);
        is_right(-12.001, -12.0, false);
        is_right(2.147e-12, 2.147_038_870_254_324e-12, true);
        is_right(2.149e-12, 2.147_038_870_254_324e-12, false);
        is_right(0.0, 2.147_038_870_254_324e-12, false);
        is_right(1.5001e30, 1.5e30, true);
    }

    #[test]
    fn a_small_number_counts_as_it_is_shown() {
        let style = Style { keeps_small: true, ..Style::default() };
        for (answer, expected) in [(0.002_08, true), (0.002_085, true), (0.002, false)] {
            let verdict = judge(&Value::Number(answer), &Value::Number(1.0 / 480.0), style);
            assert_eq!(verdict == Verdict::Right, expected, "{answer}: {verdict:?}");
        }
    }

    #[test]
    fn a_value_follows_from_the_numbers_as_they_are_shown() {
        use crate::record::{self, Arithmetic};
        use crate::scene::{build, builtin, file};
        let text = builtin::text("textbook").expect("the numeric example is built in");
        let read = file::check(text.as_bytes(), "textbook").unwrap_or_else(|error| panic!("{}", error.report(false)));
        let scene = build(&read.scene, &Default::default()).unwrap_or_else(|why| panic!("{why}"));
        // `P = O + d·t` of the camera ray, of which the book prints (4, 6, 8); `T2_A = 9 − 178 + 13.240²` in f64.
        let point = [16.0 - 0.946 * 12.685, 2.0 + 0.315 * 12.685, 7.0 + 0.079 * 12.685];
        for (arithmetic, key, expected) in [
            (Arithmetic::Printed, "hit.point", Value::Triple(point)),
            (Arithmetic::F64, "sphere.t2_a", Value::Number(9.0 - 178.0 + 13.24 * 13.24)),
        ] {
            let log = record::pixel(&scene, [160, 120], arithmetic);
            let tree = Tree::of(&log.events);
            let mut noted = (0..log.events.len())
                .filter(|event| log.events[*event].noted().is_some_and(|(name, _)| name.key() == key));
            let event = if key == "hit.point" { noted.next() } else { noted.next_back() };
            let event = event.expect("the example has both");
            let shown = from_shown(&log, &tree, event, Style::of(&log.header, 3)).expect("it has a formula");
            let is_close = shown.components().iter().zip(expected.components()).all(|(a, b)| (a - b).abs() < 1e-12);
            assert!(is_close, "{shown:?} for {expected:?} in {arithmetic}");
        }
    }

    #[test]
    fn the_worst_component_counts() {
        let truth = Value::Triple([1.0, 2.0, 3.0]);
        let verdict = judge(&Value::Triple([1.0, 2.25, 3.125]), &truth, Style::default());
        assert_eq!(verdict, Verdict::Off(0.25));
    }
}
