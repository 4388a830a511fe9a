//! The flat shapes and the box where numbers get difficult: shared edges, no area, no width, no middling size.

use crate::rays::{FEW_ULPS, meet, ray_through};
use glam::DVec3;
use raywalk::geometry::shape::{Cuboid, Disk, Polygon, Triangle};
use raywalk::geometry::{Intersect, Leaving, Ray, Shape, Side, Target};
use raywalk::log::What;
use raywalk::probe::{Altered, Recorder, Silent, Single};

/// A repeatable stream of numbers from −1 to 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64) / 4_503_599_627_370_496.0 - 1.0
    }

    fn point(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }
}

#[test]
fn no_ray_slips_through_a_shared_edge() {
    let mut numbers = Numbers(1);
    let (mut both, mut one) = (0, 0);
    for pair in 0..1000 {
        let origin = numbers.point() * 5.0 + DVec3::Z * 8.0;
        let (from, to) = (numbers.point(), numbers.point() + DVec3::Y);
        // The third corners lie on both sides of the edge as the eye sees it.
        let across = (from - origin).cross(to - from);
        let across = across / across.length();
        let middle = from * 0.5 + to * 0.5;
        let third = |numbers: &mut Numbers, way: f64| {
            middle
                + across * (way * (1.05 + numbers.next()))
                + numbers.point() * 0.02
                + (to - from) * (0.5 * numbers.next())
        };
        let (left, right) = (third(&mut numbers, 1.0), third(&mut numbers, -1.0));
        let ordered = |corner: DVec3, order: usize| {
            let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
            let corners = [from, to, corner];
            Shape::Triangle(Box::new(Triangle::new(orders[order % 6].map(|at| corners[at].to_array()), None)))
        };
        let triangles = [ordered(left, pair), ordered(right, pair / 6)];
        for _ in 0..100 {
            let part = 0.5 + 0.49 * numbers.next();
            let ray = ray_through(origin, from + (to - from) * part);
            let hits = triangles
                .iter()
                .filter(|shape| shape.first_crossing(Target::two_sided(0), &ray, &mut Silent).is_some())
                .count();
            assert!(hits > 0, "{ray:?} slips between {triangles:?}");
            if hits == 2 { both += 1 } else { one += 1 }
        }
    }
    assert_eq!(both + one, 100_000);
    // Signs are exact: a ray hits both only where its line hits the edge itself, of which f64 rarely has a point.
    assert!(one > 99_000, "{both} rays hit both, {one} one of them");
}

#[test]
fn triangles_without_area_are_never_hit() {
    let mut numbers = Numbers(7);
    for _ in 0..20_000 {
        let (a, step, size) = (numbers.point(), numbers.point(), libm::exp2((numbers.next() * 40.0).trunc()));
        // On one line exactly: small whole numbers of steps with few digits.
        let step = (step * 1024.0).trunc() / 1024.0;
        let start = (a * 1024.0).trunc() / 1024.0;
        let along = |count: f64| ((start + step * count) * size).to_array();
        let places = [[0.0, 1.0, 2.0], [3.0, -1.0, 7.0], [0.0, 0.0, 1.0], [2.0, 5.0, 2.0], [4.0, 4.0, 4.0]];
        for place in places {
            let shape = Shape::Triangle(Box::new(Triangle::new(place.map(along), None)));
            let target = DVec3::from(along(numbers.next() * 3.0));
            for ray in [ray_through(numbers.point() * size, target), Ray::new(target, step)] {
                assert_eq!(shape.first_crossing(Target::two_sided(0), &ray, &mut Silent), None, "{shape:?} {ray:?}");
            }
        }
    }
}

#[test]
fn no_input_makes_a_note_that_is_not_finite() {
    let mut numbers = Numbers(3);
    let extremes = [0.0, -0.0, 1.0, -3.0, 1e-310, 1e-160, 1e100, -1e160, 1e300, f64::MAX, f64::MIN];
    let mut number = || {
        let place = (numbers.next() + 1.0) * 0.5 * extremes.len() as f64;
        extremes[(place as usize).min(extremes.len() - 1)]
    };
    let mut point = || DVec3::new(number(), number(), number());
    for _ in 0..5000 {
        let corners = [point(), point(), point(), point()].map(|corner| corner.to_array());
        let normals = [point(), point(), point(), point()].map(|normal| normal.to_array());
        let three = |four: [[f64; 3]; 4]| [four[0], four[1], four[2]];
        let [first, second, third, _] = corners.map(DVec3::from);
        let shapes = [
            Shape::Triangle(Box::new(Triangle::new(three(corners), Some(three(normals))))),
            Shape::Polygon(Box::new(Polygon::new(&corners, Some(&normals)))),
            Shape::Disk(Box::new(Disk::new(first, second, third.x.abs()))),
            Shape::Cuboid(Cuboid::new(first.min(second), first.max(second))),
        ];
        let way = point();
        let directions = [DVec3::X, DVec3::new(-0.0, 0.6, -0.8), way / way.length()];
        for direction in directions.into_iter().filter(|direction| direction.is_finite()) {
            let ray = Ray::new(point(), direction);
            for shape in &shapes {
                let mut recorder = Recorder::default();
                let found = shape.first_crossing(Target::two_sided(0), &ray, &mut recorder);
                if let Some(crossing) = found {
                    shape.surface(&ray, crossing, &mut recorder);
                }
                check_notes(recorder);
                let mut single = Altered { alteration: Single, probe: Recorder::default() };
                if let Some(crossing) = shape.first_crossing(Target::two_sided(0), &ray, &mut single) {
                    shape.surface(&ray, crossing, &mut single);
                }
                check_notes(single.probe);
                assert!(found.is_none_or(|crossing| crossing.t > 0.0 && crossing.t.is_finite()));
            }
        }
    }
}

#[track_caller]
fn check_notes(recorder: Recorder) {
    for event in recorder.events() {
        if let What::Note { name, value } = event.what {
            assert!(value.components().iter().all(|x| x.is_finite()), "{name:?} is {value:?}");
        }
    }
}

#[test]
fn needles_keep_the_digits_of_their_distance() {
    // An edge of length 2 whose middle the third corner all but touches; the plane is x + y + z = 3.
    let along = DVec3::new(1.0, -1.0, 0.0);
    let beside = DVec3::new(1.0, 1.0, -2.0);
    for power in [10, 20, 30, 40] {
        let width = 1.0 / (1_u64 << power) as f64;
        let corners = [DVec3::ONE - along, DVec3::ONE + along, DVec3::ONE + beside * width];
        let shape = Shape::Triangle(Box::new(Triangle::new(corners.map(|corner| corner.to_array()), None)));
        let ray = Ray::new(DVec3::ZERO, DVec3::ONE + beside * (width * 0.25));
        let (crossing, surface) = meet(&shape, &ray).expect("a ray through the triangle");
        assert!((crossing.t - 1.0).abs() <= FEW_ULPS, "{} at width {width:e}", crossing.t);
        let outward = DVec3::ONE / 3.0_f64.sqrt();
        assert!((surface.normal.abs() - outward).length() <= FEW_ULPS, "{} at width {width:e}", surface.normal);
    }
}

#[test]
fn one_sided_faces_are_absent_from_behind() {
    let shapes = [
        Shape::Triangle(Box::new(Triangle::new([[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]], None))),
        Shape::Polygon(Box::new(Polygon::new(&[[0.0; 3], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]], None))),
        Shape::Disk(Box::new(Disk::new(DVec3::ONE - DVec3::Z, DVec3::Z, 3.0))),
        Shape::Cuboid(Cuboid::new(-DVec3::ONE * 3.0, DVec3::new(3.0, 3.0, 0.0))),
    ];
    let from = |z: f64| Ray::new(DVec3::new(1.0, 1.0, z), DVec3::Z * -z.signum());
    for shape in &shapes {
        assert!(shape.first_crossing(Target { object: 0, one_sided: true }, &from(2.0), &mut Silent).is_some());
        assert_eq!(shape.first_crossing(Target { object: 0, one_sided: true }, &from(-2.0), &mut Silent), None);
        let hit = meet(shape, &from(2.0)).expect("a hit from the front");
        assert_eq!((hit.0.t, hit.1.normal), (2.0, DVec3::Z));
        let leaving = Some(Leaving { object: 0, primitive: hit.0.primitive, side: Side::Front });
        assert_eq!(shape.first_crossing(Target::two_sided(0), &Ray { leaving, ..from(2.0) }, &mut Silent), None);
    }
}
