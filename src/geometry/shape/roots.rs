//! What the shapes with two crossings share: which of two roots counts.

use super::Approach;
use crate::geometry::ray::{Crossing, Ray, Side};
use crate::log::{Decision, Miss};
use crate::probe::Probe;

/// One of the two points where the line of a ray crosses a convex surface (or the surface that an open one is cut from).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Root {
    /// The distance along the ray.
    pub t: f64,
    /// Which part of the surface.
    pub primitive: u32,
    /// Whether the point lies on the surface; past the end of an open cylinder it doesn't.
    pub is_on_surface: bool,
}

/// Both roots, the entry first. `outer` is the side of the surface that faces outward: the front unless it is `inward`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Roots {
    /// Where the line enters.
    pub entry: Root,
    /// Where it leaves.
    pub exit: Root,
    /// The side on which the line arrives at the entry.
    pub outer: Side,
}

impl Roots {
    /// The first root that counts for this ray; marks the decision.
    pub fn first<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let first = self.candidates(approach).into_iter().flatten().find(|crossing| ray.reaches(crossing.t));
        self.mark(ray, approach, first.is_some(), probe);
        first
    }

    /// All roots that count for this ray; marks the decision.
    pub fn all<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        let before = found.len();
        found.extend(self.candidates(approach).into_iter().flatten().filter(|crossing| ray.reaches(crossing.t)));
        self.mark(ray, approach, found.len() > before, probe);
    }

    /// The roots that lie on the surface and show themselves. A ray that leaves the surface has already been at the root
    /// nearest to its origin.
    fn candidates(&self, approach: Approach) -> [Option<Crossing>; 2] {
        let is_entry_left = self.entry.t.abs() <= self.exit.t.abs();
        let candidate = |root: &Root, side: Side, is_left: bool| {
            let counts = root.is_on_surface && approach.shows(side) && !(approach.leaving.is_some() && is_left);
            counts.then_some(Crossing { t: root.t, side, primitive: root.primitive })
        };
        [
            candidate(&self.entry, self.outer, is_entry_left),
            candidate(&self.exit, self.outer.opposite(), !is_entry_left),
        ]
    }

    fn mark<P: Probe>(&self, ray: &Ray, approach: Approach, is_hit: bool, probe: &mut P) {
        if is_hit {
            probe.mark(Decision::Hit);
            return;
        }
        let why = match () {
            _ if !self.entry.is_on_surface && !self.exit.is_on_surface => Miss::Beside,
            _ if self.exit.t <= ray.t_min => Miss::Behind,
            _ if self.entry.t >= ray.t_max => Miss::Beyond,
            _ if approach.one_sided => Miss::FacesAway,
            _ => Miss::Beside,
        };
        probe.mark(Decision::Miss { why });
    }
}
