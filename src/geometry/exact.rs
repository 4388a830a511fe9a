//! Sums without any error, and the two questions that need them: on which side of an edge a ray passes, and what is left of a
//! scalar product that cancels.
//!
//! A sum is kept as parts of growing size that don't overlap (Shewchuk, "Adaptive precision floating-point arithmetic and fast
//! robust geometric predicates", 1997: GROW-EXPANSION with elimination of zeros). The last part alone has the sign.

use super::doubled::{Doubled, Doubled3};
use arrayvec::ArrayVec;
use glam::DVec3;

/// The most numbers that a sum here is made of: four to a product of three, four of those to a product of differences, and six
/// of those to a triple product.
const PARTS: usize = 96;

/// A sum without error, unless its products over- or underflow.
#[derive(Clone, Debug, Default)]
pub(super) struct Exact {
    parts: ArrayVec<f64, PARTS>,
}

impl Exact {
    /// Adds a number. There may be [`PARTS`] in all.
    pub fn add(&mut self, number: f64) {
        let mut carry = number;
        let mut kept = 0;
        for at in 0..self.parts.len() {
            let Doubled { head, tail } = Doubled::sum(self.parts[at], carry);
            carry = head;
            if tail != 0.0 {
                self.parts[kept] = tail;
                kept += 1;
            }
        }
        self.parts.truncate(kept);
        if carry != 0.0 {
            self.parts.push(carry);
        }
    }

    /// Adds a·b.
    pub fn add_product(&mut self, a: f64, b: f64) {
        let Doubled { head, tail } = Doubled::product(a, b);
        self.add(tail);
        self.add(head);
    }

    /// Adds a·b·c.
    fn add_triple(&mut self, a: f64, b: f64, c: f64) {
        if a != 0.0 && b != 0.0 && c != 0.0 {
            let Doubled { head, tail } = Doubled::product(a, b);
            self.add_product(tail, c);
            self.add_product(head, c);
        }
    }

    /// Adds a·b·c for two numbers of twice the digits.
    fn add_triple_of(&mut self, a: f64, b: Doubled, c: Doubled) {
        self.add_triple(a, b.tail, c.tail);
        self.add_triple(a, b.tail, c.head);
        self.add_triple(a, b.head, c.tail);
        self.add_triple(a, b.head, c.head);
    }

    /// The sum, rounded to twice the digits of f64.
    pub fn doubled(&self) -> Doubled {
        let sum = self.parts.iter().fold(Doubled::ZERO, |sum, part| sum + Doubled::from(*part));
        Doubled::sum(sum.head, sum.tail)
    }

    /// The sum, rounded to f64; its sign is right.
    pub fn value(&self) -> f64 {
        self.parts.iter().sum()
    }
}

/// a·b + rest, right to the last digits of a doubled number or nearly so, however much of it cancels.
pub(super) fn dot(a: DVec3, b: DVec3, rest: f64) -> Doubled {
    let products = [Doubled::product(a.x, b.x), Doubled::product(a.y, b.y), Doubled::product(a.z, b.z)];
    sum_of([Doubled::from(rest), products[0], products[1], products[2]])
}

/// v·v − r², likewise.
pub(super) fn squared_less(v: Doubled3, r: f64) -> Doubled {
    let square = |part: Doubled| part * part;
    let quick = Doubled::product(-r, r) + square(v.x) + square(v.y) + square(v.z);
    if quick.head.abs() > LEAST_LEFT * (r * r) {
        return quick;
    }
    let mut sum = Exact::default();
    sum.add_product(-r, r);
    for Doubled { head, tail } in [v.x, v.y, v.z] {
        sum.add_product(tail, tail);
        sum.add_product(2.0 * head, tail);
        sum.add_product(head, head);
    }
    sum.doubled()
}

/// The part of a sum's terms below which its digits aren't all there with doubled numbers: their errors, some 2⁻¹⁰⁰ of the terms,
/// are 2⁻⁶⁰ of what is left then.
const LEAST_LEFT: f64 = 1.0 / (1_u64 << 40) as f64;

/// The sum of numbers that are exact.
#[inline]
fn sum_of(terms: [Doubled; 4]) -> Doubled {
    let quick = terms[1..].iter().fold(terms[0], |sum, term| sum + *term);
    let size: f64 = terms.iter().map(|term| term.head.abs()).sum();
    if quick.head.abs() > LEAST_LEFT * size { quick } else { exact_sum_of(terms) }
}

#[cold]
fn exact_sum_of(terms: [Doubled; 4]) -> Doubled {
    let mut sum = Exact::default();
    for Doubled { head, tail } in terms {
        sum.add(tail);
        sum.add(head);
    }
    sum.doubled()
}

/// v · (p × q) with its right sign. Exchanging p and q negates it.
pub(super) fn triple_product(v: DVec3, p: Doubled3, q: Doubled3) -> f64 {
    let mut sum = Exact::default();
    for (v, (p_1, p_2), (q_1, q_2)) in
        [(v.x, (p.y, p.z), (q.y, q.z)), (v.y, (p.z, p.x), (q.z, q.x)), (v.z, (p.x, p.y), (q.x, q.y))]
    {
        sum.add_triple_of(v, p_1, q_2);
        sum.add_triple_of(-v, p_2, q_1);
    }
    sum.value()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_still_there() {
        let mut sum = Exact::default();
        for number in [1e100, 1.0, -1e100, 1e-100, -1.0] {
            sum.add(number);
        }
        assert_eq!(sum.value(), 1e-100);
        sum.add(-1e-100);
        assert_eq!((sum.value(), sum.doubled().head), (0.0, 0.0));
    }

    #[test]
    fn scalar_products_keep_their_rest() {
        let (a, b) = (DVec3::new(1e8, 1e-8, 1.0), DVec3::new(1e8, 1e-8, -1e16));
        assert_eq!(dot(a, b, 0.0).head, 1e-8 * 1e-8);
        assert_eq!(dot(DVec3::X, DVec3::Y, 3.0).head, 3.0);
        let v = Doubled3::difference(DVec3::new(3.0, 4.0, 1e-30), DVec3::ZERO);
        assert_eq!(squared_less(v, 5.0).head, 1e-30 * 1e-30);
    }

    #[test]
    fn triple_products_have_their_sign() {
        let (p, q) = (DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.7, -0.4, 0.9));
        let origin = DVec3::splat(1e9);
        let of = |v: DVec3, a: DVec3, b: DVec3| {
            triple_product(v, Doubled3::difference(a, origin), Doubled3::difference(b, origin))
        };
        let v = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(of(v, p, q), -of(v, q, p));
        // In the plane of the two: nothing at all is left.
        assert_eq!(of(p - origin, p - origin + origin, q), -of(p - origin, q, p - origin + origin));
        let (a, b) = (DVec3::new(3.0, 0.0, 1.0), DVec3::new(0.0, 5.0, 1.0));
        let plain = |v: DVec3| triple_product(v, a.into(), b.into());
        assert_eq!(plain(a + b), 0.0);
        assert_eq!(plain(DVec3::Z), 15.0);
        assert!(plain(a + b + DVec3::Z * 1e-15) > 0.0 && plain(a + b - DVec3::Z * 1e-15) < 0.0);
    }
}
