//! The outline of a ball or a disk in the picture: an ellipse.

use crate::geometry::shape::Round;
use crate::scene::Camera;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// An ellipse in the picture, in pixels: the image of the unit circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    center: DVec2,
    /// Lᵀ of S = L·Lᵀ, row by row, where (x − center)ᵀ·S·(x − center) ≤ 1 inside: what makes a circle of the ellipse.
    to_circle: [DVec2; 2],
    /// The shortest diameter.
    width: f64,
}

/// The corners of the polygon around an ellipse.
const CORNERS: u32 = 24;

impl Ellipse {
    /// The outline of a shape that lies in front of the eye; `None` where it isn't an ellipse: of a disk seen from its edge, or of what
    /// reaches beside the eye.
    ///
    /// With d = d_0 + x·d_x + y·d_y the direction to the place (x, y), counted from where the centre is seen, a line in that direction meets
    /// the unit ball that the shape becomes under M where |e × Md|² ≤ |Md|², with e = M(eye − centre); and a disk where
    /// |N × (e × d)|² ≤ r²(N·d)², with e = eye − centre. Both are quadratic forms in (1, x, y), in which nothing cancels that was large.
    pub fn seen(camera: &Camera, round: &Round) -> Option<Ellipse> {
        let from = DVec2::from(camera.place_of(round.center())?);
        // Differences over the whole picture, which hardly cancel.
        let [width, height] = camera.resolution.map(f64::from);
        let direction = |x: f64, y: f64| camera.vector_through([from.x + x, from.y + y]);
        let along = |to: DVec3, back: DVec3, way: f64| (to - back) / (2.0 * way);
        let directions = [
            direction(0.0, 0.0),
            along(direction(width, 0.0), direction(-width, 0.0), width),
            along(direction(0.0, height), direction(0.0, -height), height),
        ];
        let eye = camera.position() - round.center();
        let (across, within) = match *round {
            Round::Ball { half_axes: [u, v, w], .. } => {
                let volume = u.dot(v.cross(w));
                let rows = [v.cross(w) / volume, w.cross(u) / volume, u.cross(v) / volume];
                let mapped = |vector: DVec3| DVec3::from(rows.map(|row| row.dot(vector)));
                let eye = mapped(eye);
                let directions = directions.map(mapped);
                (directions.map(|direction| eye.cross(direction)), directions)
            }
            Round::Disk { normal, radius, .. } => (
                directions.map(|direction| normal.cross(eye.cross(direction))),
                directions.map(|direction| normal * (radius * normal.dot(direction))),
            ),
        };
        let form = |i: usize, j: usize| across[i].dot(across[j]) - within[i].dot(within[j]);
        Ellipse::of_form(from, [form(1, 1), form(1, 2), form(2, 2)], DVec2::new(form(0, 1), form(0, 2)), form(0, 0))
    }

    /// Where xᵀAx + 2b·x + c ≤ 0 for x counted from a place, A being [A_11, A_12, A_22].
    fn of_form(from: DVec2, [a_11, a_12, a_22]: [f64; 3], b: DVec2, c: f64) -> Option<Ellipse> {
        let determinant = a_11 * a_22 - a_12 * a_12;
        if !(a_11 > 0.0 && determinant > 0.0) {
            return None;
        }
        let center = DVec2::new(a_12 * b.y - a_22 * b.x, a_12 * b.x - a_11 * b.y) / determinant;
        let inside = -(c + b.dot(center));
        let (s_11, s_12, s_22) = (a_11 / inside, a_12 / inside, a_22 / inside);
        let determinant = determinant / (inside * inside);
        let first = s_11.sqrt();
        let to_circle = [DVec2::new(first, s_12 / first), DVec2::new(0.0, (determinant / s_11).sqrt())];
        // The larger eigenvalue of S belongs to the shorter axis.
        let half = (s_11 + s_22) / 2.0;
        let largest = half + libm::hypot((s_11 - s_22) / 2.0, s_12);
        let width = 2.0 / largest.sqrt();
        let is_good = inside > 0.0 && width > 0.0 && width.is_finite() && to_circle.iter().all(|row| row.is_finite());
        (is_good && to_circle[1].y > 0.0).then_some(Ellipse { center: from + center, to_circle, width })
    }

    /// The least distance between two parallel lines that hold it between them.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Its area.
    pub fn area(&self) -> f64 {
        PI / (self.to_circle[0].x * self.to_circle[1].y)
    }

    /// The same in a picture with so many times as many pixels.
    pub fn scaled(&self, factor: f64) -> Ellipse {
        let to_circle = self.to_circle.map(|row| row / factor);
        Ellipse { center: self.center * factor, to_circle, width: self.width * factor }
    }

    /// The place in the unit circle's plane of a place of the picture.
    pub fn circled(&self, place: [f64; 2]) -> [f64; 2] {
        let away = DVec2::from(place) - self.center;
        self.to_circle.map(|row| row.dot(away))
    }

    /// The corners of a polygon around it, less than one part in a hundred larger.
    pub fn corners(&self) -> Vec<[f64; 2]> {
        let [first, second] = self.to_circle;
        let reach = 1.0 / libm::cos(PI / f64::from(CORNERS));
        let corner = |k: u32| {
            let (sine, cosine) = libm::sincos(2.0 * PI * f64::from(k) / f64::from(CORNERS));
            let y = reach * sine / second.y;
            let x = (reach * cosine - first.y * y) / first.x;
            (self.center + DVec2::new(x, y)).to_array()
        };
        (0..CORNERS).map(corner).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::{Disk, Ellipsoid, Shape, Sphere, SphereMethod};
    use crate::geometry::{Intersect, Target};
    use crate::probe::Silent;
    use crate::random::{hash, unit};

    fn camera() -> Camera {
        let (eye, view) = (DVec3::new(1.0, 2.0, 9.0), DVec3::new(0.1, -0.2, -1.0));
        Camera::new(eye, view, DVec3::new(0.1, 1.0, 0.0), 50.0, [60, 40])
    }

    /// The ray through a place hits the shape where the place lies in the ellipse.
    #[test]
    fn rays_through_the_ellipse_meet_the_shape() {
        let camera = camera();
        let mut compared = [0; 2];
        for k in 0..600_u64 {
            let number = |axis: u64| unit(hash(k, axis)) * 2.0 - 1.0;
            let vector = |axis: u64| DVec3::new(number(axis), number(axis + 1), number(axis + 2));
            let center = vector(0) * 2.0;
            let size = 0.02 + 0.5 * number(3).abs();
            let shape = match k % 3 {
                0 => Shape::Sphere(Sphere::new(center, size, false, SphereMethod::Robust)),
                1 => Shape::Disk(Box::new(Disk::new(center, vector(4), size))),
                _ => {
                    let Some(ellipsoid) = Ellipsoid::with_axes(center, [vector(4), vector(7), vector(10) * 0.01])
                    else {
                        continue;
                    };
                    Shape::Ellipsoid(Box::new(ellipsoid))
                }
            };
            let Some(ellipse) = Ellipse::seen(&camera, &shape.round().expect("a round shape")) else { continue };
            let corners = ellipse.corners();
            for at in 0..40_u64 {
                // Near the outline, on either side.
                let corner = DVec2::from(corners[(hash(k, at + 100) % u64::from(CORNERS)) as usize]);
                let place = ellipse.center + (corner - ellipse.center) * (0.9 + 0.2 * unit(hash(k, at + 200)));
                let circled = DVec2::from(ellipse.circled(place.to_array())).length();
                if (circled - 1.0).abs() < 1e-6 {
                    continue;
                }
                let ray = camera.ray(place.to_array(), &mut Silent).expect("a direction");
                let is_met = shape.is_crossed(Target::two_sided(0), &ray, &mut Silent);
                assert_eq!(is_met, circled < 1.0, "{k} {at} {circled}");
                compared[usize::from(is_met)] += 1;
            }
        }
        assert!(compared.iter().all(|count| *count > 5000), "{compared:?}");
    }

    #[test]
    fn the_width_is_the_shortest_diameter() {
        let camera = Camera::new(DVec3::ZERO, -DVec3::Z, DVec3::Y, 90.0, [20, 20]);
        // A pixel is a tenth at this distance.
        let disk = Round::Disk { center: DVec3::new(0.2, 0.0, -1.0), normal: DVec3::Z, radius: 0.3 };
        let ellipse = Ellipse::seen(&camera, &disk).expect("an ellipse");
        assert!((ellipse.width() - 6.0).abs() < 1e-12 && (ellipse.area() - 9.0 * PI).abs() < 1e-11);
        assert!(ellipse.center.distance(DVec2::new(12.0, 10.0)) < 1e-12);
        let edge_on = Round::Disk { center: -DVec3::Z, normal: DVec3::Y, radius: 0.3 };
        assert_eq!(Ellipse::seen(&camera, &edge_on), None);
        let around_the_eye = Round::Ball { center: -DVec3::Z, half_axes: DVec3::AXES.map(|axis| axis * 2.0) };
        assert_eq!(Ellipse::seen(&camera, &around_the_eye), None);
    }
}
