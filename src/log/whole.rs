//! Whole numbers as other programs may write them: 1.0 or 1e0.

use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// A whole number, however it is spelt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Whole<T>(pub T);

/// Those that a log has.
pub trait Unsigned: TryFrom<u64> {
    /// What messages call it.
    const NAME: &'static str;
}

impl Unsigned for u32 {
    const NAME: &'static str = "u32";
}

impl Unsigned for u64 {
    const NAME: &'static str = "u64";
}

impl<'de, T: Unsigned> Deserialize<'de> for Whole<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_u64(Number(PhantomData)).map(Whole)
    }
}

struct Number<T>(PhantomData<T>);

impl<T: Unsigned> Visitor<'_> for Number<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(T::NAME)
    }

    #[inline]
    fn visit_u64<E: Error>(self, number: u64) -> Result<T, E> {
        T::try_from(number).map_err(|_| E::invalid_value(Unexpected::Unsigned(number), &self))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<T, E> {
        Err(E::invalid_value(Unexpected::Signed(number), &self))
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<T, E> {
        /// Up to there every whole number is one of f64, too.
        const MOST: f64 = 9_007_199_254_740_992.0;
        let is_whole = number == number.trunc() && number.is_sign_positive() && number < MOST;
        let whole = if is_whole { T::try_from(number as u64).ok() } else { None };
        whole.ok_or_else(|| E::invalid_type(Unexpected::Float(number), &self))
    }
}

/// Reads a field that is one.
///
/// # Errors
/// Those of the deserializer, and where it is none.
pub fn whole<'de, T: Unsigned, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    Whole::deserialize(deserializer).map(|Whole(number)| number)
}
