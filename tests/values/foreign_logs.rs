//! Logs of other programs: without forms, without digests, with other order of keys, with operands left out and quantities of their own.

use crate::intervals::agrees;
use crate::random::Random;
use crate::support::{grid, middle, scene, scene_in};
use raywalk::log::file::{Ending, PixelReader, read, to_ndjson};
use raywalk::log::formula;
use raywalk::log::{Log, Name, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::contributions::{self, Origin};
use raywalk::report::evaluate::evaluate;
use raywalk::report::expression::substituted;
use raywalk::report::language::Language;
use raywalk::report::text::text;
use raywalk::report::{Style, computation, forms};
use serde_json::{Value as Json, json};

/// What a program writes and what it doesn't.
#[derive(Clone, Copy)]
struct Foreign {
    /// Of ten values and inputs, so many are left out.
    omitted: usize,
    /// Of ten values, so many are followed by one of the program's own.
    unknown: usize,
    seed: u64,
}

impl Foreign {
    /// The log as that program writes it, and how many quantities of its own it has.
    fn write(self, log: &Log) -> (Vec<u8>, usize) {
        let mut random = Random::new(self.seed);
        let text = to_ndjson(log).expect("memory");
        let lines = text.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
        let mut lines: Vec<Json> = lines.map(|line| serde_json::from_slice(line).expect("JSON")).collect();
        lines.pop();
        let mut header = lines.remove(0);
        header["scene"].as_object_mut().expect("an object").remove("digest");
        let (mut out, mut count, mut own) = (shuffled(&header, &mut random), 0, 0);
        for mut line in lines {
            let fields = line.as_object_mut().expect("an object");
            fields.remove("form");
            if let Some(Json::Object(given)) = fields.get_mut("given") {
                given.retain(|_, _| random.below(10) >= self.omitted);
            }
            if fields.contains_key("note") && random.below(10) < self.omitted {
                continue;
            }
            let is_note = fields.contains_key("note");
            out += &shuffled(&line, &mut random);
            count += 1;
            if is_note && random.below(10) < self.unknown {
                out += &shuffled(
                    &json!({"at": line["at"], "node": line["node"], "note": "my.own", "value": 7}),
                    &mut random,
                );
                (count, own) = (count + 1, own + 1);
            }
        }
        out += &format!("{{\"end\": {{\"events\": {count}}}}}\n");
        (out.into_bytes(), own)
    }
}

/// A line with its keys in any order.
fn shuffled(value: &Json, random: &mut Random) -> String {
    fn written(value: &Json, random: &mut Random) -> String {
        let Json::Object(fields) = value else { return value.to_string() };
        let mut fields: Vec<_> = fields.iter().map(|(key, value)| (key.clone(), value.clone())).collect();
        for end in (1..fields.len()).rev() {
            fields.swap(end, random.below(end + 1));
        }
        let fields: Vec<_> =
            fields.iter().map(|(key, value)| format!("\"{key}\": {}", written(value, random))).collect();
        format!("{{{}}}", fields.join(", "))
    }
    written(value, random) + "\n"
}

fn logs() -> Vec<Log> {
    let scenes =
        ["textbook", "glass-and-mirror", "table-top", "transmission", "penumbra", "motion-blur", "frosted-glass"];
    let scenes = scenes.map(scene);
    let logs = scenes.iter().flat_map(|scene| grid(scene, 3).into_iter().map(move |pixel| (scene, pixel)));
    logs.flat_map(|(scene, pixel)| {
        [Arithmetic::F64, Arithmetic::Decimal(3), Arithmetic::F32]
            .map(|arithmetic| record::pixel(scene, pixel, arithmetic))
    })
    .collect()
}

/// Reads what that program wrote, whole and pixel by pixel, and finds the forms.
#[track_caller]
fn read_again(text: &[u8], own: usize) -> Log {
    let found = read(text).expect("a log");
    match &found.ending {
        Ending::Complete => assert_eq!(own, 0),
        Ending::Unknown { count, key, .. } => assert_eq!((*count, key.as_str()), (own, "my.own")),
        other => panic!("{other:?}"),
    }
    let mut reader = PixelReader::open(text).expect("a log");
    let events = reader.next_pixel().expect("a log").expect("a pixel").events;
    assert_eq!(events, found.log.events);
    while reader.next_pixel().expect("a log").is_some() {}
    assert_eq!(reader.ending(), Some(&found.ending));
    let mut log = found.log;
    forms::find(&mut log);
    log
}

#[test]
fn forms_are_found_by_their_values() {
    let (mut found, mut others) = (0, Vec::new());
    for log in logs() {
        let (text, own) = Foreign { omitted: 0, unknown: 0, seed: 1 }.write(&log);
        let again = read_again(&text, own);
        assert_eq!(again.events.len(), log.events.len());
        let tree = Tree::of(&log.events);
        for (at, (ours, theirs)) in log.events.iter().zip(&again.events).enumerate() {
            let (What::Note { name, value }, What::Note { name: other, value: same }) = (&ours.what, &theirs.what)
            else {
                continue;
            };
            assert_eq!((name.key(), value), (other.key(), same));
            found += usize::from(name == other && !name.form().is_empty());
            if name != other && name.formula().is_some() {
                // Another formula with the same value, as where an ellipsoid is a sphere.
                let computed = evaluate(&again, &tree, at, *other);
                let is_same =
                    computed.is_some_and(|computed| computed.is_ok_and(|computed| near(&computed, value, &log)));
                assert!(is_same, "{name:?} became {other:?}: {value:?}");
                others.push((*name, *other));
            }
        }
    }
    // By hand and in single precision formulas often come to the same.
    assert!(found > 500 && others.len() * 3 < found, "{found} found, {} others: {others:?}", others.len());
}

#[test]
fn a_whole_log_without_forms_and_digests_is_shown_as_the_original() {
    for arithmetic in [Arithmetic::F64, Arithmetic::Decimal(3)] {
        let scene = scene("textbook");
        let log = record::pixel(&scene, middle(&scene), arithmetic);
        let (written, _) = Foreign { omitted: 0, unknown: 0, seed: 3 }.write(&log);
        assert_eq!(
            text(Language::English, &read_again(&written, 0), Style::default()),
            text(Language::English, &log, Style::default())
        );
        let (written, own) = Foreign { omitted: 0, unknown: 4, seed: 3 }.write(&log);
        assert!(own > 10);
        assert_eq!(
            text(Language::English, &read_again(&written, own), Style::default()),
            text(Language::English, &log, Style::default())
        );
    }
}

#[test]
fn no_shown_line_is_false() {
    let (mut shown, mut left_out) = (0, 0);
    for (number, log) in logs().iter().enumerate() {
        for omitted in [0, 1, 4] {
            let (written, own) = Foreign { omitted, unknown: 1, seed: number as u64 }.write(log);
            let log = read_again(&written, own);
            let tree = Tree::of(&log.events);
            // By hand a value was rounded before it was shown; in single precision it may have become zero.
            let rounding = match log.header.arithmetic.as_str() {
                "decimal:3" => 5.001e-4,
                "f32" => f64::from(f32::MIN_POSITIVE),
                _ => 0.0,
            };
            for at in 0..log.events.len() {
                // A term that is left out may be as small as what is lost in a sum.
                let noise = match log.events[at].what {
                    What::Note { value, .. } => {
                        1e-12 * value.components().iter().fold(0.0, |most: f64, x| most.max(x.abs()))
                    }
                    _ => 0.0,
                };
                let Some(computation) = computation(Language::English, &log, &tree, at, Style::default()) else {
                    continue;
                };
                match computation.substituted {
                    // What is left out of a long sum can't be read.
                    Some(line) if line.contains('…') => {}
                    Some(line) => {
                        let verdict = agrees(&line, &computation.result, '.', f64::max(rounding, noise));
                        let scene = &log.header.scene.name;
                        assert_eq!(
                            verdict,
                            Ok(true),
                            "{scene}, {}: {line} = {}",
                            computation.symbol,
                            computation.result
                        );
                        shown += 1;
                    }
                    None => left_out += 1,
                }
            }
        }
    }
    assert!(shown > 5000 && left_out > 1000, "{shown} lines with numbers, {left_out} without");
}

/// Nothing that a log of raywalk's own has loses its numbers.
#[test]
fn own_logs_show_all_numbers() {
    for log in logs() {
        let tree = Tree::of(&log.events);
        for at in 0..log.events.len() {
            let What::Note { name, .. } = log.events[at].what else { continue };
            let Some(formula) = formula::of(name) else { continue };
            // Where something blocks the light, or nothing weakens it, there are no factors.
            if name == Name::ShadowTransmittance {
                continue;
            }
            for digits in [0, 3, 12] {
                let shown = substituted(&log, &tree, at, formula, Style::default().with(digits), &[]);
                assert!(
                    shown.is_some(),
                    "{} {}: {name:?}, {digits} digits",
                    log.header.scene.name,
                    log.header.arithmetic
                );
            }
        }
        let mut again = log.clone();
        forms::find(&mut again);
        assert_eq!(again, log);
    }
}

#[test]
fn what_a_log_leaves_open_is_no_rounding() {
    let scene = scene("textbook");
    for arithmetic in [Arithmetic::F64, Arithmetic::Decimal(3)] {
        let mut log = record::pixel(&scene, middle(&scene), arithmetic);
        let origins = |log: &Log| {
            let account = contributions::account(log, &Tree::of(&log.events), 0);
            let rest = account
                .contributions
                .iter()
                .filter(|part| matches!(part.origin, Origin::Rounding | Origin::Unexplained));
            rest.map(|part| part.origin).collect::<Vec<_>>()
        };
        assert!(!origins(&log).contains(&Origin::Unexplained));
        // The weights are what the account needs.
        log.events = log.events.with_inputs_where(|(name, _)| *name != Name::WeightReflected);
        assert_eq!(origins(&log), [Origin::Unexplained], "{arithmetic}");
    }
}

/// Half a unit of what is shown, and the log's own rounding; in single precision also what is too large or too small for it.
fn near(computed: &Value, logged: &Value, log: &Log) -> bool {
    let hand = if log.header.arithmetic == "decimal:3" { 0.000_500_1 } else { 0.0 };
    let is_single = log.header.arithmetic == "f32";
    let (computed, logged) = (computed.components(), logged.components());
    let scale = logged.iter().fold(0.0, |scale: f64, x| scale.max(x.abs()));
    let near = |(a, b): (&f64, &f64)| {
        let a = if is_single { a.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) } else { *a };
        let least = if is_single { f64::from(f32::MIN_POSITIVE) } else { 0.0 };
        (a - b).abs() <= f64::max(hand, 0.000_500_1 * b.abs().min(1.0)) + 1e-9 * scale + least
    };
    computed.len() == logged.len() && computed.iter().zip(logged).all(near)
}

/// A value that follows from several formulas was computed by the one that the header names.
#[test]
fn under_the_formulas_of_the_notes_forms_are_those_of_the_notes() {
    let mut printed = 0;
    for name in ["textbook", "glass-and-mirror", "transmission", "total-reflection"] {
        let scene = scene_in(name, Arithmetic::Decimal(3));
        for pixel in grid(&scene, 6) {
            let log = record::pixel(&scene, pixel, Arithmetic::Decimal(3));
            let (written, _) = Foreign { omitted: 0, unknown: 0, seed: 5 }.write(&log);
            let again = read_again(&written, 0);
            for (ours, theirs) in log.events.iter().zip(&again.events) {
                let (What::Note { name, .. }, What::Note { name: other, .. }) = (&ours.what, &theirs.what) else {
                    continue;
                };
                if ["notes", "normalized"].contains(&name.form()) {
                    assert_eq!(name, other, "{}", log.header.scene.name);
                    printed += 1;
                }
            }
        }
    }
    assert!(printed > 50, "{printed}");
}

/// No comparison is made up for a value that contradicts its own operands.
#[test]
fn a_contradicted_value_has_no_comparison() {
    let scene = scene("textbook");
    let mut log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
    let shown = |log: &Log| text(Language::English, log, Style::default()).matches("T2_A < 0").count();
    assert_eq!(shown(&log), 2);
    for event in &mut log.events {
        if let What::Note { name: Name::SphereT2a, value } = &mut event.what {
            *value = Value::Number(5.0);
        }
    }
    assert_eq!(shown(&log), 0);
}

/// Inputs that are on an event of an unknown quantity count all the same.
#[test]
fn inputs_of_unknown_quantities_are_kept() {
    let scene = scene("textbook");
    let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
    let lines = String::from_utf8(to_ndjson(&log).expect("memory")).expect("UTF-8");
    let renamed = lines.replace("\"note\":\"ray.length\"", "\"note\":\"my.own\"");
    let cut = renamed.lines().filter(|line| !line.starts_with("{\"end\""));
    let whole = cut.map(|line| line.to_owned() + "\n").collect::<String>() + "{\"end\":{\"events\":98}}\n";
    let again = read_again(whole.as_bytes(), 1);
    let given = |log: &Log| log.events.with_given().map(|(_, given)| given.len()).sum::<usize>();
    assert_eq!(given(&again), given(&log));
    // They are written and read in the order of the table, as all inputs are.
    let off_middle = to_ndjson(&record::pixel(&scene, [10, 20], Arithmetic::F64)).expect("memory");
    let renamed = String::from_utf8(off_middle).expect("UTF-8").replace("\"note\":\"pixel.x\"", "\"note\":\"my.own\"");
    let carried = read(renamed.as_bytes()).expect("a log").log;
    assert_eq!(read(&to_ndjson(&carried).expect("memory")).expect("a log").log, carried);
    assert!(
        text(Language::English, &again, Style::default())
            .contains("V_o = −(N_p · O + D_p) = −((1, 0, 0)·(16, 2, 7) + (-4)) = -12 ")
    );
}
