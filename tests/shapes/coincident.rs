//! Surfaces in one plane: the first in the scene wins, whatever kinds of shapes they are and wherever the plane lies.

use crate::random::Random;
use crate::support::scene_of;
use glam::DVec3;
use raywalk::geometry::shape::TriangleMesh;
use raywalk::geometry::{Intersect, Mesh, Shape};
use raywalk::probe::Silent;
use raywalk::scene::Scene;
use raywalk::trace::closest_hit;
use raywalk::trace::query::Query;
use std::sync::Arc;

/// Shapes whose surface, or a part of it, lies in the plane x·axis = height and covers the same square.
fn shapes(axis: usize, height: f64) -> [String; 6] {
    let point = |u: f64, v: f64, w: f64| {
        let mut point = [u, v, 0.0];
        // u, v and the height, in the axes' cyclic order.
        point[axis] = w;
        point[(axis + 1) % 3] = u;
        point[(axis + 2) % 3] = v;
        format!("[{:?}, {:?}, {:?}]", point[0], point[1], point[2])
    };
    let normal = point(0.0, 0.0, 1.0);
    let [a, b, c, d] = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)].map(|(u, v)| point(u, v, height));
    [
        format!(r#"{{"plane": {{"coefficients": {}}}}}"#, normal.replace(']', &format!(", {:?}]", -height))),
        format!(
            r#"{{"triangle": {{"vertices": [{}, {}, {}]}}}}"#,
            point(-9.0, -7.0, height),
            point(9.0, -8.0, height),
            point(0.3, 11.0, height)
        ),
        format!(r#"{{"polygon": {{"vertices": [{a}, {b}, {c}, {d}]}}}}"#),
        format!(r#"{{"disk": {{"center": {}, "normal": {normal}, "radius": 3}}}}"#, point(0.1, 0.2, height)),
        format!(r#"{{"box": {{"min": {}, "max": {}}}}}"#, point(-2.0, -2.0, height - 1.0), point(2.0, 2.0, height)),
        format!(r#"{{"polygon": {{"vertices": [{d}, {c}, {b}, {a}]}}}}"#),
    ]
}

#[test]
fn the_first_in_the_scene_wins() {
    let mut random = Random::new(11);
    let mut between = |from: f64, to: f64| from + (to - from) * random.part();
    for (axis, height) in [(0, 0.0), (1, 0.1), (2, 1.0 / 3.0), (1, -1e3 / 7.0), (2, 1e6 + 0.1)] {
        let shapes = shapes(axis, height);
        let moves = |k: usize| (0..shapes.len()).map(move |j| (k + j) % 6);
        for first in 0..shapes.len() {
            let objects: Vec<_> =
                moves(first).map(|j| format!(r#"{{"name": "{j}", "shape": {}}}"#, shapes[j])).collect();
            let text = format!(
                r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [1, 0, 0], "up": [0, 0, 1]}}, "objects": [{}]}}"#,
                objects.join(", ")
            );
            let scene = scene_of(text.as_bytes(), "coincident");
            for _ in 0..2_000 {
                let mut target = DVec3::splat(between(-1.5, 1.5));
                target[(axis + 1) % 3] = between(-1.5, 1.5);
                target[axis] = height;
                let mut origin = DVec3::new(between(-50.0, 50.0), between(-50.0, 50.0), between(-50.0, 50.0));
                origin[axis] = height + between(0.01, 40.0);
                let ray = raywalk::geometry::Ray::along(origin, target - origin);
                let hit = closest_hit(&scene, &ray, &mut Silent).expect("a hit");
                assert_eq!(hit.object, 0, "axis {axis} at {height}, {first} first: {ray:?}");
            }
        }
    }
}

#[test]
fn of_equal_curved_surfaces_too() {
    let ball = r#"{"sphere": {"center": [0.1, 0.2, 0.3], "radius": 0.7}}"#;
    let same = r#"{"ellipsoid": {"center": [0.1, 0.2, 0.3], "radii": [0.7, 0.7, 0.7]}}"#;
    let turned = r#"{"ellipsoid": {"center": [0.1, 0.2, 0.3], "radii": [0.7, 0.7, 0.7],
        "rotation": [[0, 1, 0], [0, 0, 1], [1, 0, 0]]}}"#;
    let mut random = Random::new(12);
    for (first, second) in [(ball, same), (same, ball), (same, turned), (turned, same), (turned, ball)] {
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [1, 0, 0]}},
            "objects": [{{"name": "a", "shape": {first}}}, {{"name": "b", "shape": {second}}}]}}"#
        );
        let scene = scene_of(text.as_bytes(), "equal");
        for _ in 0..2_000 {
            let target = DVec3::new(0.1, 0.2, 0.3) + random.point() * 0.4;
            let origin = target + random.unit() * 5.0;
            let ray = raywalk::geometry::Ray::along(origin, target - origin);
            let hit = closest_hit(&scene, &ray, &mut Silent).expect("a hit");
            assert_eq!(hit.object, 0, "{first}, {second}: {ray:?}");
        }
    }
}

/// A disk that moves by a long way comes to lie in another one. Rounded so, their distances along a flat ray differ by far more than the numbers
/// of the moving one at rest suggest.
#[test]
fn a_moving_surface_is_in_the_same_place_as_one_at_rest() {
    let far = 1e8;
    let normal = DVec3::new(0.3, 1.0, 0.17);
    let along = DVec3::new(1.0, -0.3, 0.0).normalize();
    let disk = |x: f64| {
        format!(r#"{{"disk": {{"center": [{:?}, 0.123, 0.2], "normal": {:?}, "radius": 2}}}}"#, x, normal.to_array())
    };
    let rests = format!(r#"{{"shape": {}}}"#, disk(far + 0.1));
    let moves = format!(r#"{{"shape": {}, "motion": {{"translation": [{far:?}, 0, 0]}}}}"#, disk(0.1));
    let mut random = Random::new(13);
    for objects in [[&rests, &moves], [&moves, &rests]] {
        let [first, second] = objects;
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [1, 0, 0], "shutter": [1, 1]}},
            "objects": [{first}, {second}]}}"#
        );
        let scene = scene_of(text.as_bytes(), "moving");
        for _ in 0..2_000 {
            let slope = libm::pow(10.0, -3.0 - 3.0 * random.part());
            let target = DVec3::new(far + 0.1, 0.123, 0.2) + along * (0.6 * random.part() - 0.3);
            let way = along - normal.normalize() * slope;
            let query = Query::new(target - way * 3.0, way);
            if let Some(hit) = query.hit(&scene) {
                assert_eq!(hit.object, 0, "{first}, {second}: {query:?}");
            }
        }
    }
}

/// A ray through a corner of a mesh hits triangles at the same distance. The search may find any of them first; the first in the file is shaded.
#[test]
fn the_triangle_that_is_hit_is_the_one_that_is_shaded() {
    let text = br#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 4], "direction": [0, 0, -1], "resolution": [1, 1]},
        "lights": [{"name": "sun", "directional": {"direction": [0.3, 0.2, -1]}}],
        "materials": {"white": {"diffuse": [1, 1, 1]}},
        "objects": [{"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "material": "white"}]}"#;
    let mut random = Random::new(14);
    let mut ties = 0;
    for number in 0..200 {
        // A fan around the origin, of round numbers, its triangles in any order.
        let rim = 24_u32;
        let mut positions = vec![DVec3::ZERO];
        positions.extend((0..rim).map(|k| {
            let angle = f64::from(k) / f64::from(rim) * std::f64::consts::TAU;
            let height = (random.part() * 8.0).round() / 8.0 - 0.5;
            DVec3::new((libm::cos(angle) * 16.0).round() / 16.0, (libm::sin(angle) * 16.0).round() / 16.0, height)
        }));
        let mut faces: Vec<[u32; 3]> = (0..rim).map(|k| [0, 1 + k, 1 + (k + 1) % rim]).collect();
        for k in (1..faces.len()).rev() {
            faces.swap(k, random.below(k + 1));
        }
        let mesh = Mesh { positions, normals: None, faces };
        let shapes = [Shape::Mesh(Arc::new(TriangleMesh::new(Arc::new(mesh))))];
        let bare = Scene::of_shapes("fan", shapes);
        let scene = Scene { objects: bare.objects, index: bare.index, ..scene_of(text, "fan") };
        let ray = raywalk::geometry::Ray::along(DVec3::Z * 4.0, DVec3::NEG_Z);
        let hit = closest_hit(&scene, &ray, &mut Silent).expect("the middle of the fan");
        ties += u32::from(hit.crossing.t == 4.0);
        let surface = scene.objects[0].shape.surface(&ray, hit.crossing, &mut Silent);
        let expected = surface.normal.dot(DVec3::new(-0.3, -0.2, 1.0).normalize()).max(0.0);
        let color = raywalk::sampling::pixel(&scene, [0, 0], &mut Silent);
        assert!((color.x - expected).abs() < 1e-9, "fan {number}: {color} instead of {expected}, {hit:?}");
    }
    assert!(ties > 150, "{ties}");
}
