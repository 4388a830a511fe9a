//! Numbers of twice the digits: an unevaluated sum of two f64, of which the second is at most half a unit in the last place
//! of the first.
//!
//! One operation errs by at most 2⁻¹⁰² of its result (Dekker, "A floating-point technique for extending the available
//! precision", 1971; Knuth, TAOCP 2, 4.2.2; Joldes, Muller and Popescu, 2017, for the bounds). Products are split by
//! Veltkamp's method and not by a fused operation, which not every machine has.

use glam::DVec3;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of twice the digits of an f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubled {
    /// The number, rounded.
    pub head: f64,
    /// What rounding took away.
    pub tail: f64,
}

impl Doubled {
    /// Zero.
    pub const ZERO: Doubled = Doubled { head: 0.0, tail: 0.0 };

    /// a + b without any error (Knuth).
    #[inline]
    pub fn sum(a: f64, b: f64) -> Doubled {
        let head = a + b;
        let b_in_head = head - a;
        let tail = (a - (head - b_in_head)) + (b - b_in_head);
        Doubled { head, tail }
    }

    /// a·b without any error, unless it over- or underflows (Dekker, Veltkamp): both factors are cut into halves whose
    /// products are exact.
    #[inline]
    pub fn product(a: f64, b: f64) -> Doubled {
        let head = a * b;
        let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
        let tail = a_low * b_low - (((head - a_high * b_high) - a_low * b_high) - a_high * b_low);
        Doubled { head, tail }
    }

    /// The f64 nearest to it.
    #[inline]
    pub fn value(self) -> f64 {
        self.head + self.tail
    }

    /// The square root of a number that isn't negative: one step of Newton's method from that of the head.
    #[inline]
    pub fn sqrt(self) -> Doubled {
        if self.head <= 0.0 {
            return Doubled::ZERO;
        }
        let root = self.head.sqrt();
        let rest = self - Doubled::product(root, root);
        quick_sum(root, rest.head / (2.0 * root))
    }

    /// The quotient, right to the last bit or two of an f64.
    #[inline]
    pub fn quotient(self, other: Doubled) -> f64 {
        let first = self.head / other.head;
        let product = Doubled::product(first, other.head);
        let rest = ((self.head - product.head) - product.tail) + (self.tail - first * other.tail);
        first + rest / other.head
    }

    /// The number times 2 to this power, exactly, unless it over- or underflows.
    pub fn scaled(self, exponent: i32) -> Doubled {
        Doubled { head: scaled(self.head, exponent), tail: scaled(self.tail, exponent) }
    }
}

impl From<f64> for Doubled {
    #[inline]
    fn from(x: f64) -> Doubled {
        Doubled { head: x, tail: 0.0 }
    }
}

impl Neg for Doubled {
    type Output = Doubled;

    #[inline]
    fn neg(self) -> Doubled {
        Doubled { head: -self.head, tail: -self.tail }
    }
}

impl Add for Doubled {
    type Output = Doubled;

    #[inline]
    fn add(self, other: Doubled) -> Doubled {
        let heads = Doubled::sum(self.head, other.head);
        let tails = Doubled::sum(self.tail, other.tail);
        let sum = quick_sum(heads.head, heads.tail + tails.head);
        quick_sum(sum.head, sum.tail + tails.tail)
    }
}

impl Sub for Doubled {
    type Output = Doubled;

    #[inline]
    fn sub(self, other: Doubled) -> Doubled {
        self + -other
    }
}

impl Mul for Doubled {
    type Output = Doubled;

    #[inline]
    fn mul(self, other: Doubled) -> Doubled {
        let heads = Doubled::product(self.head, other.head);
        quick_sum(heads.head, heads.tail + (self.head * other.tail + self.tail * other.head))
    }
}

impl Div for Doubled {
    type Output = Doubled;

    /// Long division by the head, three times.
    #[inline]
    fn div(self, other: Doubled) -> Doubled {
        let first = self.head / other.head;
        let rest = self - other * Doubled::from(first);
        let second = rest.head / other.head;
        let rest = rest - other * Doubled::from(second);
        quick_sum(first, second) + Doubled::from(rest.head / other.head)
    }
}

/// A vector of numbers of twice the digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Doubled3 {
    /// Along x.
    pub x: Doubled,
    /// Along y.
    pub y: Doubled,
    /// Along z.
    pub z: Doubled,
}

impl Doubled3 {
    /// a − b without any error.
    #[inline]
    pub fn difference(a: DVec3, b: DVec3) -> Doubled3 {
        Doubled3 { x: Doubled::sum(a.x, -b.x), y: Doubled::sum(a.y, -b.y), z: Doubled::sum(a.z, -b.z) }
    }

    /// The scalar product.
    #[inline]
    pub fn dot(self, other: Doubled3) -> Doubled {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The vector product.
    #[inline]
    pub fn cross(self, other: Doubled3) -> Doubled3 {
        Doubled3 {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The scalar product, of which what cancels loses digits.
    #[inline]
    pub fn quick_dot(self, other: Doubled3) -> Doubled {
        let mut sum = Doubled::ZERO;
        for (a, b) in [(self.x, other.x), (self.y, other.y), (self.z, other.z)] {
            let product = Doubled::product(a.head, b.head);
            let heads = Doubled::sum(sum.head, product.head);
            let tails = product.tail + (a.head * b.tail + a.tail * b.head);
            sum = Doubled { head: heads.head, tail: sum.tail + (heads.tail + tails) };
        }
        quick_sum(sum.head, sum.tail)
    }

    /// The vector product of two plain vectors: differences of products without error.
    #[inline]
    pub fn across(a: DVec3, b: DVec3) -> Doubled3 {
        let difference = |a: f64, b: f64, c: f64, d: f64| {
            let (first, second) = (Doubled::product(a, b), Doubled::product(c, d));
            let heads = Doubled::sum(first.head, -second.head);
            quick_sum(heads.head, heads.tail + (first.tail - second.tail))
        };
        Doubled3 {
            x: difference(a.y, b.z, a.z, b.y),
            y: difference(a.z, b.x, a.x, b.z),
            z: difference(a.x, b.y, a.y, b.x),
        }
    }

    /// The square of its length: a sum of squares, of which nothing cancels.
    #[inline]
    pub fn squared(self) -> Doubled {
        let [x, y, z] = [self.x, self.y, self.z].map(|part| Doubled::product(part.head, part.head));
        let doubled_products = self.x.head * self.x.tail + self.y.head * self.y.tail + self.z.head * self.z.tail;
        let first = Doubled::sum(x.head, y.head);
        let all = Doubled::sum(first.head, z.head);
        quick_sum(all.head, first.tail + all.tail + (x.tail + y.tail + z.tail) + 2.0 * doubled_products)
    }

    /// The vector times a number.
    #[inline]
    pub fn times(self, factor: Doubled) -> Doubled3 {
        Doubled3 { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }

    /// Rounded to f64.
    #[inline]
    pub fn value(self) -> DVec3 {
        DVec3::new(self.x.value(), self.y.value(), self.z.value())
    }

    /// The vector times 2 to this power.
    pub fn scaled(self, exponent: i32) -> Doubled3 {
        Doubled3 { x: self.x.scaled(exponent), y: self.y.scaled(exponent), z: self.z.scaled(exponent) }
    }

    /// The greatest magnitude of a component.
    pub fn size(self) -> f64 {
        self.x.head.abs().max(self.y.head.abs()).max(self.z.head.abs())
    }
}

impl Sub for Doubled3 {
    type Output = Doubled3;

    #[inline]
    fn sub(self, other: Doubled3) -> Doubled3 {
        Doubled3 { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl From<DVec3> for Doubled3 {
    #[inline]
    fn from(v: DVec3) -> Doubled3 {
        Doubled3 { x: v.x.into(), y: v.y.into(), z: v.z.into() }
    }
}

/// The length of a vector.
#[inline]
pub(crate) fn length(vector: DVec3) -> Doubled {
    let squared = Doubled3::from(vector).squared();
    let length = squared.head.sqrt();
    let square = Doubled::product(length, length);
    let rest = (squared.head - square.head) + (squared.tail - square.tail);
    Doubled { head: length, tail: if length > 0.0 { rest / (2.0 * length) } else { 0.0 } }
}

/// The power of two of a number's size, for [`scaled`]; 0 for what has none.
#[inline]
pub(crate) fn exponent(x: f64) -> i32 {
    match (x.to_bits() >> DIGITS) & INFINITE {
        0 if x != 0.0 => libm::ilogb(x),
        0 | INFINITE => 0,
        biased => biased as i32 - BIAS,
    }
}

/// The number times 2 to this power.
#[inline]
pub(crate) fn scaled(x: f64, exponent: i32) -> f64 {
    if (1..2 * BIAS + 1).contains(&(exponent + BIAS)) {
        x * f64::from_bits(((exponent + BIAS) as u64) << DIGITS)
    } else {
        libm::scalbn(x, exponent)
    }
}

/// The stored digits of an f64.
const DIGITS: u32 = 52;

/// What is added to the exponent of an f64.
const BIAS: i32 = 1023;

/// The stored exponent of what isn't finite.
const INFINITE: u64 = 0x7ff;

/// a + b without any error where |a| ≥ |b| (Dekker).
#[inline]
fn quick_sum(a: f64, b: f64) -> Doubled {
    let head = a + b;
    Doubled { head, tail: b - (head - a) }
}

/// A number as a sum of two of at most 26 digits each.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    /// 2²⁷ + 1
    const SPLITTER: f64 = 134_217_729.0;
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_keep_what_rounding_takes() {
        let third = 1.0 / 3.0;
        let square = Doubled::product(third, third);
        assert_eq!((square.head, square.tail != 0.0), (third * third, true));
        let sum = Doubled::sum(1.0, 1e-30);
        assert_eq!((sum.head, sum.tail), (1.0, 1e-30));
        assert_eq!((sum - Doubled::from(1.0)).value(), 1e-30);
    }

    #[test]
    fn quotients_and_roots_undo_products() {
        let seven = Doubled::from(7.0);
        let third = Doubled::from(1.0) / Doubled::from(3.0);
        let back = third * Doubled::from(3.0) - Doubled::from(1.0);
        assert!(back.value().abs() < 1e-31, "{back:?}");
        let root = seven.sqrt();
        assert!((root * root - seven).value().abs() < 1e-30);
        assert_eq!(Doubled::from(-1.0).sqrt(), Doubled::ZERO);
    }

    #[test]
    fn vectors_keep_their_digits() {
        let (a, b) = (DVec3::new(1e9, 0.1, -3.0), DVec3::new(0.7, 1e-9, 2.0));
        let difference = Doubled3::difference(a, b);
        assert_eq!(difference.x.head + difference.x.tail, 1e9 - 0.7);
        let across = difference.cross(difference.scaled(3));
        assert!(across.size() <= 1e-13, "{across:?}");
        assert_eq!(exponent(0.0), 0);
        assert_eq!(Doubled::from(3.0).scaled(exponent(0.25)).value(), 0.75);
    }
}
