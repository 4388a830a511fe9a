//! The flat shapes: where rays hit them, against plain geometry of the test's own.

use crate::rays::{FEW_ULPS, meet, point, property, ray_through, scale};
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use raywalk::geometry::shape::{Disk, Polygon, Triangle};
use raywalk::geometry::{Crossing, Intersect, Ray, Shape, Side, Surface};

/// What every hit of a flat shape must satisfy.
#[track_caller]
fn check_hit(shape: &Shape, ray: &Ray, (crossing, surface): (Crossing, Surface), outward: DVec3, on_plane: DVec3) {
    let size = ray.origin.abs().max_element() + on_plane.abs().max_element() + crossing.t;
    let height = outward.dot(surface.point - on_plane);
    assert!(height.abs() <= FEW_ULPS * size, "{shape:?}: {ray:?} ends {height:e} beside it, size {size:e}");
    for normal in [surface.normal, surface.geometric_normal()] {
        assert!((normal.length() - 1.0).abs() <= FEW_ULPS, "{normal} isn't of length 1");
    }
    let side = if outward.dot(ray.direction) < 0.0 { Side::Front } else { Side::Back };
    assert_eq!((crossing.side, surface.side), (side, side));
    let expected = if side == Side::Front { outward } else { -outward };
    assert!(
        (surface.geometric_normal() - expected).length() < 1e-9,
        "{} is not {expected}",
        surface.geometric_normal()
    );
    assert!(surface.geometric_normal().dot(ray.direction) <= 0.0);
    let bounds = shape.bounds().expect("a flat shape has an end");
    let margin = FEW_ULPS * size;
    let (min, max) = (bounds.min - margin, bounds.max + margin);
    assert!(min.cmple(surface.point).all() && surface.point.cmple(max).all(), "{} in {bounds:?}", surface.point);
}

/// Three corners that span a triangle of some width, and a point of its plane in barycentric coordinates.
fn corners() -> impl Strategy<Value = [DVec3; 3]> {
    [point(), point(), point()].prop_filter("too thin", |[a, b, c]| {
        let (u, v, w) = (*b - *a, *c - *a, *c - *b);
        u.cross(v).length() > 0.01 * (u.dot(u) + v.dot(v) + w.dot(w))
    })
}

#[test]
fn triangles() {
    let strategy = (corners(), -0.5..1.5_f64, -0.5..1.5_f64, point(), scale());
    property(strategy, |([a, b, c], u, v, origin, scale)| {
        let outward = (b - a).cross(c - a);
        let outward = outward / outward.length();
        let target = a + (b - a) * u + (c - a) * v;
        let shape = Shape::Triangle(Box::new(Triangle::new([a, b, c].map(|corner| (corner * scale).to_array()), None)));
        let ray = ray_through(origin * scale, target * scale);
        let found = meet(&shape, &ray);
        let is_inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
        let is_near_an_edge = u.abs().min(v.abs()).min((u + v - 1.0).abs()) < 1e-6;
        assert!(found.is_some() == is_inside || is_near_an_edge, "{u} {v}");
        if let Some(hit) = found {
            check_hit(&shape, &ray, hit, outward, a * scale);
        }
        is_inside
    });
}

#[test]
fn disks() {
    property(
        (point(), point(), 0.1..5.0_f64, point(), point(), scale()),
        |(center, normal, radius, aim, origin, scale)| {
            let outward = normal / normal.length();
            let in_plane = aim - outward * aim.dot(outward);
            let target = in_plane * (radius / 6.0);
            let shape = Shape::Disk(Box::new(Disk::new(center * scale, normal, radius * scale)));
            let ray = ray_through(origin * scale, (center + target) * scale);
            let found = meet(&shape, &ray);
            let is_inside = target.length() < radius;
            assert!(found.is_some() == is_inside || (target.length() - radius).abs() < 1e-9);
            if let Some(hit) = found {
                check_hit(&shape, &ray, hit, outward, center * scale);
            }
            is_inside
        },
    );
}

/// A star-shaped polygon around 0, mostly concave, counter-clockwise.
fn star() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec(0.2..3.0_f64, 5..12).prop_map(|radii| {
        let turn = std::f64::consts::TAU / radii.len() as f64;
        let ray = |(k, radius): (usize, &f64)| {
            let (sine, cosine) = libm::sincos(turn * k as f64);
            DVec2::new(cosine, sine) * *radius
        };
        radii.iter().enumerate().map(ray).collect()
    })
}

/// Two unit vectors and their normal.
fn frame() -> impl Strategy<Value = [DVec3; 3]> {
    (point(), point()).prop_filter_map("parallel", |(first, second)| {
        let normal = first.cross(second);
        (normal.length() > 1.0).then(|| {
            let (first, normal) = (first / first.length(), normal / normal.length());
            [first, normal.cross(first), normal]
        })
    })
}

/// Whether a point lies in the triangles between 0 and the edges of a star, and how far it is from the nearest edge.
fn in_star(star: &[DVec2], point: DVec2) -> (bool, f64) {
    let edges = || star.iter().copied().zip(star.iter().copied().cycle().skip(1));
    let is_in = edges()
        .any(|(a, b)| a.perp_dot(point) >= 0.0 && point.perp_dot(b) >= 0.0 && (b - a).perp_dot(point - a) >= 0.0);
    let distance = |(a, b): (DVec2, DVec2)| {
        let along = ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        (point - a - (b - a) * along).length()
    };
    (is_in, edges().map(distance).fold(f64::INFINITY, f64::min))
}

#[test]
fn concave_polygons_hold_what_their_triangles_hold() {
    let aim = prop::array::uniform2(-2.0..2.0_f64).prop_map(DVec2::from);
    property((star(), frame(), point(), aim, point(), scale()), |(star, frame, center, aim, origin, scale)| {
        let place = |point: DVec2| (center + frame[0] * point.x + frame[1] * point.y) * scale;
        let vertices: Vec<_> = star.iter().map(|corner| place(*corner).to_array()).collect();
        let shape = Shape::Polygon(Box::new(Polygon::new(&vertices, None)));
        let ray = ray_through(origin * scale, place(aim));
        let found = meet(&shape, &ray);
        let (is_inside, distance) = in_star(&star, aim);
        // The corners lie off their plane by some roundings, which a grazing ray magnifies.
        let grazes = frame[2].dot(ray.direction).abs();
        assert!(found.is_some() == is_inside || distance * grazes < 1e-12, "{star:?} {aim}");
        if let Some((crossing, surface)) = found {
            let size = (center.abs().max_element() + 3.0 + origin.abs().max_element()) * scale + crossing.t;
            let height = frame[2].dot(surface.point - place(star[0]));
            assert!(height.abs() <= 16.0 * FEW_ULPS * size, "{height:e} of {size:e}");
            let side = if frame[2].dot(ray.direction) < 0.0 { Side::Front } else { Side::Back };
            assert_eq!(surface.side, side);
        }
        is_inside
    });
}

#[test]
fn normals_that_grow_evenly_are_interpolated_exactly() {
    // A field that is linear in the point comes back from any cut into triangles.
    let aim = prop::array::uniform2(-2.0..2.0_f64).prop_map(DVec2::from);
    property((star(), frame(), aim, -0.2..0.2_f64, -0.2..0.2_f64), |(star, [right, up, normal], aim, tilt, twist)| {
        let place = |point: DVec2| right * point.x + up * point.y;
        let field = |point: DVec2| normal + right * (tilt * point.x + twist * point.y) + up * (tilt * point.y);
        let vertices: Vec<_> = star.iter().map(|corner| place(*corner).to_array()).collect();
        let normals: Vec<_> = star.iter().map(|corner| field(*corner).to_array()).collect();
        let shape = Shape::Polygon(Box::new(Polygon::new(&vertices, Some(&normals))));
        let found = meet(&shape, &ray_through(place(aim) + normal * 5.0, place(aim)));
        if let Some((_, surface)) = found {
            let expected = field(aim) / field(aim).length();
            assert!((surface.normal - expected).length() < 1e-9, "{} is not {expected}", surface.normal);
            assert!((surface.geometric_normal() - normal).length() < 1e-9);
        }
        found.is_some()
    });
}

/// Whether two hits are one but for the roundings that a ray along the surface magnifies: a triangle has its distance with more digits.
fn are_near(one: &Option<(Crossing, Surface)>, other: &Option<(Crossing, Surface)>) -> bool {
    match (one, other) {
        (Some((one, surface)), Some((other, its))) => {
            let is_one_place = (one.t - other.t).abs() <= 1e-9 * one.t;
            one.side == other.side && is_one_place && (surface.normal - its.normal).length() <= 1e-6
        }
        (one, other) => one.is_none() && other.is_none(),
    }
}

#[test]
fn a_polygon_of_three_corners_shades_as_the_triangle() {
    let weights = (corners(), [point(), point(), point()], -0.2..1.0_f64, -0.2..1.0_f64, point());
    property(weights, |([a, b, c], normals, u, v, origin)| {
        let (vertices, normals) = ([a, b, c].map(|corner| corner.to_array()), normals.map(|normal| normal.to_array()));
        let triangle = Shape::Triangle(Box::new(Triangle::new(vertices, Some(normals))));
        let polygon = Shape::Polygon(Box::new(Polygon::new(&vertices, Some(&normals))));
        let ray = ray_through(origin, a + (b - a) * u + (c - a) * v);
        let (one, other) = (meet(&triangle, &ray), meet(&polygon, &ray));
        let is_near_an_edge = u.abs().min(v.abs()).min((u + v - 1.0).abs()) < 1e-6;
        assert!(are_near(&one, &other) || is_near_an_edge, "{one:?} {other:?}");
        if let Some((_, surface)) = one {
            assert!(surface.normal.dot(surface.geometric_normal()) >= 0.0);
            assert!((surface.normal.length() - 1.0).abs() <= FEW_ULPS);
        }
        one.is_some()
    });
}
