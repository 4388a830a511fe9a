//! The rays of a log as lines in space.

use crate::support;
use raywalk::log::{Log, RayKind, Step, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::segments::{Segment, segments};
use raywalk::scene::builtin;

fn rays(name: &str, pixel: [u32; 2]) -> (Log, Vec<Segment>) {
    let log = record::pixel(&support::scene(name), pixel, Arithmetic::F64);
    let segments = segments(&log, &Tree::of(&log.events), 0, usize::MAX);
    (log, segments)
}

fn distance(from: [f64; 3], to: [f64; 3]) -> f64 {
    (0..3).map(|axis| (to[axis] - from[axis]) * (to[axis] - from[axis])).sum::<f64>().sqrt()
}

#[test]
fn the_rays_of_the_numeric_example() {
    let (_, rays) = rays("textbook", [160, 120]);
    assert_eq!(rays.len(), 4);
    let [camera, shadow, reflected, second] = [0, 1, 2, 3].map(|at| rays[at]);
    assert_eq!((camera.from, camera.kind), ([16.0, 2.0, 7.0], RayKind::Camera));
    let ends_at = |ray: Segment, point: [f64; 3]| {
        assert!(distance(ray.end(0.0), point) < 1e-12, "{ray:?} ends at {:?}", ray.end(0.0));
    };
    ends_at(camera, [4.0, 6.0, 8.0]);
    // The light.
    ends_at(shadow, [9.0, 12.0, 16.0]);
    assert!(!shadow.is_blocked);
    assert_eq!(reflected.from, [4.0, 6.0, 8.0]);
    assert!((reflected.length.expect("an end") - 10.729_408_786_907_17).abs() < 1e-12);
    ends_at(second, [9.0, 12.0, 16.0]);
}

#[test]
fn every_ray_of_every_scene_is_a_line() {
    for name in builtin::names() {
        let (log, rays) = rays(name, [3, 3]);
        let count =
            Tree::of(&log.events).nodes().iter().filter(|node| matches!(node.step, Some(Step::Ray { .. }))).count();
        assert_eq!(rays.len(), count, "{name}");
        for ray in rays {
            let shadow = matches!(ray.kind, RayKind::Shadow { .. });
            assert!(ray.length.is_none_or(|length| length > 0.0) && (shadow || !ray.is_blocked), "{name}: {ray:?}");
        }
    }
}
