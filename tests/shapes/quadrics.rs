//! Ellipsoids, cylinders and cones: answers that are known exactly.

use crate::solids::{all, first, surface, unit};
use glam::DVec3;
use raywalk::geometry::shape::{Cone, Cylinder, Ellipsoid};
use raywalk::geometry::{Intersect, Ray, Shape, Side, Target};
use raywalk::probe::Silent;

const EPSILON: f64 = f64::EPSILON;

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn cylinder(caps: bool, inward: bool) -> Shape {
    Shape::Cylinder(Box::new(Cylinder::new(v(0.0, 0.0, -1.0), v(0.0, 0.0, 3.0), 2.0, caps, inward)))
}

/// From radius 3 at z = 0 to a tip at z = 3.
fn pointed_cone(caps: bool, inward: bool) -> Shape {
    Shape::Cone(Box::new(Cone::new((DVec3::ZERO, 3.0), (v(0.0, 0.0, 3.0), 0.0), caps, inward)))
}

/// Every crossing: distance, side, part, normal.
#[track_caller]
fn crosses(shape: &Shape, origin: [f64; 3], direction: [f64; 3], expected: &[(f64, Side, u32, [f64; 3])]) {
    let ray = Ray::new(origin.into(), direction.into());
    let found = all(shape, &ray);
    let distances: Vec<_> = found.iter().map(|crossing| (crossing.t, crossing.side, crossing.primitive)).collect();
    let wanted: Vec<_> = expected.iter().map(|(t, side, primitive, _)| (*t, *side, *primitive)).collect();
    assert_eq!(distances, wanted);
    assert_eq!(first(shape, &ray), found.first().copied());
    for (crossing, (t, _, _, normal)) in found.into_iter().zip(expected) {
        let surface = surface(shape, &ray, crossing);
        assert_eq!(surface.point, ray.origin + ray.direction * *t);
        assert!((surface.normal - DVec3::from(*normal)).length() <= EPSILON, "{:?}", surface.normal);
    }
}

use Side::{Back, Front};

#[test]
fn rays_along_the_axes_of_an_ellipsoid() {
    let shape = Shape::Ellipsoid(Box::new(Ellipsoid::new(v(1.0, 0.0, 0.0), v(2.0, 1.0, 4.0), None)));
    crosses(
        &shape,
        [-5.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        &[(4.0, Front, 0, [-1.0, 0.0, 0.0]), (8.0, Back, 0, [-1.0, 0.0, 0.0])],
    );
    crosses(&shape, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], &[(4.0, Back, 0, [0.0, 0.0, -1.0])]);
    crosses(&shape, [1.0, 1.5, 0.0], [0.0, 0.0, 1.0], &[]);
    crosses(&shape, [1.0, 5.0, 0.0], [0.0, 1.0, 0.0], &[]);
    // A quarter turn about z: x' = −y, y' = x.
    let turned = Some([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    let turned = Shape::Ellipsoid(Box::new(Ellipsoid::new(DVec3::ZERO, v(2.0, 1.0, 4.0), turned)));
    crosses(
        &turned,
        [0.0, 5.0, 0.0],
        [0.0, -1.0, 0.0],
        &[(3.0, Front, 0, [0.0, 1.0, 0.0]), (7.0, Back, 0, [0.0, 1.0, 0.0])],
    );
    let bounds = turned.bounds().expect("a box");
    assert_eq!((bounds.min, bounds.max), (v(-1.0, -2.0, -4.0), v(1.0, 2.0, 4.0)));
}

#[test]
fn half_axes_make_an_ellipsoid_unless_they_are_flat() {
    let axes = [v(0.0, 2.0, 0.0), v(-1.0, 0.0, 0.0), v(0.0, 0.0, 4.0)];
    let shape = Shape::Ellipsoid(Box::new(Ellipsoid::with_axes(DVec3::ZERO, axes).expect("a solid one")));
    crosses(
        &shape,
        [0.0, 5.0, 0.0],
        [0.0, -1.0, 0.0],
        &[(3.0, Front, 0, [0.0, 1.0, 0.0]), (7.0, Back, 0, [0.0, 1.0, 0.0])],
    );
    for flat in [[axes[0], axes[1], DVec3::ZERO], [axes[0], axes[1], axes[0] * 2.0], [axes[0], axes[1], DVec3::NAN]] {
        assert_eq!(Ellipsoid::with_axes(DVec3::ZERO, flat), None);
    }
}

#[test]
fn rays_across_and_along_a_cylinder() {
    for caps in [false, true] {
        let shape = cylinder(caps, false);
        crosses(
            &shape,
            [-5.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            &[(3.0, Front, 0, [-1.0, 0.0, 0.0]), (7.0, Back, 0, [-1.0, 0.0, 0.0])],
        );
        crosses(&shape, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], &[(2.0, Back, 0, [0.0, -1.0, 0.0])]);
        crosses(&shape, [-5.0, 0.0, 4.0], [1.0, 0.0, 0.0], &[]);
        crosses(&shape, [-5.0, 3.0, 1.0], [1.0, 0.0, 0.0], &[]);
        crosses(&shape, [3.0, 0.0, -5.0], [0.0, 0.0, 1.0], &[]);
        let bounds = shape.bounds().expect("a box");
        assert_eq!((bounds.min, bounds.max), (v(-2.0, -2.0, -1.0), v(2.0, 2.0, 3.0)));
    }
    crosses(&cylinder(false, false), [1.0, 0.0, -5.0], [0.0, 0.0, 1.0], &[]);
    crosses(
        &cylinder(true, false),
        [1.0, 0.0, -5.0],
        [0.0, 0.0, 1.0],
        &[(4.0, Front, 1, [0.0, 0.0, -1.0]), (8.0, Back, 2, [0.0, 0.0, -1.0])],
    );
    crosses(
        &cylinder(true, true),
        [1.0, 0.0, 5.0],
        [0.0, 0.0, -1.0],
        &[(2.0, Back, 2, [0.0, 0.0, 1.0]), (6.0, Front, 1, [0.0, 0.0, 1.0])],
    );
}

#[test]
fn rays_across_and_along_a_cone() {
    for caps in [false, true] {
        let shape = pointed_cone(caps, false);
        let slanted = 0.5_f64.sqrt();
        crosses(
            &shape,
            [-5.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
            &[(3.0, Front, 0, [-slanted, 0.0, slanted]), (7.0, Back, 0, [-slanted, 0.0, -slanted])],
        );
        // Straight onto the tip, and beside it.
        let tip = (2.0, Front, 0, [0.0, 0.0, 1.0]);
        let base = (5.0, Back, 1, [0.0, 0.0, 1.0]);
        crosses(&shape, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0], &[tip, base][..if caps { 2 } else { 1 }]);
        crosses(&shape, [-5.0, 0.0, 3.5], [1.0, 0.0, 0.0], &[]);
        crosses(&shape, [-5.0, 0.0, -0.5], [1.0, 0.0, 0.0], &[]);
        crosses(&shape, [4.0, 0.0, 5.0], [0.0, 0.0, -1.0], &[]);
    }
    // Steeper than the cone: through the side, out of the base.
    let side = (4.0, Front, 0, [0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()]);
    let base = (5.0, Back, 1, [0.0, 0.0, 1.0]);
    crosses(&pointed_cone(true, false), [2.0, 0.0, 5.0], [0.0, 0.0, -1.0], &[side, base]);
    crosses(&pointed_cone(false, false), [2.0, 0.0, 5.0], [0.0, 0.0, -1.0], &[side]);
}

#[test]
fn rays_through_a_tip_at_the_base() {
    let shape = Shape::Cone(Box::new(Cone::new((DVec3::ZERO, 0.0), (v(0.0, 0.0, 3.0), 3.0), true, false)));
    let out = (1.75, Back, 2, [0.0, 0.0, -1.0]);
    crosses(&shape, [-1.0, 0.0, -4.0], [1.0, 0.0, 4.0], &[(1.0, Front, 0, [0.0, 0.0, -1.0]), out]);
    crosses(&shape, [0.0, 0.0, 0.0], [1.0, 0.0, 4.0], &[(0.75, out.1, out.2, out.3)]);
    // It touches the tip from the side.
    let touching = all(&shape, &Ray::new(v(-4.0, 0.0, -1.0), v(4.0, 0.0, 1.0)));
    assert!(touching.iter().all(|crossing| crossing.t == 1.0));
    assert_eq!(touching.len() % 2, 0);
}

#[test]
fn parallel_to_a_line_of_the_cone_there_is_one_crossing() {
    // The lines x = ±(3 − z) lie on the cone. In the mirror cone behind the tip there is nothing.
    for (caps, count) in [(true, 2), (false, 1)] {
        let found = all(&pointed_cone(caps, false), &Ray::new(v(4.0, 0.0, 1.0), v(-1.0, 0.0, -1.0)));
        assert_eq!(found.len(), count);
        assert_eq!((found[0].t, found[0].side, found[0].primitive), (1.0, Front, 0));
        assert!(all(&pointed_cone(caps, false), &Ray::new(v(2.0, 0.0, 6.0), v(-1.0, 0.0, -1.0))).is_empty());
    }
}

#[test]
fn a_one_sided_surface_is_absent_from_behind() {
    let across = Ray::new(v(-5.0, 0.0, 1.0), DVec3::X);
    for (shape, t) in [
        (cylinder(false, false), 3.0),
        (cylinder(false, true), 7.0),
        (cylinder(true, true), 7.0),
        (pointed_cone(false, false), 3.0),
        (pointed_cone(true, true), 7.0),
    ] {
        let found =
            shape.first_crossing(Target { object: 0, one_sided: true }, &across, &mut Silent).expect("a crossing");
        assert_eq!((found.t, found.side), (t, Front));
    }
}

#[test]
fn equal_circles_make_a_cylinder() {
    for caps in [false, true] {
        let ends = (v(0.0, 0.0, -1.0), v(0.0, 0.0, 3.0));
        let cone = Shape::Cone(Box::new(Cone::new((ends.0, 2.0), (ends.1, 2.0), caps, false)));
        for (origin, direction) in [
            (v(-5.0, 1.0, 1.0), unit(v(3.0, 1.0, 0.25))),
            (v(0.5, 0.0, -5.0), DVec3::Z),
            (v(0.5, 0.25, 1.0), unit(v(0.25, 0.5, 3.0))),
            (v(2.5, 0.0, 9.0), DVec3::NEG_Z),
        ] {
            let ray = Ray::new(origin, direction);
            let (cone, cylinder) = (all(&cone, &ray), all(&cylinder(caps, false), &ray));
            assert_eq!(cone.len(), cylinder.len());
            for (a, b) in cone.iter().zip(&cylinder) {
                assert_eq!((a.side, a.primitive), (b.side, b.primitive));
                assert!((a.t - b.t).abs() <= 4.0 * EPSILON * b.t, "{a:?} {b:?}");
            }
        }
    }
}
