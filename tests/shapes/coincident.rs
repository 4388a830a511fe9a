//! Surfaces in one plane: the first in the scene wins, whatever kinds of shapes they are and wherever the plane lies.

use crate::random::Random;
use crate::support::scene_of;
use glam::DVec3;
use raywalk::probe::Silent;
use raywalk::trace::closest_hit;

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
