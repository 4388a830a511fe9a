//! Rounding some quantities and not others.

use crate::log::{Name, Step};
use crate::probe::{Alteration, Decimal, Position, Quantity, Single, mixed_with, round_half_away};

/// How a quantity is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// By hand, to this many decimals.
    Decimal(u32),
    /// To single precision.
    Single,
}

/// Which quantities are rounded, by their keys in the tree ([`Position`]).
#[derive(Clone, Copy, Debug)]
pub(super) enum Which {
    None,
    All,
    Only(u64),
    AllBut(u64),
    /// All, each up or down at random.
    EitherWay {
        seed: u64,
    },
}

/// Rounds some quantities.
pub(super) struct Rounded {
    rounding: Rounding,
    which: Which,
    position: Position,
}

impl Rounded {
    pub fn new(rounding: Rounding, which: Which) -> Rounded {
        Rounded { rounding, which, position: Position::new(0) }
    }
}

impl Alteration for Rounded {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let key = self.position.next(name);
        let is_rounded = match self.which {
            Which::None => false,
            Which::All => true,
            Which::Only(only) => key == only,
            Which::AllBut(but) => key != but,
            Which::EitherWay { seed } => {
                let throw = |component: usize| mixed_with(mixed_with(key, seed), component as u64) & 1 == 1;
                return value.map(|component, x| self.rounding.either_way(x, throw(component)));
            }
        };
        match self.rounding {
            _ if !is_rounded => value,
            Rounding::Decimal(digits) => Decimal::new(digits).alter(name, value),
            Rounding::Single => Single.alter(name, value),
        }
    }

    fn enter(&mut self, step: Step) {
        self.position.enter(step);
    }

    fn leave(&mut self) {
        self.position.leave();
    }
}

/// 2⁻⁴⁸: what is nearer to a decimal than this part of it is that decimal, as in [`round_half_away`].
const NOISE: f64 = 16.0 * f64::EPSILON;

impl Rounding {
    /// The nearest number that this rounding leaves, or the one on the other side of `x`. What needs no rounding stays.
    fn either_way(self, x: f64, takes_other: bool) -> f64 {
        match self {
            Rounding::Decimal(digits) => {
                let nearest = round_half_away(x, digits);
                if !takes_other || (x - nearest).abs() <= NOISE * x.abs() {
                    return nearest;
                }
                let step = (0..digits).fold(1.0, |step: f64, _| step / 10.0);
                round_half_away(nearest + step.copysign(x - nearest), digits)
            }
            Rounding::Single => {
                let nearest = (x as f32).clamp(f32::MIN, f32::MAX);
                let other = if f64::from(nearest) < x { nearest.next_up() } else { nearest.next_down() };
                let stays = !takes_other || f64::from(nearest) == x || !other.is_finite();
                f64::from(if stays { nearest } else { other })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn lies_between(rounding: Rounding, x: f64, nearest: f64, other: f64) {
        assert_eq!([false, true].map(|takes_other| rounding.either_way(x, takes_other)), [nearest, other], "{x}");
    }

    #[test]
    fn a_number_lies_between_two_decimals() {
        lies_between(Rounding::Decimal(3), 0.2317, 0.232, 0.231);
        lies_between(Rounding::Decimal(3), 0.2311, 0.231, 0.232);
        lies_between(Rounding::Decimal(3), -0.2317, -0.232, -0.231);
        lies_between(Rounding::Decimal(0), 0.3, 0.0, 1.0);
    }

    #[test]
    fn what_needs_no_rounding_stays() {
        lies_between(Rounding::Decimal(3), 2.675, 2.675, 2.675);
        lies_between(Rounding::Decimal(3), 3.0 * 0.1, 0.3, 0.3);
        lies_between(Rounding::Decimal(3), 0.0, 0.0, 0.0);
        lies_between(Rounding::Single, 0.5, 0.5, 0.5);
        lies_between(Rounding::Single, 1e300, f64::from(f32::MAX), f64::from(f32::MAX));
    }

    #[test]
    fn a_number_lies_between_two_singles() {
        let tenth = f64::from(0.1_f32);
        lies_between(Rounding::Single, 0.1, tenth, f64::from(0.1_f32.next_down()));
    }
}
