//! The probe: it sees, and may alter, every named quantity of the one tracing path.
//!
//! There is one implementation of intersecting, shading and recursion, generic over [`Probe`]. Every quantity that the
//! source text names goes through [`Probe::note`], and the computation goes on with what that returns. The default of
//! every method does nothing, so that [`Silent`] compiles to nothing.

mod altered;
mod erased;
mod forward;
mod perturbed;
mod position;
mod printed;
mod ray_tree;
mod recorder;
mod silent;

pub use crate::log::round_half_away;
pub use altered::{Alteration, Altered, Decimal, Single};
pub use erased::Erased;
pub(crate) use forward::forward;
pub use perturbed::Perturbed;
pub use position::{Position, mixed_with};
pub use printed::{Printed, PrintedValue};
pub use ray_tree::{RayTree, is_same};
pub use recorder::{CutOff, Outlet, Recorder, until_cut_off};
pub use silent::Silent;

use crate::log::plane::Emitter;
use crate::log::{Decision, Name, SkipReason, Step, Value};
use glam::DVec3;

/// The bound of the rounding errors of a computed point, and of the numbers of a surface, relative to their sizes:
/// 64 roundings of f64 (`docs/numerics.md`, "Coincident surfaces").
pub const ROUNDINGS: f64 = 32.0 * f64::EPSILON;

/// Sees a computation as it happens.
pub trait Probe: Sized {
    /// Whether the probe ignores everything, so that work without effect on the result can be skipped.
    const IS_SILENT: bool = false;

    /// Whether trees are traversed with the processor's best instructions, for which the traversal is compiled a second time. Kernels get the
    /// same primitives either way. Only silent probes use operations that not every processor has, so that the counts of others are the same on
    /// every machine.
    const USES_SIMD: bool = Self::IS_SILENT;

    /// An input that the problem states, for the next event. Inputs are never altered.
    #[inline(always)]
    fn given<Q: Quantity>(&mut self, _name: Name, _value: Q) {}

    /// A named quantity was computed. The computation goes on with the value returned.
    #[inline(always)]
    fn note<Q: Quantity>(&mut self, _name: Name, value: Q) -> Q {
        value
    }

    /// A decision was taken.
    #[inline(always)]
    fn mark(&mut self, _decision: Decision) {}

    /// Bounding volumes were tested. They only find candidates, so they are counted, not logged.
    #[inline(always)]
    fn bounds_tested(&mut self, _count: u64) {}

    /// Whether decisions that f64 leaves in doubt are taken with more digits. Other arithmetics go on with the numbers that they have
    /// computed so far.
    #[inline(always)]
    fn certifies(&self) -> bool {
        true
    }

    /// To how many decimals the products of a dot product are rounded before they are added; `None` if they aren't.
    #[inline(always)]
    fn decimals_of_products(&self) -> Option<u32> {
        None
    }

    /// The dot product a · b of a formula.
    #[inline(always)]
    fn dot(&self, a: DVec3, b: DVec3) -> f64 {
        match self.decimals_of_products() {
            None => a.dot(b),
            Some(digits) => (a * b).map(|x| round_half_away(x, digits)).element_sum(),
        }
    }

    /// How far rounding may move a computed point whose coordinates and operands have this size. Surfaces that
    /// near to each other coincide.
    #[inline(always)]
    fn slack(&self, size: f64) -> f64 {
        ROUNDINGS * size
    }

    /// f64 left something in doubt, and more digits were used. It is counted, not logged.
    #[inline(always)]
    fn fallback(&mut self) {}

    /// This many rays aren't traced, or not searched for what they hit. It is counted, not logged: the log has the decision.
    #[inline(always)]
    fn rays_saved(&mut self, _why: Saving, _rays: u64) {}

    /// Whether [`Probe::part`] is called.
    #[inline(always)]
    fn sees_parts(&self) -> bool {
        false
    }

    /// A part of the light that the open ray brings to its own end, before the weights on the ray's way: all parts of a ray and of those that it
    /// spawns, weighted as their sums are, add up to its colour. It is neither altered nor logged: the log has what it follows from.
    #[inline(always)]
    fn part(&mut self, _emitter: Emitter, _color: DVec3) {}

    /// The ray through this place of the picture begins, in pixels from its top left corner.
    #[inline(always)]
    fn aim(&mut self, _place: [f64; 2]) {}

    /// The ray through the latest place is complete.
    #[inline(always)]
    fn aimed(&mut self) {}

    /// A node begins. Kernels call [`Probe::within`], which can't forget the end.
    #[inline(always)]
    fn enter(&mut self, _step: Step) {}

    /// The latest node ends.
    #[inline(always)]
    fn leave(&mut self) {}

    /// A part of the computation, as a node of its own.
    #[inline(always)]
    fn within<T>(&mut self, step: Step, body: impl FnOnce(&mut Self) -> T) -> T {
        self.enter(step);
        let result = body(self);
        self.leave();
        result
    }
}

/// Why rays aren't traced, or not searched for what they hit.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Saving {
    /// A rule leaves them out. Of a blurred bounce all rays count, of a local model the shadow rays to all lights; not what they would
    /// have spawned.
    Skipped(SkipReason),
    /// They would lie too deep in the ray tree.
    DepthLimit,
    /// Another pixel has traced them.
    Shared,
    /// Nothing can block them, so a rendering that counts nothing doesn't search.
    Search,
}

/// What can be noted: a number, or a triple.
pub trait Quantity: Copy {
    /// The same quantity with each component put through `f`, which gets the component's index.
    fn map(self, f: impl FnMut(usize, f64) -> f64) -> Self;

    /// The quantity as it is in a log.
    fn value(self) -> Value;
}

impl Quantity for f64 {
    #[inline]
    fn map(self, mut f: impl FnMut(usize, f64) -> f64) -> f64 {
        f(0, self)
    }

    fn value(self) -> Value {
        Value::Number(self)
    }
}

impl Quantity for DVec3 {
    // In arithmetic by hand every value goes through it.
    #[inline(always)]
    fn map(self, mut f: impl FnMut(usize, f64) -> f64) -> DVec3 {
        DVec3::new(f(0, self.x), f(1, self.y), f(2, self.z))
    }

    fn value(self) -> Value {
        Value::Triple(self.to_array())
    }
}
