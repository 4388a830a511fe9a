//! `raywalk log schema`: a schema that takes every line of every log, refuses damaged ones, and says what docs/log.md says.

use crate::calls::prints;
use crate::support;
use jsonschema::Validator;
use raywalk::log::file::{to_json, to_ndjson};
use raywalk::log::schema::{self, MARKS, Of, STEPS, json_schema};
use raywalk::log::{Acceptance, Asking, Decision, Miss, Name, SkipReason, Split, Term};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::builtin;
use serde_json::{Number, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use std::{env, fs};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/log.md");

fn validator() -> Validator {
    jsonschema::draft202012::new(&json_schema()).expect("a good schema")
}

/// The line with every number as 0 or 0.5, so that lines of one kind are looked at once.
fn kind_of(mut value: Value) -> Value {
    match &mut value {
        Value::Number(number) => {
            *number = if number.is_f64() { Number::from_f64(0.5).expect("finite") } else { 1.into() }
        }
        Value::Array(items) => items.iter_mut().for_each(|item| *item = kind_of(item.take())),
        Value::Object(fields) => fields.values_mut().for_each(|field| *field = kind_of(field.take())),
        _ => {}
    }
    value
}

fn lines(text: &[u8]) -> Vec<Value> {
    let lines = text.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
    lines.map(|line| serde_json::from_slice(line).expect("JSON")).collect()
}

/// Logs of all built-in scenes and of those that provoke what is rare.
fn logs(mut see: impl FnMut(&[u8])) {
    let arithmetics =
        [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3), Arithmetic::Decimal(0), Arithmetic::Perturbed(7)];
    let extra = [
        support::scene_of(include_bytes!("../support/shapes.json"), "shapes"),
        support::scene_of(include_bytes!("../support/effects.json"), "effects"),
        support::scene_of(include_bytes!("../support/touching.json"), "touching"),
    ];
    for scene in builtin::names().map(support::scene).chain(extra) {
        for pixel in support::grid(&scene, 4) {
            for arithmetic in arithmetics {
                see(&to_ndjson(&record::pixel(&scene, pixel, arithmetic)).expect("memory"));
            }
        }
    }
    let textbook = support::scene("textbook");
    see(&to_ndjson(&record::pixel(&textbook, [160, 120], Arithmetic::Printed)).expect("memory"));
    let region = record::region::bounded(&textbook, [159, 119, 161, 121], Arithmetic::F64).expect("memory");
    see(&to_ndjson(&region).expect("memory"));
}

#[test]
fn it_is_a_schema() {
    assert!(jsonschema::draft202012::meta::is_valid(&json_schema()));
    let printed: Value = serde_json::from_str(&prints(&["log", "schema", "--format", "json"])).expect("JSON");
    assert_eq!(printed, json_schema());
    assert_eq!(prints(&["log", "schema"]), schema::text());
}

#[test]
fn it_takes_every_line_of_every_log() {
    let validator = validator();
    let (mut seen, mut words) = (BTreeSet::new(), BTreeSet::new());
    logs(|log| {
        for line in lines(log) {
            for kind in ["enter", "mark"] {
                words.extend(line[kind].as_object().into_iter().flat_map(|object| object.keys().cloned()));
            }
            // A header has words that others don't: all of it counts.
            let kind = if line.get("log").is_some() || line.get("end").is_some() {
                line.clone()
            } else {
                kind_of(line.clone())
            };
            if seen.insert(kind.to_string()) {
                let errors: Vec<_> = validator.iter_errors(&line).map(|error| error.to_string()).collect();
                assert!(errors.is_empty(), "{line}: {errors:?}");
            }
        }
    });
    assert!(seen.len() > 1000, "{} kinds of lines", seen.len());
    assert!(words.len() > 20, "{words:?}");
    // Lines of several runs.
    let digits = prints(&["trace", "textbook", "--pixel", "160,120", "--arithmetic", "perturbed:1"]);
    for line in lines(digits.as_bytes()) {
        assert!(validator.is_valid(&line), "{line}");
    }
}

#[test]
fn it_refuses_damaged_lines() {
    let validator = validator();
    let log = record::pixel(&support::scene("textbook"), [160, 120], Arithmetic::F64);
    let lines = lines(&to_ndjson(&log).expect("memory"));
    let mut refused = 0;
    for line in &lines {
        assert!(validator.is_valid(line));
        let keys: Vec<_> = line.as_object().expect("an object").keys().cloned().collect();
        for key in keys {
            let is_optional = ["form", "given", "path", "parent", "seed"].contains(&key.as_str());
            let mut without = line.clone();
            without.as_object_mut().expect("an object").remove(&key);
            assert_eq!(validator.is_valid(&without), is_optional, "{key} missing: {without}");
            let mut other = line.clone();
            other[&key] = if line[&key].is_string() { json!(7) } else { json!("x") };
            assert!(!validator.is_valid(&other), "{other}");
            other[&key] = Value::Null;
            assert!(!validator.is_valid(&other), "{other}");
            refused += 2;
        }
        let mut more = line.clone();
        more["extra"] = json!(1);
        assert!(!validator.is_valid(&more), "{more}");
    }
    assert!(refused > 500, "{refused}");
    for (line, why) in [
        (r#"{"at":1,"node":1,"note":"plane.v_x","value":1}"#, "an unknown quantity"),
        (r#"{"at":1,"node":1,"note":"plane.t","value":[1,2,3]}"#, "a triple for a number"),
        (r#"{"at":1,"node":1,"note":"hit.point","value":1}"#, "a number for a triple"),
        (r#"{"at":1,"node":1,"note":"hit.point","value":[1,2]}"#, "two numbers"),
        (r#"{"at":1,"node":1,"note":"hit.point","form":"on_plane","value":[1,2,3]}"#, "an unknown form"),
        (r#"{"at":1,"node":1,"note":"sphere.oc","form":"far","value":[1,2,3]}"#, "a form where there is one formula"),
        (r#"{"at":1,"node":1,"mark":{"miss":{"why":"besides"}}}"#, "an unknown reason"),
        (r#"{"at":1,"node":1,"mark":{"hit":{},"outside":{}}}"#, "two decisions"),
        (r#"{"at":1,"node":1,"mark":{"nearest":{}}}"#, "no object"),
        (r#"{"at":1,"node":1,"enter":{"ray":{"kind":"camara","depth":0}},"parent":0}"#, "an unknown kind of ray"),
        (r#"{"at":-1,"node":1,"leave":{}}"#, "a negative number of an event"),
        (r#"{"at":1.5,"node":1,"leave":{}}"#, "half an event"),
        (r#"{"at":1,"node":0,"result":{"color":[1,2]}}"#, "a colour of two channels"),
        (r#"{"at":1,"node":0,"leave":{},"given":{"sphere.radius":[1,2,3]}}"#, "an input of another kind"),
        (r#"{"at":1,"node":0,"leave":{},"given":{"radius":1}}"#, "an unknown input"),
        (r#"{"end":{"events":3,"digest":"blake3:12"}}"#, "a short digest"),
        (r#"{"log":"raywalk-log/2"}"#, "another version"),
    ] {
        let value: Value = serde_json::from_str(line).expect("JSON");
        assert!(!validator.is_valid(&value), "{why}: {line}");
    }
    // What other programs may leave out.
    for line in [
        r#"{"at":1,"node":1,"note":"hit.normal","value":[0,0,1]}"#,
        r#"{"end":{"events":3}}"#,
        r#"{"at":1,"node":1,"enter":{"test":{"object":"x"}},"parent":1}"#,
    ] {
        assert!(validator.is_valid(&serde_json::from_str(line).expect("JSON")), "{line}");
    }
}

/// Every decision, so that a new one can't be forgotten in the schema: the match has no `_`.
#[test]
fn it_knows_every_decision() {
    let word = |decision: &Decision| match decision {
        Decision::Hit => "hit",
        Decision::Miss { .. } => "miss",
        Decision::Outside => "outside",
        Decision::Inside => "inside",
        Decision::Nearest { .. } => "nearest",
        Decision::Coincident { .. } => "coincident",
        Decision::Immersed { .. } => "immersed",
        Decision::Background => "background",
        Decision::Free => "free",
        Decision::Occluded { .. } => "occluded",
        Decision::Attenuated { .. } => "attenuated",
        Decision::Undefined { .. } => "undefined",
        Decision::TotalInternalReflection => "total_internal_reflection",
        Decision::DepthLimit { .. } => "depth_limit",
        Decision::LeakGuard { .. } => "leak_guard",
        Decision::Bent { .. } => "bent",
        Decision::Rejected { .. } => "rejected",
        Decision::Skipped { .. } => "skipped",
        Decision::Subdivided { .. } => "subdivided",
        Decision::Accepted { .. } => "accepted",
        Decision::Asked { .. } => "asked",
        Decision::MoreSamples { .. } => "more_samples",
    };
    let (what, cell) = (Term::Shadow, [0.0, 0.5, 0.25]);
    let all = [
        Decision::Hit,
        Decision::Miss { why: Miss::Beyond },
        Decision::Outside,
        Decision::Inside,
        Decision::Nearest { object: 0 },
        Decision::Coincident { object: 0, triangle: Some(3) },
        Decision::Immersed { object: 0 },
        Decision::Background,
        Decision::Free,
        Decision::Occluded { object: 0 },
        Decision::Attenuated { object: 0, factor: [0.5; 3] },
        Decision::Undefined { quantity: Name::RayDirection },
        Decision::TotalInternalReflection,
        Decision::DepthLimit { what },
        Decision::LeakGuard { what },
        Decision::Bent { what },
        Decision::Rejected { what },
        Decision::Skipped { what, why: SkipReason::Blocked },
        Decision::Subdivided { cell, why: Split::SmallObject, object: Some(0) },
        Decision::Accepted { cell: Some(cell), why: Acceptance::Alike },
        Decision::Asked { light: 0, why: Asking::Hidden, points: 1, object: Some(0) },
        Decision::MoreSamples { from: 4, to: 8 },
    ];
    let words: Vec<_> = all.iter().map(word).collect();
    let listed: Vec<_> = MARKS.iter().map(|kind| kind.word).collect();
    assert_eq!(words.iter().collect::<BTreeSet<_>>(), listed.iter().collect::<BTreeSet<_>>());
    let mut log = record::pixel(&support::scene("textbook"), [160, 120], Arithmetic::F64);
    let template = log.events[0].clone();
    let mark =
        |decision: &Decision| raywalk::log::Event { what: raywalk::log::What::Mark(*decision), ..template.clone() };
    log.events.splice(1..1, all.iter().map(mark).collect::<Vec<_>>());
    let validator = validator();
    for line in lines(&to_ndjson(&log).expect("memory")) {
        assert!(validator.is_valid(&line), "{line}");
    }
}

/// Each key of the annotations is what the table of names says.
#[test]
fn quantities_have_symbol_unit_and_formulas() {
    let schema = json_schema();
    let quantities = schema["$defs"]["note"]["oneOf"].as_array().expect("a list");
    let by_key: BTreeMap<_, _> =
        quantities.iter().map(|one| (one["properties"]["note"]["const"].as_str().expect("a key"), one)).collect();
    assert_eq!(by_key.len(), quantities.len());
    for name in Name::all() {
        let one = by_key[name.key()];
        assert_eq!(one["symbol"], name.symbol());
        assert_eq!(one["unit"], name.unit().text());
        assert_eq!(one["formulas"].get(name.form()).and_then(Value::as_str), name.formula(), "{name:?}");
    }
    assert_eq!(by_key["sphere.t2_a"]["section"], "1.3");
    assert_eq!(by_key["sphere.t2_a"]["unit"], "length²");
    assert_eq!(by_key["box.t"].get("section"), None);
}

/// The values of a log have as many components as the table says.
#[test]
fn one_document_has_the_same_events() {
    let log = record::pixel(&support::scene("textbook"), [160, 120], Arithmetic::F64);
    let document: Value = serde_json::from_slice(&to_json(&log).expect("memory")).expect("JSON");
    let validator = validator();
    assert!(validator.is_valid(&document["header"]));
    let mut count = 0;
    let mut open = document["children"].as_array().expect("a list").clone();
    while let Some(mut event) = open.pop() {
        if let Some(Value::Array(children)) = event.as_object_mut().expect("an object").remove("children") {
            open.extend(children);
        }
        assert!(validator.is_valid(&event), "{event}");
        count += 1;
    }
    assert_eq!(count, log.events.len());
}

/// `UPDATE_DOCS=1 cargo test --test program log_schema` writes the table into the page.
#[test]
fn the_page_has_the_table_and_an_example_of_everything() {
    const BEGIN: &str = "<!-- raywalk log schema: begin -->\n```text\n";
    const END: &str = "```\n<!-- raywalk log schema: end -->";
    let page = fs::read_to_string(PAGE).expect("docs/log.md");
    let (before, rest) = page.split_once(BEGIN).expect("where the table begins");
    let (table, after) = rest.split_once(END).expect("where the table ends");
    if env::var_os("UPDATE_DOCS").is_some() {
        fs::write(PAGE, format!("{before}{BEGIN}{}{END}{after}", schema::quantities())).expect("written");
    } else {
        assert_eq!(table, schema::quantities(), "UPDATE_DOCS=1 cargo test --test program log_schema");
    }
    // The example lines of the page are lines of a log.
    let validator = validator();
    let examples: Vec<Value> = before
        .lines()
        .filter(|line| line.starts_with("{\""))
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}")))
        .collect();
    for example in &examples {
        assert!(validator.is_valid(example), "{example}");
    }
    for (field, kinds) in [("enter", STEPS), ("mark", MARKS)] {
        for kind in kinds {
            assert!(examples.iter().any(|line| line[field].get(kind.word).is_some()), "no example of `{}`", kind.word);
            assert!(before.contains(kind.meaning), "`{}` isn't explained: {}", kind.word, kind.meaning);
            let words = kind.fields.iter().flat_map(|field| match field.value {
                Of::Words(words) => words(),
                _ => Vec::new(),
            });
            let row = before.lines().find(|line| line.starts_with(&format!("| `{{\"{}\"", kind.word))).unwrap_or("");
            for word in words {
                assert!(row.contains(word), "the row of `{}` lacks `{word}`: {row}", kind.word);
            }
        }
    }
    for field in ["log", "leave", "result", "end", "note", "digits"] {
        assert!(examples.iter().any(|line| line.get(field).is_some()), "no example of `{field}`");
    }
}

/// Every call of the page runs, where the tool that it is about is there.
#[test]
fn the_calls_of_the_page_run() {
    let page = fs::read_to_string(PAGE).expect("docs/log.md");
    let calls: Vec<&str> =
        page.split("```sh\n").skip(1).map(|rest| rest.split("```").next().expect("an end")).collect();
    assert_eq!(calls.len(), 3);
    let program = assert_cmd::cargo::cargo_bin("raywalk");
    let path = format!("{}:{}", program.parent().expect("a folder").display(), env::var("PATH").expect("a path"));
    for (call, tool) in calls.into_iter().zip(["jq", "python3", "duckdb"]) {
        assert!(call.contains(&format!("\n{tool} ")), "{call}");
        if Command::new(tool).arg("--version").output().is_err() {
            crate::shared::skipped(&format!("no {tool} here"));
            continue;
        }
        let folder = tempfile::tempdir().expect("a folder");
        let mut run = Command::new("bash");
        run.args(["-euo", "pipefail", "-c", call]).env("PATH", &path).current_dir(folder.path());
        let output = run.output().expect("it runs");
        assert!(output.status.success(), "{call}\n{}", String::from_utf8_lossy(&output.stderr));
        assert!(!output.stdout.is_empty(), "{call}");
    }
}
