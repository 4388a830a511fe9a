//! Logs as other programs rewrite them: in another order of keys, with other blanks, numbers and strings spelt otherwise.

use crate::random::Random;
use crate::support::{middle, scene, scene_of};
use raywalk::files::Kind;
use raywalk::log::file::{Ending, PixelReader, read, to_json, to_ndjson};
use raywalk::log::{self, Log};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::builtin;
use serde_json::Value;
use std::io::Cursor;

/// How a program writes JSON.
struct Writer {
    random: Random,
    /// Whether it breaks values into several lines.
    breaks_lines: bool,
    out: String,
}

impl Writer {
    fn blank(&mut self) {
        let blanks = ["", "", "", " ", "\t", "\n ", "\r\n  "];
        self.out += blanks[self.random.below(if self.breaks_lines { 7 } else { 5 })];
    }

    fn value(&mut self, value: &Value) {
        match value {
            Value::Object(fields) => {
                let mut fields: Vec<_> = fields.iter().collect();
                for end in (1..fields.len()).rev() {
                    fields.swap(end, self.random.below(end + 1));
                }
                self.list(['{', '}'], &fields, |this, (key, value)| {
                    // No program escapes letters in keys.
                    this.out += &format!("\"{key}\"");
                    this.blank();
                    this.out += ":";
                    this.blank();
                    this.value(value);
                });
            }
            Value::Array(items) => self.list(['[', ']'], items, Writer::value),
            Value::Number(number) => self.number(number),
            Value::String(text) => self.string(text),
            Value::Bool(_) | Value::Null => self.out += &value.to_string(),
        }
    }

    fn list<T>(&mut self, [open, close]: [char; 2], items: &[T], mut item: impl FnMut(&mut Writer, &T)) {
        self.out.push(open);
        for (number, one) in items.iter().enumerate() {
            self.out += if number == 0 { "" } else { "," };
            self.blank();
            item(self, one);
            self.blank();
        }
        self.out.push(close);
    }

    fn number(&mut self, number: &serde_json::Number) {
        let x = number.as_f64().expect("a number");
        // Above 2^53 not every whole number has a fraction of zeros in f64.
        let is_exact = x.abs() < 9e15;
        self.out += &match self.random.below(4) {
            1 if is_exact => format!("{x:e}"),
            2 if is_exact => format!("{x:E}"),
            3 if is_exact && x == x.trunc() => format!("{x:.2}"),
            _ => number.to_string(),
        };
    }

    fn string(&mut self, text: &str) {
        let plain = serde_json::to_string(text).expect("a string");
        let escapes = self.random.below(4) == 0 && text.chars().all(|c| c.is_alphanumeric());
        let escaped: String = text.encode_utf16().map(|unit| format!("\\u{unit:04x}")).collect();
        self.out += &if escapes { format!("\"{escaped}\"") } else { plain };
    }
}

/// A text of values, one a line, rewritten.
fn respelt(values: &[Value], seed: u64) -> String {
    let breaks_lines = seed % 3 == 2;
    let mut writer = Writer { random: Random::new(seed), breaks_lines, out: String::new() };
    writer.out += if seed % 2 == 1 { "\u{feff}" } else { "" };
    for value in values {
        writer.value(value);
        writer.out += ["\n", "\r\n", "\n\n", " \n"][writer.random.below(4)];
    }
    writer.out
}

fn values(lines: &[u8]) -> Vec<Value> {
    serde_json::Deserializer::from_slice(lines).into_iter().map(|value| value.expect("JSON")).collect()
}

fn logs() -> Vec<Log> {
    let names = (0..90).map(|number| {
        format!(r#"{{"name": "sphère {number}", "shape": {{"sphere": {{"center": [{number}, 0, 0], "radius": 1}}}}}}"#)
    });
    let of_many = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0.01, -1]}},
            "sampling": {{"adaptive": {{"threshold": 1, "depth": 1}}}}, "objects": [{}]}}"#,
        names.collect::<Vec<_>>().join(",")
    );
    let of_many = scene_of(of_many.as_bytes(), "many");
    let region = record::region::bounded(&scene("textbook"), [159, 119, 161, 121], Arithmetic::F64).expect("a log");
    let of_scene = |name| {
        let scene = scene(name);
        record::pixel(&scene, middle(&scene), Arithmetic::F64)
    };
    let mut logs: Vec<_> = builtin::names().map(of_scene).filter(|log| log.events.len() < 5000).collect();
    assert!(logs.len() > 15);
    logs.extend([record::pixel(&of_many, middle(&of_many), Arithmetic::F64), region]);
    logs
}

/// How the log ends when it is read pixel by pixel, once or twice.
fn ending_by_pixels(bytes: &[u8]) -> Ending {
    let input = Cursor::new(bytes.to_vec());
    let again = input.clone();
    let once = PixelReader::open(input.clone()).expect("a log");
    let twice = PixelReader::open(input).expect("a log").with_again(|| Some(again));
    let [once, twice] = [once, twice].map(|mut reader| {
        while reader.next_pixel().expect("a pixel").is_some() {}
        reader.ending().expect("the end").clone()
    });
    assert_eq!(once, twice);
    once
}

/// The lines that are copied to another log, if the digest of the bytes shows that all are there.
fn copied(bytes: &[u8]) -> Option<Vec<u8>> {
    let reader = PixelReader::open(bytes).expect("a log");
    let header = reader.header().clone();
    let mut writer = log::file::Writer::new(Vec::new(), &header).expect("memory");
    reader.copy_to(&mut writer).expect("memory").then(|| writer.finish().expect("memory"))
}

#[test]
fn lines_are_copied_only_as_they_were_written() {
    for (seed, log) in (0..).zip(logs()) {
        let lines = to_ndjson(&log).expect("memory");
        assert!(copied(&lines).as_ref() == Some(&lines));
        let values = values(&lines);
        let text = String::from_utf8(lines.clone()).expect("UTF-8");
        let without_digest = text.rsplit_once(",\"digest\"").expect("a digest").0.to_owned() + "}}\n";
        let changed = text.replacen("\"value\":", "\"value\":1", 1);
        let (document, longer) = (to_json(&log).expect("memory"), [&lines[..], b"{}"].concat());
        for other in [respelt(&values, seed).as_bytes(), &lines[..lines.len() / 2], &document, &longer] {
            assert_eq!(copied(other), None, "{seed}");
        }
        assert_eq!([without_digest, changed].map(|text| copied(text.as_bytes())), [None, None], "{seed}");
    }
}

#[test]
fn a_log_is_the_same_and_whole_in_every_spelling() {
    for (number, log) in (0..).zip(logs()) {
        let (lines, document) = (to_ndjson(&log).expect("memory"), to_json(&log).expect("memory"));
        for seed in (0..6).map(|seed| 6 * number + seed) {
            for original in [&lines, &document] {
                let text = respelt(&values(original), seed);
                assert!(Kind::of(&text.as_bytes()[..text.len().min(512)]).is_log(), "{seed}: {text:.600}");
                let found = read(text.as_bytes()).unwrap_or_else(|error| panic!("{seed}: {error}: {text:.600}"));
                assert_eq!(found.ending, Ending::Complete, "{seed}: {}", log.header.scene.name);
                assert!(to_ndjson(&found.log).expect("memory") == lines, "{seed}: {}", log.header.scene.name);
                assert_eq!(ending_by_pixels(text.as_bytes()), Ending::Complete, "{seed}");
            }
        }
    }
}

#[test]
fn a_changed_value_is_damage_in_every_spelling() {
    let mut random = Random::new(1);
    for (seed, log) in (0..).zip(logs()) {
        let lines = values(&to_ndjson(&log).expect("memory"));
        let notes: Vec<_> = (0..lines.len()).filter(|line| lines[*line]["value"].is_number()).collect();
        let mut changed = lines.clone();
        let value = &mut changed[notes[random.below(notes.len())]]["value"];
        *value = value.as_f64().expect("a number").next_up().into();
        let text = respelt(&changed, seed);
        for ending in [read(text.as_bytes()).expect("a log").ending, ending_by_pixels(text.as_bytes())] {
            let expected = "its digest fits neither its bytes nor its events";
            assert_eq!(ending, Ending::Mismatch { what: expected.to_owned() }, "{seed}");
        }
    }
}

#[test]
fn an_end_without_a_digest_counts() {
    for (seed, log) in (0..).zip(logs()).take(4) {
        let mut lines = values(&to_ndjson(&log).expect("memory"));
        let end = lines.last_mut().expect("the end");
        end["end"].as_object_mut().expect("an object").remove("digest");
        assert_eq!(read(respelt(&lines, seed).as_bytes()).expect("a log").ending, Ending::Complete);
        lines.remove(2);
        let ending = read(respelt(&lines, seed).as_bytes()).expect("a log").ending;
        assert!(matches!(&ending, Ending::Mismatch { what } if what.contains("counts")), "{ending:?}");
    }
}

#[test]
fn damage_in_a_log_of_long_values_has_its_place() {
    let mut log = record::pixel(&scene("textbook"), [160, 120], Arithmetic::F64);
    let lines = values(&to_ndjson(&log).expect("memory"));
    let pretty: Vec<_> = lines.iter().map(|line| serde_json::to_string_pretty(line).expect("JSON")).collect();
    let text = pretty.join("\n").replacen("\"at\": 2,", "\"at\": x,", 1);
    let line = 1 + text.lines().position(|line| line.contains("\"at\": x")).expect("the line");
    let found = read(text.as_bytes()).expect("a log");
    let Ending::Damaged { what } = &found.ending else { panic!("{:?}", found.ending) };
    assert!(what.starts_with(&format!("{line}:9: ")), "{what}, not {line}");
    log.events.truncate(1);
    assert_eq!(found.log.events, log.events);
}
