//! Numbers of twice the digits with a bound of their error, for formulas whose operands the tracer took so, too.
//!
//! Sums are Knuth's, products are split as Dekker and Veltkamp do it. The bound adds 2⁻¹⁰⁰ of each result to what the operands'
//! errors make of it.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with about 32 decimal digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wide {
    head: f64,
    tail: f64,
    /// A bound of the error.
    pub error: f64,
}

/// What one operation may add to the error, as a part of its result: 2⁻¹⁰⁰.
const STEP: f64 = f64::EPSILON * f64::EPSILON * 16.0;

impl Wide {
    pub const ZERO: Wide = Wide::exact(0.0);

    /// A number as it is.
    pub const fn exact(x: f64) -> Wide {
        Wide { head: x, tail: 0.0, error: 0.0 }
    }

    /// A number that may be off by so much.
    pub fn off(x: f64, error: f64) -> Wide {
        Wide { error, ..Wide::exact(x) }
    }

    /// The f64 nearest to it.
    pub fn value(self) -> f64 {
        self.head + self.tail
    }

    pub fn sqrt(self) -> Wide {
        if self.head <= 0.0 {
            // No more than its error can be there.
            return Wide { error: self.error.max(0.0).sqrt(), ..Wide::ZERO };
        }
        let root = self.head.sqrt();
        let rest = self - product(root, root);
        let (head, tail) = quick_sum(root, rest.head / (2.0 * root));
        let error = (self.error / root).min(self.error.sqrt()) + head * STEP;
        Wide { head, tail, error }
    }
}

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let head = a + b;
    let b_in_head = head - a;
    (head, (a - (head - b_in_head)) + (b - b_in_head))
}

fn quick_sum(a: f64, b: f64) -> (f64, f64) {
    let head = a + b;
    (head, b - (head - a))
}

fn product(a: f64, b: f64) -> Wide {
    /// 2²⁷ + 1
    const SPLITTER: f64 = 134_217_729.0;
    let split = |x: f64| {
        let wide = SPLITTER * x;
        let high = wide - (wide - x);
        (high, x - high)
    };
    let head = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let tail = a_low * b_low - (((head - a_high * b_high) - a_low * b_high) - a_high * b_low);
    Wide { head, tail, error: 0.0 }
}

impl Neg for Wide {
    type Output = Wide;

    fn neg(self) -> Wide {
        Wide { head: -self.head, tail: -self.tail, ..self }
    }
}

impl Add for Wide {
    type Output = Wide;

    fn add(self, other: Wide) -> Wide {
        let (head, low) = two_sum(self.head, other.head);
        let (tail_head, tail_low) = two_sum(self.tail, other.tail);
        let (head, low) = quick_sum(head, low + tail_head);
        let (head, tail) = quick_sum(head, low + tail_low);
        Wide { head, tail, error: self.error + other.error + head.abs() * STEP }
    }
}

impl Sub for Wide {
    type Output = Wide;

    fn sub(self, other: Wide) -> Wide {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Wide;

    fn mul(self, other: Wide) -> Wide {
        let whole = product(self.head, other.head);
        let (head, tail) = quick_sum(whole.head, whole.tail + (self.head * other.tail + self.tail * other.head));
        let of_operands = self.head.abs() * other.error + other.head.abs() * self.error + self.error * other.error;
        Wide { head, tail, error: of_operands + head.abs() * STEP }
    }
}

impl Div for Wide {
    type Output = Wide;

    fn div(self, other: Wide) -> Wide {
        let first = self.head / other.head;
        let rest = self - Wide::exact(first) * Wide { error: 0.0, ..other };
        let second = rest.head / other.head;
        let rest = rest - Wide::exact(second) * Wide { error: 0.0, ..other };
        let (head, tail) = quick_sum(first, second);
        let (head, low) = quick_sum(head, tail + rest.head / other.head);
        let divisor = other.head.abs() - other.error;
        // A divisor that may be 0 leaves nothing.
        let of_operands = if divisor > 0.0 { (self.error + head.abs() * other.error) / divisor } else { f64::INFINITY };
        Wide { head, tail: low, error: of_operands + head.abs() * STEP }
    }
}
