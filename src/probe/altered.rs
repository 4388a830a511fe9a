//! Probes that alter what the computation goes on with: other arithmetics, with or without a recording.

use super::{Probe, Quantity, ROUNDINGS, forward};
use crate::log::{Name, Step, round_half_away};

/// Alters every named quantity, then shows it to `probe`.
#[derive(Clone, Debug, Default)]
pub struct Altered<A, P> {
    /// What is done to the quantities.
    pub alteration: A,
    /// Who sees them then.
    pub probe: P,
}

/// What is done to every named quantity.
pub trait Alteration {
    /// The value that the computation goes on with instead.
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q;

    /// How far this arithmetic may move a point of this size (see [`Probe::slack`]).
    fn slack(&self, size: f64) -> f64 {
        ROUNDINGS * size
    }

    /// To how many decimals this arithmetic rounds the products of a dot product (see [`Probe::decimals_of_products`]).
    fn decimals_of_products(&self) -> Option<u32> {
        None
    }

    /// A node begins.
    fn enter(&mut self, _step: Step) {}

    /// The latest node ends.
    fn leave(&mut self) {}

    /// The ray through this place of the picture begins.
    fn aim(&mut self, _place: [f64; 2]) {}

    /// All that it brings is there.
    fn aimed(&mut self) {}
}

impl<A: Alteration, P: Probe> Probe for Altered<A, P> {
    forward!(self => Probe of self.probe; given mark bounds_tested rays_saved sees_parts part);

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let altered = self.alteration.alter(name, value);
        self.probe.note(name, altered)
    }

    fn certifies(&self) -> bool {
        false
    }

    fn slack(&self, size: f64) -> f64 {
        self.alteration.slack(size)
    }

    fn decimals_of_products(&self) -> Option<u32> {
        self.alteration.decimals_of_products()
    }

    fn aim(&mut self, place: [f64; 2]) {
        self.alteration.aim(place);
        self.probe.aim(place);
    }

    fn aimed(&mut self) {
        self.probe.aimed();
        self.alteration.aimed();
    }

    fn enter(&mut self, step: Step) {
        self.alteration.enter(step);
        self.probe.enter(step);
    }

    fn leave(&mut self) {
        self.probe.leave();
        self.alteration.leave();
    }
}

/// Arithmetic by hand: every named quantity is rounded to a number of decimals.
#[derive(Clone, Copy, Debug)]
pub struct Decimal {
    digits: u32,
    rounds_products: bool,
}

impl Decimal {
    /// How many decimals there may be.
    pub const MAX_DIGITS: u32 = 15;

    /// Arithmetic with this many decimals, at most [`Decimal::MAX_DIGITS`].
    pub fn new(digits: u32) -> Decimal {
        Decimal { digits: digits.min(Decimal::MAX_DIGITS), rounds_products: false }
    }

    /// The same arithmetic, in which the products of every dot product are rounded before they are added, as the source text does in
    /// step 7 of its example.
    pub fn with_rounded_products(digits: u32) -> Decimal {
        Decimal { rounds_products: true, ..Decimal::new(digits) }
    }
}

impl Alteration for Decimal {
    #[inline(always)]
    fn alter<Q: Quantity>(&mut self, _name: Name, value: Q) -> Q {
        value.map(|_, x| round_half_away(x, self.digits))
    }

    fn decimals_of_products(&self) -> Option<u32> {
        self.rounds_products.then_some(self.digits)
    }

    /// Chosen, not derived: the bound for all 64 roundings would, with few digits, close gaps that a reader sees. So coincident surfaces may
    /// still be distinguished here.
    fn slack(&self, size: f64) -> f64 {
        let step = (0..self.digits).fold(1.0, |step, _| step / 10.0);
        step * (1.0 + size) / 8.0
    }
}

/// What single precision would do: every named quantity is rounded to f32, and to the greatest one where it would overflow,
/// since a log holds finite numbers only.
#[derive(Clone, Copy, Debug, Default)]
pub struct Single;

impl Alteration for Single {
    fn alter<Q: Quantity>(&mut self, _name: Name, value: Q) -> Q {
        value.map(|_, x| f64::from((x as f32).clamp(f32::MIN, f32::MAX)))
    }

    fn slack(&self, size: f64) -> f64 {
        32.0 * f64::from(f32::EPSILON) * size
    }
}
