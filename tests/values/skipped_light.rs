//! Light of which zeros among the factors leave nothing: which rays that saves, and that small numbers aren't taken for zeros.

use super::skips::{picture, skipped};
use crate::support;
use proptest::prelude::*;
use raywalk::log::{Decision, SkipReason, Step, Term, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::{Counter, Statistics};
use raywalk::scene::{Color, Sampling, Scene, Skip};

/// A floor that the eye looks down on with a lamp above it, and nothing else.
fn floor(light: [f64; 3], material: &str) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1",
        "camera": {{"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [3, 3], "vertical_fov": 20}},
        "lights": [{{"name": "lamp", "point": {{"position": [0, 1, 4]}}, "color": {light:?}}}],
        "materials": {{"floor": {{{material}}}}},
        "objects": [{{"name": "floor", "shape": {{"plane": {{"coefficients": [0, 0, 1, 0]}}}}, "material": "floor"}}]}}"#
    );
    support::scene_of(text.as_bytes(), "floor")
}

/// Filters before lamps of several colours: a scene in which every rule but a cutoff's leaves something out.
pub fn all_kinds() -> Scene {
    let text = r#"{"format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 5], "direction": [0.02, 0.03, -1], "resolution": [3, 2], "vertical_fov": 20},
        "ambient": [0.1, 0.2, 0.3], "background": [0.5, 0.4, 0.3],
        "lights": [{"name": "white", "point": {"position": [0, 0, 9]}},
            {"name": "black", "point": {"position": [0, 1, 9]}, "color": [0, 0, 0]},
            {"name": "red", "point": {"position": [1, 1, 9]}, "color": [3, 0, 0]},
            {"name": "blue", "disk": {"center": [0, 0, -0.5], "normal": [0, 0, 1], "radius": 0.3}, "samples": 2,
             "color": [0, 0, 2]},
            {"name": "hidden", "point": {"position": [0, 0, -9]}}],
        "materials": {
            "filter": {"diffuse": [0.1, 0, 0.2], "weights": {"local": 1, "reflected": [0, 0.2, 0], "transmitted": [0.9, 0, 0]}},
            "cyan": {"diffuse": [0, 0.4, 0.5], "specular": [0, 1, 1], "transmission": [0, 0.5, 0.5],
                     "weights": {"local": [0, 0.5, 0.5], "transmitted": [1, 0.2, 0]}},
            "pink": {"diffuse": [0.3, 0, 0.5], "weights": {"local": 1, "reflected": [0, 0.5, 0]}},
            "none": {"weights": {"local": 1, "transmitted": 0.5}},
            "unseen": {"diffuse": [1, 1, 1], "weights": {"local": 0, "transmitted": 1}}},
        "objects": [
            {"name": "front", "shape": {"plane": {"coefficients": [0, 0, 1, -1]}}, "material": "filter"},
            {"name": "unseen", "shape": {"plane": {"coefficients": [0, 0, 1, -0.5]}}, "material": "unseen"},
            {"name": "middle", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "cyan"},
            {"name": "none", "shape": {"plane": {"coefficients": [0, 0, 1, 0.75]}}, "material": "none"},
            {"name": "back", "shape": {"plane": {"coefficients": [0, 0, 1, 1]}}, "material": "pink"}],
        "tracing": {"max_depth": 6}}"#;
    support::scene_of(text.as_bytes(), "all kinds")
}

fn counted(scene: &Scene) -> Statistics {
    statistics(&picture(scene).1)
}

fn statistics(counter: &Counter) -> Statistics {
    counter.statistics(0, Default::default(), 0)
}

/// How many shadow rays its picture takes.
fn shadow_rays(scene: &Scene) -> u64 {
    let json = serde_json::to_value(counted(scene)).expect("JSON");
    json["rays"]["shadow"].as_u64().expect("a number")
}

#[test]
fn a_scene_for_every_rule() {
    let counts = skipped(&picture(&all_kinds()).1);
    for rule in SkipReason::ALL {
        // There is no cutoff, and planes of glass block nothing but what lies behind the back.
        let is_absent = matches!(rule, SkipReason::Cutoff | SkipReason::Blocked);
        assert!(is_absent || counts[rule.word()] > 0, "{rule:?}: {counts:?}");
    }
}

#[test]
fn a_light_without_colour_and_one_that_the_surface_swallows_get_no_shadow_ray() {
    const CYAN: &str = r#""diffuse": [0, 0.5, 0.5], "specular": [0, 1, 0]"#;
    for (light, material) in [([0.0; 3], r#""diffuse": [1, 1, 1]"#), ([2.0, 0.0, 0.0], CYAN)] {
        let mut scene = floor(light, material);
        let statistics = counted(&scene);
        assert_eq!((statistics.skipped["zero_light"], statistics.saved["zero_light"]), (9, 9));
        assert_eq!(shadow_rays(&scene), 0);
        scene.tracing.skip = Skip::NONE;
        assert_eq!(shadow_rays(&scene), 9);
    }
    let scene = floor([2.0, 0.1, 0.0], CYAN);
    assert_eq!((shadow_rays(&scene), counted(&scene).skipped["zero_light"]), (9, 0));
}

#[test]
fn light_of_which_the_weights_leave_nothing_gets_no_shadow_ray() {
    // W_l takes the red that the light and the surface have in common.
    let mut scene = floor([2.0, 0.1, 0.0], r#""diffuse": [0.5, 0, 0.5], "weights": {"local": [0, 1, 1]}"#);
    let statistics = counted(&scene);
    assert_eq!((statistics.skipped["zero_path_light"], statistics.saved["zero_path_light"]), (9, 9));
    assert_eq!(shadow_rays(&scene), 0);
    scene.tracing.skip = Skip::NONE.with(SkipReason::ZeroLight);
    assert_eq!(shadow_rays(&scene), 9);
}

/// A colour whose channels are there or not.
fn channels() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(prop::sample::select(vec![0.0, 0.0, 0.25, 3.0]))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Behind a filter, the light gets a shadow ray where some channel comes through all of them: the filter, W_l, the light's colour, and
    /// one of the two coefficients. From the back it is the coefficient of what shines through.
    #[test]
    fn a_light_gets_a_shadow_ray_where_a_channel_is_left(
        [filter, local, light, diffuse, specular, through] in [channels(), channels(), channels(), channels(), channels(), channels()],
        is_behind: bool,
    ) {
        let height = if is_behind { -2 } else { 3 };
        let text = format!(
            r#"{{"format": "raywalk-scene/1",
            "camera": {{"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [1, 1], "vertical_fov": 20}},
            "lights": [{{"name": "lamp", "point": {{"position": [0, 1, {height}]}}, "color": {light:?}}}],
            "materials": {{
                "filter": {{"weights": {{"local": 0, "transmitted": {filter:?}}}}},
                "floor": {{"diffuse": {diffuse:?}, "specular": {specular:?}, "transmission": {through:?}, "weights": {{"local": {local:?}}}}}}},
            "objects": [
                {{"name": "filter", "shape": {{"plane": {{"coefficients": [0, 0, 1, -4]}}}}, "material": "filter"}},
                {{"name": "floor", "shape": {{"plane": {{"coefficients": [0, 0, 1, 0]}}}}, "material": "floor"}}]}}"#
        );
        let scene = support::scene_of(text.as_bytes(), "filtered");
        let is_left = |channel: usize| {
            let used = if is_behind { through[channel] } else { diffuse[channel] + specular[channel] };
            [filter, local, light].iter().all(|factor| factor[channel] > 0.0) && used > 0.0
        };
        prop_assert_eq!(shadow_rays(&scene), u64::from((0..3).any(is_left)), "{}", text);
    }
}

/// The local model behind a filter of another colour: neither its weight nor that of the path is zero.
#[test]
fn a_local_model_of_which_the_path_leaves_nothing_is_left_out() {
    let mut scene = all_kinds();
    let log = record::pixel(&scene, [1, 1], Arithmetic::F64);
    let why = |rule| {
        let decision = Decision::Skipped { what: Term::Local, why: rule };
        log.events.iter().filter(|event| event.what == What::Mark(decision)).count()
    };
    // The front lets red through, which the one in the middle doesn't show of itself.
    assert_eq!((why(SkipReason::ZeroPathLocal), why(SkipReason::ZeroLocal)), (1, 1));
    let statistics = counted(&scene);
    let lights_and_points = 4 + 2;
    assert_eq!(statistics.saved["zero_path_local"], statistics.skipped["zero_path_local"] * lights_and_points);
    let with_all = shadow_rays(&scene);
    scene.tracing.skip = Skip::ALL.without(SkipReason::ZeroPathLocal).without(SkipReason::ZeroPathLight);
    assert!(shadow_rays(&scene) > with_all);
}

/// Products that are too small for a number aren't zeros: a bright light shows them.
#[test]
fn small_factors_are_no_zeros() {
    for [light, diffuse, local] in [[1e100, 1e-200, 1e-250], [1e-200, 1e-200, 1.0], [1.0, 1e-200, 1e-200]] {
        let material = format!(r#""diffuse": [{diffuse:?}, 0, 0], "weights": {{"local": [{local:?}, 0, 0]}}"#);
        let scene = floor([light, 0.0, 0.0], &material);
        assert_eq!(shadow_rays(&scene), 9, "{light} {diffuse} {local}");
        let skipped = counted(&scene).skipped;
        assert!(skipped.iter().all(|(rule, count)| *count == 0 || *rule == "zero_term"), "{skipped:?}");
    }
}

/// A rule's count in rays: of a blurred bounce all of them, of a bounce beyond the depth limit too.
#[test]
fn the_statistics_say_how_many_rays_were_saved() {
    let blurred = r#""diffuse": [1, 1, 1], "gloss_exponent": 20, "samples": 16,
        "weights": {"local": 1, "reflected": [0.5, 0, 0]}"#;
    let mut scene = floor([1.0; 3], blurred);
    scene.tracing.max_depth = 0;
    let statistics = counted(&scene);
    assert_eq!((statistics.saved["depth_limit"], statistics.saved["zero_weight"]), (9 * 16, 0));
    let text = statistics.to_string();
    assert!(text.contains("rays beyond the depth limit: 144\n"), "{text}");
    scene.materials.iter_mut().for_each(|material| {
        material.weights.reflected = Color::ZERO;
        material.weights.transmitted = Color::new(0.0, 0.0, 1.0);
        material.ior = 1.5;
    });
    scene.tracing.max_depth = 2;
    let statistics = counted(&scene);
    assert_eq!((statistics.skipped["zero_weight"], statistics.saved["zero_weight"]), (9, 9 * 16));
    assert!(statistics.to_string().contains("skipped zero_weight: 9 (144 rays)\n"));
    // What shortens no ray tree saves no ray.
    assert_eq!((statistics.skipped["zero_term"], statistics.saved["zero_term"]), (9, 0));
}

#[test]
fn corners_that_pixels_share_are_rays_that_were_saved() {
    let mut scene = floor([1.0; 3], r#""diffuse": [1, 1, 1]"#);
    for n in [1, 2] {
        scene.sampling = Sampling::Shared { n };
        let corners = u64::from(3 * n + 1).pow(2);
        let alone = 9 * u64::from(n + 1).pow(2);
        assert_eq!(counted(&scene).saved["shared"], alone - corners);
    }
    // All of the floor looks alike, so that no cell is cut.
    scene.sampling = Sampling::Adaptive { threshold: 1.0, depth: 3 };
    let statistics = counted(&scene);
    assert_eq!((statistics.samples, statistics.saved["shared"]), (16, 9 * 4 - 16));
    // Where cells are cut, a pixel by itself takes the corners that its log has.
    let mut scene = support::changed_scene("figure-17", |file| file.camera.resolution = [20, 15]);
    scene.sampling = Sampling::Adaptive { threshold: 0.1, depth: 3 };
    let statistics = counted(&scene);
    let pixels = (0..15).flat_map(|y| (0..20).map(move |x| [x, y]));
    let alone: usize = pixels
        .map(|pixel| {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let is_sample = |what: &What| matches!(what, What::Enter { step: Step::Sample { .. }, .. });
            log.events.iter().filter(|event| is_sample(&event.what)).count()
        })
        .sum();
    assert_eq!(statistics.saved["shared"] + statistics.samples, alone as u64);
    scene.sampling = Sampling::Regular { n: 2 };
    assert_eq!(counted(&scene).saved["shared"], 0);
}

/// The floor is all there is: of the light's points none can be hidden from it.
#[test]
fn shadow_rays_that_nothing_can_block_are_reported() {
    let text = r#"{"format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [3, 3], "vertical_fov": 20},
        "lights": [{"name": "lamp", "sphere": {"center": [0, 1, 4], "radius": 0.5}, "samples": 4}],
        "materials": {"floor": {"diffuse": [1, 1, 1]}},
        "objects": [{"name": "floor", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "floor"}]}"#;
    let scene = support::scene_of(text.as_bytes(), "free");
    let statistics = counted(&scene);
    assert_eq!(statistics.free_shadow_rays, 9 * 4);
    assert!(statistics.to_string().contains("shadow rays that nothing could block: 36\n"));
    let with_ball = text.replace(
        r#""material": "floor"}]"#,
        r#""material": "floor"},
        {"name": "ball", "shape": {"sphere": {"center": [0, 0.5, 2], "radius": 0.3}}, "material": "floor"}]"#,
    );
    let statistics = counted(&support::scene_of(with_ball.as_bytes(), "blocked"));
    assert!(statistics.free_shadow_rays < 36, "{}", statistics.free_shadow_rays);
}
