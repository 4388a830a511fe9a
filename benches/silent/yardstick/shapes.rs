//! Planes and spheres, and where rays cross them.

use glam::DVec3;

/// A shape; `is_geometric` are the formulas of the source text, else those that keep their digits.
pub enum Shape {
    Plane { normal: DVec3, offset: f64, unit_normal: DVec3 },
    Sphere { center: DVec3, radius: f64, radius_squared: f64, is_geometric: bool },
}

/// A ray; it counts between `start` and `end`, and `from` is the object that it leaves and whether it sets off behind its
/// surface.
pub struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
    pub from: Option<(usize, bool)>,
    pub start: f64,
    pub end: f64,
}

/// Where a ray crosses a surface; from behind, if it does.
#[derive(Clone, Copy)]
pub struct Crossing {
    pub t: f64,
    pub behind: bool,
}

/// The part of a ray's line inside a sphere.
struct Chord {
    l2_oc: f64,
    t_a: f64,
    half: f64,
    radius_squared: f64,
    is_outside: bool,
    is_geometric: bool,
}

impl Ray {
    fn reaches(&self, crossing: Crossing) -> Option<Crossing> {
        (self.start < crossing.t && crossing.t < self.end).then_some(crossing)
    }

    /// Whether the ray leaves this object, and if so, whether it sets off behind its surface.
    fn leaves(&self, number: usize) -> Option<bool> {
        self.from.filter(|(from, _)| *from == number).map(|(_, behind)| behind)
    }
}

impl Shape {
    /// The first crossing with this shape, the object `number`.
    pub fn first_crossing(&self, number: usize, ray: &Ray) -> Option<Crossing> {
        let crossing = match (self, ray.leaves(number)) {
            (Shape::Plane { .. }, Some(_)) | (Shape::Sphere { .. }, Some(false)) => return None,
            (Shape::Plane { normal, offset, .. }, None) => {
                let v_d = normal.dot(ray.direction);
                if v_d == 0.0 {
                    return None;
                }
                Crossing { t: -(normal.dot(ray.origin) + offset) / v_d, behind: v_d > 0.0 }
            }
            (Shape::Sphere { center, .. }, Some(true)) => {
                Crossing { t: 2.0 * (*center - ray.origin).dot(ray.direction), behind: true }
            }
            (Shape::Sphere { center, radius_squared, is_geometric, .. }, None) => {
                let chord = Chord::new(*center, *radius_squared, *is_geometric, ray)?;
                if chord.is_outside {
                    let near = chord.near();
                    if near.t > ray.start { near } else { chord.far() }
                } else {
                    chord.far()
                }
            }
        };
        ray.reaches(crossing)
    }

    /// All crossings with this shape, the object `number`.
    pub fn all_crossings(&self, number: usize, ray: &Ray) -> [Option<Crossing>; 2] {
        if let (Shape::Sphere { center, radius_squared, is_geometric, .. }, None) = (self, ray.leaves(number)) {
            return match Chord::new(*center, *radius_squared, *is_geometric, ray) {
                Some(chord) if chord.is_outside => [ray.reaches(chord.near()), ray.reaches(chord.far())],
                Some(chord) => [ray.reaches(chord.far()), None],
                None => [None, None],
            };
        }
        [self.first_crossing(number, ray), None]
    }

    /// The point of a crossing, and the normal on the ray's side.
    pub fn surface(&self, ray: &Ray, crossing: Crossing) -> (DVec3, DVec3) {
        let along = ray.origin + ray.direction * crossing.t;
        match self {
            Shape::Plane { unit_normal, .. } => (along, if crossing.behind { -*unit_normal } else { *unit_normal }),
            Shape::Sphere { center, radius, is_geometric, .. } => {
                let point = if *is_geometric {
                    along
                } else {
                    let from_center = along - *center;
                    *center + from_center * (*radius / from_center.length())
                };
                let outward = if crossing.behind { *center - point } else { point - *center };
                (point, outward / *radius)
            }
        }
    }
}

impl Chord {
    fn new(center: DVec3, radius_squared: f64, is_geometric: bool, ray: &Ray) -> Option<Chord> {
        let oc = center - ray.origin;
        let l2_oc = oc.dot(oc);
        let t_a = oc.dot(ray.direction);
        let is_outside = l2_oc > radius_squared;
        if is_outside && t_a < 0.0 {
            return None;
        }
        let t2_a = if is_geometric {
            radius_squared - l2_oc + t_a * t_a
        } else {
            let beside = oc - ray.direction * t_a;
            radius_squared - beside.dot(beside)
        };
        if t2_a < 0.0 || (t2_a == 0.0 && t_a == 0.0) {
            return None;
        }
        Some(Chord { l2_oc, t_a, half: t2_a.sqrt(), radius_squared, is_outside, is_geometric })
    }

    fn near(&self) -> Crossing {
        let t = if self.is_geometric {
            self.t_a - self.half
        } else {
            (self.l2_oc - self.radius_squared) / (self.t_a + self.half)
        };
        Crossing { t, behind: false }
    }

    fn far(&self) -> Crossing {
        let t = if self.t_a < 0.0 && !self.is_geometric {
            (self.radius_squared - self.l2_oc) / (self.half - self.t_a)
        } else {
            self.t_a + self.half
        };
        Crossing { t, behind: true }
    }
}
