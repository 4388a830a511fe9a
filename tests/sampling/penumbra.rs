//! Penumbras of a disk without sampling: against closed forms, against the tracer with very many shadow rays, and against themselves.

use crate::support;
use proptest::prelude::*;
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Color, Sampling, Scene};
use raywalk::study::bench::exact::{self, Estimate, NotExact, Penumbra};
use std::sync::LazyLock;

/// A floor z = 0 under a lamp of radius 1 at height 3 over the origin, at which the eye looks; ambient 0.25, K_d·I = 1.
fn scene(lamp: &str, objects: &str, resolution: [u32; 2], samples: u32) -> Scene {
    let [width, height] = resolution;
    let text = format!(
        r#"{{"format": "raywalk-scene/1",
        "camera": {{"position": [0.5, -7, 4], "look_at": [0, 0, 0], "up": [0, 0, 1], "vertical_fov": 30, "resolution": [{width}, {height}]}},
        "ambient": [0.25, 0.25, 0.25], "background": [0.1, 0.2, 0.3],
        "lights": [{{"name": "lamp", "disk": {lamp}, "color": [1, 1, 1], "samples": {samples}}}],
        "materials": {{"paper": {{"ambient": [1, 1, 1], "diffuse": [1, 1, 1]}}, "clay": {{"ambient": [0.5, 0.2, 0.1], "diffuse": [0.7, 0.3, 0.2]}}}},
        "objects": [{{"name": "floor", "shape": {{"plane": {{"coefficients": [0, 0, 1, 0]}}}}, "material": "paper"}}{objects}]}}"#
    );
    support::scene_of(text.as_bytes(), "penumbra")
}

const LAMP: &str = r#"{"center": [0, 0, 3], "normal": [0, 0, 1], "radius": 1}"#;

fn object(name: &str, shape: &str) -> String {
    format!(r#", {{"name": "{name}", "shape": {shape}, "material": "clay"}}"#)
}

fn of(scene: &Scene) -> Penumbra<'_> {
    Penumbra::of(scene).unwrap_or_else(|why| panic!("{why}"))
}

/// The light at the origin, in parts of I·K_d.
fn at_origin(objects: &str) -> f64 {
    let scene = scene(LAMP, objects, [8, 6], 1);
    of(&scene).at([4.0, 3.0]).value.x - 0.25
}

/// ∫ h/√(r² + h²)·2πr dr/πR² from r = `inner` to R = 1, with h = 3.
fn ring(inner: f64) -> f64 {
    6.0 * (10.0_f64.sqrt() - (inner * inner + 9.0).sqrt())
}

#[track_caller]
fn is_near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");
}

#[test]
fn points_under_the_middle_of_the_lamp() {
    is_near(at_origin(""), ring(0.0));
    // An edge through the centre hides one half, whatever shape it belongs to.
    let half = r#"{"polygon": {"vertices": [[0, -2, 1.5], [2, -2, 1.5], [2, 2, 1.5], [0, 2, 1.5]]}}"#;
    is_near(at_origin(&object("half", half)), ring(0.0) / 2.0);
    let half = r#"{"box": {"min": [0, -2, 1.5], "max": [2, 2, 2]}}"#;
    is_near(at_origin(&object("half", half)), ring(0.0) / 2.0);
    // Two halves that touch, and a half in two parts that share an edge.
    let other = r#"{"triangle": {"vertices": [[0, -9, 2], [-9, 0, 2], [0, 9, 2]]}}"#;
    is_near(at_origin(&(object("half", half) + &object("other", other))), 0.0);
    let parts = [
        r#"{"triangle": {"vertices": [[0, -2, 1.5], [2, -2, 1.5], [0, 0.2, 1.5]]}}"#,
        r#"{"polygon": {"vertices": [[2, -2, 1.5], [2, 2, 1.5], [0, 2, 1.5], [0, 0.2, 1.5]]}}"#,
    ];
    is_near(at_origin(&(object("one", parts[0]) + &object("two", parts[1]))), ring(0.0) / 2.0);
    // A quadrant.
    let wall = r#"{"box": {"min": [-2, 0, 1], "max": [2, 2, 1.2]}}"#;
    is_near(at_origin(&(object("half", half) + &object("wall", wall))), ring(0.0) / 4.0);
    // Disks and balls leave a ring.
    let disk =
        |radius: f64| format!(r#"{{"disk": {{"center": [0, 0, 1.5], "normal": [0, 0, 1], "radius": {radius}}}}}"#);
    is_near(at_origin(&object("disk", &disk(0.3))), ring(0.6));
    is_near(at_origin(&object("disk", &disk(0.6))), 0.0);
    let ball = r#"{"sphere": {"center": [0, 0, 2], "radius": 0.4}}"#;
    is_near(at_origin(&object("ball", ball)), ring(3.0 * (0.2 / 0.96_f64.sqrt())));
    // Half a ring, and what is behind the lamp hides nothing.
    is_near(at_origin(&(object("half", half) + &object("disk", &disk(0.3).replace("1.5", "1.2")))), ring(0.75) / 2.0);
    is_near(at_origin(&object("disk", &disk(2.0).replace("1.5", "3.5"))), ring(0.0));
    // A plane through the lamp's middle.
    is_near(at_origin(&object("wall", r#"{"plane": {"coefficients": [1, 0, -0.25, 0.75]}}"#)), ring(0.0) / 2.0);
}

/// By the tracer, with 128 × 128 strata on the lamp: each on an outline errs by at most its own area, and outlines cross at most some 600.
fn agrees(lamp: &str, objects: &str) {
    let scene = scene(lamp, objects, [8, 6], 16384);
    let scene = Scene { sampling: Sampling::Center {}, ..scene };
    let exact = of(&scene);
    for pixel in (0..48).map(|k| [k % 8, k / 8]) {
        let found = exact.at(pixel.map(|side| f64::from(side) + 0.5));
        let traced = record::pixel_color(&scene, pixel, Arithmetic::F64);
        let difference = (found.value - traced).abs().max_element();
        assert!(difference < 4e-3, "{pixel:?}: {} {traced}\n{lamp}\n{objects}", found.value);
        assert!(found.error < 1e-11, "{}", found.error);
    }
}

fn number(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (0..1000_u32).prop_map(move |k| low + (high - low) * f64::from(k) / 1000.0)
}

fn point(low: [f64; 3], high: [f64; 3]) -> impl Strategy<Value = [f64; 3]> {
    [0, 1, 2].map(|k| number(low[k], high[k]))
}

fn shape() -> impl Strategy<Value = String> {
    let place = || point([-1.0, -1.0, 0.2], [1.0, 1.0, 1.6]);
    prop_oneof![
        (place(), number(0.1, 0.6))
            .prop_map(|(center, radius)| format!(r#"{{"sphere": {{"center": {center:?}, "radius": {radius}}}}}"#)),
        (place(), point([0.1, -1.0, -1.0], [1.0, 1.0, 1.0]), number(0.1, 0.7)).prop_map(
            |(center, normal, radius)| format!(
                r#"{{"disk": {{"center": {center:?}, "normal": {normal:?}, "radius": {radius}}}}}"#
            )
        ),
        (place(), point([0.1, 0.1, 0.1], [0.9, 0.9, 0.6])).prop_map(|([x, y, z], [a, b, c])| {
            let z = if z < 0.6 { 0.0 } else { z };
            format!(r#"{{"box": {{"min": {:?}, "max": {:?}}}}}"#, [x, y, z], [x + a, y + b, z + c])
        }),
        (place(), place(), place())
            .prop_map(|(a, b, c)| format!(r#"{{"triangle": {{"vertices": [{a:?}, {b:?}, {c:?}]}}}}"#)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn random_scenes_are_what_the_tracer_shows(
        center in point([-1.5, -1.5, 3.0], [1.5, 1.5, 4.0]), tilt in point([-0.3, -0.3, 1.0], [0.3, 0.3, 2.0]), radius in number(0.1, 0.9),
        shapes in prop::collection::vec(shape(), 1..4),
    ) {
        let lamp = format!(r#"{{"center": {center:?}, "normal": {tilt:?}, "radius": {radius}}}"#);
        let objects: String = shapes.iter().enumerate().map(|(k, shape)| object(&format!("shape {k}"), shape)).collect();
        agrees(&lamp, &objects);
    }
}

fn wall_and_ball() -> String {
    object("wall", r#"{"box": {"min": [-0.9, 0.1, 0], "max": [-0.5, 1.2, 1.1]}}"#)
        + &object("ball", r#"{"sphere": {"center": [0.8, 0.3, 0.6], "radius": 0.5}}"#)
}

/// A scene with the shadows of a wall and a ball on a floor, of this many pixels.
fn shadows(resolution: [u32; 2]) -> Scene {
    scene(&LAMP.replace("[0, 0, 3]", "[0.4, -0.3, 3]"), &wall_and_ball(), resolution, 4)
}

/// Pixels of that scene by 6 × 4: the lit floor, the wall's outline and its shadow, the ball's outline and its shadow, both shadows.
/// Those of which most takes long, and which show no other kinds of edges, aren't among them.
const PIXELS: [[u32; 2]; 7] = [[0, 0], [2, 0], [4, 0], [1, 2], [2, 2], [4, 2], [2, 3]];

/// What they show: computed once for the tests that need it.
static WHOLE: LazyLock<Vec<Estimate<Color>>> = LazyLock::new(|| {
    let scene = shadows([6, 4]);
    let exact = of(&scene);
    PIXELS.iter().map(|pixel| exact.pixel(*pixel)).collect()
});

/// The mean over a pixel is that over its quarters, which have their nodes elsewhere.
#[test]
fn pixels_are_the_means_of_their_quarters() {
    let fine = shadows([12, 8]);
    let fine = of(&fine);
    let mut worst: f64 = 0.0;
    for ([column, row], whole) in PIXELS.into_iter().zip(&*WHOLE) {
        let quarters = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| fine.pixel([2 * column + x, 2 * row + y]));
        let mean = quarters.iter().map(|quarter| quarter.value).sum::<Color>() / 4.0;
        let told = whole.error + quarters.iter().map(|quarter| quarter.error).sum::<f64>() / 4.0;
        let difference = (whole.value - mean).abs().max_element();
        assert!(difference <= told + 1e-13, "{column} {row}: {difference:e}, told {told:e}");
        worst = worst.max(told);
    }
    assert!(worst < 2e-7, "{worst:e}");
}

#[test]
fn sobol_converges_to_it() {
    const SEEDS: u64 = 8;
    let scene = shadows([6, 4]);
    let own = WHOLE.iter().map(|whole| whole.error).fold(0.0, f64::max);
    assert!(own < 1e-7, "{own:e}");
    let squares = |n| {
        let of_seed = |seed| {
            let scene = Scene { sampling: Sampling::Sobol { n }, seed, ..scene.clone() };
            let square = |(pixel, whole): (&[u32; 2], &Estimate<Color>)| {
                (record::pixel_color(&scene, *pixel, Arithmetic::F64) - whole.value).length_squared() / 3.0
            };
            PIXELS.iter().zip(&*WHOLE).map(square).sum::<f64>()
        };
        (0..SEEDS).map(of_seed).sum::<f64>() / (SEEDS as f64 * PIXELS.len() as f64)
    };
    let errors = [4, 16, 64, 256].map(|n| squares(n).sqrt());
    // At least as the root of the number, as independent samples do: 64 times as many err an eighth as much.
    assert!(errors.windows(2).all(|pair| pair[1] < pair[0] / 1.5) && errors[3] < errors[0] / 8.0, "{errors:?}");
    assert!(errors[3] > 100.0 * own, "{errors:?}");
    // Values between 0 and V = 1.25, the ambient part and the lamp's, have a variance of V²/4 at most (Popoviciu), and Sobol's
    // points err less than independent ones.
    for (n, error) in [4.0_f64, 16.0, 64.0, 256.0].into_iter().zip(errors) {
        assert!(error < 1.25 / (2.0 * n.sqrt()), "{n}: {errors:?}");
    }
}

#[test]
fn scenes_that_are_refused_say_why() {
    let why = |scene: &Scene| exact::picture(scene).expect_err("no exact picture").to_string();
    assert!(why(&support::scene("penumbra")).contains("`wall` isn't two-sided, opaque and diffuse only"));
    let cylinder = r#"{"cylinder": {"base": [0, 0, 0], "apex": [0, 0, 1], "radius": 0.2, "caps": true}}"#;
    assert!(why(&scene(LAMP, &object("post", cylinder), [4, 3], 1)).contains("`post` isn't a plane, box, sphere"));
    let high = r#"{"box": {"min": [2, 2, 0], "max": [3, 3, 4]}}"#;
    assert!(why(&scene(LAMP, &object("tower", high), [4, 3], 1)).contains("`tower` may reach through the plane"));
    let mut two = scene(LAMP, "", [4, 3], 1);
    two.lights.push(two.lights[0].clone());
    assert_eq!(Penumbra::of(&two).err(), Some(NotExact::Lights));
}
