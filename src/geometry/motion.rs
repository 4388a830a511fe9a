//! Rigid motions: a turn about an axis, and then a shift, both proportional to time.

use super::bounds::Bounds;
use super::ray::{Ray, Surface};
use super::unit::unit;
use crate::log::Name;
use crate::probe::{Probe, Silent};
use glam::DVec3;

/// A motion: at time t an object is first turned by t times the angle, then moved by t times the translation.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// How far it moves in a unit of time.
    pub translation: DVec3,
    /// How it turns.
    pub turn: Option<Turn>,
}

/// A turn about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// The unit vector along the axis.
    axis: DVec3,
    /// A point on it.
    point: DVec3,
    /// Degrees in a unit of time, counter-clockwise for whoever the axis points at.
    degrees: f64,
}

impl Turn {
    /// A turn about an axis, of any length but zero, through a point, by this many degrees in a unit of time.
    pub fn new(axis: DVec3, point: DVec3, degrees: f64) -> Turn {
        Turn { axis: unit(axis).0, point, degrees }
    }
}

/// Where a motion has brought an object at one time.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    shift: DVec3,
    turned: Option<Turned>,
}

#[derive(Clone, Copy, Debug)]
struct Turned {
    axis: DVec3,
    point: DVec3,
    cos: f64,
    sin: f64,
}

impl Turned {
    /// v·cos φ + (a × v)·sin φ + a·((a · v)·(1 − cos φ)) (Rodrigues, 1840).
    fn forth<P: Probe>(&self, v: DVec3, probe: &P) -> DVec3 {
        v * self.cos + self.axis.cross(v) * self.sin + self.axis * (probe.dot(self.axis, v) * (1.0 - self.cos))
    }

    /// The same by −φ.
    fn back<P: Probe>(&self, v: DVec3, probe: &P) -> DVec3 {
        v * self.cos - self.axis.cross(v) * self.sin + self.axis * (probe.dot(self.axis, v) * (1.0 - self.cos))
    }
}

/// Cosine and sine of an angle in degrees; exact for quarters of a turn, whole turns left out.
fn cos_sin(degrees: f64) -> [f64; 2] {
    let degrees = libm::fmod(degrees, 360.0);
    let quarters = (degrees / 90.0).round();
    // Without rounding: both are multiples of the unit in the last place of the greater one.
    let rest = (degrees - quarters * 90.0).to_radians();
    let (cos, sin) = (libm::cos(rest), libm::sin(rest));
    match quarters.rem_euclid(4.0) as u8 {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    }
}

impl Motion {
    /// The size of its numbers: how far the object moves in a unit of time, and where it turns.
    pub fn size(&self) -> f64 {
        let pivot = self.turn.map_or(DVec3::ZERO, |turn| turn.point);
        self.translation.abs().max_element() + pivot.abs().max_element()
    }

    /// Where the object is at a time.
    pub fn at<P: Probe>(&self, time: f64, probe: &mut P) -> Pose {
        probe.given(Name::RayTime, time);
        probe.given(Name::MotionTranslation, self.translation);
        let shift = probe.note(Name::MotionShift, self.translation * time);
        let turned = self.turn.map(|Turn { axis, point, degrees }| {
            probe.given(Name::MotionAxis, axis);
            probe.given(Name::MotionPoint, point);
            probe.given(Name::MotionDegrees, degrees);
            let angle = probe.note(Name::MotionAngle, degrees * time);
            let [cos, sin] = cos_sin(angle);
            let cos = probe.note(Name::MotionCos, cos);
            let sin = probe.note(Name::MotionSin, sin);
            Turned { axis, point, cos, sin }
        });
        Pose { shift, turned }
    }

    /// A box around everything that a box holds while time goes from one end of the interval to the other.
    ///
    /// A point that turns stays within r·Δ²/8 of the chord while the angle grows by Δ, as its acceleration is r·Δ² in a unit of time; a
    /// shift bends nothing. Points of a box are means of its corners, and so are their ways.
    pub fn sweep(&self, bounds: Bounds, [from, to]: [f64; 2]) -> Bounds {
        const PIECES: u32 = 32;
        let degrees = self.turn.map_or(0.0, |turn| (turn.degrees * (to - from)).abs());
        let pieces = if degrees == 0.0 { 1 } else { PIECES };
        let bend = (degrees / f64::from(pieces)).to_radians();
        let mut swept = Bounds::EMPTY;
        let silent = &mut crate::probe::Silent;
        let poses: Vec<_> = (0..=pieces)
            .map(|k| {
                self.at(if k == pieces { to } else { from + (to - from) * (f64::from(k) / f64::from(pieces)) }, silent)
            })
            .collect();
        for corner in bounds.corners() {
            let radius = self.turn.map_or(0.0, |turn| (corner - turn.point).cross(turn.axis).length());
            // Beyond a whole turn no point lies farther from the chord than the circle is wide.
            let margin = radius * (bend * bend / 8.0).min(2.0);
            for pose in &poses {
                let place = pose.forth_point(corner);
                let point = self.turn.map_or(DVec3::ZERO, |turn| turn.point);
                let size = place.abs().max(corner.abs()).max(point.abs()).max(pose.shift.abs()).max_element();
                let around = DVec3::splat(margin * (1.0 + 1e-9) + ROUNDINGS * size);
                swept = swept.with(place - around).with(place + around);
            }
        }
        swept
    }
}

/// How far rounding may have moved a point, there and back, as a part of the greatest number in it.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

impl Pose {
    /// The constants and what was noted of them, for formulas in another node than that of the pose.
    pub fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::MotionShift, self.shift);
        if let Some(turned) = &self.turned {
            probe.given(Name::MotionAxis, turned.axis);
            probe.given(Name::MotionPoint, turned.point);
            probe.given(Name::MotionCos, turned.cos);
            probe.given(Name::MotionSin, turned.sin);
        }
    }

    fn forth_point(&self, own: DVec3) -> DVec3 {
        match &self.turned {
            None => own + self.shift,
            Some(turned) => turned.forth(own - turned.point, &Silent) + turned.point + self.shift,
        }
    }

    /// The ray as the object sees it in its own frame. Distances are the same.
    pub fn own_ray<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Ray {
        let Some(turned) = &self.turned else {
            let origin = probe.note(Name::RayOriginShifted, ray.origin - self.shift);
            return Ray { origin, slack: self.own_slack(ray, probe), ..*ray };
        };
        let arm = probe.note(Name::MotionArm, ray.origin - self.shift - turned.point);
        let origin = probe.note(Name::RayOriginTurned, turned.back(arm, probe) + turned.point);
        let direction = probe.note(Name::RayDirectionTurned, turned.back(ray.direction, probe));
        Ray { origin, direction, vector: direction, slack: self.own_slack(ray, probe), ..*ray }
    }

    /// The ray's slack with the roundings of the way into the object's own frame; a given origin stays exact.
    fn own_slack<P: Probe>(&self, ray: &Ray, probe: &P) -> f64 {
        if ray.slack == 0.0 {
            return 0.0;
        }
        let pivot = self.turned.as_ref().map_or(DVec3::ZERO, |turned| turned.point);
        let size = ray.origin.abs().element_sum() + self.shift.abs().element_sum() + 2.0 * pivot.abs().element_sum();
        ray.slack + probe.slack(size)
    }

    /// A point of the moved object where it was before, for its pattern.
    pub fn own_point<P: Probe>(&self, point: DVec3, probe: &mut P) -> DVec3 {
        let Some(turned) = &self.turned else { return probe.note(Name::PatternPointShifted, point - self.shift) };
        let arm = probe.note(Name::MotionArmPattern, point - self.shift - turned.point);
        probe.note(Name::PatternPointTurned, turned.back(arm, probe) + turned.point)
    }

    /// A direction of the moved object as it was before.
    pub fn own_direction(&self, direction: DVec3) -> DVec3 {
        self.turned.as_ref().map_or(direction, |turned| turned.back(direction, &Silent))
    }

    /// The surface in the object's own frame, carried to where it is.
    pub fn surface<P: Probe>(&self, own: Surface, probe: &mut P) -> Surface {
        self.give(probe);
        probe.given(Name::MotionHitPoint, own.point);
        let point = match &self.turned {
            None => probe.note(Name::HitPointShifted, own.point + self.shift),
            Some(turned) => {
                let arm = probe.note(Name::MotionArmHit, own.point - turned.point);
                probe.note(Name::HitPointTurned, turned.forth(arm, probe) + turned.point + self.shift)
            }
        };
        let beneath = own.beneath.map(|normal| {
            probe.given(Name::MotionGeometricNormal, normal);
            match &self.turned {
                None => probe.note(Name::HitGeometricNormalShifted, normal),
                Some(turned) => probe.note(Name::HitGeometricNormalTurned, turned.forth(normal, probe)),
            }
        });
        probe.given(Name::MotionHitNormal, own.normal);
        let normal = match &self.turned {
            None => probe.note(Name::HitNormalShifted, own.normal),
            Some(turned) => probe.note(Name::HitNormalTurned, turned.forth(own.normal, probe)),
        };
        Surface { point, normal, beneath, side: own.side }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_of_a_turn_are_exact() {
        for (degrees, expected) in [(0.0, [1.0, 0.0]), (90.0, [0.0, 1.0]), (180.0, [-1.0, 0.0]), (-90.0, [0.0, -1.0])] {
            for turns in [-2.0, 0.0, 1e6] {
                assert_eq!(cos_sin(degrees + 360.0 * turns), expected, "{degrees}, {turns}");
            }
        }
        for k in -800..800 {
            let degrees = f64::from(k) * 1.37;
            let [cos, sin] = cos_sin(degrees);
            let radians = degrees.to_radians();
            assert!((cos - libm::cos(radians)).abs() + (sin - libm::sin(radians)).abs() < 1e-14, "{degrees}");
        }
    }

    #[test]
    fn the_swept_box_holds_every_moment() {
        let bounds = Bounds { min: DVec3::new(1.0, -2.0, 0.5), max: DVec3::new(2.0, 0.0, 3.0) };
        for degrees in [0.0, 10.0, 170.0, 900.0, -1e5] {
            for axis in [DVec3::X, DVec3::new(1.0, -3.0, 0.2)] {
                let turn = Some(Turn::new(axis, DVec3::new(0.3, 5.0, -1.0), degrees));
                let motion = Motion { translation: DVec3::new(7.0, 0.0, -0.5), turn };
                let swept = motion.sweep(bounds, [-0.25, 1.5]);
                for k in 0..=5000 {
                    let pose = motion.at(-0.25 + 1.75 * f64::from(k) / 5000.0, &mut crate::probe::Silent);
                    assert!(bounds.corners().all(|corner| swept.contains(pose.forth_point(corner))), "{degrees} {k}");
                }
            }
        }
    }
}
