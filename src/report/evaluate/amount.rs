//! The arithmetic of numbers and triples that is the same however many digits they have.

use crate::log::Value;
use crate::log::formula::Operator;
use std::ops::{Add, Div, Mul, Sub};

/// A number or a triple.
#[derive(Clone, Copy, Debug)]
pub(super) enum Amount<N> {
    Number(N),
    Triple([N; 3]),
}

impl<N: Copy + Add<Output = N> + Sub<Output = N> + Mul<Output = N> + Div<Output = N>> Amount<N> {
    /// What an operator makes of two; `None` where it makes nothing of such.
    pub fn with(self, operator: Operator, other: Amount<N>) -> Option<Amount<N>> {
        use Amount::{Number, Triple};
        let zipped = |a: [N; 3], b: [N; 3], f: fn(N, N) -> N| Triple([0, 1, 2].map(|i| f(a[i], b[i])));
        Some(match (operator, self, other) {
            (Operator::Plus, Number(a), Number(b)) => Number(a + b),
            (Operator::Plus, Triple(a), Triple(b)) => zipped(a, b, |a, b| a + b),
            (Operator::Minus, Number(a), Number(b)) => Number(a - b),
            (Operator::Minus, Triple(a), Triple(b)) => zipped(a, b, |a, b| a - b),
            (Operator::Times, Number(a), Number(b)) => Number(a * b),
            (Operator::Times, Triple(a), Number(b)) | (Operator::Times, Number(b), Triple(a)) => {
                Triple(a.map(|x| x * b))
            }
            (Operator::Times, Triple(a), Triple(b)) => Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]),
            (Operator::Over, Number(a), Number(b)) => Number(a / b),
            (Operator::Over, Triple(a), Number(b)) => Triple(a.map(|x| x / b)),
            (Operator::Cross, Triple(a), Triple(b)) => {
                let minor = |i: usize, j: usize| a[i] * b[j] - b[i] * a[j];
                Triple([minor(1, 2), minor(2, 0), minor(0, 1)])
            }
            _ => return None,
        })
    }
}

impl<N> Amount<N> {
    /// With each of its numbers as `f` makes it.
    pub fn map<M>(self, f: impl Fn(N) -> M) -> Amount<M> {
        match self {
            Amount::Number(x) => Amount::Number(f(x)),
            Amount::Triple(xyz) => Amount::Triple(xyz.map(f)),
        }
    }
}

impl From<Value> for Amount<f64> {
    fn from(value: Value) -> Amount<f64> {
        match value {
            Value::Number(x) => Amount::Number(x),
            Value::Triple(xyz) => Amount::Triple(xyz),
        }
    }
}

impl From<Amount<f64>> for Value {
    fn from(amount: Amount<f64>) -> Value {
        match amount {
            Amount::Number(x) => Value::Number(x),
            Amount::Triple(xyz) => Value::Triple(xyz),
        }
    }
}
