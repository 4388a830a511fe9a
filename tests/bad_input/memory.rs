//! Memory and time by the byte: some kilobytes that unpack to megabytes of the smallest objects there are, and as many siblings of one node.
//!
//! Whatever a file holds, reading it takes at most 64 MiB and eight times its bytes as they are unpacked, and time that grows as they do.

use crate::run::{Answer, limited_answer, raywalk};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::time::Duration;

/// How many bytes of each are unpacked.
const SIZE: usize = 8 << 20;

/// The most time on a processor for as many bytes, in a build that isn't optimized.
const MOST_TIME: Duration = Duration::from_secs(60);

/// Bytes that begin and end like this, with so many of a unit between them.
fn many(before: &str, unit: impl Fn(usize) -> String, after: &str) -> Vec<u8> {
    let mut text = before.as_bytes().to_vec();
    for number in 0.. {
        text.extend_from_slice(unit(number).as_bytes());
        if text.len() >= SIZE {
            break;
        }
    }
    if text.ends_with(b",") {
        text.pop();
    }
    text.extend_from_slice(after.as_bytes());
    text
}

/// The same unit again and again.
fn same(unit: &str) -> impl Fn(usize) -> String {
    move |_| unit.to_owned()
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).expect("memory");
    encoder.finish().expect("memory")
}

/// Reads a packed file with these arguments, in which `@` stands for its name, within the bounds. The commands that take two logs or
/// pictures read it twice.
#[track_caller]
fn bounded(name: &str, bytes: &[u8], arguments: &[&str], code: i32) -> Answer {
    let folder = tempfile::tempdir().expect("a folder");
    let file = format!("{name}.gz");
    fs::write(folder.path().join(&file), packed(bytes)).expect("written");
    bounded_in(folder.path(), bytes.len(), &file, arguments, code)
}

#[track_caller]
fn bounded_in(folder: &Path, unpacked: usize, file: &str, arguments: &[&str], code: i32) -> Answer {
    let reads = arguments.iter().filter(|argument| **argument == "@").count().max(1);
    let arguments: Vec<&str> =
        arguments.iter().map(|argument| if *argument == "@" { file } else { argument }).collect();
    let answer = limited_answer(&mut raywalk(folder, &arguments), MOST_TIME);
    let most = (64 << 10) + 8 * (unpacked * reads / 1024) as u64;
    assert!(answer.peak <= most, "{arguments:?}: {} KiB of {most} for {unpacked} bytes", answer.peak);
    assert_eq!(answer.code, Some(code), "{arguments:?}: {}", answer.message);
    answer
}

/// A header of a log with other objects and further keys.
fn header(objects: &str, further: &str) -> String {
    format!(
        "{{\"log\":\"raywalk-log/1\",\"version\":\"0.1.0\",\"scene\":{{\"name\":\"t\"}},\"pixel\":[0,0],\"arithmetic\":\"f64\",\"tracing\":\
         {{\"algorithm\":\"recursive\",\"max_depth\":4,\"specular\":\"half_vector\",\"sphere_method\":\"robust\",\"cutoff\":0.0,\
         \"two_sided\":true}},\"sampling\":{{\"none\":{{}}}},\"lights\":[\"L\"],\"objects\":[{objects}]{further}}}"
    )
}

/// The header with a list of this many bytes in the place of `@`.
fn header_with(objects: &str, further: &str, unit: impl Fn(usize) -> String) -> Vec<u8> {
    let header = header(objects, further);
    let (before, after) = header.split_once('@').expect("a place");
    many(before, unit, &format!("{after}\n"))
}

#[test]
fn headers_of_logs() {
    let walk = ["walk", "@"];
    for (bytes, expected) in [
        (header_with("@", "", same("\"\",")), "expected at most 1048576, found more"),
        (header_with("\"a\"", ",\"more\":[@]", same("[],")), ""),
        (header_with("\"a\"", ",\"more\":{@}", |number| format!("\"{number}\":0,")), ""),
        (header_with("\"a\"", ",\"seed\":1.0,\"more\":[@]", same("0,")), ""),
    ] {
        let code = if expected.is_empty() { 0 } else { 2 };
        let answer = bounded("a.ndjson", &bytes, &walk, code);
        assert!(answer.message.contains(expected), "{}", answer.message);
    }
    let methods = header("\"a\"", "").replace("\"none\":{}", "@");
    let (before, after) = methods.split_once('@').expect("a place");
    let methods = many(before, |number| format!("\"{number}\":{{}},"), after);
    let refused = bounded("a.ndjson", &methods, &walk, 2);
    assert!(refused.message.contains("methods of sampling"), "{}", refused.message);
}

#[test]
fn a_million_names_are_read_and_no_more() {
    let names = |count: usize| (0..count).map(|number| format!("\"{number:x}\"")).collect::<Vec<_>>().join(",");
    let hit = "{\"at\":1,\"node\":0,\"mark\":{\"nearest\":{\"object\":\"fffff\"}}}\n";
    // One of them is the light's.
    let log = |count: usize| format!("{}\n{hit}", header(&names(count), ""));
    let shown = bounded("a.ndjson", log((1 << 20) - 1).replace("fffff", "ffffe").as_bytes(), &["walk", "@"], 0);
    assert!(String::from_utf8_lossy(&shown.out).contains("ffffe"));
    let refused = bounded("a.ndjson", log(1 << 20).as_bytes(), &["walk", "@"], 2);
    assert!(refused.message.contains("names of objects and lights"), "{}", refused.message);
}

#[test]
fn events_of_logs() {
    for unit in [
        "{\"at\":1,\"node\":0,\"leave\":{}}",
        "{\"at\":1,\"node\":0,\"mark\":{\"hit\":{}}}",
        "{\"at\":1,\"node\":0,\"note\":\"ray.length\",\"value\":1}",
        "{\"at\":1,\"node\":0,\"leave\":{},\"digits\":1,\"given\":{\"plane.t\":1,\"plane.t\":1,\"plane.t\":1,\"plane.t\":1}}",
        "{\"at\":0,\"node\":0,\"enter\":{\"pixel\":[0,0]}}",
    ] {
        let lines = many(&format!("{}\n", header("\"a\"", "")), same(&format!("{unit}\n")), "");
        let document =
            many(&format!("{{\"header\":{},\"children\":[", header("\"a\"", "")), same(&format!("{unit},")), "]}");
        for (name, bytes) in [("a.ndjson", &lines), ("a.json", &document)] {
            bounded(name, bytes, &["walk", "@", "--screenshot", "a.svg"], 0);
            bounded(name, bytes, &["trace", "@", "-o", "b"], 0);
            // Neither has an end line.
            bounded(name, bytes, &["diff", "@", "@"], 2);
        }
    }
}

#[test]
fn documents_of_nothing() {
    let before = format!("{{\"header\":{},\"children\":[", header("\"a\"", ""));
    for unit in ["{},", "0,", "{\"children\":[]},", "[[]],"] {
        bounded("a.json", &many(&before, same(unit), "]}"), &["walk", "@"], 2);
    }
}

#[test]
fn lines_without_an_end() {
    let before = format!("{}\n", header("\"a\"", ""));
    for unit in [" ", "{\"at\":1,\"node\":0,", "a"] {
        let refused = bounded("a.ndjson", &many(&before, same(unit), ""), &["walk", "@"], 2);
        let expected = "a.ndjson.gz: line 2 is too long, expected at most 1048576 bytes";
        let is_damage = unit == "a";
        assert!(is_damage || refused.message.contains(expected), "{}", refused.message);
    }
}

#[test]
fn pictures_with_profiles_and_texts() {
    use crate::pictures::{chunk, white_png};
    let text = {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(&vec![b'a'; 1 << 28]).expect("memory");
        encoder.finish().expect("memory")
    };
    for (name, before) in [(b"iCCP", &b"a\0\0"[..]), (b"zTXt", b"a\0\0"), (b"iTXt", b"a\0\x01\0\0\0")] {
        let data = [before, &text].concat();
        for png in [white_png(&chunk(name, &data), &[]), white_png(&[], &chunk(name, &data))] {
            let folder = tempfile::tempdir().expect("a folder");
            fs::write(folder.path().join("a.png"), &png).expect("written");
            bounded_in(folder.path(), png.len(), "a.png", &["diff", "@", "@"], 0);
        }
    }
}

const SCENE: &str =
    "{\"format\":\"raywalk-scene/1\",\"camera\":{\"position\":[0,0,5],\"direction\":[0,0,-1],\"resolution\":[8,6]},";

#[test]
fn scenes_of_one_line() {
    let objects = format!(
        "{SCENE}\"objects\":[{{\"name\":\"a\",\"shape\":{{\"sphere\":{{\"center\":[0,0,-9],\"radius\":1}}}}}}],"
    );
    // Forty thousand lights: before, the place of each was looked for from the beginning.
    let lights =
        (0..40_000).map(|number| format!("{{\"name\":\"{number}\",\"point\":{{\"position\":[0,{number},9]}}}}"));
    let lights = format!("{objects}\"lights\":[{}]}}", lights.collect::<Vec<_>>().join(","));
    let checked = bounded("a.json", lights.as_bytes(), &["scene", "check", "@"], 0);
    assert_eq!(checked.message.matches("warning: a.json").count(), 20, "{}", checked.message);
    assert!(checked.message.ends_with("warning: and 39980 more warnings, not shown\n"), "{}", checked.message);
    let many_lights = many(&format!("{objects}\"lights\":["), same("{\"point\":{\"position\":[0,0,0]}},"), "]}");
    let refused = bounded("a.json", &many_lights, &["scene", "check", "@"], 2);
    assert!(refused.message.contains("too many lights, expected at most 131072, found more"), "{}", refused.message);
    let many_materials = many(&format!("{objects}\"materials\":{{"), |number| format!("\"{number:07}\":{{}},"), "}}");
    let refused = bounded("a.json", &many_materials, &["scene", "check", "@"], 2);
    assert!(refused.message.contains("too many materials, expected at most 131072, found more"), "{}", refused.message);
    let materials = (0..1000).map(|number| format!("\"{number}\":{{}}")).collect::<Vec<_>>().join(",");
    let checked =
        bounded("a.json", format!("{objects}\"materials\":{{{materials}}}}}").as_bytes(), &["scene", "check", "@"], 0);
    assert!(checked.message.ends_with("warning: and 980 more warnings, not shown\n"), "{}", checked.message);
}

/// The events of a node, or the nodes in one, in their tens of thousands: each was looked for among all before it.
#[test]
fn nodes_that_hold_much() {
    const MANY: usize = 40_000;
    let ray = "{\"at\":1,\"node\":1,\"enter\":{\"ray\":{\"kind\":\"camera\",\"depth\":0}},\"parent\":0}\n";
    let note = |key: &str, value: &str| format!("{{\"at\":1,\"node\":1,\"note\":\"{key}\",\"value\":{value}}}\n");
    let notes =
        [note("ray.direction", "[1,0,0]"), note("plane.v_d", "1"), note("plane.t", "2"), note("hit.point", "[1,2,3]")];
    let test = "{\"at\":1,\"node\":2,\"enter\":{\"test\":{\"object\":\"a\"}},\"parent\":1}\n{\"at\":1,\"node\":2,\"note\":\"plane.v_d\",\
                \"value\":1}\n{\"at\":1,\"node\":2,\"mark\":{\"hit\":{}}}\n{\"at\":1,\"node\":2,\"leave\":{}}\n";
    let hit = "{\"at\":1,\"node\":0,\"mark\":{\"hit\":{}}}\n";
    let bodies = [
        format!("{ray}{}", notes.concat().repeat(MANY / 4)),
        format!("{ray}{}", test.repeat(MANY / 4)),
        hit.repeat(MANY),
    ];
    for body in bodies {
        let log = format!("{}\n{body}", header("\"a\"", ""));
        for format in ["text", "html", "latex", "markdown", "svg"] {
            let folder = tempfile::tempdir().expect("a folder");
            fs::write(folder.path().join("a.ndjson"), &log).expect("written");
            let call = ["trace", "a.ndjson", "--format", format, "-o", "b"];
            let answer = limited_answer(&mut raywalk(folder.path(), &call), Duration::from_secs(12));
            assert_eq!(answer.code, Some(0), "{format}: {}", answer.message);
        }
    }
}

/// Two logs of which one has more of everything, or something else: the cause of each difference was looked for in all of its ray.
#[test]
fn logs_that_differ_in_much() {
    const MANY: usize = 40_000;
    let ray = |node: usize, parent: usize| {
        format!(
            "{{\"at\":1,\"node\":{node},\"enter\":{{\"ray\":{{\"kind\":\"camera\",\"depth\":0}}}},\"parent\":{parent}}}\n"
        )
    };
    let note = |key: &str, value: &str| format!("{{\"at\":1,\"node\":1,\"note\":\"{key}\",\"value\":{value}}}\n");
    let notes = |key: &str, value: &str, count: usize| format!("{}{}", ray(1, 0), note(key, value).repeat(count));
    let siblings =
        |count: usize| (1..=count).map(|node| ray(node, 0) + &format!("{{\"at\":1,\"node\":{node},\"leave\":{{}}}}\n"));
    let pairs = [
        [notes("plane.t", "2", MANY), notes("plane.t", "2", MANY / 2)],
        [notes("plane.t", "2", MANY), notes("plane.t", "3", MANY)],
        [notes("plane.t", "2", MANY), notes("hit.point", "[1,2,3]", MANY)],
        [siblings(MANY / 4).collect(), siblings(MANY / 8).collect()],
    ];
    for bodies in pairs {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, body) in ["a.ndjson", "b.ndjson"].iter().zip(&bodies) {
            fs::write(folder.path().join(name), format!("{}\n{body}", header("\"a\"", ""))).expect("written");
        }
        let call = ["diff", "a.ndjson", "b.ndjson"];
        let answer = limited_answer(&mut raywalk(folder.path(), &call), Duration::from_secs(20));
        assert!(matches!(answer.code, Some(1 | 2)), "{:?}: {}", answer.code, answer.message);
    }
}

/// The smallest objects there are of each shape. Those of NFF take more (docs/robustness.md).
#[test]
fn objects_of_a_scene() {
    let before = r#"{"format":"raywalk-scene/1","camera":{"position":[0,0,5],"direction":[0,0,-1],"resolution":[8,6]},"objects":["#;
    let shapes = [
        r#""sphere":{"center":[0,0,0],"radius":1}"#,
        r#""plane":{"coefficients":[1,0,0,0]}"#,
        r#""box":{"min":[0,0,0],"max":[1,1,1]}"#,
        r#""triangle":{"vertices":[[0,0,0],[1,0,0],[0,1,0]]}"#,
        r#""polygon":{"vertices":[[0,0,0],[1,0,0],[0,1,0]]}"#,
    ];
    for shape in shapes {
        let text = many(before, same(&format!(r#"{{"shape":{{{shape}}}}},"#)), "]}");
        bounded("s.json", &text, &["scene", "check", "@"], 0);
        bounded("s.json", &text, &["scene", "show", "@"], 0);
    }
    let polygon = many(&format!(r#"{before}{{"shape":{{"polygon":{{"vertices":["#), same("[0,0,0],"), "]}}},");
    let polygon = [polygon.strip_suffix(b"]}}},").expect("its end"), b",[1,0,0],[0,1,0]]}}}]}".as_slice()].concat();
    bounded("s.json", &polygon, &["scene", "check", "@"], 0);
}

/// Triangles between the same few corners, each a few bytes.
#[test]
fn triangles_of_a_mesh() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let ply = format!("{ply}element face {}\nproperty list uchar int vertex_indices\nend_header\n", SIZE / 8);
    let faces = many("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", same("f 1 2 3\n"), "");
    let short = many("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", same("f 1 2 3 4\n"), "");
    let text = [format!("{ply}0 0 0\n1 0 0\n0 1 0\n").into_bytes(), b"3 0 1 2\n".repeat(SIZE / 8)].concat();
    for (name, mesh) in [("m.obj", faces), ("m.obj", short), ("m.ply", text)] {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = format!(
            r#"{{"format":"raywalk-scene/1","camera":{{"position":[0,0,5],"direction":[0,0,-1],"resolution":[8,6]}},
                "objects":[{{"shape":{{"mesh":{{"path":"{name}.gz"}}}}}}]}}"#
        );
        fs::write(folder.path().join("t.json"), scene).expect("written");
        fs::write(folder.path().join(format!("{name}.gz")), packed(&mesh)).expect("written");
        bounded_in(folder.path(), mesh.len(), "t.json", &["scene", "check", "@"], 0);
    }
}
