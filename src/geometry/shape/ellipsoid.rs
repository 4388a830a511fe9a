//! The ellipsoid: a linear map makes it a sphere, and the ray's distances stay what they are.
//!
//! The map is scaled so that the sphere has the largest of the radii: its quantities are as large as those of the scene,
//! and no direction gets shorter. By Lagrange's identity the discriminant b² − a·c is r²·|d'|² − |o' × d'|² (d' and o' the
//! mapped direction and origin), where a far origin doesn't cancel; nor do the roots (see [`Quadratic`]).

use super::doubled_chord::{DoubledChord, corrected_in};
use super::roots::{Digits, Lost, Quadratic, Root, Roots};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{Doubled, Doubled3, length};
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// An ellipsoid. Its front is the outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Ellipsoid {
    pub(super) center: DVec3,
    /// The rows of the map to the sphere, E_1, E_2, E_3.
    rows: [DVec3; 3],
    /// The rows with twice the digits.
    doubled_rows: Box<[Doubled3; 3]>,
    /// Whether the map stretches so much that what it makes of a vector is left of terms that cancel.
    is_elongated: bool,
    /// The square of the sphere's radius.
    radius_squared: f64,
    /// Half the sides of the box around the ellipsoid.
    extent: DVec3,
}

impl Ellipsoid {
    /// The ellipsoid center + rotation·(radii ∘ unit point); the rotation is given by its rows, its absence is none.
    pub fn new(center: DVec3, radii: DVec3, rotation: Option<[[f64; 3]; 3]>) -> Ellipsoid {
        let [x, y, z] = rotation.map_or([DVec3::X, DVec3::Y, DVec3::Z], |rows| rows.map(DVec3::from));
        let columns = [DVec3::new(x.x, y.x, z.x), DVec3::new(x.y, y.y, z.y), DVec3::new(x.z, y.z, z.z)];
        Ellipsoid::along(center, columns, radii.to_array(), radii.max_element())
    }

    /// The ellipsoid with these half axes, which may be any three vectors (the columns of a linear map of the unit
    /// sphere); `None` if they lie in a plane.
    pub fn with_axes(center: DVec3, axes: [DVec3; 3]) -> Option<Ellipsoid> {
        let largest = axes.map(DVec3::length).into_iter().fold(0.0, f64::max);
        let ellipsoid = Ellipsoid::along(center, axes, [1.0; 3], largest);
        ellipsoid.rows.iter().all(|row| row.is_finite()).then_some(ellipsoid)
    }

    /// The half axes are the columns times the radii. The columns needn't be quite perpendicular: the map is the inverse of
    /// the columns as they are.
    fn along(center: DVec3, columns: [DVec3; 3], radii: [f64; 3], largest: f64) -> Ellipsoid {
        // A row of the inverse is the cross product of the two other columns over the determinant.
        let doubled = columns.map(Doubled3::from);
        let row = |i: usize| {
            let across = doubled[(i + 1) % 3].cross(doubled[(i + 2) % 3]);
            let factor = Doubled::from(largest) / (doubled[i].dot(across) * Doubled::from(radii[i]));
            across.times(factor)
        };
        let doubled_rows = Box::new([row(0), row(1), row(2)]);
        let rows = doubled_rows.map(Doubled3::value);
        let is_elongated = rows.iter().any(|row| row.length() > LONGEST);
        let extent_squared: DVec3 = (0..3).map(|i| columns[i] * radii[i]).map(|axis| axis * axis).sum();
        let extent = DVec3::new(extent_squared.x.sqrt(), extent_squared.y.sqrt(), extent_squared.z.sqrt());
        Ellipsoid { center, rows, doubled_rows, is_elongated, radius_squared: largest * largest, extent }
    }

    /// Its half axes: the columns of the map's inverse times the sphere's radius.
    pub(super) fn half_axes(&self) -> [DVec3; 3] {
        let [x, y, z] = self.rows;
        let factor = self.radius_squared.sqrt() / x.dot(y.cross(z));
        [y.cross(z), z.cross(x), x.cross(y)].map(|column| column * factor)
    }

    /// A vector of the scene in the sphere's space, each component under its own name.
    #[inline]
    fn mapped<P: Probe>(&self, vector: DVec3, [x, y, z]: [Name; 3], probe: &mut P) -> DVec3 {
        let x = probe.note(x, probe.dot(self.rows[0], vector));
        let y = probe.note(y, probe.dot(self.rows[1], vector));
        let z = probe.note(z, probe.dot(self.rows[2], vector));
        DVec3::new(x, y, z)
    }

    /// The roots with twice the digits.
    #[cold]
    #[inline(never)]
    fn doubled_roots<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Roots> {
        probe.fallback();
        let chord = self.doubled_chord(ray);
        if chord.is_beside {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        let root = |t: Doubled, name| Root { t: t.value(), primitive: 0, is_on_surface: true, name };
        let (entry, exit) = (root(chord.near, Name::EllipsoidTDoubled), root(chord.far, Name::EllipsoidTDoubledFar));
        Some(Roots { entry, exit, outer: Side::Front })
    }

    fn doubled_chord(&self, ray: &Ray) -> DoubledChord {
        let [row_1, row_2, row_3] = *self.doubled_rows;
        let mapped = |v: Doubled3| Doubled3 { x: row_1.dot(v), y: row_2.dot(v), z: row_3.dot(v) };
        let oc = mapped(Doubled3::difference(self.center, ray.origin));
        let radius = self.radius_squared.sqrt();
        let radius_squared = Doubled::product(radius, radius);
        let vector = mapped(Doubled3::from(ray.vector));
        DoubledChord::in_sphere(oc, vector, oc.dot(oc) - radius_squared, radius_squared, length(ray.vector))
    }

    #[inline]
    fn roots<P: Probe>(&self, ray: &Ray, is_leaving: bool, probe: &mut P) -> Option<Roots> {
        let from_center = probe.note(Name::EllipsoidOrigin, ray.origin - self.center);
        let origin = self.mapped(from_center, ORIGIN, probe);
        let direction = self.mapped(ray.direction, DIRECTION, probe);
        let a = probe.note(Name::EllipsoidA, direction.dot(direction));
        let b = probe.note(Name::EllipsoidB, origin.dot(direction));
        let c = probe.note(Name::EllipsoidC, origin.dot(origin) - self.radius_squared);
        probe.mark(if c > 0.0 { Decision::Outside } else { Decision::Inside });
        let across = origin.cross(direction);
        let discriminant = self.radius_squared * a - across.dot(across);
        let discriminant = probe.note(Name::EllipsoidDiscriminant, discriminant);
        let doubt = OF_DISCRIMINANT * a * (origin.dot(origin) + self.radius_squared);
        if probe.certifies() && (self.is_elongated || discriminant.abs() <= doubt) {
            return self.doubled_roots(ray, probe);
        }
        // Arithmetic with few digits can round the direction away.
        let crosses = discriminant >= 0.0 && a > 0.0;
        let equation = Quadratic { a, b, c, discriminant };
        let names = [Name::EllipsoidT1, Name::EllipsoidT2];
        let Some([first, second]) = crosses.then(|| equation.roots(names, probe)).flatten() else {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        };
        let root = |(t, name)| Root { t, primitive: 0, is_on_surface: true, name };
        let (entry, exit) = if first.0 < second.0 { (first, second) } else { (second, first) };
        let (mut entry, mut exit) = (root(entry), root(exit));
        if probe.certifies() {
            let digits = Digits::of(&equation, origin.dot(origin), across.dot(across));
            // A ray that leaves the surface has been at one root already, of which there are no digits.
            let left = if is_leaving { entry.t.abs().min(exit.t.abs()) } else { -1.0 };
            let doubled = [Name::EllipsoidTDoubled, Name::EllipsoidTDoubledFar];
            for (root, doubled) in [&mut entry, &mut exit].into_iter().zip(doubled) {
                if root.t.abs() == left {
                    continue;
                }
                match digits.of_root(root.t, root.name == Name::EllipsoidT2, ray) {
                    Lost::Nothing => {}
                    Lost::Some => self.correct(root, doubled, ray, probe),
                    Lost::All => return self.doubled_roots(ray, probe),
                }
            }
        }
        Some(Roots { entry, exit, outer: Side::Front })
    }

    /// Gives a distance all of its digits.
    #[cold]
    #[inline(never)]
    fn correct<P: Probe>(&self, root: &mut Root, doubled: Name, ray: &Ray, probe: &mut P) {
        probe.fallback();
        let [row_1, row_2, row_3] = *self.doubled_rows;
        let map = |v: Doubled3| Doubled3 { x: row_1.quick_dot(v), y: row_2.quick_dot(v), z: row_3.quick_dot(v) };
        let along = DVec3::from_array(self.rows.map(|row| row.dot(ray.vector)));
        let radius = self.radius_squared.sqrt();
        root.t = corrected_in(map, along, self.center, Doubled::product(radius, radius), ray, root.t);
        root.name = doubled;
    }
}

/// The greatest ratio of half axes that f64 alone copes with.
const LONGEST: f64 = 8.0;

/// A bound of the error of the discriminant in parts of a·(o'·o' + r²): of 2⁻⁵³, four for each component of the mapped vectors
/// (one of the row, one of the ray, two of the sum), so that o' × d' errs by ten of |o'|·|d'| and its square by twenty and
/// five for its own sum; r²·a by twelve.
const OF_DISCRIMINANT: f64 = 24.0 * f64::EPSILON;

const ORIGIN: [Name; 3] = [Name::EllipsoidOrigin1, Name::EllipsoidOrigin2, Name::EllipsoidOrigin3];
const DIRECTION: [Name; 3] = [Name::EllipsoidDirection1, Name::EllipsoidDirection2, Name::EllipsoidDirection3];
const POINT: [Name; 3] = [Name::EllipsoidPoint1, Name::EllipsoidPoint2, Name::EllipsoidPoint3];

impl Kernel for Ellipsoid {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::EllipsoidCenter, self.center);
        probe.given(Name::EllipsoidRow1, self.rows[0]);
        probe.given(Name::EllipsoidRow2, self.rows[1]);
        probe.given(Name::EllipsoidRow3, self.rows[2]);
        probe.given(Name::EllipsoidRadiusSquared, self.radius_squared);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let at_an_end = |crossing| self.at_an_end(ray, approach, crossing);
        self.roots(ray, approach.leaving.is_some(), probe)?.first(ray, approach, at_an_end, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if let Some(roots) = self.roots(ray, approach.leaving.is_some(), probe) {
            roots.all(ray, approach, |crossing| self.at_an_end(ray, approach, crossing), found, probe);
        }
    }

    /// Rounding took the point off the surface; one step of Newton's method along the gradient puts it back. (Scaling it
    /// back from the centre would move a point of a flat ellipsoid far along the surface.)
    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let from_center = ray.origin - self.center + ray.direction * crossing.t;
        let from_center = probe.note(Name::EllipsoidPoint, from_center);
        let mapped = self.mapped(from_center, POINT, probe);
        let offset = probe.note(Name::EllipsoidOffset, mapped.dot(mapped) - self.radius_squared);
        let [row_1, row_2, row_3] = self.rows;
        let gradient = row_1 * mapped.x + row_2 * mapped.y + row_3 * mapped.z;
        let gradient = probe.note(Name::EllipsoidGradient, gradient);
        let steepness_squared = probe.dot(gradient, gradient);
        if steepness_squared == 0.0 {
            // Too small for the arithmetic: all that is left of it faces the ray.
            let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
            let normal = probe.note(Name::HitNormalFacing, -ray.direction);
            return Surface::plain(point, normal, crossing.side);
        }
        let step = gradient * (offset / (2.0 * steepness_squared));
        let point = probe.note(Name::HitPointEllipsoid, self.center + (from_center - step));
        let normal = match crossing.side {
            Side::Front => probe.note(Name::HitNormalEllipsoid, gradient / gradient.length()),
            Side::Back => probe.note(Name::HitNormalEllipsoidBack, -gradient / gradient.length()),
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds { min: self.center - self.extent, max: self.center + self.extent })
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let chord = self.doubled_chord(ray);
        if crossing.side == Side::Front { chord.near } else { chord.far }
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        sets_off == Side::Back
    }
}
