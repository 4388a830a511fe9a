//! Lens and shutter against what mathematics says: the disc of confusion of a point, the ramp of a moving edge, moving shapes where
//! they are at each time.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::geometry::{Crossing, Intersect, Leaving, Ray};
use raywalk::probe::Silent;
use raywalk::random::{Arrangement, Draws};
use raywalk::record::{Arithmetic, pixel_color};
use raywalk::scene::{Index, Object, Scene};
use raywalk::trace::{Hit, camera_ray, closest_hit, is_any_hit};
use serde_json::{Value, json};

/// A picture of 33 × 33 pixels by a lens of radius r in focus at 4, of white objects.
fn through_lens(r: f64, objects: &str, shutter: [f64; 2], n: u32) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1",
            "camera": {{"position": [0, 0, 0], "direction": [0, 0, -7], "vertical_fov": 20, "resolution": [33, 33],
                       "lens": {{"radius": {r:?}, "focus_distance": 4}}, "shutter": {shutter:?}}},
            "ambient": [1, 1, 1], "materials": {{"white": {{"ambient": [1, 1, 1]}}}},
            "objects": [{objects}], "sampling": {{"stochastic": {{"n": {n}}}}}}}"#
    );
    scene_of(text.as_bytes(), "lens")
}

fn picture(scene: &Scene) -> Vec<Vec<f64>> {
    let row = |y: u32| (0..33).map(|x| pixel_color(scene, [x, y], Arithmetic::F64).x).collect();
    (0..33).map(row).collect()
}

/// A point at the depth z is blurred to a disc of radius r·|z − f|/(z·f), measured at distance 1; a disc spreads a picture's second
/// moment by half its radius squared, and a pixel by 1/6.
#[test]
fn a_point_is_blurred_to_its_disc_of_confusion() {
    let pixel = 2.0 * libm::tan(10_f64.to_radians()) / 33.0;
    for (depth, r) in [(2.5, 0.15), (8.0, 0.3), (4.0, 0.3)] {
        let size = 0.02 * depth;
        let object = format!(
            r#"{{"shape": {{"disk": {{"center": [0, 0, {:?}], "normal": [0, 0, 1], "radius": {size:?}}}}}, "material": "white"}}"#,
            -depth
        );
        let picture = picture(&through_lens(r, &object, [0.0, 0.0], 144));
        let blur = r * (depth - 4.0_f64).abs() / (depth * 4.0) / pixel;
        let own = size / depth / pixel;
        let (mut sum, mut moment, mut farthest) = (0.0, 0.0, 0.0_f64);
        for (y, row) in picture.iter().enumerate() {
            for (x, value) in row.iter().enumerate() {
                let distance = libm::hypot(x as f64 - 16.0, y as f64 - 16.0);
                sum += value;
                moment += value * distance * distance;
                if *value > 0.0 {
                    farthest = farthest.max(distance);
                }
            }
        }
        // A point of the disc shows the size of its own pinhole image, less or more as the lens comes nearer to its rim.
        let expected = (blur * blur + own * own) / 2.0 + 1.0 / 6.0;
        let found = moment / sum;
        assert!((found / expected - 1.0).abs() < 0.05, "depth {depth}: {found}, expected {expected}");
        assert!(farthest <= blur + own + 0.71, "depth {depth}: {farthest} of {blur} + {own}");
        assert!((sum / (std::f64::consts::PI * own * own) - 1.0).abs() < 0.05, "depth {depth}: the light is {sum}");
    }
}

/// Every ray of a place goes through the point in focus.
#[test]
fn rays_of_a_place_meet_in_the_plane_in_focus() {
    let scene = through_lens(0.4, r#"{"shape": {"sphere": {"center": [0, 0, -9], "radius": 1}}}"#, [0.0, 0.0], 1);
    for place in [[16.5, 16.5], [3.0, 30.25]] {
        let pinhole = scene.camera.ray(place, &mut Silent).expect("a direction");
        let focus = pinhole.direction * (4.0 / -pinhole.direction.z);
        for number in 0..100 {
            let draws = Draws::of_pixel(0, [7, 8], number, Arrangement::Stratified { count: 100 });
            let ray = scene.camera.sampled_ray(place, &draws, &mut Silent).expect("a direction");
            assert!(ray.origin.z == 0.0 && ray.origin.length() <= 0.4);
            let off = (focus - ray.origin).cross(ray.direction).length();
            assert!(off < 1e-14, "{off}");
        }
    }
}

/// An edge that moves by 8 pixels while the shutter is open leaves a ramp: a pixel shows the mean over time of what the edge covers
/// of it.
#[test]
fn a_moving_edge_leaves_its_ramp() {
    let pixel = 8.0 * libm::tan(10_f64.to_radians()) / 33.0;
    let edge = format!(
        r#"{{"shape": {{"polygon": {{"vertices": [[0, -9, -4], [0, 9, -4], [-9, 9, -4], [-9, -9, -4]]}}}}, "material": "white",
            "motion": {{"translation": [{:?}, 0, 0]}}}}"#,
        16.0 * pixel
    );
    // From half a pixel right of the middle's left side; open from 0.25 to 0.75.
    let scene = through_lens(0.0, &edge, [0.25, 0.75], 1);
    for column in 0..33 {
        let covered = |t: f64| (16.5 + 16.0 * t - f64::from(column)).clamp(0.0, 1.0);
        let steps = 4000;
        let expected = (0..steps).map(|k| covered(0.25 + 0.5 * (f64::from(k) + 0.5) / f64::from(steps))).sum::<f64>()
            / f64::from(steps);
        let mut values = Vec::new();
        for seed in 0..100 {
            let mut scene = Scene { seed, ..scene.clone() };
            scene.sampling = raywalk::scene::Sampling::Stochastic { n: 16 };
            values.push(pixel_color(&scene, [column, 16], Arithmetic::F64).x);
        }
        let mean = values.iter().sum::<f64>() / 100.0;
        let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / 99.0;
        assert!(
            (mean - expected).abs() <= 4.0 * (variance / 100.0).sqrt() + 1e-9,
            "{column}: {mean}, expected {expected}"
        );
        assert!(variance.sqrt() < 0.15, "{column}: {}", variance.sqrt());
    }
}

/// Every shape of the test scene, each with a motion of its own, many times over.
fn moving_shapes(shutter: [f64; 2]) -> Scene {
    let mut file: Value = serde_json::from_str(include_str!("../support/shapes.json")).expect("JSON");
    file["camera"]["shutter"] = json!(shutter);
    let objects = file["objects"].as_array_mut().expect("objects");
    objects.push(json!({"name": "knot", "shape": {"mesh": {"path": "knot.obj"}}, "material": "matt"}));
    for (k, object) in (0..).zip(objects.iter_mut()) {
        let k = f64::from(k);
        let turn = json!({"axis": [libm::sin(k), libm::cos(2.0 * k), 0.3], "point": [k / 9.0, -0.5, 0.2], "degrees": 40.0 * k - 300.0});
        let mut motion = json!({"translation": [libm::cos(k), libm::sin(3.0 * k), 0.4]});
        if k % 3.0 != 0.0 {
            motion["rotation"] = turn;
        }
        object["motion"] = motion;
    }
    scene_of(file.to_string().as_bytes(), "moving")
}

fn same(one: Option<Hit>, other: Option<Hit>) -> bool {
    let bits = |hit: Hit| {
        let Crossing { t, side, primitive } = hit.crossing;
        (hit.object, t.to_bits(), side, primitive)
    };
    one.map(bits) == other.map(bits)
}

/// The boxes of moving objects hold them while the shutter is open: no ray misses what testing every object finds.
#[test]
fn bounds_of_moving_objects_hold_them_at_all_times() {
    for shutter in [[0.0, 1.0], [-0.5, -0.2], [3.0, 3.0], [0.0, 40.0]] {
        let scene = moving_shapes(shutter);
        let all = Scene { index: Index::of_all(&scene.objects), ..scene.clone() };
        assert!(scene.index != all.index, "there is a tree");
        let mut hits = 0;
        for number in 0..6000 {
            let draws = Draws::of_pixel(9, [number, 3], 0, Arrangement::Independent);
            let dimension = |light| raywalk::random::Dimension::Light { route: raywalk::random::Route::CAMERA, light };
            let coordinate = |k: u32| draws.pick(dimension(k)).point().map(|x| 12.0 * x - 6.0);
            let ([a, b], [c, d], [e, f]) = (coordinate(0), coordinate(1), coordinate(2));
            let time = shutter[0] + draws.number(raywalk::random::Dimension::Time) * (shutter[1] - shutter[0]);
            let ray = Ray { time, ..Ray::along(DVec3::new(a, b, c), DVec3::new(d, e, f) * 0.5 - DVec3::new(a, b, c)) };
            let found = closest_hit(&scene, &ray, &mut Silent);
            assert!(same(found, closest_hit(&all, &ray, &mut Silent)), "{ray:?}");
            assert_eq!(found.is_some(), is_any_hit(&scene, &ray, &mut Silent));
            hits += u32::from(found.is_some());
        }
        assert!(hits > 1500, "{hits} hits while the shutter is open {shutter:?}");
    }
}

/// A ray hits a moving object as it would hit a static object at its place at the ray's time.
#[test]
fn an_object_is_where_its_motion_has_brought_it() {
    let scene = |center: [f64; 3], motion: &str| {
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0, -1], "shutter": [0, 1]}},
                "ambient": [1, 1, 1], "lights": [{{"point": {{"position": [4, 5, 6]}}}}],
                "materials": {{"m": {{"diffuse": [1, 1, 1], "weights": {{"reflected": 0.5}}}}}},
                "objects": [{{"shape": {{"ellipsoid": {{"center": {center:?}, "radii": [1, 1, 1]}}}}, "material": "m"{motion}}},
                            {{"shape": {{"plane": {{"coefficients": [0, 1, 0, 2]}}}}, "material": "m"}}]}}"#
        );
        scene_of(text.as_bytes(), "moved")
    };
    // Turned by 45° about the z axis through (1, 0, 0), then moved.
    let moving = scene(
        [3.0, 0.0, 0.0],
        r#", "motion": {"translation": [0, 0, 2], "rotation": {"axis": [0, 0, 5], "point": [1, 0, 7], "degrees": 90}}"#,
    );
    let root = std::f64::consts::SQRT_2;
    let still = scene([1.0 + root, root, 1.0], "");
    let mut hits = 0;
    for k in 0..400 {
        let aim = DVec3::new(f64::from(k % 20) / 4.0 - 0.5, f64::from(k / 20) / 5.0 - 1.0, 0.0);
        let ray = Ray { time: 0.5, ..Ray::along(DVec3::new(0.5, 0.2, 9.0), aim - DVec3::new(0.5, 0.2, 9.0)) };
        let [one, other] = [&moving, &still].map(|scene| camera_ray(scene, |_| Some(ray), &mut Silent));
        assert!((one - other).length() < 1e-9, "{k}: {one}, {other}");
        hits += u32::from(closest_hit(&moving, &ray, &mut Silent).is_some_and(|hit| hit.object == 0));
    }
    assert!(hits > 50, "{hits}");
}

/// Whole turns and no motion at all change nothing to the last bit.
#[test]
fn at_time_zero_everything_is_as_written() {
    let moving = moving_shapes([0.0, 0.0]);
    let mut still = scene_of(include_bytes!("../support/shapes.json"), "shapes");
    let knot = moving.objects.last().expect("objects");
    still.objects.push(Object { shape: knot.shape.at_rest().clone(), ..knot.clone() });
    still.index = Index::new(&still.objects);
    for k in 0..2000 {
        let (around, up) = (f64::from(k) * 2.4, f64::from(k % 20) / 10.0 - 0.95);
        let direction = DVec3::new(libm::cos(around), up, libm::sin(around));
        let ray = Ray::along(DVec3::new(0.1, 0.7, 0.4), direction);
        let [one, other] = [&moving, &still].map(|scene| closest_hit(scene, &ray, &mut Silent));
        assert_eq!(one.map(|hit| hit.object), other.map(|hit| hit.object));
        let distance = |hit: Option<Hit>| hit.map_or(0.0, |hit| hit.crossing.t);
        assert!((distance(one) - distance(other)).abs() <= 1e-13 * distance(one), "{one:?} {other:?}");
    }
}

/// What leaves a moving surface doesn't hit it again where it sets off, however the motion rounds.
#[test]
fn rays_leave_moving_surfaces() {
    let scene = moving_shapes([0.0, 1.0]);
    let mut left = vec![0; scene.objects.len()];
    for number in 0..20_000 {
        let draws = Draws::of_pixel(2, [number, 5], 0, Arrangement::Independent);
        let point = |dimension| draws.pick(dimension).point().map(|x| 2.0 * x - 1.0);
        let ([a, b], [c, d]) = (point(raywalk::random::Dimension::Lens), point(raywalk::random::Dimension::Pixel));
        let time = draws.number(raywalk::random::Dimension::Time);
        let object = &scene.objects[number as usize % scene.objects.len()];
        let aim = object.shape.bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
        let origin = aim + DVec3::new(a, b, c) * 4.0;
        let ray = Ray { time, ..Ray::along(origin, aim + DVec3::new(d, a * b, c * d) - origin) };
        let Some(hit) = closest_hit(&scene, &ray, &mut Silent) else { continue };
        let surface = scene.objects[hit.object as usize].shape.surface(&ray, hit.crossing, &mut Silent);
        let normal = surface.geometric_normal();
        let aside = normal.cross(DVec3::new(a, c, d));
        let leaving = Leaving { object: hit.object, primitive: hit.crossing.primitive, side: surface.side };
        let slack = ray.slack_at(surface.point, &Silent);
        let away = Ray { time, leaving: Some(leaving), slack, ..Ray::along(surface.point, normal * 0.05 + aside) };
        let again = closest_hit(&scene, &away, &mut Silent).filter(|again| again.object == hit.object);
        assert!(
            again.is_none_or(|again| again.crossing.t > 1e-6),
            "{}: {again:?}",
            scene.objects[hit.object as usize].name
        );
        left[hit.object as usize] += 1;
    }
    assert!(left.iter().all(|count| *count > 20), "{left:?}");
}
