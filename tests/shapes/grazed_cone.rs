//! Rays that graze a cone, decided in whole numbers.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::geometry::Ray;
use raywalk::probe::Silent;
use raywalk::trace::closest_hit;

/// Coordinates are whole numbers of this.
const STEP: f64 = 1.0 / (1_u64 << 44) as f64;

/// The numbers turned and three times as large. Each component of the axis has endless digits in its unit vector.
fn turned([x, y, z]: [f64; 3]) -> DVec3 {
    DVec3::new(x + 2.0 * (y + z), 2.0 * (x - z) + y, 2.0 * (x - y) + z)
}

/// A cone with its tip at 0 around z which holds the line along (p, q, h), with p² + q² = r²; without its part below `from`. Its base is far away, so that rounding matters.
fn text(r: i32, h: i32, from: i32) -> String {
    let at = |z: i32| turned([0.0, 0.0, f64::from(h * z)]).to_array();
    format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [1, 0, 0]}},
        "objects": [{{"name": "a", "shape": {{"cone": {{"base": {:?}, "apex": {:?},
        "base_radius": {}, "apex_radius": {}, "caps": false}}}}}}]}}"#,
        at(1000),
        at(from),
        3 * r * 1000,
        3 * r * from
    )
}

#[test]
fn every_decision_is_right() {
    let mut seen = [0, 0];
    for (p, q, r, h) in [(3, 4, 5, 5), (3, 4, 5, 2), (5, 12, 13, 6), (-8, 15, 17, 4)] {
        for from in [0, 1] {
            let scene = scene_of(text(r, h, from).as_bytes(), "grazed");
            for (across, along) in [(1, 0), (1, 1), (-2, 1), (1, -3), (3, -1)] {
                // A direction of the plane that touches the cone along (p, q, h), so flat that it crosses one half only.
                let way = [across * q + along * p, along * q - across * p, along * h];
                for (off, axis) in (-40..=40_i64).flat_map(|off| (0..3).map(move |axis| (off, axis))) {
                    // From a point of the line that meets (p, q, h)·4, `off` steps beside it.
                    let mut origin = [4 * p - way[0], 4 * q - way[1], 4 * h - way[2]].map(f64::from);
                    origin[axis] += off as f64 * STEP;
                    assert!(origin.iter().all(|x| x.abs() < 102.0), "{origin:?} has more digits than an f64");
                    let outward = [p * h, q * h, -r * r][axis];
                    let outside = i64::from(outward) * off;
                    if outside == 0 {
                        continue;
                    }
                    let ray = Ray::along(turned(origin), turned(way.map(f64::from)));
                    let is_hit = closest_hit(&scene, &ray, &mut Silent).is_some();
                    assert_eq!(is_hit, outside < 0, "{p} {q} {h} from {from}, {way:?}, {off} steps along {axis}");
                    seen[usize::from(is_hit)] += 1;
                }
            }
        }
    }
    assert!(seen[0] > 4000 && seen[1] > 4000, "{seen:?}");
}
