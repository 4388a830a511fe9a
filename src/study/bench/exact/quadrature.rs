//! Integrals over an interval, with an estimate of their error, and the zeros of polynomials at which integrands have kinks.

use std::ops::{Add, Mul, Sub};

/// An integral, and an estimate of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate<T> {
    /// The integral.
    pub value: T,
    /// The estimate of its error, in the same unit.
    pub error: f64,
}

/// What can be integrated: numbers and colours.
pub trait Value: Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self> {
    /// Its largest component's magnitude.
    fn size(self) -> f64;
}

impl Value for f64 {
    fn size(self) -> f64 {
        self.abs()
    }
}

impl Value for crate::scene::Color {
    fn size(self) -> f64 {
        self.abs().max_element()
    }
}

/// The nodes of Gauss and Kronrod with 15 points, from the end to the middle; those with odd numbers are Gauss's 7 (Piessens and others,
/// "QUADPACK", 1983).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];

const WEIGHTS: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_83,
];

const GAUSS_WEIGHTS: [f64; 4] =
    [0.129_484_966_168_869_7, 0.279_705_391_489_276_64, 0.381_830_050_505_118_9, 0.417_959_183_673_469_4];

/// How an integral is refined.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// Parts whose error is no larger aren't halved.
    pub tolerance: f64,
    /// How often the interval is halved at most.
    pub halvings: u32,
}

/// The integral from `from` to `to` by parts that are halved until the rules of 7 and of 15 points agree on each. The error is the sum of what they
/// differ by, which the better of the two doesn't reach where the integrand is smooth or has kinks, and of the errors of the integrand itself.
/// It is an estimate, no bound: a jump or a kink nearer to the end of a part than its first node, 0.4 % of it, isn't seen, so callers split there.
pub fn integral<T: Value>(f: &mut impl FnMut(f64) -> Estimate<T>, [from, to]: [f64; 2], rule: Rule) -> Estimate<T> {
    let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
    let (mut kronrod, mut gauss, mut own) = (T::default(), T::default(), 0.0);
    for (k, node) in NODES.into_iter().enumerate() {
        let both = if node == 0.0 { &[0.0][..] } else { &[-1.0, 1.0] };
        for sign in both {
            let Estimate { value, error } = f(middle + sign * half * node);
            kronrod = kronrod + value * WEIGHTS[k];
            own += error * WEIGHTS[k];
            if k % 2 == 1 {
                gauss = gauss + value * GAUSS_WEIGHTS[k / 2];
            }
        }
    }
    let width = half.abs();
    let difference = (kronrod - gauss).size() * width;
    if difference <= rule.tolerance || rule.halvings == 0 || !difference.is_finite() {
        return Estimate { value: kronrod * half, error: difference + own * width };
    }
    let rule = Rule { halvings: rule.halvings - 1, ..rule };
    let (low, high) = (integral(f, [from, middle], rule), integral(f, [middle, to], rule));
    Estimate { value: low.value + high.value, error: low.error + high.error }
}

/// The same in pieces between `from`, the places of `splits` within, and `to`.
pub fn in_pieces<T: Value>(
    f: &mut impl FnMut(f64) -> Estimate<T>,
    [from, to]: [f64; 2],
    mut splits: Vec<f64>,
    rule: Rule,
) -> Estimate<T> {
    let mut sum = Estimate { value: T::default(), error: 0.0 };
    for piece in pieces([from, to], &mut splits) {
        let part = integral(f, piece, rule);
        sum = Estimate { value: sum.value + part.value, error: sum.error + part.error };
    }
    sum
}

/// The pieces into which places divide an interval; none is shorter than roundings.
pub fn pieces([from, to]: [f64; 2], splits: &mut Vec<f64>) -> Vec<[f64; 2]> {
    let least = (to - from) * 1e-13;
    splits.retain(|place| *place > from + least && *place < to - least);
    splits.sort_by(f64::total_cmp);
    splits.dedup_by(|next, kept| *next - *kept <= least);
    let starts = std::iter::once(from).chain(splits.iter().copied());
    starts.zip(splits.iter().copied().chain([to])).map(|(from, to)| [from, to]).collect()
}

/// The zeros between −1 and 1 of a polynomial with these coefficients, the constant first: between those of its derivative there is
/// at most one each, which halving finds.
pub fn zeros(coefficients: &[f64]) -> Vec<f64> {
    let Some((_, higher)) = coefficients.split_first().filter(|(_, higher)| !higher.is_empty()) else {
        return Vec::new();
    };
    let derivative: Vec<_> = (1..).zip(higher).map(|(power, factor)| f64::from(power) * factor).collect();
    let value = |x: f64| coefficients.iter().rev().fold(0.0, |sum, factor| sum * x + factor);
    let turns = zeros(&derivative);
    let ends = std::iter::once(-1.0).chain(turns.iter().copied());
    let mut found = Vec::new();
    for (mut low, mut high) in ends.zip(turns.iter().copied().chain([1.0])) {
        let is_below = value(low) < 0.0;
        if is_below == (value(high) < 0.0) {
            continue;
        }
        loop {
            let middle = (low + high) / 2.0;
            if middle <= low || middle >= high {
                break;
            }
            if (value(middle) < 0.0) == is_below { low = middle } else { high = middle }
        }
        found.push(low);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: Rule = Rule { tolerance: 1e-13, halvings: 48 };

    fn of(f: impl Fn(f64) -> f64, rule: Rule) -> Estimate<f64> {
        integral(&mut |x| Estimate { value: f(x), error: 0.0 }, [0.0, 1.0], rule)
    }

    /// The rule of 15 points is right for powers up to 22, that of 7 up to 13.
    #[test]
    fn powers_at_once() {
        for power in 0..=22 {
            let found = of(|x| (0..power).fold(1.0, |product, _| product * x), Rule { halvings: 0, ..RULE });
            assert!((found.value * f64::from(power + 1) - 1.0).abs() < 2e-14, "{power}: {found:?}");
            assert!((found.error < 1e-14) == (power <= 13) || power > 13, "{power}: {found:?}");
        }
    }

    #[test]
    fn errors_are_no_larger_than_told() {
        // A third of every part, so that no part has it at its very end.
        let place = 1.0 / 3.0;
        let cases: [(&dyn Fn(f64) -> f64, f64); 3] = [
            (&|x| if x < place { 1.0 } else { 0.0 }, place),
            (&|x| (x - place).abs(), (place * place + (1.0 - place) * (1.0 - place)) / 2.0),
            (&|x| x.sqrt(), 2.0 / 3.0),
        ];
        for (f, expected) in cases {
            for halvings in [0, 3, 10, 48] {
                let found = of(f, Rule { halvings, ..RULE });
                assert!((found.value - expected).abs() <= found.error + 1e-15, "{halvings}: {found:?} {expected}");
            }
            assert!(of(f, RULE).error < 1e-11);
        }
    }

    #[test]
    fn zeros_of_a_quartic() {
        let product = [0.5, -0.25, 0.75, 3.0].iter().fold(vec![1.0], |factors: Vec<f64>, zero| {
            let mut next = vec![0.0; factors.len() + 1];
            for (k, factor) in factors.iter().enumerate() {
                next[k] -= zero * factor;
                next[k + 1] += factor;
            }
            next
        });
        let found = zeros(&product);
        assert_eq!(found.len(), 3, "{found:?}");
        for (found, expected) in found.iter().zip([-0.25, 0.5, 0.75]) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
