//! Logs as files: what is written reads back the same, and what was cut off or damaged is said.

use crate::support::{grid, middle, scene, scene_of};
use raywalk::log::file::{Ending, read, to_json, to_ndjson};
use raywalk::log::{Log, Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::builtin;

fn textbook_log() -> Log {
    record::pixel(&scene("textbook"), [160, 120], Arithmetic::F64)
}

#[test]
fn both_forms_read_back_the_same_bits() {
    for name in builtin::names() {
        let scene = scene(name);
        for pixel in grid(&scene, 4) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            for bytes in [to_ndjson(&log).expect("memory"), to_json(&log).expect("memory")] {
                let found = read(&bytes).expect("a log");
                assert_eq!(found.ending, Ending::Complete, "{name} {pixel:?}");
                assert_eq!(found.log.header, log.header);
                assert_eq!(found.log.events, log.events);
                for (ours, theirs) in found.log.events.iter().zip(&log.events) {
                    if let (What::Note { value: a, .. }, What::Note { value: b, .. }) = (&ours.what, &theirs.what) {
                        // Equality would let -0 pass for 0.
                        assert!(a.same_bits(b), "{name} {pixel:?}: {a:?} {b:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_document_is_json_and_nests() {
    let bytes = to_json(&textbook_log()).expect("memory");
    let document: serde_json::Value = serde_json::from_slice(&bytes).expect("JSON");
    assert_eq!(document["header"]["log"], "raywalk-log/1");
    let camera_ray = &document["children"][0];
    assert_eq!(camera_ray["path"], "C");
    assert_eq!(camera_ray["children"][2]["children"][0]["note"], "plane.v_d");
    assert_eq!(document["children"][1]["node"], 0);
    assert!(document["end"]["events"].as_u64().is_some_and(|events| events > 50));
}

#[test]
fn a_deep_document_reads_back() {
    let mut scene = scene("hall-of-mirrors");
    scene.tracing.max_depth = 256;
    let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
    let found = read(&to_json(&log).expect("memory")).expect("a log");
    assert_eq!((found.ending, found.log), (Ending::Complete, log));
}

#[test]
fn a_document_that_nests_without_end_is_refused() {
    let text = format!("{{\"header\": {}", "[".repeat(200_000));
    assert_eq!(read(text.as_bytes()).expect_err("too deep").to_string(), "1:1: brackets nested more than 4114 deep");
}

#[test]
fn what_stands_after_the_end_is_said() {
    let mut bytes = to_ndjson(&textbook_log()).expect("memory");
    bytes.extend_from_slice(b"{}\n");
    let found = read(&bytes).expect("a log");
    assert_eq!(found.ending, Ending::Mismatch { what: "2 bytes follow its end line".into() });
}

#[test]
fn what_stands_after_a_document_is_said() {
    let document = to_json(&textbook_log()).expect("memory");
    assert_eq!(read(&[&document[..], b" \n"].concat()).expect("a log").ending, Ending::Complete);
    for behind in [&b"{}"[..], b"]", b"\0"] {
        let found = read(&[&document[..], behind].concat()).expect("a log");
        assert_eq!(found.log, textbook_log());
        assert_eq!(found.ending, Ending::Mismatch { what: "other text follows the document".into() });
    }
}

/// Logs that no raywalk wrote, as other programs may: nodes are left that weren't entered, pixels open while nodes are.
#[test]
fn nodes_that_do_not_match_are_written_and_read_back() {
    let lines = String::from_utf8(to_ndjson(&textbook_log()).expect("memory")).expect("UTF-8");
    let header = lines.lines().next().expect("a header");
    let enter = |number: u32| format!(r#"{{"at":{number},"node":{number},"enter":{{"combine":{{}}}}}}"#);
    let pixel = r#"{"at":0,"node":0,"enter":{"pixel":[1,2]},"parent":7}"#.to_owned();
    let leave = r#"{"at":9,"node":9,"leave":{}}"#.to_owned();
    let logs = [
        vec![leave.clone(), enter(1), leave.clone(), leave.clone(), leave.clone(), enter(2)],
        vec![pixel.clone(), enter(1), enter(2), pixel.clone(), leave.clone(), leave.clone(), pixel.clone()],
    ];
    for events in logs {
        let text = format!("{header}\n{}\n", events.join("\n"));
        let log = read(text.as_bytes()).expect("a log").log;
        assert_eq!(log.events.len(), events.len());
        for written in [to_ndjson(&log).expect("memory"), to_json(&log).expect("memory")] {
            let again = read(&written).expect("a log");
            assert_eq!((again.ending, &again.log), (Ending::Complete, &log), "{}", String::from_utf8_lossy(&written));
        }
    }
}

#[test]
fn names_are_escaped() {
    let text = scene_text_with_names("a \\\"quoted\\\" \\\\ name", "lámpara");
    let scene = scene_of(text.as_bytes(), "names");
    let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
    assert_eq!(log.header.objects[0], "a \"quoted\" \\ name");
    assert_eq!(read(&to_ndjson(&log).expect("memory")).expect("a log").log, log);
}

fn scene_text_with_names(object: &str, light: &str) -> String {
    format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 5], "direction": [0, 0, -1]}},
            "lights": [{{"name": "{light}", "point": {{"position": [0, 5, 5]}}}}],
            "objects": [{{"name": "{object}", "shape": {{"sphere": {{"center": [0, 0, 0], "radius": 2}}}}}}]}}"#
    )
}

#[test]
fn a_log_without_its_end_is_read_and_said() {
    let bytes = to_ndjson(&textbook_log()).expect("memory");
    let text = String::from_utf8(bytes).expect("UTF-8");
    let lines: Vec<_> = text.lines().collect();
    let without_end = lines[..lines.len() - 1].join("\n") + "\n";
    let found = read(without_end.as_bytes()).expect("a log");
    assert_eq!(found.ending, Ending::Missing { incomplete_record: false });
    assert_eq!(found.log, textbook_log());

    let cut_in_a_line = &without_end[..without_end.len() - 10];
    let found = read(cut_in_a_line.as_bytes()).expect("a log");
    assert_eq!(found.ending, Ending::Missing { incomplete_record: true });
    assert_eq!(found.log.events.len(), textbook_log().events.len() - 1);
    assert!(found.ending.warning().is_some_and(|warning| warning.contains("1 incomplete record")));
}

#[test]
fn a_changed_value_is_noticed() {
    let bytes = to_ndjson(&textbook_log()).expect("memory");
    let text = String::from_utf8(bytes).expect("UTF-8").replacen("12.68857754044952", "12.68857754044953", 1);
    let found = read(text.as_bytes()).expect("a log");
    assert!(matches!(found.ending, Ending::Mismatch { .. }), "{:?}", found.ending);
}

#[track_caller]
fn is_refused(text: &str, expected: &str) {
    let error = read(text.as_bytes()).expect_err("not a good log");
    assert_eq!(error.to_string(), expected);
}

#[test]
fn what_is_no_log_is_refused() {
    is_refused("", "1:1: not a log: expected the header of a `raywalk-log/1` log, found nothing");
    is_refused("hello\n", "1:1: not a log: expected the header of a `raywalk-log/1` log, found `hello`");
    is_refused(
        "{\"log\":\"raywalk-log/9\"}\n",
        "1:1: log: this program reads `raywalk-log/1`, the log is `raywalk-log/9`",
    );
}

#[test]
fn a_damaged_record_is_named() {
    let bytes = to_ndjson(&textbook_log()).expect("memory");
    let text = String::from_utf8(bytes).expect("UTF-8");
    let damaged = text.replacen("{\"at\":5,", "{\"at\":5;", 1);
    let mut before = textbook_log().events;
    before.truncate(4);
    let found = read(damaged.as_bytes()).expect("what stands before");
    assert!(matches!(&found.ending, Ending::Damaged { what } if what.starts_with("6:")), "{:?}", found.ending);
    assert_eq!(found.log.events, before);
}

#[test]
fn an_unknown_quantity_is_skipped() {
    let bytes = to_ndjson(&textbook_log()).expect("memory");
    let text = String::from_utf8(bytes).expect("UTF-8");
    let changed = text.replacen("plane.v_d", "plane.v_x", 1);
    let mut expected = textbook_log().events;
    expected.remove(4);
    let found = read(changed.as_bytes()).expect("a log");
    assert!(matches!(found.ending, Ending::Mismatch { .. }), "{:?}", found.ending);
    assert_eq!(found.log.events, expected);
    // The digest is that of what the program wrote.
    let (before, _) = changed.trim_end().rsplit_once('\n').expect("an end line");
    let digest = blake3::hash(format!("{before}\n").as_bytes());
    let with = |end: &str| format!("{before}\n{{\"end\":{{\"events\":{}{end}}}}}\n", expected.len() + 1);
    for end in [String::new(), format!(",\"digest\":\"blake3:{digest}\"")] {
        let found = read(with(&end).as_bytes()).expect("a log");
        assert_eq!(found.ending, Ending::Unknown { count: 1, key: "plane.v_x".into(), line: 6 });
        assert!(!found.ending.is_whole() && found.log.events == expected);
    }
    // So is an input, and a form.
    let input = text.replacen("\"plane.offset\"", "\"plane.depth\"", 1);
    let form = text.replacen("\"form\":\"plane\"", "\"form\":\"plain\"", 1);
    for (text, key, lost) in [(input, "plane.depth", 0), (form, "hit.normal (plain)", 1)] {
        let (before, _) = text.trim_end().rsplit_once('\n').expect("an end line");
        let count = textbook_log().events.len();
        let text = format!("{before}\n{{\"end\":{{\"events\":{count}}}}}\n");
        let found = read(text.as_bytes()).expect("a log");
        assert!(matches!(&found.ending, Ending::Unknown { key: found, .. } if found == key), "{:?}", found.ending);
        assert_eq!(found.log.events.len(), count - lost);
    }
}

#[test]
fn nodes_inside_are_passed_over() {
    for name in builtin::names() {
        let scene = scene(name);
        let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
        // Whole, and cut off where nodes are still open.
        for events in [&log.events[..], &log.events[..log.events.len() / 2]] {
            let tree = Tree::of(events);
            for node in 0..tree.nodes().len() {
                let is_own = |event: &usize| tree.owner(*event) == node;
                let own: Vec<_> = tree.nodes()[node].events.clone().filter(is_own).collect();
                assert_eq!(tree.own_events(node).collect::<Vec<_>>(), own);
                for before in [0, own.first().map_or(0, |first| first + 1), events.len() / 3, events.len()] {
                    let mut expected: Vec<_> = own.iter().copied().filter(|event| *event < before).collect();
                    assert_eq!(tree.own_events_before(node, before).collect::<Vec<_>>(), expected);
                    expected.reverse();
                    assert_eq!(tree.own_events_before(node, before).rev().collect::<Vec<_>>(), expected);
                }
            }
        }
    }
}

/// Other programs write an event over several lines. Brackets in names don't end it.
#[test]
fn events_over_several_lines_read_back() {
    let mut log = textbook_log();
    log.header.objects = ["a}]b", "{[\\\"}"].map(str::to_owned).into();
    let pretty = |line: &[u8]| {
        let value: serde_json::Value = serde_json::from_slice(line).expect("JSON");
        serde_json::to_string_pretty(&value).expect("text") + "\n"
    };
    let lines = to_ndjson(&log).expect("memory");
    let spread: String = lines.trim_ascii_end().split(|byte| *byte == b'\n').map(pretty).collect();
    assert_eq!(read(spread.as_bytes()).expect("a log").log, log);
}

#[test]
fn a_line_that_is_too_long_is_said_by_its_number() {
    let mut lines = to_ndjson(&textbook_log()).expect("memory");
    let second = 1 + lines.iter().position(|byte| *byte == b'\n').expect("a line");
    let third = second + 1 + lines[second..].iter().position(|byte| *byte == b'\n').expect("a line");
    lines.splice(third..third, vec![b' '; 3 << 20]);
    let refused = read(&lines).expect_err("a line of three megabytes").to_string();
    assert!(refused.contains("line 3 is too long"), "{refused}");
}
