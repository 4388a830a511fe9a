//! The flat disk: where the ray hits its plane, the squared distance from the centre decides.

use super::flat::{PlaneNames, meet_plane_certainly, refined, toward};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::geometry::size::unit;
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A disk. Its front is the side its normal points to.
#[derive(Clone, Debug, PartialEq)]
pub struct Disk {
    pub(super) center: DVec3,
    normal: DVec3,
    pub(super) unit_normal: DVec3,
    pub(super) radius: f64,
    radius_squared: f64,
}

const PLANE: PlaneNames = PlaneNames { v_d: Name::DiskVd, v_o: Name::DiskVo, t: Name::DiskT };

impl Disk {
    /// The disk with this centre, this normal of any length but zero, and this positive radius.
    pub fn new(center: DVec3, normal: DVec3, radius: f64) -> Disk {
        Disk { center, normal, unit_normal: unit(normal), radius, radius_squared: radius * radius }
    }
}

impl Kernel for Disk {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::DiskCenter, self.center);
        probe.given(Name::DiskNormal, self.normal);
        probe.given(Name::DiskUnitNormal, self.unit_normal);
        probe.given(Name::DiskRadius, self.radius);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let plane = meet_plane_certainly(ray, self.normal, self.center, (&PLANE, Name::DiskTDoubled), probe)?;
        let from_center = ray.origin + ray.direction * plane.t - self.center;
        let distance_squared = from_center.dot(from_center);
        let is_on_disk = distance_squared.is_finite()
            && probe.note(Name::DiskDistanceSquared, distance_squared) <= self.radius_squared;
        if !is_on_disk {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        let crossing = Crossing { t: plane.t, side: plane.side, primitive: 0 };
        self.decide(ray, approach, crossing, probe)
    }

    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let (front, back) = (Name::HitNormalDisk, Name::HitNormalDiskBack);
        let normal = toward(crossing.side, self.unit_normal, front, back, probe);
        Surface::plain(point, normal, crossing.side)
    }

    fn refined(&self, ray: &Ray, _crossing: Crossing) -> Doubled {
        refined(ray, self.normal, self.center)
    }

    /// Along an axis the disk reaches as far as its radius times the sine between the axis and the normal.
    fn bounds(&self) -> Option<Bounds> {
        let squares = self.unit_normal * self.unit_normal;
        let sine = |others: f64| others.sqrt();
        let sines = DVec3::new(sine(squares.y + squares.z), sine(squares.z + squares.x), sine(squares.x + squares.y));
        let reach = sines * self.radius;
        Some(Bounds { min: self.center - reach, max: self.center + reach }.widened())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ray::Side;
    use crate::probe::Silent;

    fn meets(x: f64) -> Option<Crossing> {
        let disk = Disk::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 0.0, -2.0), 0.5);
        let ray = Ray::new(DVec3::new(x, 2.0, 0.0), DVec3::Z);
        disk.first_crossing(&ray, Approach { leaving: None, one_sided: false }, &mut Silent)
    }

    #[test]
    fn the_rim_belongs_to_the_disk() {
        assert_eq!(meets(1.5), Some(Crossing { t: 3.0, side: Side::Front, primitive: 0 }));
        assert_eq!(meets(1.5_f64.next_up()), None);
        assert_eq!(meets(0.5), Some(Crossing { t: 3.0, side: Side::Front, primitive: 0 }));
    }

    #[test]
    fn the_box_is_flat_along_the_normal() {
        let disk = Disk::new(DVec3::ZERO, DVec3::Y * 7.0, 2.0);
        let bounds = disk.bounds().expect("a disk has an end");
        assert!((bounds.max - DVec3::new(2.0, 0.0, 2.0)).abs().max_element() < 1e-14, "{bounds:?}");
    }
}
