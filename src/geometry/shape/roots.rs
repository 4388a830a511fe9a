//! What the shapes with two crossings share: the roots of their quadratic equation, and which of two roots counts.

use super::Approach;
use crate::geometry::ray::{Crossing, Ray, Side};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;

/// One of the two points where the line of a ray crosses a convex surface (or the surface that an open one is cut from).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Root {
    /// The distance along the ray; infinite where the line doesn't come out of the surface.
    pub t: f64,
    /// Which part of the surface.
    pub primitive: u32,
    /// Whether the point lies on the surface; past the end of an open cylinder it doesn't.
    pub is_on_surface: bool,
    /// What the distance is called in the log when it is chosen.
    pub name: Name,
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

/// Which of two roots are ends of the ray.
#[derive(Clone, Copy)]
struct Ends {
    /// Whether the ray begins at the root nearest to its origin.
    has_left: bool,
    /// Whether the light is at the entry, and at the exit.
    light: [bool; 2],
}

impl Ends {
    /// Those of a ray neither of whose ends is near a root, unless it leaves the surface.
    fn of(approach: Approach) -> Ends {
        Ends { has_left: approach.leaving.is_some(), light: [false; 2] }
    }
}

impl Roots {
    /// The first root that counts for this ray; notes it and marks the decision. `at_an_end` tells whether a root is an end of the ray.
    #[inline]
    pub fn first<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        at_an_end: impl Fn(Crossing) -> Option<Miss>,
        probe: &mut P,
    ) -> Option<Crossing> {
        if ray.is_near_an_end(self.entry.t) || ray.is_near_an_end(self.exit.t) {
            return self.first_near_end(ray, approach, at_an_end, probe);
        }
        self.first_but_for(ray, approach, Ends::of(approach), probe)
    }

    // A call at the end, before which no register need be saved; by value, so that the roots stay in registers.
    #[cold]
    #[inline(never)]
    fn first_near_end<P: Probe>(
        self,
        ray: &Ray,
        approach: Approach,
        at_an_end: impl Fn(Crossing) -> Option<Miss>,
        probe: &mut P,
    ) -> Option<Crossing> {
        self.first_but_for(ray, approach, self.ends(ray, approach, at_an_end), probe)
    }

    #[inline(always)]
    fn first_but_for<P: Probe>(&self, ray: &Ray, approach: Approach, ends: Ends, probe: &mut P) -> Option<Crossing> {
        let counts = |(crossing, _): &(Crossing, Name)| ray.reaches(crossing.t);
        let Some((crossing, name)) = self.candidates(approach, ends).into_iter().flatten().find(counts) else {
            self.mark_miss(ray, approach, ends, probe);
            return None;
        };
        let t = probe.note(name, crossing.t);
        probe.mark(Decision::Hit);
        Some(Crossing { t, ..crossing })
    }

    /// All roots that count for this ray; marks the decision.
    pub fn all<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        at_an_end: impl Fn(Crossing) -> Option<Miss>,
        found: &mut Vec<Crossing>,
        probe: &mut P,
    ) {
        let before = found.len();
        let ends = self.ends(ray, approach, at_an_end);
        let candidates = self.candidates(approach, ends).into_iter().flatten().map(|(crossing, _)| crossing);
        found.extend(candidates.filter(|crossing| ray.reaches(crossing.t)));
        if found.len() > before {
            probe.mark(Decision::Hit);
        } else {
            self.mark_miss(ray, approach, ends, probe);
        }
    }

    /// Which of the roots are ends of the ray. It begins at the one nearest to its origin.
    fn ends(&self, ray: &Ray, approach: Approach, at_an_end: impl Fn(Crossing) -> Option<Miss>) -> Ends {
        let why = |root: &Root, side: Side| {
            let is_near = root.is_on_surface && ray.reaches(root.t) && ray.is_near_an_end(root.t);
            let crossing = Crossing { t: root.t, side, primitive: root.primitive };
            if is_near { at_an_end(crossing) } else { None }
        };
        let why = [why(&self.entry, self.outer), why(&self.exit, self.outer.opposite())];
        let nearest = usize::from(!self.is_entry_nearest());
        Ends {
            has_left: approach.leaving.is_some() || why[nearest] == Some(Miss::BeginsThere),
            light: why.map(|why| why == Some(Miss::Beyond)),
        }
    }

    #[inline(always)]
    fn is_entry_nearest(&self) -> bool {
        self.entry.t.abs() <= self.exit.t.abs()
    }

    /// The roots that lie on the surface and show themselves. A ray that leaves the surface has already been at the root
    /// nearest to its origin.
    #[inline]
    fn candidates(&self, approach: Approach, ends: Ends) -> [Option<(Crossing, Name)>; 2] {
        let is_entry_nearest = self.is_entry_nearest();
        let candidate = |root: &Root, side: Side, is_nearest: bool, is_light: bool| {
            let is_end = (ends.has_left && is_nearest) || is_light;
            let counts = root.is_on_surface && approach.shows(side) && !is_end;
            counts.then_some((Crossing { t: root.t, side, primitive: root.primitive }, root.name))
        };
        [
            candidate(&self.entry, self.outer, is_entry_nearest, ends.light[0]),
            candidate(&self.exit, self.outer.opposite(), !is_entry_nearest, ends.light[1]),
        ]
    }

    /// Says why no crossing counts. Of a ray that begins inside one crossing lies behind it, and the other one tells.
    fn mark_miss<P: Probe>(&self, ray: &Ray, approach: Approach, ends: Ends, probe: &mut P) {
        let is_entry_nearest = self.is_entry_nearest();
        let is_left = [ends.has_left && is_entry_nearest, ends.has_left && !is_entry_nearest];
        let [entry, exit] = [(&self.entry, is_left[0]), (&self.exit, is_left[1])];
        let is_ahead = |(root, is_left): (&Root, bool)| root.is_on_surface && !is_left && root.t > ray.t_min;
        let is_behind = |(root, is_left): (&Root, bool)| is_left || root.t <= ray.t_min;
        let is_beyond = |root| is_ahead(root) && root.0.t >= ray.t_max;
        let faces_away = |root, side| is_ahead(root) && !approach.shows(side);
        let is_on_surface = (entry.0.is_on_surface && !entry.1) || (exit.0.is_on_surface && !exit.1);
        let why = if ends.light != [false; 2] || is_beyond(entry) {
            Miss::Beyond
        } else if faces_away(entry, self.outer) || faces_away(exit, self.outer.opposite()) {
            Miss::FacesAway
        } else if is_beyond(exit) {
            Miss::Beyond
        } else if ends.has_left && approach.leaving.is_none() {
            Miss::BeginsThere
        } else if is_on_surface && is_behind(entry) && is_behind(exit) {
            Miss::Behind
        } else {
            Miss::Beside
        };
        probe.mark(Decision::Miss { why });
    }
}

/// The equation a·t² + 2·b·t + c = 0, with its discriminant b² − a·c by a formula that keeps its digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quadratic {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub discriminant: f64,
}

impl Quadratic {
    /// The two roots, in no order, each with its name in the log: q/a, which is infinite if a = 0, and c/q. q is the sum of
    /// b and the discriminant's root with the sign that doesn't cancel (Press et al., Numerical Recipes, section 5.6). If
    /// q = 0, so are both roots, the first of them said twice. `None` if a = 0 too, where c alone tells.
    ///
    /// A negative discriminant counts as 0: whether it means that there are no roots is for the caller to say.
    #[inline]
    pub fn roots<P: Probe>(&self, [first, second]: [Name; 2], probe: &mut P) -> Option<[(f64, Name); 2]> {
        let root = if self.discriminant > 0.0 { self.discriminant.sqrt() } else { 0.0 };
        let q = if self.b > 0.0 {
            probe.note(Name::QuadraticQAway, -self.b - root)
        } else {
            probe.note(Name::QuadraticQToward, -self.b + root)
        };
        if q == 0.0 && self.a == 0.0 {
            return None;
        }
        let t_1 = noted(Name::QuadraticT1, q / self.a, probe);
        let other = if q == 0.0 { (t_1, first) } else { (noted(Name::QuadraticT2, self.c / q, probe), second) };
        Some([(t_1, first), other])
    }
}

/// How many digits the distances have lost: b shows the roundings of |o'|·|d'| in t, the root of the discriminant those of |o' × d'|
/// magnified, and c those of o'·o'.
pub(super) struct Digits {
    /// The square of the factor by which a distance shows them, times its own square.
    steepness: f64,
    /// The part of o'·o' that is left in c.
    left: f64,
}

/// What a distance has lost.
pub(super) enum Lost {
    /// No more than a bit or two that matter.
    Nothing,
    /// Digits that a correction gives back.
    Some,
    /// So many that there is nothing to correct.
    All,
}

impl Digits {
    #[inline]
    pub fn of(equation: &Quadratic, origin_squared: f64, across_squared: f64) -> Digits {
        let Quadratic { a, c, discriminant, .. } = *equation;
        let steepness = origin_squared / a * (across_squared / discriminant).max(1.0);
        Digits { steepness, left: c.abs() / origin_squared }
    }

    #[inline]
    pub fn of_root(&self, t: f64, is_part_of_c: bool, ray: &Ray) -> Lost {
        /// The square of the greatest factor.
        const STEEPEST: f64 = 2.0;
        /// The same where half of the digits are enough.
        const HALF_STEEP: f64 = (1_u64 << 56) as f64;
        const LEAST_LEFT: f64 = 0.75;
        const LEAST_TO_CORRECT: f64 = 1.0 / (1 << 20) as f64;
        let squared = t * t;
        // Only one of the roots is a part of c.
        let left = if is_part_of_c { self.left } else { 1.0 };
        // Compared so that what is no number has lost all.
        let has_half = self.steepness <= HALF_STEEP * squared && left >= LEAST_TO_CORRECT;
        let keeps_digits = self.steepness <= STEEPEST * squared && left >= LEAST_LEFT;
        if keeps_digits || (has_half && ray.is_settled_by_half(t)) {
            Lost::Nothing
        } else if has_half {
            Lost::Some
        } else {
            Lost::All
        }
    }
}

/// Notes a distance, unless it is infinite: a log holds numbers only.
#[inline]
pub(super) fn noted<P: Probe>(name: Name, t: f64, probe: &mut P) -> f64 {
    if t.is_finite() { probe.note(name, t) } else { t }
}
