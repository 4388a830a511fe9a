//! Ellipsoids, cylinders and cones: properties of random ones, from 1e-3 to 1e3 in size, near the origin of space and far
//! from it.

use crate::solids::{
    Form, aimed, all, direction, ellipsoid, first, holds, scale, solid, surface, ten_to, triple, unit,
};
use Side::{Back, Front};
use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use raywalk::geometry::shape::{Cone, Cylinder, Ellipsoid, Sphere, SphereMethod};
use raywalk::geometry::{Intersect, Leaving, Ray, Shape, Side};

const EPSILON: f64 = f64::EPSILON;

#[test]
fn hit_points_lie_on_the_surface_with_unit_normals_that_face_the_ray() {
    holds(aimed(), &["hit", "miss"], |(solid, ray)| {
        let found = all(&solid.shape, &ray);
        prop_assert_eq!(first(&solid.shape, &ray), found.first().copied());
        for crossing in &found {
            let at = surface(&solid.shape, &ray, *crossing);
            let off = solid.depth(at.point).abs() / (EPSILON * solid.scale);
            // The distance by itself, before the point was put back onto the surface.
            let along = ray.origin + ray.direction * crossing.t;
            let off_along = solid.depth(along).abs() / (EPSILON * scale(&solid, &ray));
            prop_assert!(off <= 4.0 && off_along <= 4.0, "{off} and {off_along} ulp off the surface");
            prop_assert!((at.normal.length() - 1.0).abs() < 1e-15);
            prop_assert!(at.normal.dot(ray.direction) <= 1e-9);
            let outward = if crossing.side == Front { at.normal } else { -at.normal };
            let step = 1e-9 * solid.scale;
            prop_assert!(solid.depth(at.point + outward * step) < -0.5 * step);
        }
        Ok(if found.is_empty() { "miss" } else { "hit" })
    });
}

#[test]
fn between_entering_and_leaving_a_ray_is_inside() {
    let closed = aimed().prop_filter("a closed one", |(solid, _)| !solid.is_open());
    holds(closed, &["through", "from inside", "miss"], |(solid, ray)| {
        let near = 64.0 * EPSILON * scale(&solid, &ray);
        let found = all(&solid.shape, &ray);
        let depth_at = |t: f64| solid.depth(ray.origin + ray.direction * t);
        let sides: Vec<_> = found.iter().map(|crossing| crossing.side).collect();
        match sides[..] {
            [Front, Back] => {
                prop_assert!(found[0].t <= found[1].t);
                prop_assert!(depth_at(found[0].t * 0.5 + found[1].t * 0.5) >= -near);
                Ok("through")
            }
            [Back] => {
                prop_assert!(depth_at(found[0].t * 0.5) >= -near);
                Ok("from inside")
            }
            [] => {
                let length = (ray.origin - solid.center).length() + 2.0 * solid.size;
                for step in 0..200 {
                    prop_assert!(depth_at(length * f64::from(step) / 200.0) <= near);
                }
                Ok("miss")
            }
            _ => Err(TestCaseError::fail(format!("{sides:?}"))),
        }
    });
}

#[test]
fn an_open_surface_is_the_lateral_part_of_the_closed_one() {
    let open = aimed().prop_filter("an open one", |(solid, _)| solid.is_open());
    holds(open, &["hit", "miss"], |(solid, ray)| {
        let Form::Round { ends, radii, .. } = solid.form else { return Err(TestCaseError::reject("round")) };
        let closed = match solid.shape {
            Shape::Cylinder(_) => Shape::Cylinder(Box::new(Cylinder::new(ends[0], ends[1], radii[0], true, false))),
            _ => Shape::Cone(Box::new(Cone::new((ends[0], radii[0]), (ends[1], radii[1]), true, false))),
        };
        let lateral: Vec<_> = all(&closed, &ray).into_iter().filter(|crossing| crossing.primitive == 0).collect();
        prop_assert_eq!(&all(&solid.shape, &ray), &lateral);
        Ok(if lateral.is_empty() { "miss" } else { "hit" })
    });
}

#[test]
fn the_box_holds_the_surface() {
    let points = (solid(), [-1.0..1.0, -1.0..1.0], direction());
    holds(points, &["inside"], |(solid, place, around)| {
        let bounds = solid.shape.bounds().expect("a box").widened();
        prop_assert!(bounds.contains(solid.point(place, around)));
        Ok("inside")
    });
    // It touches the surface on each side.
    holds(ellipsoid(), &["tight"], |solid| {
        let bounds = solid.shape.bounds().expect("a box");
        let Form::Ellipsoid { axes, radii } = solid.form else { return Err(TestCaseError::reject("an ellipsoid")) };
        for space in DVec3::AXES {
            // The point whose normal is that axis of space.
            let reach: DVec3 = (0..3).map(|i| axes[i] * (radii[i] * radii[i] * axes[i].dot(space))).sum();
            let touching = reach / reach.dot(space).sqrt();
            let side = (bounds.max - solid.center).dot(space);
            prop_assert!((touching.dot(space) - side).abs() <= 8.0 * EPSILON * solid.scale);
        }
        Ok("tight")
    });
}

#[test]
fn a_ray_that_leaves_the_surface_inward_meets_the_other_end_only() {
    let leaving = (aimed(), direction());
    holds(leaving, &["other end", "out", "no hit"], |((solid, ray), away)| {
        let Some(crossing) = first(&solid.shape, &ray) else { return Ok("no hit") };
        let at = surface(&solid.shape, &ray, crossing);
        let leaving = |direction: DVec3, side| Ray {
            leaving: Some(Leaving { object: 0, primitive: crossing.primitive, side }),
            slack: ray.slack_at(at.point, &raywalk::probe::Silent),
            ..Ray::new(at.point, direction)
        };
        let outward = if crossing.side == Front { at.normal } else { -at.normal };
        let away = if away.dot(outward) > 0.0 { -away } else { away };
        prop_assert!(all(&solid.shape, &leaving(-away, Front)).is_empty());
        let inward = leaving(away, Back);
        let found = all(&solid.shape, &inward);
        prop_assert!(found.len() <= 1);
        let Some(other) = found.first() else {
            prop_assert!(solid.is_open() || away.dot(outward) > -1e-6, "it doesn't come out");
            return Ok("out");
        };
        prop_assert_eq!((first(&solid.shape, &inward), other.side), (Some(*other), Back));
        let end = surface(&solid.shape, &inward, *other);
        prop_assert!(solid.depth(end.point).abs() <= 4.0 * EPSILON * solid.scale);
        let near = 64.0 * EPSILON * solid.scale;
        prop_assert!(solid.depth((at.point + end.point) * 0.5) >= -near);
        Ok("other end")
    });
}

#[test]
fn an_ellipsoid_of_equal_radii_is_a_sphere() {
    let balls = aimed().prop_filter_map("an ellipsoid", |(solid, ray)| match solid.form {
        Form::Ellipsoid { axes, radii } => Some((solid.center, radii[0], axes, ray)),
        Form::Round { .. } => None,
    });
    holds(balls, &["hit", "miss"], |(center, radius, axes, ray)| {
        let rotation = [0, 1, 2].map(|i| [axes[0][i], axes[1][i], axes[2][i]]);
        let ellipsoid = Shape::Ellipsoid(Box::new(Ellipsoid::new(center, DVec3::splat(radius), Some(rotation))));
        let sphere = Shape::Sphere(Sphere::new(center, radius, false, SphereMethod::Robust));
        let (ours, theirs) = (all(&ellipsoid, &ray), all(&sphere, &ray));
        prop_assert_eq!(ours.len(), theirs.len());
        for (a, b) in ours.iter().zip(&theirs) {
            let (p, q) = (surface(&ellipsoid, &ray, *a), surface(&sphere, &ray, *b));
            let slant = q.normal.dot(ray.direction).abs().max(1e-3);
            let distance = center.length() + (ray.origin - center).length() + radius;
            prop_assert!((a.t - b.t).abs() * slant <= 8.0 * EPSILON * distance);
            prop_assert!((p.normal - q.normal).length() * slant * radius <= 16.0 * EPSILON * distance);
        }
        Ok(if ours.is_empty() { "miss" } else { "hit" })
    });
}

#[test]
fn an_upright_cylinder_is_a_circle_seen_from_above() {
    let rays = ((triple(), triple()), 0.5..2.0);
    holds(rays, &["hit", "miss"], |((origin, target), radius): ((DVec3, DVec3), f64)| {
        let shape = Shape::Cylinder(Box::new(Cylinder::new(DVec3::Z * -100.0, DVec3::Z * 100.0, radius, false, false)));
        let origin = origin * 8.0;
        let ray = Ray::new(origin, unit(target * 3.0 - origin));
        let is_between = |t: f64| (origin.z + ray.direction.z * t).abs() < 100.0;
        let (o, d) = (origin.truncate(), ray.direction.truncate());
        // The foot of the perpendicular from the centre, and half the chord.
        let foot = -o.dot(d) / d.length_squared();
        let half = radius * radius - (o + d * foot).length_squared();
        let expected: Vec<f64> = if half < 0.0 {
            vec![]
        } else {
            let half = half.sqrt() / d.length();
            [foot - half, foot + half].into_iter().filter(|t| *t > 0.0 && is_between(*t)).collect()
        };
        let found: Vec<f64> = all(&shape, &ray).iter().map(|crossing| crossing.t).collect();
        prop_assert_eq!(found.len(), expected.len());
        for (a, b) in found.iter().zip(&expected) {
            prop_assert!((a - b).abs() <= 1e-12, "{a} {b}");
        }
        Ok(if found.is_empty() { "miss" } else { "hit" })
    });
}

#[test]
fn grazing_and_degenerate_rays_give_numbers() {
    let tangents = (solid(), [-1.0..1.0, -1.0..1.0], direction(), direction(), -4.0..4.0, any::<bool>());
    holds(tangents, &["hit", "miss"], |(solid, place, around, direction, far, is_axial)| {
        let target = solid.point(place, around);
        let direction = match solid.form {
            Form::Round { ends, .. } if is_axial => unit(ends[1] - ends[0]),
            Form::Ellipsoid { axes, .. } if is_axial => axes[2],
            // In the tangent plane.
            _ => {
                let step = 1e-6 * solid.size;
                let slope = [DVec3::X, DVec3::Y, DVec3::Z]
                    .map(|e| solid.depth(target + e * step) - solid.depth(target - e * step));
                unit(direction.cross(unit(DVec3::from(slope))))
            }
        };
        prop_assume!(direction.is_finite());
        let ray = Ray::new(target - direction * (solid.size * ten_to(far)), direction);
        let found = all(&solid.shape, &ray);
        for crossing in &found {
            let at = surface(&solid.shape, &ray, *crossing);
            prop_assert!(crossing.t.is_finite() && at.point.is_finite());
            prop_assert!((at.normal.length() - 1.0).abs() < 1e-15);
        }
        Ok(if found.is_empty() { "miss" } else { "hit" })
    });
}
