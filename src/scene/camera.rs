//! The eye: which ray goes through which place of the picture.

use super::aim::along;
use super::lens::Lens;
use crate::geometry::Ray;
use crate::geometry::size::unit;
use crate::geometry::unit::middling;
use crate::log::Name;
use crate::probe::{Probe, Silent};
use crate::random::{Dimension, Draws};
use glam::DVec3;

/// A camera with square pixels: a pinhole, or a thin lens.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    position: DVec3,
    /// The direction of view as given; its length doesn't matter.
    direction: DVec3,
    /// The direction that is up as given, somewhere above `direction`.
    up_as_given: DVec3,
    length: f64,
    right: DVec3,
    up: DVec3,
    /// In degrees.
    vertical_fov: f64,
    /// The side of a pixel in the plane at distance 1.
    pixel_side: f64,
    /// Pixels across and down.
    pub resolution: [u32; 2],
    /// When the shutter opens and closes; `None` where nothing moves.
    pub shutter: Option<[f64; 2]>,
    /// The lens; `None` for a pinhole.
    pub lens: Option<Lens>,
}

impl Camera {
    /// A camera at `position` that looks along `direction`, of any length, with `up` not parallel to it, and
    /// `vertical_fov` degrees from the picture's top edge to its bottom edge.
    pub fn new(position: DVec3, direction: DVec3, up: DVec3, vertical_fov: f64, resolution: [u32; 2]) -> Camera {
        // Of middling size, so that no product of them vanishes or overflows; the digits are the same.
        let (along, upward) = (middling(direction), middling(up));
        let to_right = along.cross(upward);
        let half_height = libm::tan(vertical_fov.to_radians() / 2.0);
        Camera {
            position,
            direction,
            up_as_given: up,
            length: direction.length(),
            right: unit(to_right),
            up: unit(to_right.cross(along)),
            vertical_fov,
            pixel_side: 2.0 * half_height / f64::from(resolution[1]),
            resolution,
            shutter: None,
            lens: None,
        }
    }

    /// The direction of view as given, of any length.
    pub fn direction(&self) -> DVec3 {
        self.direction
    }

    /// The place of the picture, in pixels from its top left corner, at which a point is seen; `None` for what doesn't lie in
    /// front of the eye.
    pub fn place_of(&self, point: DVec3) -> Option<[f64; 2]> {
        let away = point - self.position;
        let depth = away.dot(self.direction) / self.length * self.pixel_side;
        let [half_width, half_height] = self.resolution.map(|side| f64::from(side) / 2.0);
        let place = [half_width + away.dot(self.right) / depth, half_height - away.dot(self.up) / depth];
        (depth > 0.0 && place.iter().all(|side| side.is_finite())).then_some(place)
    }

    /// Whether a point lies in the field of view, whatever is before it.
    pub fn sees(&self, point: DVec3) -> bool {
        let away = point - self.position;
        let depth = away.dot(self.direction) / self.length;
        let [half_width, half_height] = self.resolution.map(|side| f64::from(side) / 2.0 * self.pixel_side * depth);
        depth > 0.0 && away.dot(self.right).abs() <= half_width && away.dot(self.up).abs() <= half_height
    }

    /// The time at which the shutter opens: that of rays of which nobody knows a sample.
    pub fn opening(&self) -> f64 {
        self.shutter.map_or(0.0, |[open, _]| open)
    }

    /// The ray of a sample through a place of the picture, in pixels from its top left corner: from a point of the lens, at a time
    /// while the shutter is open.
    #[inline(always)]
    pub fn sampled_ray<P: Probe>(&self, place: [f64; 2], draws: &Draws, probe: &mut P) -> Option<Ray> {
        if self.lens.is_none() && self.shutter.is_none() {
            return self.ray(place, probe);
        }
        self.distributed_ray(place, draws, probe)
    }

    // Kept out of the way of a pinhole before which nothing moves.
    #[inline(never)]
    fn distributed_ray<P: Probe>(&self, place: [f64; 2], draws: &Draws, probe: &mut P) -> Option<Ray> {
        let ray = match &self.lens {
            None => self.ray(place, probe)?,
            Some(lens) => lens.ray(self.position, self.frame_through(place, probe), draws, probe)?,
        };
        let time = self.shutter.map_or(0.0, |shutter| time_within(shutter, draws, probe));
        Some(Ray { time, ..ray })
    }

    /// The pinhole's ray through a place of the picture, in pixels from its top left corner.
    ///
    /// Through the centre it has the direction of view as given, normalised; others normalise
    /// G + |G|·(x·e_x + y·e_y), x and y measured in the plane at distance 1.
    // Like what it calls a part of its callers, so that the ray is made where it is used and not copied.
    #[inline(always)]
    pub fn ray<P: Probe>(&self, [column, row]: [f64; 2], probe: &mut P) -> Option<Ray> {
        let middle = self.resolution.map(|side| f64::from(side) / 2.0);
        probe.given(Name::RayOrigin, self.position);
        let vector = if [column, row] == middle {
            probe.given(Name::RayVector, self.direction);
            self.direction
        } else {
            self.frame_through([column, row], probe).2
        };
        along(self.position, vector, probe)
    }

    /// The direction to a place of the picture, in pixels from its top left corner, not normalised: linear in the place.
    pub fn vector_through(&self, place: [f64; 2]) -> DVec3 {
        self.frame_through(place, &mut Silent).2
    }

    /// Which way is up in the picture: a unit vector.
    pub fn up(&self) -> DVec3 {
        self.up
    }

    /// The eye, or the lens's centre.
    pub fn position(&self) -> DVec3 {
        self.position
    }

    /// |G|, with the products of G · G rounded where the arithmetic does that.
    #[inline(always)]
    fn length_by<P: Probe>(&self, probe: &P) -> f64 {
        match probe.decimals_of_products() {
            None => self.length,
            Some(_) => probe.dot(self.direction, self.direction).sqrt(),
        }
    }

    /// |G|, e_x and e_y, and D = G + |G|·(x·e_x + y·e_y). What doesn't depend on the pixel was computed with the camera, by the same
    /// formulas.
    #[inline(always)]
    pub(super) fn frame_through<P: Probe>(&self, [column, row]: [f64; 2], probe: &mut P) -> (f64, [DVec3; 2], DVec3) {
        let middle = self.resolution.map(|side| f64::from(side) / 2.0);
        probe.given(Name::CameraDirection, self.direction);
        let length = probe.note(Name::CameraLength, self.length_by(probe));
        probe.given(Name::CameraUpAsGiven, self.up_as_given);
        let right = probe.note(Name::CameraRight, self.right);
        let up = probe.note(Name::CameraUp, self.up);
        probe.given(Name::PixelColumn, column);
        probe.given(Name::PixelMiddleColumn, middle[0]);
        probe.given(Name::CameraVerticalFov, self.vertical_fov);
        probe.given(Name::CameraRows, f64::from(self.resolution[1]));
        probe.given(Name::PixelSide, self.pixel_side);
        let x = probe.note(Name::PixelX, (column - middle[0]) * self.pixel_side);
        probe.given(Name::PixelRow, row);
        probe.given(Name::PixelMiddleRow, middle[1]);
        let y = probe.note(Name::PixelY, (middle[1] - row) * self.pixel_side);
        let vector = probe.note(Name::RayVector, self.direction + (right * x + up * y) * length);
        (length, [right, up], vector)
    }
}

/// A time while the shutter is open.
fn time_within<P: Probe>([open, close]: [f64; 2], draws: &Draws, probe: &mut P) -> f64 {
    if open == close {
        probe.given(Name::RayTime, open);
        return open;
    }
    let part = draws.number(Dimension::Time);
    probe.given(Name::ShutterOpen, open);
    probe.given(Name::SampleTime, part);
    probe.given(Name::ShutterClose, close);
    probe.note(Name::RayTimeSampled, open + part * (close - open))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_seen_where_its_ray_goes() {
        let (eye, up) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.1, 1.0, 0.0));
        let camera = Camera::new(eye, DVec3::new(2.0, -1.0, 0.5), up, 50.0, [30, 20]);
        for place in [[0.0, 0.0], [15.0, 10.0], [29.5, 3.25], [-4.0, 21.0]] {
            let ray = camera.ray(place, &mut Silent).expect("a direction");
            for distance in [0.5, 7.0] {
                let seen = camera.place_of(eye + ray.direction * distance).expect("a place");
                assert!((0..2).all(|axis| (seen[axis] - place[axis]).abs() < 1e-12), "{place:?} {seen:?}");
            }
            assert_eq!(camera.place_of(eye - ray.direction), None);
        }
        assert_eq!(camera.place_of(eye), None);
    }

    #[test]
    fn the_axes_need_no_middling_size() {
        let of_size = |along: f64, up: f64| {
            let camera = Camera::new(
                DVec3::ZERO,
                DVec3::new(2.0, -1.0, 0.5) * along,
                DVec3::new(0.1, 1.0, 0.0) * up,
                50.0,
                [3, 2],
            );
            (camera.right, camera.up)
        };
        let plain = of_size(1.0, 1.0);
        assert!((plain.0.length() - 1.0).abs() < 1e-15 && plain.0.dot(plain.1).abs() < 1e-15);
        let power = |exponent: i32| f64::from_bits(((1023 + exponent) as u64) << 52);
        for [along, up] in [[-490, -490], [330, 330], [-490, 330], [330, -490]] {
            assert_eq!(of_size(power(along), power(up)), plain, "2^{along}, 2^{up}");
        }
    }
}
