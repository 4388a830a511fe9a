//! Lanes whose results are the same on every machine.

use super::{Eight, Lanes};

/// The instructions of other lanes, without fused operations.
#[derive(Clone, Copy, Debug)]
pub(in crate::geometry::bvh) struct Unfused<L>(pub L);

impl<L: Lanes> Lanes for Unfused<L> {
    type Eight = L::Eight;

    #[inline(always)]
    fn splat(self, x: f32) -> L::Eight {
        self.0.splat(x)
    }

    #[inline(always)]
    fn load(self, eight: &Eight) -> L::Eight {
        self.0.load(eight)
    }

    #[inline(always)]
    fn store(self, eight: L::Eight) -> Eight {
        self.0.store(eight)
    }

    #[inline(always)]
    fn add(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.add(a, b)
    }

    #[inline(always)]
    fn sub(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.sub(a, b)
    }

    #[inline(always)]
    fn mul(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.mul(a, b)
    }

    #[inline(always)]
    fn times_plus(self, a: L::Eight, b: L::Eight, c: L::Eight) -> L::Eight {
        self.0.add(self.0.mul(a, b), c)
    }

    #[inline(always)]
    fn times_minus(self, a: L::Eight, b: L::Eight, c: L::Eight) -> L::Eight {
        self.0.sub(self.0.mul(a, b), c)
    }

    #[inline(always)]
    fn less_times(self, c: L::Eight, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.sub(c, self.0.mul(a, b))
    }

    #[inline(always)]
    fn min(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.min(a, b)
    }

    #[inline(always)]
    fn max(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.max(a, b)
    }

    #[inline(always)]
    fn sqrt(self, a: L::Eight) -> L::Eight {
        self.0.sqrt(a)
    }

    #[inline(always)]
    fn negated_as(self, a: L::Eight, b: L::Eight) -> L::Eight {
        self.0.negated_as(a, b)
    }

    #[inline(always)]
    fn at_least(self, a: L::Eight, b: L::Eight) -> u32 {
        self.0.at_least(a, b)
    }

    #[inline(always)]
    fn run<R>(self, body: impl FnOnce() -> R) -> R {
        self.0.run(body)
    }
}
