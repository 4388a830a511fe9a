//! The trait of intersection tests, and what the kernels of all shapes share.

use super::intersect::{Intersect, Target};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name, Step};
use crate::probe::{Probe, Silent};

/// What a kernel needs to know besides the ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Approach {
    /// The side of this surface on which the ray starts, if it leaves it.
    pub leaving: Option<Side>,
    /// Whether the surface is absent for rays that arrive at its back.
    pub one_sided: bool,
}

/// The intersection test of one kind of shape.
pub trait Kernel {
    /// Writes the inputs to the log.
    fn give<P: Probe>(&self, probe: &mut P);

    /// The first point where the ray crosses the surface.
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing>;

    /// All points where the ray crosses the surface, in its order. A flat shape has no more than one.
    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        found.extend(self.first_crossing(ray, approach, probe));
    }

    /// The surface at a crossing, its normals turned toward the arriving ray.
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface;

    /// A box around the shape; `None` for one without end.
    fn bounds(&self) -> Option<Bounds>;

    /// Whether a ray that sets off on this side of the surface can hit the same surface again (self-intersection). Flat shapes can't be hit again.
    fn can_self_intersect(&self, _sets_off: Side) -> bool {
        false
    }

    /// The distance of a crossing as exactly as the shape can compute it, to order crossings that f64 can't.
    fn refined(&self, _ray: &Ray, crossing: Crossing) -> Doubled {
        Doubled::from(crossing.t)
    }

    /// The size of the numbers that define the surface, whose roundings move it: its greatest coordinate.
    fn size(&self) -> f64 {
        Kernel::bounds(self).map_or(0.0, Bounds::size)
    }

    /// The part of the ray's direction that is along the normal at a crossing: how fast the ray leaves the surface.
    fn slope(&self, ray: &Ray, crossing: Crossing) -> f64 {
        Kernel::surface(self, ray, crossing, &mut Silent).geometric_normal().dot(ray.direction).abs()
    }

    /// Whether a crossing near an end of the ray is that end, as far as rounding can tell: where the ray begins, or where the light is. Then
    /// it is a miss, and why.
    #[cold]
    #[inline(never)]
    fn at_an_end(&self, ray: &Ray, approach: Approach, crossing: Crossing) -> Option<Miss> {
        at_an_end(ray, approach.leaving.is_none(), crossing.t, self.slope(ray, crossing), Kernel::size(self))
    }

    /// Marks the only candidate as hit or missed.
    #[inline(always)]
    fn decide<P: Probe>(&self, ray: &Ray, approach: Approach, candidate: Crossing, probe: &mut P) -> Option<Crossing> {
        let Crossing { t, side, primitive } = candidate;
        let at_an_end =
            if ray.is_near_an_end(t) { self.at_a_near_end(ray, approach, t, side, primitive) } else { None };
        decide(ray, approach, candidate, at_an_end, probe)
    }

    /// [`Kernel::at_an_end`], called with what fits into registers. A `Crossing` passed to a call lives in memory even where the call
    /// isn't taken: it would be stored field by field and loaded as a whole, a stall that takes longer than the test of a plane.
    #[cold]
    #[inline(never)]
    fn at_a_near_end(&self, ray: &Ray, approach: Approach, t: f64, side: Side, primitive: u32) -> Option<Miss> {
        self.at_an_end(ray, approach, Crossing { t, side, primitive })
    }
}

/// The first point where the ray crosses the target; `None` also where the ray leaves the target and can't hit it again.
// Each kernel is a function of its own: in one function they would spill each other's registers.
#[inline(never)]
fn test<K: Kernel, P: Probe>(kernel: &K, target: Target, ray: &Ray, probe: &mut P) -> Option<Crossing> {
    let approach = Approach::of(kernel, target, ray)?;
    kernel.give(probe);
    probe.within(step_of(target), |probe| kernel.first_crossing(ray, approach, probe))
}

fn step_of(target: Target) -> Step {
    Step::Test { object: target.object, triangle: None }
}

impl<K: Kernel> Intersect for K {
    #[inline(always)]
    fn nearest<P: Probe>(&self, target: Target, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        if let Some(crossing) = test(self, target, ray, probe) {
            nearest.offer(target.object, crossing, ray, probe);
        }
    }

    #[inline(always)]
    fn is_crossed<P: Probe>(&self, target: Target, source: &impl RaySource, probe: &mut P) -> bool {
        test(self, target, source.ray(), probe).is_some()
    }

    #[inline(never)]
    fn all_crossings<P: Probe>(&self, target: Target, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P) {
        let Some(approach) = Approach::of(self, target, ray) else { return };
        self.give(probe);
        probe.within(step_of(target), |probe| Kernel::all_crossings(self, ray, approach, found, probe));
    }

    fn touch<P: Probe>(&self, target: Target, _primitive: u32, _ray: &Ray, probe: &mut P) {
        self.give(probe);
        probe.within(step_of(target), touched);
    }

    #[inline(never)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        Kernel::surface(self, ray, crossing, probe)
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        Kernel::refined(self, ray, crossing)
    }

    fn bounds(&self) -> Option<Bounds> {
        Kernel::bounds(self)
    }

    fn size(&self, _primitive: u32) -> f64 {
        Kernel::size(self)
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        Kernel::can_self_intersect(self, sets_off)
    }
}

/// A test with a known answer: the ray begins on the surface.
pub(super) fn touched<P: Probe>(probe: &mut P) {
    probe.note(Name::TouchT, 0.0);
    probe.mark(Decision::Hit);
}

impl Approach {
    /// How the ray comes to the target; `None` where it leaves it and can't hit it again.
    #[inline(always)]
    fn of(kernel: &impl Kernel, target: Target, ray: &Ray) -> Option<Approach> {
        let leaving = ray.leaving.filter(|leaving| leaving.object == target.object).map(|leaving| leaving.side);
        let can_hit = leaving.is_none_or(|side| Kernel::can_self_intersect(kernel, side));
        can_hit.then_some(Approach { leaving, one_sided: target.one_sided })
    }

    /// Whether the surface is there for a ray that arrives on this side.
    #[inline]
    pub fn shows(self, side: Side) -> bool {
        !self.one_sided || side == Side::Front
    }
}

/// Whether a crossing, through which the ray passes so fast along the normal, is an end of the ray.
pub(super) fn at_an_end(ray: &Ray, may_begin: bool, t: f64, slope: f64, size: f64) -> Option<Miss> {
    if may_begin && ray.holds(t * slope, size) {
        Some(Miss::BeginsThere)
    } else if ray.holds((ray.t_max - t) * slope, size) {
        Some(Miss::Beyond)
    } else {
        None
    }
}

/// Marks a candidate as hit or missed: by its side, by whether the ray reaches it, and by whether it is an end of the ray.
#[inline]
pub(super) fn decide<P: Probe>(
    ray: &Ray,
    approach: Approach,
    candidate: Crossing,
    at_an_end: Option<Miss>,
    probe: &mut P,
) -> Option<Crossing> {
    let why = match at_an_end {
        _ if !approach.shows(candidate.side) => Miss::FacesAway,
        Some(why) if ray.reaches(candidate.t) => why,
        None if ray.reaches(candidate.t) => {
            probe.mark(Decision::Hit);
            return Some(candidate);
        }
        _ if candidate.t >= ray.t_max => Miss::Beyond,
        _ => Miss::Behind,
    };
    probe.mark(Decision::Miss { why });
    None
}
