//! The box, against its six faces as rectangles of their own.

use crate::rays::{FEW_ULPS, meet, point, property, ray_through, scale};
use glam::DVec3;
use proptest::prelude::*;
use raywalk::geometry::shape::Cuboid;
use raywalk::geometry::{Intersect, Leaving, Ray, Shape, Side, Target};
use raywalk::probe::Silent;

/// The corners of a box, a point that a ray aims at, and its origin, both in and around the box.
fn box_and_ray() -> impl Strategy<Value = [DVec3; 4]> {
    let sides = prop::array::uniform3(0.1..9.0_f64);
    let (aim, origin) = (prop::array::uniform3(-0.5..1.5_f64), prop::array::uniform3(-1.0..2.0_f64));
    (point(), sides, aim, origin).prop_map(|(min, sides, aim, origin)| {
        let at = |part: [f64; 3]| min + DVec3::from(sides) * DVec3::from(part);
        [min, at([1.0; 3]), at(aim), at(origin)]
    })
}

#[test]
fn boxes_are_entered_and_left_through_their_faces() {
    property((box_and_ray(), scale()), |([min, max, aim, origin], scale)| {
        let (min, max) = (min * scale, max * scale);
        let shape = Shape::Cuboid(Cuboid::new(min, max));
        let ray = ray_through(origin * scale, aim * scale);
        // Each face as a rectangle of its own.
        let mut faces: Vec<(f64, u32)> = (0..6_u32)
            .filter_map(|face| {
                let axis = face as usize / 2;
                let plane = if face % 2 == 0 { min } else { max };
                let t = (plane[axis] - ray.origin[axis]) / ray.direction[axis];
                let point = ray.origin + ray.direction * t;
                let others = [(axis + 1) % 3, (axis + 2) % 3];
                let is_on = others.iter().all(|other| min[*other] <= point[*other] && point[*other] <= max[*other]);
                (t > 0.0 && is_on).then_some((t, face))
            })
            .collect();
        faces.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found = Vec::new();
        shape.all_crossings(Target::two_sided(0), &ray, &mut found, &mut Silent);
        let found_faces: Vec<_> = found.iter().map(|crossing| (crossing.t, crossing.primitive)).collect();
        assert_eq!(found_faces, faces, "{ray:?} {shape:?}");
        assert_eq!(shape.first_crossing(Target::two_sided(0), &ray, &mut Silent), found.first().copied());
        for crossing in &found {
            let surface = shape.surface(&ray, *crossing, &mut Silent);
            let axis = crossing.primitive as usize / 2;
            let plane = if crossing.primitive.is_multiple_of(2) { min } else { max };
            let size = ray.origin.abs().max_element() + crossing.t;
            assert!((surface.point[axis] - plane[axis]).abs() <= FEW_ULPS * size);
            assert_eq!(surface.normal[axis].abs(), 1.0);
            assert!(surface.normal.dot(ray.direction) < 0.0);
            let outward = if crossing.primitive.is_multiple_of(2) { -1.0 } else { 1.0 };
            assert_eq!(surface.normal[axis] == outward, crossing.side == Side::Front);
        }
        !found.is_empty()
    });
}

#[test]
fn what_sets_off_from_a_face_meets_another_one() {
    property(box_and_ray(), |[min, max, aim, origin]| {
        let shape = Shape::Cuboid(Cuboid::new(min, max));
        let arriving = ray_through(origin, aim);
        let Some((crossing, surface)) = meet(&shape, &arriving) else { return false };
        let leaving = |side| Some(Leaving { object: 0, primitive: crossing.primitive, side });
        let slack = arriving.slack_at(surface.point, &Silent);
        let onward =
            Ray { leaving: leaving(crossing.side.opposite()), slack, ..Ray::new(surface.point, arriving.direction) };
        match (crossing.side, meet(&shape, &onward)) {
            (Side::Front, Some((exit, _))) => assert!(exit.side == Side::Back && exit.primitive != crossing.primitive),
            (Side::Front, None) => panic!("{onward:?} is inside {shape:?} and doesn't come out"),
            (Side::Back, beyond) => assert_eq!(beyond, None),
        }
        true
    });
}
