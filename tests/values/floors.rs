//! Floors are shown with as many decimals as give them.

use crate::support;
use proptest::prelude::*;
use raywalk::log::{Log, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::report::{Style, computation};
use raywalk::scene::file::schema::Formulas;

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    /// Surfaces on the sides of a checkerboard's cubes, or as near to one as the next numbers are.
    #[test]
    fn floors_are_those_of_the_shown_numbers(
        size in prop_oneof![(1..2000_u32).prop_map(|k| f64::from(k) / 1000.0), 0.01..3.0, (3..12_u32).prop_map(|k| 1.0 / f64::from(k))],
        cubes in -6..7_i32, steps in -2..3_i32, axis in 0..3_usize, tilt in prop_oneof![Just(0.0), -0.01..0.01],
    ) {
        let mut height = size * f64::from(cubes);
        for _ in 0..steps.abs() {
            height = if steps < 0 { height.next_down() } else { height.next_up() };
        }
        let mut plane = [tilt, tilt, tilt];
        plane[axis] = 1.0;
        let mut eye = [0.3, 0.7, 0.45];
        eye[axis] += height + 4.0;
        let mut target = [0.1, 0.2, 0.3];
        target[axis] = height;
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": {eye:?}, "look_at": {target:?}, "up": [0.1, 1.7, 0.9], "resolution": [6, 4]}},
            "lights": [{{"point": {{"position": {eye:?}}}}}],
            "materials": {{"tiles": {{"diffuse": [1, 1, 1], "pattern": {{"checker": {{"a": [1, 1, 1], "b": [0, 0, 0], "size": {size:?}}}}}}}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [{}, {}, {}, {:?}]}}}}, "material": "tiles"}}]}}"#,
            plane[0], plane[1], plane[2], -height
        );
        let scene = support::scene_of(text.as_bytes(), "tiles");
        let read: usize = (0..4).map(|k| floors(&record::pixel(&scene, [k, k], Arithmetic::F64))).sum();
        prop_assert!(read >= 4 * 2 * 3 * 2, "{read}");
    }
}

#[test]
fn the_issue_s_floor_reads_back() {
    let scene = support::changed_scene("motion-blur", |file| {
        file.camera.resolution = [60, 45];
        file.tracing.formulas = Some(Formulas::Notes);
    });
    assert!(floors(&record::pixel(&scene, [53, 21], Arithmetic::F64)) > 20);
}

/// Reads all floors of a log, in exact arithmetic; how many there were.
#[track_caller]
fn floors(log: &Log) -> usize {
    let tree = Tree::of(&log.events);
    let mut read = 0;
    for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
        for event in 0..log.events.len() {
            for digits in [3, 1, 12] {
                let Some(computation) = computation(language, log, &tree, event, Style::default().with(digits)) else {
                    continue;
                };
                let Some((before, inner)) = computation.substituted.as_ref().and_then(|line| line.split_once('⌊'))
                else {
                    continue;
                };
                let inner = inner.strip_suffix('⌋').expect("nothing behind it");
                let (above, below) = match inner.rsplit_once('/') {
                    Some((above, below)) => (decimals(above, mark), decimals(below, mark)),
                    None => (decimals(inner, mark), vec![(1, 0)]),
                };
                let results = decimals(&computation.result, mark);
                if before.is_empty() {
                    for (above, result) in above.iter().zip(&results) {
                        assert_eq!(
                            floor(*above, below[0]),
                            result.0,
                            "{} = {}",
                            computation.line(),
                            computation.result
                        );
                    }
                } else {
                    // σ − 2·⌊σ/2⌋, of whole numbers.
                    assert_eq!(above[0].0 - 2 * floor(above[0], below[0]), results[0].0, "{}", computation.line());
                }
                read += 1;
            }
        }
    }
    read
}

/// The numbers of a triple, or one, each with its digits and how many of them are decimals.
fn decimals(text: &str, mark: char) -> Vec<(i128, i32)> {
    let text = text.trim_matches(['(', ')']);
    let number = |text: &str| {
        let (mantissa, power) = text.trim().split_once("·10").unwrap_or((text.trim(), ""));
        let power: String = power
            .chars()
            .map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c).map_or('-', |k| char::from(b'0' + k as u8)))
            .collect();
        let places = mantissa.split_once(mark).map_or(0, |(_, decimals)| decimals.len() as i32);
        let digits = mantissa.replace(mark, "").parse().expect("a number");
        (digits, places - power.parse::<i32>().unwrap_or(0))
    };
    text.split(if mark == ',' { ';' } else { ',' }).map(number).collect()
}

/// The floor of a quotient.
fn floor((above, places): (i128, i32), (below, of_below): (i128, i32)) -> i128 {
    let ten = |places: i32| 10_i128.pow(places.try_into().expect("not negative"));
    let most = places.max(of_below);
    // The smallest numbers here are above 10⁻²⁰ in size.
    (above * ten(most - places)).div_euclid(below * ten(most - of_below))
}
