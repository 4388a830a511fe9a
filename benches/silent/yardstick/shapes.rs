//! Planes and spheres, and where rays cross them.

use glam::DVec3;

/// A shape.
pub enum Shape {
    Plane(Plane),
    Sphere(Sphere),
}

/// The plane normal·x + offset = 0.
pub struct Plane {
    pub normal: DVec3,
    pub offset: f64,
    pub unit_normal: DVec3,
}

/// A sphere; `is_geometric` are the formulas of the source text, else those that keep their digits; the front of one that
/// `is_hollow` is its inside.
pub struct Sphere {
    pub center: DVec3,
    pub radius: f64,
    pub radius_squared: f64,
    pub is_geometric: bool,
    pub is_hollow: bool,
}

/// A ray; it counts between `start` and `end`, and `from` is the object that it leaves and whether it sets off behind its
/// surface. Rounding may have moved its origin by `slack`: what lies no farther from an end is in the same place, and isn't crossed.
pub struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
    pub from: Option<(usize, bool)>,
    pub start: f64,
    pub end: f64,
    pub slack: f64,
}

/// Where a ray crosses a surface; from behind, if it does.
#[derive(Clone, Copy)]
pub struct Crossing {
    pub t: f64,
    pub behind: bool,
}

/// The end of a ray at which a crossing lies.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum End {
    Start,
    Light,
}

/// A bound of what rounding does to a point, as a part of the sizes of its numbers.
pub const ROUNDINGS: f64 = 32.0 * f64::EPSILON;

/// The part of a ray's line inside a sphere.
struct Chord {
    l2_oc: f64,
    t_a: f64,
    half: f64,
    is_outside: bool,
}

impl Ray {
    fn reaches(&self, crossing: Crossing) -> Option<Crossing> {
        (self.start < crossing.t && crossing.t < self.end).then_some(crossing)
    }

    /// Whether a crossing may lie at an end of the ray, seen however flat.
    #[inline(always)]
    fn is_near_an_end(&self, t: f64) -> bool {
        let near = (1_u64 << 40) as f64 * self.slack;
        self.start < t && t < self.end && (t <= near || self.end - t <= near)
    }

    /// Whether the ray leaves this object, and if so, whether it sets off behind its surface.
    fn leaves(&self, number: usize) -> Option<bool> {
        self.from.filter(|(from, _)| *from == number).map(|(_, behind)| behind)
    }
}

impl Shape {
    /// The first crossing with this shape, the object `number`, which may be there only for rays that arrive at its front.
    pub fn first_crossing(&self, number: usize, is_one_sided: bool, ray: &Ray) -> Option<Crossing> {
        match (self, ray.leaves(number)) {
            (Shape::Plane(_), Some(_)) => None,
            (Shape::Sphere(sphere), Some(behind)) if behind == sphere.is_hollow => None,
            (Shape::Plane(plane), None) => plane.first_crossing(false, is_one_sided, ray),
            (Shape::Sphere(sphere), leaves) => sphere.first_crossing(leaves.is_some(), is_one_sided, ray),
        }
    }

    /// All crossings with this shape, the object `number`, which is there on both sides.
    pub fn all_crossings(&self, number: usize, ray: &Ray) -> [Option<Crossing>; 2] {
        if let (Shape::Sphere(sphere), None) = (self, ray.leaves(number)) {
            return match sphere.chord(ray) {
                Some(chord) if chord.is_outside => {
                    [sphere.near(&chord), sphere.far(&chord)].map(|crossing| sphere.counted(ray, false, crossing))
                }
                Some(chord) => [sphere.counted(ray, false, sphere.far(&chord)), None],
                None => [None, None],
            };
        }
        [self.first_crossing(number, false, ray), None]
    }

    /// The point of a crossing, and the normal on the ray's side.
    pub fn surface(&self, ray: &Ray, crossing: Crossing) -> (DVec3, DVec3) {
        match self {
            Shape::Plane(plane) => plane.surface(ray, crossing),
            Shape::Sphere(sphere) => sphere.surface(ray, crossing),
        }
    }

    /// The greatest of the numbers that say where the surface is.
    pub fn size(&self) -> f64 {
        match self {
            Shape::Plane(plane) => plane.size(),
            Shape::Sphere(sphere) => sphere.size(),
        }
    }
}

/// How a ray hits a shape.
pub trait Meet {
    /// The first crossing of a ray that may leave this shape.
    fn first_crossing(&self, leaves: bool, is_one_sided: bool, ray: &Ray) -> Option<Crossing>;

    /// The point of a crossing, and the normal on the ray's side.
    fn surface(&self, ray: &Ray, crossing: Crossing) -> (DVec3, DVec3);

    /// The greatest of the numbers that say where the surface is.
    fn size(&self) -> f64;

    /// Whether a ray that begins on the surface begins where it crosses it so.
    fn may_begin(&self, _ray: &Ray, _behind: bool) -> bool {
        true
    }

    /// The end of the ray at which a crossing lies, as far as rounding can tell.
    #[cold]
    #[inline(never)]
    fn end_at(&self, ray: &Ray, leaves: bool, t: f64, behind: bool) -> Option<End> {
        let slope = self.surface(ray, Crossing { t, behind }).1.dot(ray.direction).abs();
        let is_at = |along: f64| ray.slack > 0.0 && (along * slope).abs() <= ray.slack + ROUNDINGS * self.size();
        if !leaves && is_at(t) {
            self.may_begin(ray, behind).then_some(End::Start)
        } else if is_at(ray.end - t) {
            Some(End::Light)
        } else {
            None
        }
    }

    /// A crossing that the ray reaches, unless it is an end of the ray.
    #[inline(always)]
    fn counted(&self, ray: &Ray, leaves: bool, crossing: Crossing) -> Option<Crossing> {
        let Crossing { t, behind } = crossing;
        let is_an_end = ray.is_near_an_end(t) && self.end_at(ray, leaves, t, behind).is_some();
        if is_an_end { None } else { ray.reaches(crossing) }
    }
}

impl Meet for Plane {
    #[inline(always)]
    fn first_crossing(&self, _leaves: bool, is_one_sided: bool, ray: &Ray) -> Option<Crossing> {
        let v_d = self.normal.dot(ray.direction);
        let t = -(self.normal.dot(ray.origin) + self.offset) / v_d;
        if v_d == 0.0 || !t.is_finite() || (is_one_sided && v_d > 0.0) {
            return None;
        }
        self.counted(ray, false, Crossing { t, behind: v_d > 0.0 })
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray, crossing: Crossing) -> (DVec3, DVec3) {
        let normal = if crossing.behind { -self.unit_normal } else { self.unit_normal };
        (ray.origin + ray.direction * crossing.t, normal)
    }

    fn size(&self) -> f64 {
        self.offset.abs() / self.normal.length()
    }
}

impl Meet for Sphere {
    #[inline(always)]
    fn first_crossing(&self, leaves: bool, is_one_sided: bool, ray: &Ray) -> Option<Crossing> {
        let crossing = if leaves {
            Crossing { t: 2.0 * (self.center - ray.origin).dot(ray.direction), behind: !self.is_hollow }
        } else {
            let chord = self.chord(ray)?;
            let near = (chord.is_outside && !(is_one_sided && self.is_hollow)).then(|| self.near(&chord));
            let begins_at = |near: &Crossing| {
                ray.is_near_an_end(near.t) && self.end_at(ray, false, near.t, near.behind) == Some(End::Start)
            };
            near.filter(|near| near.t > ray.start && !begins_at(near)).unwrap_or_else(|| self.far(&chord))
        };
        if is_one_sided && crossing.behind { None } else { self.counted(ray, leaves, crossing) }
    }

    #[inline(always)]
    fn surface(&self, ray: &Ray, crossing: Crossing) -> (DVec3, DVec3) {
        let is_outside = crossing.behind == self.is_hollow;
        let along = ray.origin + ray.direction * crossing.t;
        if self.is_geometric {
            let outward = if is_outside { along - self.center } else { self.center - along };
            return (along, outward / self.radius);
        }
        // From the centre on, so that the digits of the centre don't get into its normal.
        let from_center = ray.origin - self.center + ray.direction * crossing.t;
        let distance = from_center.length();
        if distance == 0.0 {
            return (along, -ray.direction);
        }
        let point = self.center + from_center * (self.radius / distance);
        let outward = if is_outside { from_center } else { -from_center };
        (point, outward / distance)
    }

    fn size(&self) -> f64 {
        (self.center.abs() + self.radius).max_element()
    }

    /// It begins at the nearer of the two crossings.
    fn may_begin(&self, ray: &Ray, behind: bool) -> bool {
        behind == self.is_hollow || (self.center - ray.origin).dot(ray.direction) < 0.0
    }
}

impl Sphere {
    #[inline]
    fn chord(&self, ray: &Ray) -> Option<Chord> {
        let oc = self.center - ray.origin;
        let l2_oc = oc.dot(oc);
        let t_a = oc.dot(ray.direction);
        let is_outside = l2_oc > self.radius_squared;
        if is_outside && t_a < 0.0 {
            return None;
        }
        let t2_a = if self.is_geometric {
            self.radius_squared - l2_oc + t_a * t_a
        } else {
            let beside = oc - ray.direction * t_a;
            self.radius_squared - beside.dot(beside)
        };
        if t2_a < 0.0 || (t2_a == 0.0 && t_a == 0.0) {
            return None;
        }
        Some(Chord { l2_oc, t_a, half: t2_a.sqrt(), is_outside })
    }

    #[inline]
    fn near(&self, chord: &Chord) -> Crossing {
        let t = if self.is_geometric {
            chord.t_a - chord.half
        } else {
            (chord.l2_oc - self.radius_squared) / (chord.t_a + chord.half)
        };
        Crossing { t, behind: self.is_hollow }
    }

    #[inline]
    fn far(&self, chord: &Chord) -> Crossing {
        let t = if chord.t_a < 0.0 && !self.is_geometric {
            (self.radius_squared - chord.l2_oc) / (chord.half - chord.t_a)
        } else {
            chord.t_a + chord.half
        };
        Crossing { t, behind: !self.is_hollow }
    }
}
