//! Statistics of the samples of a pixel, and Student's quantiles, as the text of [`formula`](crate::log::formula) says what they are.

use super::wide::Wide;
use crate::log::formula::Several;
use crate::log::scope::{self, Element};
use crate::log::{Events, Name, Tree, Value};

/// How far the mean of the samples may be from the pixel's value.
struct Spread {
    error: f64,
    freedom: f64,
}

/// The standard error of the mean of the samples before an event, or its degrees of freedom.
///
/// # Errors
/// Which value of which sample the log doesn't hold.
pub(super) fn of_samples(statistic: Several, events: &Events, tree: &Tree, event: usize) -> Result<Value, String> {
    let elements = scope::elements(events, tree, event, statistic);
    let colors: Vec<[f64; 3]> = elements
        .iter()
        .map(|element| match scope::operand_of_element(events, tree, *element, Name::CombineColor.symbol()) {
            Some(Value::Triple(color)) => Ok(color),
            _ => Err("the log holds no colour of a sample".to_owned()),
        })
        .collect::<Result<_, _>>()?;
    let n = colors.len();
    let places: Vec<[f64; 2]> = if n.is_power_of_two() && n > 1 {
        elements.iter().map(|element| place(events, tree, *element)).collect::<Result<_, _>>()?
    } else {
        Vec::new()
    };
    let channel = |k: usize| {
        let colors: Vec<f64> = colors.iter().map(|color| color[k]).collect();
        let spread = spread(&places, &colors);
        if statistic == Several::Freedom { spread.freedom } else { spread.error }
    };
    Ok(Value::Triple([0, 1, 2].map(channel)))
}

/// Where in its pixel a sample lies: what a logged place was made of tells it before any rounding.
fn place(events: &Events, tree: &Tree, sample: Element) -> Result<[f64; 2], String> {
    let Element::Sample(sample) = sample else { return Err("cells have no place".to_owned()) };
    let given = |name: Name| {
        let mut inputs = tree.own_events(sample).flat_map(|at| events.given(&events[at]));
        inputs.find(|(given, _)| *given == name).and_then(|(_, value)| value.components().first().copied())
    };
    let in_its_part = || {
        let across = given(Name::SampleAcross)?;
        let x = (given(Name::SampleColumn)? + given(Name::SampleJitterX)?) / across;
        Some([x, (given(Name::SampleAbove)? + given(Name::SampleJitterY)? * across) / given(Name::SampleCount)?])
    };
    let place = in_its_part().or_else(|| Some([given(Name::SampleX)?, given(Name::SampleY)?]));
    // Rounding may reach 1, which is outside.
    let place = place.map(|place| place.map(|x| x.min(1.0 - f64::EPSILON / 2.0)));
    place.ok_or_else(|| "the log holds no place of a sample".to_owned())
}

/// The spread of one channel; `places` are empty where there are no pairs.
fn spread(places: &[[f64; 2]], colors: &[f64]) -> Spread {
    if places.is_empty() {
        return of_all(colors);
    }
    let halvings = (colors.len() / 2).trailing_zeros();
    let (more, fewer) = (1_u32 << halvings.div_ceil(2), 1_u32 << (halvings / 2));
    let [lying, standing] = [[fewer, more], [more, fewer]].map(|parts| of_pairs(places, colors, parts));
    let greater = if standing.error > lying.error { standing } else { lying };
    if greater.error == 0.0 { of_all(colors) } else { greater }
}

/// From the differences of the two samples in each of this many parts across and down.
fn of_pairs(places: &[[f64; 2]], colors: &[f64], [across, down]: [u32; 2]) -> Spread {
    let mut first = vec![None; colors.len() / 2];
    let mut differences = Vec::with_capacity(colors.len() / 2);
    for ([x, y], color) in places.iter().zip(colors) {
        let part = (y * f64::from(down)) as u32 * across + (x * f64::from(across)) as u32;
        match first.get_mut(part as usize).map(Option::take) {
            Some(Some(other)) => differences.push(color - other),
            Some(None) => first[part as usize] = Some(*color),
            None => {}
        }
    }
    let unit = unit_of(&differences);
    let (mut squares, mut fourths) = (0.0, 0.0);
    for relative in differences.iter().map(|difference| difference / unit) {
        squares += relative * relative;
        fourths += relative * relative * relative * relative;
    }
    Spread {
        error: (unit * f64::sqrt(squares) / colors.len() as f64).min(f64::MAX),
        freedom: if squares == 0.0 { differences.len() as f64 } else { (squares * squares / fourths).max(1.0) },
    }
}

/// All samples as one part.
fn of_all(colors: &[f64]) -> Spread {
    let n = colors.len() as f64;
    let sum = colors.iter().fold(Wide::ZERO, |sum, color| sum + Wide::exact(*color));
    let mean = (sum / Wide::exact(n)).value();
    let off: Vec<f64> = colors.iter().map(|color| color - mean).collect();
    let unit = unit_of(&off);
    let squares: f64 = off.iter().map(|off| off / unit).map(|off| off * off).sum();
    Spread { error: (unit * (squares / (n - 1.0) / n).sqrt()).min(f64::MAX), freedom: n - 1.0 }
}

/// The greatest magnitude, in units of which no square over- or underflows; 1 where all are zero.
fn unit_of(numbers: &[f64]) -> f64 {
    let greatest = numbers.iter().fold(0.0, |greatest: f64, number| greatest.max(number.abs()));
    if greatest > 0.0 { greatest } else { 1.0 }
}

/// The t for which a variable of Student's distribution lies between −t and t with this probability, above 0 and below 1; `None`
/// outside of that, and of no degrees of freedom.
///
/// The logarithm of the probability outside is nearly straight over that of t, so Newton's method takes a few steps.
pub(super) fn quantile(probability: f64, freedom: f64) -> Option<f64> {
    if !(0.0 < probability && probability < 1.0 && freedom > 0.0) {
        return None;
    }
    let whole = beyond(0.0, freedom);
    let wanted = libm::log1p(-probability);
    let mut bracket = [-40.0, 800.0];
    let mut log_t = 0.5;
    for _ in 0..100 {
        let t = libm::exp(log_t);
        let outside = beyond(t, freedom);
        let above = libm::log(outside / whole) - wanted;
        bracket[usize::from(above <= 0.0)] = log_t;
        let newton = log_t + above * outside / (t * density(t, freedom));
        let next = if bracket[0] < newton && newton < bracket[1] { newton } else { (bracket[0] + bracket[1]) / 2.0 };
        if (next - log_t).abs() < 1e-13 * log_t.abs().max(1.0) {
            break;
        }
        log_t = next;
    }
    Some(libm::exp(log_t))
}

/// By how much the tracer's quantile may differ from this one, as a part of it. Of a small probability the digits of the rest are lost.
pub(super) fn error_of_quantile(probability: f64) -> f64 {
    2e-9 + 1e-12 / probability
}

/// (1 + t²/ν)^(−(ν + 1)/2)
fn density(t: f64, freedom: f64) -> f64 {
    let ratio = t / freedom.sqrt();
    // Where the square overflows, 1 is nothing beside it.
    let log = if ratio > 1e150 { 2.0 * libm::log(ratio) } else { libm::log1p(ratio * ratio) };
    libm::exp(-(freedom + 1.0) / 2.0 * log)
}

/// The integral of [`density`] from t to infinity, by the double exponential rule of Takahasi and Mori ("Double exponential formulas
/// for numerical integration", 1974): u = t + s·exp(π/2·sinh(x)) in equal steps of x.
fn beyond(t: f64, freedom: f64) -> f64 {
    const STEP: f64 = 1.0 / 32.0;
    const REACH: i32 = 200;
    // The length over which the density falls by about e: 1 near the middle, further out the reciprocal of its logarithm's slope.
    let off = freedom.sqrt() / t;
    let size = if t <= 1.0 { 1.0 } else { t * ((1.0 + off * off) / (freedom + 1.0)) };
    let terms = (-REACH..=REACH).map(|k| {
        let x = f64::from(k) * STEP;
        let distance = size * libm::exp(std::f64::consts::FRAC_PI_2 * libm::sinh(x));
        let term = density(t + distance, freedom) * distance * libm::cosh(x);
        if term.is_finite() { term } else { 0.0 }
    });
    terms.sum::<f64>() * STEP * std::f64::consts::FRAC_PI_2
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// At one degree of freedom t = tan(πp/2), at two p·√(2/(1 − p²)).
    #[test]
    fn quantiles_of_few_degrees_of_freedom_have_closed_forms() {
        for probability in [1e-3, 0.1, 0.5, 0.9, 0.95, 0.999, 1.0 - 1e-9] {
            let one = 1.0 / libm::tan(std::f64::consts::FRAC_PI_2 * (1.0 - probability));
            let two = probability * (2.0 / ((1.0 - probability) * (1.0 + probability))).sqrt();
            for (freedom, expected) in [(1.0, one), (2.0, two)] {
                let found = quantile(probability, freedom).unwrap();
                let error = (found / expected - 1.0).abs();
                assert!(error < error_of_quantile(probability) / 2.0, "{probability}, {freedom}: {found}, {expected}");
            }
        }
    }

    /// Of printed tables.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (probability, freedom, expected) in
            [(0.95, 5.0, 2.571), (0.95, 30.0, 2.042), (0.99, 10.0, 3.169), (0.999, 3.0, 12.924), (0.95, 1e6, 1.960)]
        {
            let found = quantile(probability, freedom).unwrap();
            assert!((found - expected).abs() < 6e-4, "{probability}, {freedom}: {found}");
        }
    }

    #[test]
    fn what_is_no_probability_has_no_quantile() {
        for (probability, freedom) in [(0.0, 3.0), (1.0, 3.0), (f64::NAN, 3.0), (0.5, 0.0)] {
            assert_eq!(quantile(probability, freedom), None);
        }
    }
}
