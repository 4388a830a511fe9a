//! Rays that graze a cylinder, decided in whole numbers.

use crate::support::scene_of;
use raywalk::geometry::Ray;
use raywalk::probe::Silent;
use raywalk::trace::closest_hit;

/// Coordinates are whole numbers of this.
const STEP: f64 = 1.0 / (1_u64 << 36) as f64;

#[test]
fn every_decision_is_right() {
    let mut seen = [0, 0];
    for (dx, dy, h) in [(3_i64, 4_i64, 5_i64), (5, 12, 13), (8, 15, 17)] {
        for m in [1, 2, 7] {
            let text = format!(
                r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [1, 0, 0]}},
                "objects": [{{"name": "a", "shape": {{"cylinder":
                {{"base": [0, 0, -50], "apex": [0, 0, 50], "radius": {}}}}}}}]}}"#,
                h * m
            );
            let scene = scene_of(text.as_bytes(), "grazed");
            for s in [-1, -3, -40, -1000, -5000] {
                for (dz, off) in (0..3).flat_map(|dz| (-30..=30).map(move |off| (dz, off))) {
                    // On the tangent that is parallel to d, `off` steps beside it.
                    let scale = 1_i128 << 36;
                    let a = i128::from(-dy * m + s * dx) * scale + off;
                    let b = i128::from(dx * m + s * dy) * scale;
                    let across = i128::from(dx) * b - i128::from(dy) * a;
                    let limit = i128::from(h * m * h) * scale;
                    if across == limit {
                        continue;
                    }
                    let origin = glam::DVec3::new(a as f64 * STEP, b as f64 * STEP, (dz * s) as f64);
                    let ray = Ray::along(origin, glam::DVec3::new(dx as f64, dy as f64, dz as f64));
                    let is_hit = closest_hit(&scene, &ray, &mut Silent).is_some();
                    assert_eq!(is_hit, across < limit, "{dx} {dy}, radius {}, from {s}, {off} steps", h * m);
                    seen[usize::from(is_hit)] += 1;
                }
            }
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
}
