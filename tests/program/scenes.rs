//! Every scene file: its ray tree at the middle pixel, pinned; and a recorded pixel that equals the rendered one.
//!
//! A new file in `scenes/` is a new test without code.

use crate::support::{ARITHMETICS, grid, middle, scene, scene_of, snapshots};
use raywalk::log::{Event, Input, Value, What};
use raywalk::probe::Silent;
use raywalk::record::{self, Arithmetic};
use raywalk::report::{Style, outline};
use raywalk::sampling;
use raywalk::scene::builtin;

#[test]
fn ray_tree_of_the_middle_pixel() {
    let settings = snapshots();
    settings.bind(|| {
        insta::glob!("../../scenes", "*.json", |path| {
            let text = std::fs::read(path).expect("a readable scene");
            let name = path.file_stem().expect("a file name").to_string_lossy();
            let scene = scene_of(&text, &name);
            let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
            insta::assert_snapshot!("ray_tree", outline::outline(&log, Style::default()));
        });
    });
}

#[test]
fn every_scene_file_is_built_in() {
    let files = std::fs::read_dir("scenes").expect("the folder of scenes");
    let mut stems: Vec<_> = files
        .filter_map(|entry| {
            let path = entry.expect("an entry").path();
            let is_scene = path.extension().is_some_and(|ending| ending == "json");
            is_scene.then(|| path.file_stem().expect("a name").to_string_lossy().into_owned())
        })
        .collect();
    stems.sort();
    assert_eq!(stems, builtin::names().collect::<Vec<_>>());
}

#[test]
fn the_recorded_colour_is_the_silent_one_bit_for_bit() {
    for name in builtin::names() {
        let scene = scene(name);
        for arithmetic in ARITHMETICS {
            for pixel in grid(&scene, 9) {
                let recorded = record::pixel(&scene, pixel, arithmetic);
                let silent = record::pixel_color(&scene, pixel, arithmetic);
                let Some(What::Result { color }) = recorded.events.last().map(|event| &event.what) else {
                    panic!("{name} {pixel:?}: a log ends with the result");
                };
                let same = color.iter().zip(silent.to_array()).all(|(a, b)| a.to_bits() == b.to_bits());
                assert!(same, "{name} {pixel:?} {arithmetic}: {color:?} is not {silent:?}");
            }
        }
    }
}

#[test]
fn logs_hold_finite_numbers_and_nodes_that_nest() {
    for name in builtin::names() {
        let scene = scene(name);
        for pixel in grid(&scene, 15) {
            let arithmetics = [&ARITHMETICS[..], &[Arithmetic::Decimal(0), Arithmetic::Decimal(1)]].concat();
            for arithmetic in arithmetics {
                let log = record::pixel(&scene, pixel, arithmetic);
                assert!(log.events.with_given().all(is_finite), "{name} {pixel:?} {arithmetic}");
            }
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let mut open = vec![0];
            for (index, event) in log.events.iter().enumerate() {
                assert_eq!(event.at as usize, index + 1);
                match event.what {
                    What::Enter { parent, .. } => {
                        assert_eq!(Some(&parent), open.last());
                        open.push(event.node);
                    }
                    What::Leave => assert_eq!(open.pop(), Some(event.node)),
                    _ => assert_eq!(Some(&event.node), open.last()),
                }
            }
            assert_eq!(open, [0]);
        }
    }
}

fn is_finite((event, given): (&Event, &[Input])) -> bool {
    let all = |value: &Value| value.components().iter().all(|x| x.is_finite());
    let noted = match &event.what {
        What::Note { value, .. } => all(value),
        What::Result { color } => color.iter().all(|x| x.is_finite()),
        _ => true,
    };
    noted && given.iter().all(|(_, value)| all(value))
}

#[test]
fn every_arithmetic_is_its_own_result() {
    // The numeric example ends at different numbers, so none of the arithmetics is another one in disguise.
    let scene = scene("textbook");
    let mut reds: Vec<_> =
        ARITHMETICS.iter().map(|arithmetic| record::pixel_color(&scene, [160, 120], *arithmetic).x).collect();
    reds.sort_by(f64::total_cmp);
    reds.dedup();
    assert_eq!(reds.len(), ARITHMETICS.len());
    let by_hand = sampling::pixel(&scene, [160, 120], &mut Silent);
    assert_eq!(by_hand, record::pixel_color(&scene, [160, 120], Arithmetic::F64));
}

/// Where a light does reach a surface and its colour leaves nothing there, that is the reason, wherever it is.
#[test]
fn lights_whose_colour_leaves_nothing_are_reported_so() {
    let check = |floor: &str, above: &str, expected: &str| {
        let scene = format!(
            r#"{{"format": "raywalk-scene/1", "name": "room", "camera": {{"position": [0, 2, 6], "look_at": [0, 1, 0]}},
            "lights": [{{"point": {{"position": [1, 9, 1]}}, "color": [1, 0, 0]}}],
            "materials": {{"cyan": {{"diffuse": {floor}}}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "cyan"}}{above}]}}"#
        );
        let output = crate::calls::raywalk(&["scene", "check", "-"]).write_stdin(scene).output().expect("it runs");
        let said = String::from_utf8(output.stderr).expect("UTF-8");
        assert!(output.status.success() && said.contains(expected), "expected `{expected}` in: {said}");
        said
    };
    let nothing = "lights nothing in view: its colour and the coefficients of the surfaces seen through 3072 pixels leave nothing";
    let said = check("[0, 1, 1]", "", nothing);
    assert!(!said.contains("field of view"), "{said}");
    // The coefficients alone, wherever the light is: a ball has a side that the light is behind.
    let ball = r#", {"shape": {"sphere": {"center": [0, 1, 0], "radius": 1}}, "material": "cyan"}"#;
    check(
        "[0, 1, 1]",
        ball,
        "it reaches none, or its colour and their coefficients leave nothing of any channel; it is outside",
    );
    for above in ["", ball] {
        check("[0, 0, 0]", above, "lights nothing in view: K_d, K_e and K_t of every surface are 0 in every channel");
    }
    check("[1, 1, 1]", "", "is outside the field of view, which it lights all the same");
}

/// A light that is off is reported as such, whether surfaces are turned to it or not.
#[test]
fn lights_without_a_colour_are_reported_so() {
    let scene = r#"{"format": "raywalk-scene/1", "name": "room", "camera": {"position": [0, 2, 6], "look_at": [0, 1, 0]},
        "lights": [{"point": {"position": [1, 9, 1]}, "color": [0, 0, 0]}, {"point": {"position": [1, 9, 1]}}],
        "materials": {"clay": {"diffuse": [1, 1, 1]}},
        "objects": [{"shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "clay"},
                    {"shape": {"sphere": {"center": [0, 1, 0], "radius": 1}}, "material": "clay"}]}"#;
    let output = crate::calls::raywalk(&["scene", "check", "-"]).write_stdin(scene).output().expect("it runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    let of_lights: Vec<_> = said.lines().filter(|line| line.contains("lights nothing")).collect();
    assert!(
        of_lights.len() == 1
            && of_lights[0].ends_with("lights[0]: lights nothing in view: its colour is 0 in every channel"),
        "{said}"
    );
}

/// A surface whose local weight is 0 asks for no light: that is the reason, not that the light doesn't get there.
#[test]
fn lights_of_surfaces_without_a_local_term_are_reported_so() {
    let check = |floor: [f64; 3], ball: &str| {
        let scene = format!(
            r#"{{"format": "raywalk-scene/1", "name": "room", "camera": {{"position": [0, 2, 6], "look_at": [0, 1, 0]}},
            "lights": [{{"point": {{"position": [1, 2, 1]}}}}, {{"point": {{"position": [0, -1, 0]}}}}],
            "materials": {{"mirror": {{"diffuse": [1, 1, 1], "weights": {{"local": {floor:?}, "reflected": 1}}}}, "clay": {{"diffuse": [1, 1, 1]}}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "mirror"}},
                        {{"shape": {{"sphere": {{"center": [0, 1, 0], "radius": 1}}}}, "material": "{ball}"}}]}}"#
        );
        let output = crate::calls::raywalk(&["scene", "check", "-"]).write_stdin(scene).output().expect("it runs");
        let said = String::from_utf8(output.stderr).expect("UTF-8");
        assert!(output.status.success(), "{said}");
        let reasons = said.lines().filter_map(|line| line.split_once(": lights nothing in view: "));
        reasons.map(|(light, why)| (light.ends_with("lights[0]"), why.to_owned())).collect::<Vec<_>>()
    };
    let unweighted = "no surface seen through 3072 pixels has a local term that weighs more than 0".to_owned();
    assert_eq!(check([0.0; 3], "mirror"), [(true, unweighted.clone()), (false, unweighted)]);
    // The ball has one, which the first light reaches and the second doesn't, whatever it does to the floor.
    let why = "of the surfaces seen through 3072 pixels it reaches none, or its colour and their coefficients leave nothing of any channel";
    assert_eq!(check([0.0; 3], "clay"), [(false, why.to_owned())]);
    // The floor has one in green.
    let why = "reaches no surface seen through 3072 pixels".to_owned();
    assert_eq!(check([0.0, 0.5, 0.0], "mirror"), [(false, why)]);
}
